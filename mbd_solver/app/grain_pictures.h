#pragma once
// Pictures of grains coloured by speed together with the mechanism, as [Lin25 Figure 10]: drawn by DepthImage, set on a
// page with title, colour bar and scale by gnuplot.

#include <string>
#include <vector>

#include "mbd_solver/app/mechanism_shape.h"
#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/bed/depth_image.h"

namespace footfall {

struct GrainView {
  Eye eye;
  int width = 1600;      // of the drawing [pixels]
  double fastest = 1.0;  // speed at the upper end of the colours; faster grains have its colour [m/s]
  double cut = -1e300;   // grains with y below this are left out [m]
};

// The eye from which all that is given can be seen. `azimuth`, `elevation` [rad].
Eye eye_around(const std::vector<const BedFrame*>& beds, const std::vector<const MechanismShape*>& shapes, double cut,
               double azimuth, double elevation);

// The speed that all but one in a thousand grains of the fastest of these frames stay below, rounded up to 1, 2 or 5
// times a power of ten [m/s].
double colour_range(const std::vector<const BedFrame*>& beds);

// NAME.rgb (what was drawn) and NAME.gp in `folder`; the script draws NAME.png. Returns the script's file name. Throws
// InputError when the folder cannot be written.
std::string write_grain_picture(const std::string& folder, const std::string& name, const std::string& title,
                                const BedFrame& bed, const MechanismShape& shape, const GrainView& view);

// footfall pictures: grains, coloured by speed, and the mechanism at chosen times.

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
