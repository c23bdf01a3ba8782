// Reads dumps into columns by name, then into matrices sorted by the grains' ids.
#include "mbd_solver/bed/bed_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <system_error>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/packed_bytes.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/bed/codes.h"

namespace footfall {
namespace fs = std::filesystem;

namespace {

// Columns of numbers by name.
struct Columns {
  std::map<std::string, std::vector<double>> of;
  bool without_grains = false;  // a dump from before the first grain, or after the last: VTK files then name no columns
  const std::vector<double>& get(const std::string& path, const std::string& name) const {
    const auto found = of.find(name);
    if (found == of.end())
      throw InputError(code::kDumpColumnMissing, path, ": no column \"", name,
                       "\"; dump id x y z vx vy vz radius of the grains");
    return found->second;
  }
};

// "ITEM: ATOMS id x y z ...", then a row per grain.
Columns read_text(TextReader& text) {
  Columns columns;
  std::vector<std::vector<double>*> row;
  while (text.next()) {
    const std::vector<std::string_view>& words = text.fields(Separators::kBlanks);
    if (text.line().rfind("ITEM:", 0) == 0) {
      row.clear();
      if (words.size() < 2 || words[1] != "ATOMS") continue;
      columns.of.clear();
      for (std::size_t i = 2; i < words.size(); ++i) row.push_back(&columns.of[std::string(words[i])]);
      continue;
    }
    if (words.size() < row.size())
      text.fail("is \"", text.line(), "\", expected a number for each column of ITEM: ATOMS");
    for (std::size_t i = 0; i < row.size(); ++i) row[i]->push_back(text.number(words[i]));
  }
  return columns;
}

// POINTS n TYPE, then x y z each; later fields NAME components n TYPE.
Columns read_vtk(TextReader& text) {
  Columns columns;
  const auto numbers = [&](const std::vector<std::string>& names, long n) {
    std::vector<std::vector<double>*> to;
    to.reserve(names.size());
    for (const std::string& name : names) to.push_back(&columns.of[name]);
    std::string_view word;
    double value = 0.0;
    for (long i = 0; i < n; ++i)
      for (std::vector<double>* const column : to) {
        if (!text.next_word(word)) text.fail("the file ends in the middle of \"", names.front(), "\"");
        if (!read_number(word, value) || !std::isfinite(value))
          text.fail("\"", names.front(), "\" contains ", in_quotes(word), ", expected a finite number");
        column->push_back(value);
      }
  };
  bool fields = false;
  while (text.next()) {
    const std::vector<std::string_view>& words = text.fields(Separators::kBlanks);
    long components = 0, n = 0;
    if (words.empty()) continue;
    const std::string name(words[0]);
    if (name == "BINARY") text.fail("is a binary VTK file, expected the ASCII file that dump custom/vtk writes");
    if (name == "POINTS" && words.size() > 1 && read_whole(words[1], n)) {
      columns.without_grains = n == 0;
      numbers({"x", "y", "z"}, n);
    } else if (name == "FIELD") {
      fields = true;
    } else if (fields && words.size() > 3 && read_whole(words[1], components) && read_whole(words[2], n)) {
      if (components == 3) {
        numbers({name + "x", name + "y", name + "z"}, n);
      } else {
        std::vector<std::string> names;
        for (long c = 0; c < components; ++c) names.push_back(c == 0 ? name : name + std::to_string(c));
        numbers(names, n);
      }
    }
  }
  return columns;
}

// One array of a .vtp of ours: VTK's header (blocks, bytes of a block, of a smaller last one, compressed bytes), then one block of
// zlib, both in base64.
std::string unpacked_array(std::string_view text, std::size_t most, const std::string& path) {
  constexpr std::size_t kHeader = 16, kWholeHeader = 24;  // characters of three numbers, of four
  const InputError damaged(code::kDumpNotReadable, path + ": an array is incomplete; was the file cut off?");
  const auto number = [](const std::string& bytes, std::size_t k) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + 4 * k, 4);
    return value;
  };
  const std::optional<std::string> start = bytes_of_base64(text.substr(0, kHeader));
  if (!start || start->size() < 12) throw damaged;
  if (number(*start, 0) == 0) return "";
  if (number(*start, 0) != 1 || text.size() < kWholeHeader)
    throw InputError(code::kDumpNotReadable, path, ": is no file that footfall has written");
  const std::size_t size = number(*start, 1);
  const std::optional<std::string> packed = bytes_of_base64(text.substr(kWholeHeader));
  if (size > most || !packed) throw damaged;
  const std::optional<std::string> bytes = inflated(*packed, size);
  if (!bytes) throw damaged;
  return *bytes;
}

std::string_view attribute(std::string_view element, const std::string& name) {
  const std::size_t at = element.find(name + "=\"");
  if (at == std::string_view::npos) return {};
  const std::size_t from = at + name.size() + 2, to = element.find('"', from);
  return to == std::string_view::npos ? std::string_view() : element.substr(from, to - from);
}

// What grain_polydata of app/paraview_files.h writes.
Columns read_vtp(const std::string& path) {
  const std::string text = read_whole_file(path).value_or("");
  Columns columns;
  const std::size_t piece = text.find("<Piece ");
  double number = -1.0;
  if (piece == std::string::npos ||
      !read_number(attribute(std::string_view(text).substr(piece, 200), "NumberOfPoints"), number) ||
      !(number >= 0.0) || number > 1e3 * static_cast<double>(text.size()))
    throw InputError(code::kDumpNotReadable, path, ": is no VTK file of points; was it cut off?");
  const auto n = static_cast<std::size_t>(number);
  columns.without_grains = n == 0;
  for (std::size_t at = piece; (at = text.find("<DataArray ", at)) != std::string::npos;) {
    const std::size_t start = text.find('>', at), end = text.find("</DataArray>", at);
    if (start == std::string::npos || end == std::string::npos || end < start)
      throw InputError(code::kDumpNotReadable, path, ": ends in the middle of an array");
    const std::string_view element(text.data() + at, start - at);
    std::string name(attribute(element, "Name"));
    const bool whole = attribute(element, "type") == "Int32";
    const std::size_t components = attribute(element, "NumberOfComponents") == "3" ? 3 : 1;
    const std::string bytes =
        unpacked_array(std::string_view(text).substr(start + 1, end - start - 1), 4 * components * n, path);
    at = end;
    if (bytes.size() != 4 * components * n)
      throw InputError(code::kDumpNotReadable, path, ": \"", name, "\" has the wrong length");
    if (name == "Points") name = "";
    if (name == "velocity") name = "v";
    if (name == "force") name = "f";
    for (std::size_t c = 0; c < components; ++c) {
      std::vector<double>& column = columns.of[components == 3 ? name + "xyz"[c] : name];
      for (std::size_t i = 0; i < n; ++i) {
        float real = 0.0f;
        std::int32_t integer = 0;
        std::memcpy(whole ? static_cast<void*>(&integer) : &real, bytes.data() + 4 * (components * i + c), 4);
        column.push_back(whole ? static_cast<double>(integer) : static_cast<double>(real));
        if (!std::isfinite(column.back()))
          throw InputError(code::kDumpNotReadable, path, ": \"", name, "\" has a number that is not finite");
      }
    }
  }
  return columns;
}

// PREFIX_STEP.vtk -> PREFIX, STEP; false for other names.
bool parts_of(const fs::path& file, std::string& prefix, long& step) {
  const std::string end = file.extension().string(), stem = file.stem().string();
  const std::size_t line = stem.rfind('_');
  if ((end != ".vtk" && end != ".txt" && end != ".vtp") || line == std::string::npos || line + 1 == stem.size())
    return false;
  const std::string digits = stem.substr(line + 1);
  if (digits.find_first_not_of("0123456789") != std::string::npos || digits.size() > 12) return false;
  prefix = stem.substr(0, line);
  step = std::stol(digits);
  return true;
}

Columns read_columns(const std::string& path) {
  TextReader text(path, code::kDumpNotReadable, "a dump of grains");
  if (fs::path(path).extension() == ".vtp") return read_vtp(path);
  const bool vtk = text.next() && text.line().rfind("# vtk", 0) == 0;
  text.back();
  return vtk ? read_vtk(text) : read_text(text);
}

// Files that LIGGGHTS begins again in a resumed run.
constexpr const char* kRows[] = {"grains_energy", "walls_energy"};
fs::path rows_of(const std::string& run, const char* name) { return fs::path(run) / (concat(name, ".txt")); }
fs::path rows_aside(const std::string& run, const char* name) { return fs::path(run) / (concat(name, ".before.txt")); }

// Lines of the text whose step is in (after, until]; comments on request.
std::string rows_between(const std::string& text, long after, long until, bool comments) {
  std::string kept;
  for (const std::string& line : split(text, '\n')) {
    const bool comment = !line.empty() && line[0] == '#';
    const long step = std::strtol(line.c_str(), nullptr, 10);
    if (comment ? comments : step > after && step <= until) kept += line + "\n";
  }
  return kept;
}

long last_step(const std::string& text) {
  long step = -1;
  for (const std::string& line : split(text, '\n'))
    if (!line.empty() && line[0] != '#') step = std::strtol(line.c_str(), nullptr, 10);
  return step;
}

}  // namespace

std::vector<std::string> dumped_columns(const std::string& path) {
  std::vector<std::string> names;
  for (const auto& [name, values] : read_columns(path).of) names.push_back(name);
  return names;
}

BedFrame read_bed_frame(const std::string& path) {
  const Columns columns = read_columns(path);
  if (columns.without_grains) {
    BedFrame empty;
    std::string ignored;
    parts_of(path, ignored, empty.step);
    return empty;
  }
  const std::vector<double>& id = columns.get(path, "id");
  std::vector<std::size_t> order(id.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return id[a] < id[b]; });
  BedFrame frame;
  std::string prefix;
  parts_of(path, prefix, frame.step);
  const auto matrix = [&](const char* a, const char* b, const char* c) {
    const std::vector<double>* const rows[3] = {&columns.get(path, a), &columns.get(path, b), &columns.get(path, c)};
    Eigen::Matrix3Xd m(3, static_cast<Eigen::Index>(id.size()));
    for (int k = 0; k < 3; ++k) {
      if (rows[k]->size() != id.size())
        throw InputError(code::kDumpNotReadable, path, ": its columns have different lengths");
      for (std::size_t i = 0; i < order.size(); ++i) m(k, static_cast<Eigen::Index>(i)) = (*rows[k])[order[i]];
    }
    return m;
  };
  // Of grains that have gone round a periodic box: their places in W.
  const bool unwrapped = columns.of.count("xu") > 0 && columns.of.count("yu") > 0;
  frame.x = unwrapped ? matrix("xu", "yu", "z") : matrix("x", "y", "z");
  if (columns.of.count("vx") > 0) frame.v = matrix("vx", "vy", "vz");
  if (columns.of.count("fx") > 0) frame.f = matrix("fx", "fy", "fz");
  const std::vector<double>& radius = columns.get(path, "radius");
  if (const auto type = columns.of.find("type"); type != columns.of.end() && type->second.size() == id.size())
    for (const std::size_t i : order) frame.type.push_back(static_cast<int>(type->second[i]));
  for (const std::size_t i : order) {
    frame.id.push_back(static_cast<int>(id[i]));
    frame.radius.push_back(radius.at(i));
  }
  return frame;
}

std::map<long, std::string> find_bed_frames(const std::string& folder) {
  std::map<std::string, std::map<long, std::string>> by_prefix;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    std::string prefix;
    long step = 0;
    if (!parts_of(entry.path(), prefix, step)) continue;
    std::string& file = by_prefix[prefix][step];
    if (file.empty() || entry.path().extension() != ".vtp") file = entry.path().string();
  }
  std::map<long, std::string> best;
  for (const auto& [prefix, frames] : by_prefix) {
    if (frames.size() <= best.size()) continue;
    try {  // the first dumps may have no grains yet
      for (const auto& [step, file] : frames)
        if (read_bed_frame(file).count() > 0) {
          best = frames;
          break;
        }
    } catch (const InputError&) {  // a dump of something else, such as meshes
    }
  }
  return best;
}

long step_of_checkpoint(const std::string& checkpoint) {
  const std::string file = checkpoint + "/grains.txt", mark = "\nstep ";
  const std::string text = read_whole_file(file).value_or("");
  const std::size_t at = text.find(mark);
  if (at == std::string::npos)
    throw InputError(code::kGrainsCheckpointDamaged, file, ": does not hold the step of LIGGGHTS");
  return std::strtol(text.c_str() + at + mark.size(), nullptr, 10);
}

void move_rows_aside(const std::string& run, long step) {
  join_rows(run);
  for (const char* const name : kRows)
    if (const std::optional<std::string> text = read_whole_file(rows_of(run, name).string()))
      write_whole_file(rows_aside(run, name).string(), rows_between(*text, -1, step, true));
}

std::string energy_at_start(const std::string& run) {
  TextReader text = TextReader::if_there(run + "/grains_energy_start.txt");
  std::string_view number;
  double value = 0.0;
  return text.next_word(number) && read_number(number, value) ? std::string(number) : "";
}

void join_rows(const std::string& run) {
  for (const char* const name : kRows) {
    const std::optional<std::string> before = read_whole_file(rows_aside(run, name).string());
    if (!before) continue;
    const std::string after = read_whole_file(rows_of(run, name).string()).value_or("");
    write_whole_file(rows_of(run, name).string(), *before + rows_between(after, last_step(*before), 1L << 62, false));
    fs::remove(rows_aside(run, name));
  }
}

}  // namespace footfall
