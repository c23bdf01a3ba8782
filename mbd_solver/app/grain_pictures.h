#pragma once
// footfall view --pictures: grains coloured by speed and the mechanism, as [Lin25 Figure 10]. DepthImage draws them; gnuplot
// adds title, colour bar and scale.

#include <string>
#include <vector>

#include "mbd_solver/app/mechanism_shape.h"
#include "mbd_solver/bed/depth_image.h"

namespace footfall {

// Struts, joints with their axes, and brackets from a joint or strut to its body where that is drawn elsewhere: of the marks
// of a drawing (session/observe/marks.h). Nothing for a drawing without marks.
void draw_marks(const VtkFrame& frame, DepthImage& image);

struct PicturesArguments {
  std::string run;                                        // folder of a run that dumped its grains
  std::vector<double> times = {0.05, 0.1, 0.25, 0.5, 1};  // [s]; the nearest dump is drawn
  std::vector<double> camera;                             // azimuth, elevation of the eye [deg]; empty: default
  bool cut = false;            // leave out the grains in front of the foremost coupled surface
  std::vector<double> cut_at;  // or in front of this y [m]
  double fastest = 0.0;        // speed at the end of the colour scale [m/s]; 0: from the grains
  int width = 1600;            // of the drawing [pixels]
};

// Writes DIR/pictures/NAME.png for each time and prints their paths. Returns the exit code. Throws InputError.
int draw_grain_pictures(const PicturesArguments& arguments);

}  // namespace footfall
