#pragma once
// footfall pictures: grains, coloured by speed, and the mechanism at chosen times.

#include <string>
#include <vector>

namespace footfall {

struct PicturesArguments {
  std::string run;                                        // folder of a run that dumped its grains
  std::vector<double> times = {0.05, 0.1, 0.25, 0.5, 1};  // [s]; the nearest dump is drawn
  std::vector<double> view;                               // azimuth, elevation of the eye [deg]; empty: one that suits
  bool cut = false;            // leave out the grains in front of the foremost coupled surface
  std::vector<double> cut_at;  // or in front of this y [m]
  double fastest = 0.0;        // speed at the end of the colours [m/s]; 0: from the grains
  int width = 1600;            // of the drawing [pixels]
};

// DIR/pictures/NAME.png for each time; prints their paths. The mechanism is drawn as DIR/bodies.pvd has it (output.vtk
// = true); without that its coupled surfaces, moved rigidly as DIR/motion says. Throws InputError.
int pictures_command(const PicturesArguments& arguments);

}  // namespace footfall
