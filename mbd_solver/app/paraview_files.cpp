// Writes dumps of grains as VTK XML (zlib in base64), lists of files with their times, and a script for ParaView.
#include "mbd_solver/app/paraview_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>

#include "coupler/base/files.h"
#include "mbd_solver/app/mechanism_shape.h"
#include "mbd_solver/app/packed_series.h"
#include "mbd_solver/app/results.h"
#include "mbd_solver/base/packed_bytes.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/summary.h"
#include "mbd_solver/session/output/vtk_writer.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kDiskAdvice = "is the disk full?";

// Length of the window that ends with each drawing [s]. Where the run chose its windows, the history has the number of DEM
// steps of the window at the next row.
std::vector<double> windows_before(const std::string& out, const std::vector<double>& drawn, double dt,
                                   const Json& summary) {
  if (summary.contains("substeps_per_window") && summary.at("substeps_per_window").is_number())
    return std::vector<double>(drawn.size(), dt * summary.at("substeps_per_window").get<double>());
  const History history = read_history((fs::path(out) / "history.csv").string());
  const std::vector<double>&times = history.column("time"), &substeps = history.column("coupling.substeps");
  std::vector<double> windows;
  if (times.empty()) return std::vector<double>(drawn.size(), dt);
  for (const double t : drawn) {
    const auto row = std::lower_bound(times.begin(), times.end(), t - 0.5 * dt) - times.begin();
    const std::size_t k = std::min(static_cast<std::size_t>(row), times.size() - 1);
    windows.push_back(dt * std::max(1.0, substeps[k]));
  }
  return windows;
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes(sizeof(Number) * numbers.size(), '\0');
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

template <class Number>
std::string data_array(const char* type, const char* name, int components, const std::vector<Number>& numbers) {
  const std::string bytes = bytes_of(numbers), packed = bytes.empty() ? "" : packed_bytes(bytes);
  std::vector<std::uint32_t> header = {0, 0, 0};  // blocks, bytes of a block, bytes of a smaller last block
  if (!bytes.empty()) {
    const std::size_t padding = std::count(packed.end() - 2, packed.end(), '=');
    header = {1, static_cast<std::uint32_t>(bytes.size()), 0,
              static_cast<std::uint32_t>(packed.size() / 4 * 3 - padding)};
  }
  return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"binary\">" + base64(bytes_of(header)) + packed + "</DataArray>\n";
}

std::vector<float> singles(const Eigen::Matrix3Xd& x) { return {x.data(), x.data() + x.size()}; }

// A dump in VTK's text format with no columns besides the columns of its .vtp, which takes a third of the room. Text dumps stay: scripts of
// users read them.
bool holds_all_of(const std::string& dump) {
  if (fs::path(dump).extension() != ".vtk") return false;
  const std::vector<std::string> columns = dumped_columns(dump);
  return std::all_of(columns.begin(), columns.end(), [](const std::string& name) {
    for (const char* known : {"id", "type", "radius", "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz", "xu", "yu"})
      if (name == known) return true;
    return false;
  });
}

}  // namespace

std::string grain_polydata(const BedFrame& frame) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\" "
      "compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n<Piece NumberOfPoints=\"" +
      std::to_string(frame.count()) +
      "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n";
  text += data_array("Int32", "id", 1, std::vector<std::int32_t>(frame.id.begin(), frame.id.end()));
  if (!frame.type.empty())
    text += data_array("Int32", "type", 1, std::vector<std::int32_t>(frame.type.begin(), frame.type.end()));
  text += data_array("Float32", "radius", 1, std::vector<float>(frame.radius.begin(), frame.radius.end()));
  if (frame.v.cols() > 0) text += data_array("Float32", "velocity", 3, singles(frame.v));
  if (frame.f.cols() > 0) text += data_array("Float32", "force", 3, singles(frame.f));
  text += "</PointData>\n<Points>\n" + data_array("Float32", "Points", 3, singles(frame.x));
  return text + "</Points>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

void write_grain_series(const std::string& out) {
  try {
    const Json summary = read_summary((fs::path(out) / "summary.json").string());
    const double dt = summary.value("dt_dem_s", 0.0);
    if (!(dt > 0.0)) return;
    const std::map<long, std::string> dumps = find_bed_frames(out);
    if (dumps.empty()) return;
    std::vector<double> drawn;
    if (const fs::path pvd = fs::path(out) / "bodies.pvd"; fs::exists(pvd))
      for (const auto& [time, file] : read_vtk_series(pvd.string())) drawn.push_back(time);
    const std::vector<double> windows = windows_before(out, drawn, dt, summary);
    std::vector<std::pair<double, std::string>> list;
    std::vector<std::string> replaced;
    for (const auto& [step, file] : dumps) {
      double time = static_cast<double>(step) * dt;
      if (!drawn.empty())
        if (const std::size_t k = nearest(drawn, time); std::abs(drawn[k] - time) < 1.001 * windows[k]) time = drawn[k];
      const fs::path made = fs::path(file).replace_extension(".vtp");
      list.emplace_back(time, made.filename().string());
      if (made == file) continue;  // of the part of the run before it was resumed
      write_whole_file(made.string(), grain_polydata(read_bed_frame(file)), kDiskAdvice);
      if (holds_all_of(file)) replaced.push_back(file);
    }
    const std::string stem = fs::path(dumps.begin()->second).stem().string();
    write_vtk_list((fs::path(out) / (stem.substr(0, stem.rfind('_')) + ".pvd")).string(), list);
    std::error_code ignored;
    for (const std::string& file : replaced) fs::remove(file, ignored);
  } catch (const std::exception& e) {
    warn_missing_file("list of the dumps of grains", e);
  }
}

namespace {

constexpr const char* kScript =
    R"(# Opens this run in ParaView:  paraview --script=paraview.py  in this folder, or Tools, Python Shell, Run Script.
# Bodies are coloured by number (their names are in the field data "body_names"), grains by speed; both have velocities.
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
    if (drew_something(out)) write_whole_file((fs::path(out) / "paraview.py").string(), kScript, kDiskAdvice);
  } catch (const std::exception& e) {
    warn_missing_file("paraview.py", e);
  }
}

}  // namespace footfall
