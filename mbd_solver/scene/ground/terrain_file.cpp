// The whole file is read at once and passed once. The header is judged before any sample is stored.

#include "mbd_solver/scene/ground/terrain_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/input_file.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/codes.h"

namespace footfall {
namespace {

constexpr double kMostMapSamples = 3e7;                        // 5400 x 5400, 240 MB
constexpr std::uint64_t kLargestMap = std::uint64_t{2} << 30;  // [bytes]
constexpr double kEvenGrid = 0.01;                             // of a step: places of samples agree with a regular grid
constexpr const char* kExpected =
    "expected an ESRI ASCII grid (ncols, nrows, xllcorner, yllcorner, cellsize, then rows of "
    "heights), or lines of x, y, z of a regular grid";
constexpr const char* kFill = "fill the holes first, for example by gdal_fillnodata.py in.tif out.tif";
constexpr const char* kCoarser = "cut or thin it first, for example by gdal_translate -projwin ... -tr 0.1 0.1";

// Words of a text, with the line of each.
class MapWords {
 public:
  MapWords(const std::string& file, std::string_view text)
      : file_(file), at_(text.data()), end_(at_ + text.size()), counted_(at_) {}

  [[noreturn]] void fail(const std::string& what) {
    throw InputError(code::kTerrainMap, file_ + ":" + std::to_string(line()) + ": " + what);
  }
  // The next word, of this line alone or of any; empty at the end.
  std::string_view next(bool this_line = false) {
    for (; at_ < end_ && is_gap(*at_); ++at_)
      if (*at_ == '\n' && this_line) return {};
    const char* const from = at_;
    while (at_ < end_ && !is_gap(*at_)) ++at_;
    return {from, static_cast<std::size_t>(at_ - from)};
  }
  std::string_view peek() {
    const char* const at = at_;
    const std::string_view word = next();
    at_ = at;
    return word;
  }
  void skip_line() {
    while (at_ < end_ && *at_ != '\n') ++at_;
  }
  // The next word as a plain number: digits, at most one point, no more than 15 of them, so that both parts of the quotient, and
  // with them the nearest double, are exact [Clinger, PLDI 1990]. False, and nothing is passed, for a hole and all others.
  bool plain_number(double hole, double& value) {
    static constexpr std::array<double, 16> kTens = {1.0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const char* at = at_;
    while (at < end_ && is_gap(*at)) ++at;
    const bool negative = at < end_ && *at == '-';
    if (negative) ++at;
    std::uint64_t digits = 0;
    const char* const first = at;
    for (; at < end_ && is_digit(*at); ++at) digits = 10 * digits + static_cast<unsigned>(*at - '0');
    std::ptrdiff_t count = at - first, behind = 0;
    if (at < end_ && *at == '.') {
      const char* const point = at++;
      for (; at < end_ && is_digit(*at); ++at) digits = 10 * digits + static_cast<unsigned>(*at - '0');
      behind = at - point - 1;
      count += behind;
    }
    if (count == 0 || count > 15 || (at < end_ && !is_gap(*at))) return false;
    value = static_cast<double>(digits) / kTens[static_cast<std::size_t>(behind)];
    if (negative) value = -value;
    if (value == hole) return false;
    at_ = at;
    return true;
  }
  bool number(std::string_view word, double& value) const {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    return result.ec == std::errc() && result.ptr == word.data() + word.size();
  }
  int line() {  // of the last word
    line_ += static_cast<int>(std::count(counted_, at_, '\n'));
    counted_ = at_;
    return line_;
  }
  void set_line(int line) {
    line_ = line;
    counted_ = at_;
  }

 private:
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_gap(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == ',' || c == ';'; }

  const std::string& file_;
  const char* at_;
  const char* end_;
  const char* counted_;  // line ends up to here are in line_
  int line_ = 1;
};

std::string shown(std::string_view word) {
  std::string out;
  for (const char c : word.substr(0, 30)) out += c < ' ' || c > '~' ? '?' : c;
  return "\"" + out + (word.size() > 30 ? "..." : "") + "\"";
}

struct RawMap {
  HeightGrid grid;
  double x = 0.0, y = 0.0;  // of the first sample, in coordinates of the file [m]
};

void judge_size(MapWords& words, double columns, double rows) {
  if (!(columns >= 2.0 && rows >= 2.0))
    words.fail("the map has " + number_text(columns) + " columns and " + number_text(rows) +
               " rows, expected at least 2 of each: one row has no slope across it");
  if (!(columns * rows <= kMostMapSamples))
    words.fail("the map has " + number_text(columns * rows, 4) + " samples, expected at most " +
               number_text(kMostMapSamples, 2) + "; " + kCoarser);
}

RawMap read_esri(MapWords& words) {
  double columns = 0.0, rows = 0.0, x = 0.0, y = 0.0, dx = 0.0, dy = 0.0, hole = -9999.0;
  bool has_x = false, has_y = false, corner_x = false, corner_y = false, has_hole = false;
  int header = 1;
  for (double first; !words.number(words.peek(), first);) {
    const std::string_view key = words.next();
    std::string name(key.substr(0, 20));
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::string_view word = words.next(true);
    double value = 0.0;
    if (!words.number(word, value) || !std::isfinite(value)) {
      if (name.empty()) break;
      words.fail("the header has " + shown(key) + " with the value " + shown(word) + ", expected a number; " +
                 kExpected);
    }
    header = words.line();
    if (name == "ncols") {
      columns = value;
    } else if (name == "nrows") {
      rows = value;
    } else if (name == "xllcorner" || name == "xllcenter") {
      x = value;
      has_x = true;
      corner_x = name == "xllcorner";
    } else if (name == "yllcorner" || name == "yllcenter") {
      y = value;
      has_y = true;
      corner_y = name == "yllcorner";
    } else if (name == "cellsize") {
      dx = dy = value;
    } else if (name == "dx") {
      dx = value;
    } else if (name == "dy") {
      dy = value;
    } else if (name == "nodata_value") {
      hole = value;
      has_hole = true;
    } else {
      words.fail("the header has the unknown key " + shown(key) + "; " + kExpected);
    }
  }
  const auto demand = [&](bool good, const char* what) {
    if (good) return;
    words.set_line(header);
    words.fail(std::string("the header has no ") + what + "; " + kExpected);
  };
  demand(columns != 0.0, "ncols");
  demand(rows != 0.0, "nrows");
  demand(has_x, "xllcorner or xllcenter");
  demand(has_y, "yllcorner or yllcenter");
  demand(dx > 0.0 && dy > 0.0, "cellsize above 0 [m]");
  if (columns != std::floor(columns) || rows != std::floor(rows)) words.fail("ncols and nrows must be whole numbers");
  judge_size(words, columns, rows);
  RawMap map;
  map.grid.columns = static_cast<int>(columns);
  map.grid.rows = static_cast<int>(rows);
  map.grid.step = {dx, dy};
  map.x = x + (corner_x ? 0.5 * dx : 0.0);
  map.y = y + (corner_y ? 0.5 * dy : 0.0);
  map.grid.heights.resize(static_cast<std::size_t>(map.grid.columns) * static_cast<std::size_t>(map.grid.rows));
  // From the north; words count, as other programs break lines where they like.
  for (int row = map.grid.rows - 1; row >= 0; --row) {
    double* const heights =
        &map.grid.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.grid.columns)];
    for (int column = 0; column < map.grid.columns; ++column) {
      if (words.plain_number(hole, heights[column])) continue;
      const std::string_view word = words.next();
      const auto where = [&] {
        return "row " + std::to_string(map.grid.rows - row) + " from the top, column " + std::to_string(column + 1);
      };
      if (word.empty())
        words.fail("the file ends in " + where() + "; the header promises " + number_text(rows) + " rows of " +
                   number_text(columns) + " heights");
      double& value = heights[column];
      if (!words.number(word, value) || !std::isfinite(value))
        words.fail(where() + " is " + shown(word) + ", expected a height [m]; " + kFill);
      if (value == hole)
        words.fail(where() + " is a hole (" + (has_hole ? "NODATA_value " : "") + shown(word) + "); " + kFill);
    }
  }
  if (!words.peek().empty()) {
    words.next();
    words.fail("there are more heights than ncols times nrows = " + number_text(columns * rows));
  }
  return map;
}

// Places along one axis, each once, in order.
std::vector<double> places_along(std::vector<double> all, double& step) {
  std::sort(all.begin(), all.end());
  const double wide = all.back() - all.front(), near = 1e-9 * std::max(std::abs(all.front()), std::abs(all.back()));
  std::vector<double> places;
  for (const double x : all)
    if (places.empty() || x - places.back() > std::max(near, 1e-7 * wide)) places.push_back(x);
  step = places.size() > 1 ? wide / static_cast<double>(places.size() - 1) : 0.0;
  return places;
}

RawMap read_points(MapWords& words) {
  std::vector<double> x, y, z;
  std::vector<int> lines;
  double first;
  if (!words.number(words.peek(), first)) words.skip_line();  // names of the columns
  while (!words.peek().empty()) {
    double values[3];
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = words.next(k > 0);
      if (word.empty()) words.fail("has " + std::to_string(k) + " numbers, expected x, y and z; " + kExpected);
      if (!words.number(word, values[k]) || !std::isfinite(values[k]))
        words.fail("has " + shown(word) + ", expected a number; " + (k == 2 ? kFill : kExpected));
    }
    if (const std::string_view more = words.next(true); !more.empty())
      words.fail("has more than three numbers, expected x, y and z; " + std::string(kExpected));
    x.push_back(values[0]);
    y.push_back(values[1]);
    z.push_back(values[2]);
    lines.push_back(words.line());
    if (static_cast<double>(z.size()) > kMostMapSamples) judge_size(words, static_cast<double>(z.size()), 2.0);
  }
  if (z.empty()) words.fail(std::string("there are no heights; ") + kExpected);
  double dx, dy;
  const std::vector<double> along_x = places_along(x, dx), along_y = places_along(y, dy);
  judge_size(words, static_cast<double>(along_x.size()), static_cast<double>(along_y.size()));
  RawMap map;
  map.x = along_x.front();
  map.y = along_y.front();
  map.grid.columns = static_cast<int>(along_x.size());
  map.grid.rows = static_cast<int>(along_y.size());
  map.grid.step = {dx, dy};
  const std::size_t count = along_x.size() * along_y.size();
  map.grid.heights.assign(count, std::nan(""));
  for (std::size_t k = 0; k < z.size(); ++k) {
    const double i = (x[k] - map.x) / dx, j = (y[k] - map.y) / dy;
    words.set_line(lines[k]);
    if (std::abs(i - std::round(i)) > kEvenGrid || std::abs(j - std::round(j)) > kEvenGrid)
      words.fail("the place (" + number_text(x[k], 12) + ", " + number_text(y[k], 12) +
                 ") is not on the regular grid of the others, with steps of " + number_text(dx, 6) + " and " +
                 number_text(dy, 6) + " m; make one, for example by gdal_grid or gdalwarp -tr");
    double& height = map.grid.heights[static_cast<std::size_t>(std::lround(j)) * along_x.size() +
                                      static_cast<std::size_t>(std::lround(i))];
    if (!std::isnan(height))
      words.fail("the place (" + number_text(x[k], 12) + ", " + number_text(y[k], 12) + ") is given twice; remove one");
    height = z[k];
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (!std::isnan(map.grid.heights[k])) continue;
    const double row = static_cast<double>(k / along_x.size()), column = static_cast<double>(k % along_x.size());
    words.fail("the map has a hole at x = " + number_text(map.x + column * dx, 12) +
               ", y = " + number_text(map.y + row * dy, 12) + " (" +
               number_text(static_cast<double>(count - z.size())) + " in all); " + kFill);
  }
  return map;
}

}  // namespace

std::shared_ptr<const HeightGrid> read_height_map(const TerrainMapSpec& spec) {
  const std::string name = std::filesystem::path(spec.file).filename().string();
  require_regular_file(spec.file, kLargestMap);
  const std::optional<std::string> text = read_whole_file(spec.file);
  if (!text) throw InputError(code::kFileNotReadable, spec.file + ": cannot be read; " + kExpected);
  MapWords words(name, *text);
  double number;
  const std::string_view first = words.peek();
  if (first.empty()) words.fail(std::string("the file is empty; ") + kExpected);
  if (text->find('\0') != std::string::npos)
    words.fail(std::string("the file is not text; ") + kExpected +
               "; gdal_translate -of AAIGrid in.tif out.asc turns a map of GDAL into one");
  const bool points = words.number(first, number) || first == "x" || first == "X" || first == "\"x\"" || first == "#";
  RawMap map = points ? read_points(words) : read_esri(words);
  HeightGrid& grid = map.grid;
  // Without an origin of its own the middle of the map, and the height of the sample there.
  const Eigen::Vector3d middle(map.x + (grid.columns / 2) * grid.step.x(), map.y + (grid.rows / 2) * grid.step.y(),
                               grid.at(grid.columns / 2, grid.rows / 2));
  const Eigen::Vector3d origin = spec.origin.value_or(middle);
  grid.first = {map.x - origin.x(), map.y - origin.y()};
  for (double& height : grid.heights) height = (height - origin.z()) * spec.height_scale;
  return std::make_shared<const HeightGrid>(std::move(grid));
}

}  // namespace footfall
