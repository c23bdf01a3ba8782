#include "mbd_solver/cli/analysis/paraview_script.h"

#include <cstdio>
#include <exception>
#include <filesystem>

#include "coupler/base/whole_file.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr const char* kScript =
    R"(# Opens this run in ParaView:  paraview --script=paraview.py  in this folder, or Tools, Python Shell, Run Script.
# Bodies are coloured by number (the names stand in the field data "body_names"), grains by speed; both have velocities.
import os

from paraview.simple import *

here = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
view = GetActiveViewOrCreate("RenderView")


def file_of(name):
    path = os.path.join(here, name)
    return path if os.path.exists(path) else None


if file_of("bodies.pvd"):
    bodies = PVDReader(registrationName="bodies", FileName=file_of("bodies.pvd"))
    shown = Show(bodies, view)
    shown.SetRepresentationType("Surface")
    shown.LineWidth = 4.0
    ColorBy(shown, ("CELLS", "body"))

for name in sorted(os.listdir(here)):
    if not name.endswith(".pvd") or name == "bodies.pvd":
        continue
    grains = PVDReader(registrationName=name[: -len(".pvd")], FileName=file_of(name))
    grains.UpdatePipeline()
    shown = Show(grains, view)
    known = [array.Name for array in grains.PointData]
    if "radius" in known:
        shown.SetRepresentationType("Point Gaussian")
        shown.ShaderPreset = "Sphere"
        shown.ScaleByArray = 1
        shown.SetScaleArray = ["POINTS", "radius"]
        shown.UseScaleFunction = 0
        shown.GaussianRadius = 1.0
    if "velocity" in known:
        ColorBy(shown, ("POINTS", "velocity", "Magnitude"))
        shown.RescaleTransferFunctionToDataRangeOverTime()
        shown.SetScalarBarVisibility(view, True)
        bar = GetScalarBar(GetColorTransferFunction("velocity"), view)
        bar.Title, bar.ComponentTitle = "speed [m/s]", ""

GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
view.CameraViewUp = [0, 0, 1]
view.CameraPosition = [1, -2, 1]
view.CameraFocalPoint = [0, 0, 0]
ResetCamera(view)
Render(view)
)";

bool drew_something(const fs::path& out) {
  for (const fs::directory_entry& entry : fs::directory_iterator(out))
    if (entry.path().extension() == ".pvd") return true;
  return false;
}

}  // namespace

void write_paraview_script(const std::string& out) {
  try {
    if (drew_something(out)) write_whole_file((fs::path(out) / "paraview.py").string(), kScript, "is the disk full?");
  } catch (const std::exception& e) {
    std::fprintf(stderr, "footfall: warning: no paraview.py: %s\n", e.what());
  }
}

}  // namespace footfall
