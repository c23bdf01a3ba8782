// VTK's XML with ASCII arrays (pugixml). Texts are arrays of character codes. Cells are formatted once and reused while
// they do not change.

#include "mbd_solver/session/output/vtk_writer.h"

#include <cstdio>
#include <iterator>
#include <locale>
#include <pugixml.hpp>
#include <sstream>
#include <string_view>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/input_file.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/session/codes.h"

namespace footfall {
namespace {

constexpr int kLine = 3, kTriangle = 5;  // VTK's cell types
constexpr int kVtkDigits = 9;

pugi::xml_node data_array(pugi::xml_node parent, const char* type, const std::string& name, int components) {
  pugi::xml_node array = parent.append_child("DataArray");
  array.append_attribute("type") = type;
  array.append_attribute("Name") = name.c_str();
  if (components > 1) array.append_attribute("NumberOfComponents") = components;
  array.append_attribute("format") = "ascii";
  return array;
}

void append(std::string& text, double value) {
  append_number(text, value, kVtkDigits);
  text += ' ';
}

template <class Values>
std::string numbers(const Values& values) {
  std::string text;
  for (Eigen::Index j = 0; j < values.cols(); ++j)
    for (Eigen::Index i = 0; i < values.rows(); ++i) append(text, values(i, j));
  return text;
}

pugi::xml_node vtk_file(pugi::xml_document& document, const char* type) {
  pugi::xml_node root = document.append_child("VTKFile");
  root.append_attribute("type") = type;
  root.append_attribute("version") = "0.1";
  root.append_attribute("byte_order") = "LittleEndian";
  return root;
}

// Text of one of the arrays of cells.
template <class Append>
std::string each_cell(const VtkFrame& frame, Append append) {
  std::string text;
  for (const Eigen::Vector3i& t : frame.triangles) append(text, t.data(), 3);
  for (const Eigen::Vector2i& l : frame.lines) append(text, l.data(), 2);
  return text;
}

// A text is its character codes followed by zero.
void add_field_data(pugi::xml_node grid, const VtkFrame& frame) {
  if (frame.texts.empty() && frame.field_vectors.empty()) return;
  pugi::xml_node field = grid.append_child("FieldData");
  for (const auto& [name, texts] : frame.texts) {
    std::string bytes;
    for (const std::string& text : texts) {
      for (const char c : text) bytes += std::to_string(static_cast<unsigned char>(c)) + " ";
      bytes += "0 ";
    }
    pugi::xml_node array = data_array(field, "String", name, 1);
    array.append_attribute("NumberOfTuples") = static_cast<int>(texts.size());
    array.text() = bytes.c_str();
  }
  for (const auto& [name, values] : frame.field_vectors) {
    pugi::xml_node array = data_array(field, "Float64", name, 3);
    array.append_attribute("NumberOfTuples") = static_cast<int>(values.cols());
    array.text() = numbers(values).c_str();
  }
}

void save(const pugi::xml_document& document, const std::string& path) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  document.save(text, " ");
  write_whole_file_unsynced(path, text.str());
}

pugi::xml_node loaded(pugi::xml_document& document, const std::string& path, const char* kind) {
  require_regular_file(path);
  const pugi::xml_parse_result result = document.load_file(path.c_str());
  if (!result) throw InputError(code::kPictureDamaged, path + ": cannot be read: " + result.description());
  const pugi::xml_node node = document.child("VTKFile").child(kind);
  if (!node)
    throw InputError(code::kPictureDamaged,
                     path + ": contains no " + kind + "; expected a file of a run with output.vtk = true");
  return node;
}

std::vector<double> numbers_in(pugi::xml_node parent, const char* name) {
  std::istringstream text(parent.find_child_by_attribute("DataArray", "Name", name).text().get());
  text.imbue(std::locale::classic());
  return {std::istream_iterator<double>(text), {}};
}

Eigen::Matrix3Xd vectors_in(pugi::xml_node parent, const char* name) {
  const std::vector<double> x = numbers_in(parent, name);
  return Eigen::Map<const Eigen::Matrix3Xd>(x.data(), 3, static_cast<Eigen::Index>(x.size() / 3));
}

std::vector<std::string> texts_in(pugi::xml_node parent, const char* name) {
  std::vector<std::string> texts;
  std::string text;
  for (const double code : numbers_in(parent, name)) {
    if (code == 0.0)
      texts.push_back(std::exchange(text, {}));
    else
      text += static_cast<char>(static_cast<unsigned char>(code));
  }
  return texts;
}

}  // namespace

void write_vtk_list(const std::string& pvd, const std::vector<std::pair<double, std::string>>& frames) {
  pugi::xml_document list;
  pugi::xml_node collection = vtk_file(list, "Collection").append_child("Collection");
  for (const auto& [time, file] : frames) {
    pugi::xml_node entry = collection.append_child("DataSet");
    entry.append_attribute("timestep") = time;
    entry.append_attribute("file") = file.c_str();
  }
  save(list, pvd);
}

std::vector<std::pair<double, std::string>> read_vtk_series(const std::string& pvd) {
  pugi::xml_document document;
  std::vector<std::pair<double, std::string>> frames;
  for (const pugi::xml_node entry : loaded(document, pvd, "Collection").children("DataSet"))
    frames.emplace_back(entry.attribute("timestep").as_double(), entry.attribute("file").as_string());
  for (const auto& [time, file] : frames)
    if (file.find('/') != std::string::npos)
      throw InputError(code::kPictureDamaged,
                       pvd + ": lists \"" + file + "\", expected a file in the folder of the list");
  return frames;
}

VtkFrame read_vtk_frame(const std::string& vtu) {
  pugi::xml_document document;
  const pugi::xml_node piece = loaded(document, vtu, "UnstructuredGrid").child("Piece");
  VtkFrame frame;
  frame.points = vectors_in(piece.child("Points"), "Points");
  const pugi::xml_node field = piece.parent().child("FieldData");
  for (const pugi::xml_node array : field.children("DataArray")) {
    const char* const name = array.attribute("Name").as_string();
    if (std::string_view(array.attribute("type").as_string()) == "String")
      frame.texts.emplace_back(name, texts_in(field, name));
    else
      frame.field_vectors.emplace_back(name, vectors_in(field, name));
  }
  const std::vector<double> links = numbers_in(piece.child("Cells"), "connectivity");
  std::size_t first = 0;
  for (const double end : numbers_in(piece.child("Cells"), "offsets")) {
    const auto last = static_cast<std::size_t>(end);
    if (last > links.size() || last < first + 2)
      throw InputError(code::kPictureDamaged, vtu + ": offsets and connectivity disagree; was the file cut off?");
    const auto node = [&](std::size_t k) {
      const int j = static_cast<int>(links[first + k]);
      if (j < 0 || j >= frame.points.cols())
        throw InputError(code::kPictureDamaged, vtu + ": a cell has point " + std::to_string(j) +
                                                    ", which does not exist; was the file cut off?");
      return j;
    };
    if (last - first == 3) frame.triangles.emplace_back(node(0), node(1), node(2));
    if (last - first == 2) frame.lines.emplace_back(node(0), node(1));
    first = last;
  }
  for (const pugi::xml_node array : piece.child("CellData").children("DataArray")) {
    const std::vector<double> values = numbers_in(piece.child("CellData"), array.attribute("Name").as_string());
    frame.cell_numbers.emplace_back(
        array.attribute("Name").as_string(),
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  }
  return frame;
}

VtkSeries::VtkSeries(std::string folder, std::string name) : folder_(std::move(folder)), name_(std::move(name)) {}

void VtkSeries::add_to_list(double time) {
  char number[16];
  std::snprintf(number, sizeof number, "_%04zu.vtu", frames_.size());
  frames_.emplace_back(time, name_ + number);
}

std::vector<double> VtkSeries::times() const {
  std::vector<double> times;
  for (const auto& [time, file] : frames_) times.push_back(time);
  return times;
}

void VtkSeries::resume_after(const std::vector<double>& times) {
  frames_.clear();
  for (const double time : times) add_to_list(time);
}

const VtkSeries::Cells& VtkSeries::cells_of(const VtkFrame& frame) {
  if (cells_.written && cells_.triangles == frame.triangles && cells_.lines == frame.lines) return cells_;
  cells_ = {true, frame.triangles, frame.lines, {}, {}, {}};
  cells_.connectivity = each_cell(frame, [](std::string& text, const int* points, int count) {
    for (int k = 0; k < count; ++k) text += std::to_string(points[k]) + " ";
  });
  int offset = 0;
  cells_.offsets = each_cell(
      frame, [&](std::string& text, const int*, int count) { text += std::to_string(offset += count) + " "; });
  cells_.types = each_cell(frame, [](std::string& text, const int*, int count) {
    text += std::to_string(count == 3 ? kTriangle : kLine) + " ";
  });
  return cells_;
}

void VtkSeries::write(double time, const VtkFrame& frame) {
  if (!frame.points.allFinite())
    throw NumericalError(code::kOutputNotFinite,
                         "t = " + plain_text(time) + " s: geometry of " + name_ + " is not finite");
  pugi::xml_document document;
  pugi::xml_node grid = vtk_file(document, "UnstructuredGrid").append_child("UnstructuredGrid");
  add_field_data(grid, frame);
  pugi::xml_node piece = grid.append_child("Piece");
  piece.append_attribute("NumberOfPoints") = static_cast<int>(frame.points.cols());
  piece.append_attribute("NumberOfCells") = static_cast<int>(frame.triangles.size() + frame.lines.size());
  data_array(piece.append_child("Points"), "Float64", "Points", 3).text() = numbers(frame.points).c_str();
  const Cells& written = cells_of(frame);
  pugi::xml_node cells = piece.append_child("Cells");
  data_array(cells, "Int32", "connectivity", 1).text() = written.connectivity.c_str();
  data_array(cells, "Int32", "offsets", 1).text() = written.offsets.c_str();
  data_array(cells, "UInt8", "types", 1).text() = written.types.c_str();
  pugi::xml_node point_data = piece.append_child("PointData");
  for (const auto& [name, values] : frame.point_vectors)
    data_array(point_data, "Float64", name, 3).text() = numbers(values).c_str();
  pugi::xml_node cell_data = piece.append_child("CellData");
  for (const auto& [name, values] : frame.cell_numbers)
    data_array(cell_data, "Float64", name, 1).text() = numbers(values).c_str();

  add_to_list(time);
  save(document, folder_ + "/" + frames_.back().second);
  write_vtk_list(folder_ + "/" + name_ + ".pvd", frames_);
}

}  // namespace footfall
