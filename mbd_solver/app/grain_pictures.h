#pragma once
// footfall view --pictures: grains coloured by speed and the mechanism, as [Lin25 Figure 10]. DepthImage draws them; gnuplot
// adds title, colour bar and scale.

#include <string>
#include <vector>

#include "mbd_solver/app/mechanism_shape.h"
#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/bed/depth_image.h"

namespace footfall {

struct GrainView {
  Eye eye;
  int width = 1600;      // of the drawing [pixels]
  double fastest = 1.0;  // speed at the end of the colour scale [m/s]
  double cut = -1e300;   // grains with y below this are left out [m]
};

// The eye that sees all beds and shapes. `azimuth`, `elevation` [rad].
Eye eye_around(const std::vector<const BedFrame*>& beds, const std::vector<const MechanismShape*>& shapes, double cut,
               double azimuth, double elevation);

// The speed that one in a thousand grains exceeds, in the fastest of these frames, rounded up to 1, 2 or 5 times a power
// of ten [m/s].
double colour_range(const std::vector<const BedFrame*>& beds);

// Writes NAME.rgb and NAME.gp into `folder`; the script draws NAME.png. Returns the name of the script. Throws InputError
// when the folder cannot be written.
std::string write_grain_picture(const std::string& folder, const std::string& name, const std::string& title,
                                const BedFrame& bed, const MechanismShape& shape, const GrainView& view);

// Struts, joints with their axes, and brackets from a joint or strut to its body where that is drawn elsewhere: of the marks
// of a drawing (run/observe/marks.h). Nothing for a drawing without marks.
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
