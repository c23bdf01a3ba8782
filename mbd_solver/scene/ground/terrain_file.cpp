// The header is judged before any sample. Samples that are plain numbers are read where a body comes; others, and what is wrong with
// them, take a pass word by word.

#include "mbd_solver/scene/resolve.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "coupler/base/concat.h"
#include "coupler/base/errors.h"
#include "coupler/base/input_file.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/number_file.h"
#include "mbd_solver/scene/codes.h"

namespace footfall {
namespace {

constexpr double kMostMapSamples = 3e7;                        // 5400 x 5400, 240 MB
constexpr std::uint64_t kLargestMap = std::uint64_t{2} << 30;  // [bytes]
constexpr double kEvenGrid = 0.01;                             // of a step: places of samples agree with a regular grid
constexpr double kMostHeight = 1e8;                            // more is a mark [m, or what height_scale makes m of]
constexpr double kUsualHole = -9999.0, kOtherHole = -32768.0;  // of files that do not tell theirs
constexpr const char* kDecimalPoint = "; a comma separates two numbers: write decimal points, as in 0.5";
constexpr const char* kExpected =
    "expected an ESRI ASCII grid (ncols, nrows, xllcorner, yllcorner, cellsize, then rows of "
    "heights), or lines of x, y, z of a regular grid";
constexpr const char* kFill = "fill the holes first, for example by gdal_fillnodata.py in.tif out.tif";
constexpr const char* kCoarser = "cut or thin it first, for example by gdal_translate -projwin ... -tr 0.1 0.1";

// Words of a text, with the line of each.
class MapWords {
 public:
  MapWords(const std::string& file, std::string_view text)
      : file_(file), begin_(text.data()), at_(begin_), end_(at_ + text.size()), counted_(at_) {}

  void skip_byte_order_mark() {
    if (end_ - at_ >= 3 && std::memcmp(at_, "\xef\xbb\xbf", 3) == 0) at_ += 3;
  }
  template <class... Pieces>
  [[noreturn]] void fail(const Pieces&... what) {
    throw InputError(code::kTerrainMap, file_, ":", line(), ": ", what...);
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
  // The next word as a plain number. False, and nothing is passed, for a hole and all others.
  bool plain_number(double hole, double& value) {
    const char* at = at_;
    while (at < end_ && is_gap(*at)) ++at;
    if (!read_plain_number(at, end_, value) || value == hole || std::abs(value) >= kMostHeight) return false;
    at_ = at;
    return true;
  }
  bool at_comma() const { return at_ < end_ && *at_ == ','; }
  std::string comma_advice() const { return std::find(begin_, end_, ',') < end_ ? kDecimalPoint : ""; }
  // The same text, and what comes behind it.
  void go_on_with(std::string_view text) {
    const std::ptrdiff_t at = at_ - begin_, counted = counted_ - begin_;
    begin_ = text.data();
    at_ = begin_ + at;
    counted_ = begin_ + counted;
    end_ = begin_ + text.size();
  }
  std::size_t passed() const { return static_cast<std::size_t>(at_ - begin_); }  // bytes
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
  static bool is_gap(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == ',' || c == ';'; }

  const std::string& file_;
  const char* begin_;
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
    words.fail("the map has ", columns, " columns and ", rows,
               " rows, expected at least 2 of each: one row has no slope across it");
  if (!(columns * rows <= kMostMapSamples))
    words.fail("the map has ", number_text(columns * rows, 4), " samples, expected at most ",
               number_text(kMostMapSamples, 2), "; ", kCoarser);
}

struct EsriHeader {
  std::map<std::string, double> values;  // by key, in small letters
  std::map<std::string, int> lines;
  int line = 1;  // the last
  bool has(const std::string& key) const { return values.count(key) > 0; }
  double of(const std::string& key) const { return has(key) ? values.at(key) : 0.0; }
  int line_of(const std::string& key) const { return has(key) ? lines.at(key) : line; }
};

EsriHeader read_header(MapWords& words) {
  static const std::set<std::string> kKeys = {"ncols",     "nrows",    "xllcorner", "xllcenter", "yllcorner",
                                              "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};
  EsriHeader header;
  for (double first; !words.number(words.peek(), first);) {
    const std::string_view key = words.next();
    std::string name(key.substr(0, 20));
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    if (name.empty()) break;
    const std::string_view word = words.next(true);
    double value = 0.0;
    if (kKeys.count(name) == 0) words.fail("the header has the unknown key ", shown(key), "; ", kExpected);
    if (!words.number(word, value) || (!std::isfinite(value) && name != "nodata_value"))
      words.fail("the header has ", shown(key), " with the value ", shown(word), ", expected a number; ", kExpected);
    if (words.at_comma()) words.fail("the header has ", shown(key), " with a comma", kDecimalPoint);
    header.line = words.line();
    header.lines[name] = header.line;
    if (!header.values.emplace(name, value).second)
      words.fail("the header gives ", shown(key), " a second time; keep one of the two");
    for (const auto& [one, other] :
         {std::pair{"xllcorner", "xllcenter"}, {"yllcorner", "yllcenter"}, {"cellsize", "dx"}, {"cellsize", "dy"}})
      if (header.has(one) && header.has(other))
        words.fail("the header gives ", one, " and ", other, "; keep one of the two");
  }
  return header;
}

RawMap read_esri(MapWords& words, std::shared_ptr<NumberFile> file) {
  const EsriHeader header = read_header(words);
  const double columns = header.of("ncols"), rows = header.of("nrows");
  const double dx = header.of(header.has("cellsize") ? "cellsize" : "dx"),
               dy = header.of(header.has("cellsize") ? "cellsize" : "dy");
  const bool has_hole = header.has("nodata_value");
  const double hole = has_hole ? header.of("nodata_value") : kUsualHole;
  const auto is_hole = [hole](double value) { return value == hole || (std::isnan(value) && std::isnan(hole)); };
  const auto demand = [&](bool good, const std::string& what) {
    if (good) return;
    words.set_line(header.line);
    words.fail("the header has no ", what, "; ", kExpected);
  };
  demand(header.has("ncols"), "ncols");
  demand(header.has("nrows"), "nrows");
  demand(header.has("xllcorner") || header.has("xllcenter"), "xllcorner or xllcenter");
  demand(header.has("yllcorner") || header.has("yllcenter"), "yllcorner or yllcenter");
  demand(header.has("cellsize") || (header.has("dx") && header.has("dy")), "cellsize, or not both of dx and dy");
  const std::string along_x = header.has("cellsize") ? "cellsize" : "dx";
  words.set_line(header.line_of(dx > 0.0 && !header.has("cellsize") ? "dy" : along_x));
  if (!(dx > 0.0 && dy > 0.0)) words.fail("the header has cells of ", dx, " by ", dy, " m, expected sizes above 0");
  const bool whole_columns = columns == std::floor(columns);
  words.set_line(
      header.line_of(whole_columns && columns >= 2.0 && (rows < 2.0 || rows != std::floor(rows)) ? "nrows" : "ncols"));
  if (!whole_columns || rows != std::floor(rows))
    words.fail("the header has ", columns, " columns and ", rows, " rows, expected whole numbers");
  judge_size(words, columns, rows);
  words.set_line(header.line);
  RawMap map;
  map.grid.columns = static_cast<int>(columns);
  map.grid.rows = static_cast<int>(rows);
  map.grid.step = {dx, dy};
  map.x = header.has("xllcorner") ? header.of("xllcorner") + 0.5 * dx : header.of("xllcenter");
  map.y = header.has("yllcorner") ? header.of("yllcorner") + 0.5 * dy : header.of("yllcenter");
  const std::size_t count = static_cast<std::size_t>(map.grid.columns) * static_cast<std::size_t>(map.grid.rows);
  if (file->judge(words.passed(), count, hole)) {
    map.grid.numbers = [numbers = std::shared_ptr<const NumberFile>(std::move(file))](
                           std::size_t first, std::size_t n, double* out) { numbers->read(first, n, out); };
    return map;
  }
  words.go_on_with(file->whole());
  map.grid.heights.resize(count);
  // From the north; words count, as other programs break lines where they like.
  for (int row = map.grid.rows - 1; row >= 0; --row) {
    double* const heights =
        &map.grid.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.grid.columns)];
    for (int column = 0; column < map.grid.columns; ++column) {
      if (words.plain_number(hole, heights[column])) continue;
      const std::string_view word = words.next();
      const auto where = [&] { return concat("row ", map.grid.rows - row, " from the top, column ", column + 1); };
      if (word.empty())
        words.fail("the file ends in ", where(), "; the header promises ", rows, " rows of ", columns, " heights");
      double& value = heights[column];
      const bool number = words.number(word, value);
      if (number && is_hole(value))
        words.fail(where(), " is a hole (", has_hole ? "NODATA_value " : "", shown(word), "); ", kFill);
      if (!number || !(std::abs(value) < kMostHeight))
        words.fail(where(), " is ", shown(word), ", expected a height [m]; ", kFill);
    }
  }
  if (!words.peek().empty()) {
    words.next();
    words.fail("there are more heights than ncols times nrows = ", columns * rows, words.comma_advice());
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
      if (word.empty()) words.fail("has ", k, " numbers, expected x, y and z; ", kExpected);
      if (!words.number(word, values[k]) || !std::isfinite(values[k]))
        words.fail("has ", shown(word), ", expected a number; ", k == 2 ? kFill : kExpected);
      if (k == 2 && (!(std::abs(values[k]) < kMostHeight) || values[k] == kUsualHole || values[k] == kOtherHole))
        words.fail("has the height ", shown(word), ", which marks a hole; ", kFill);
    }
    if (const std::string_view more = words.next(true); !more.empty())
      words.fail("has more than three numbers, expected x, y and z", words.comma_advice(), "; ", kExpected);
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
      words.fail("the place (", number_text(x[k], 12), ", ", number_text(y[k], 12),
                 ") is not on the regular grid of the others, with steps of ", number_text(dx, 6), " and ",
                 number_text(dy, 6), " m; make one, for example by gdal_grid or gdalwarp -tr");
    double& height = map.grid.heights[static_cast<std::size_t>(std::lround(j)) * along_x.size() +
                                      static_cast<std::size_t>(std::lround(i))];
    if (!std::isnan(height))
      words.fail("the place (", number_text(x[k], 12), ", ", number_text(y[k], 12), ") is given twice; remove one");
    height = z[k];
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (!std::isnan(map.grid.heights[k])) continue;
    const double row = static_cast<double>(k / along_x.size()), column = static_cast<double>(k % along_x.size());
    words.fail("the map has a hole at x = ", number_text(map.x + column * dx, 12),
               ", y = ", number_text(map.y + row * dy, 12), " (", static_cast<double>(count - z.size()), " in all); ",
               kFill);
  }
  return map;
}

}  // namespace

std::shared_ptr<const HeightGrid> read_height_map(const TerrainMapSpec& spec) {
  const std::string name = std::filesystem::path(spec.file).filename().string();
  require_regular_file(spec.file, kLargestMap);
  std::shared_ptr<NumberFile> file = NumberFile::open(spec.file);
  if (!file) throw InputError(code::kFileNotReadable, spec.file + ": cannot be read; " + kExpected);
  std::string_view text = file->head();
  MapWords words(name, text);
  words.skip_byte_order_mark();
  double number;
  const auto begins = [&](const char* bytes) { return text.substr(0, 2) == bytes; };
  if (begins("\xff\xfe") || begins("\xfe\xff"))
    words.fail("the file is UTF-16, expected plain text: iconv -f UTF-16 -t UTF-8 in.asc > out.asc turns it into that");
  if (begins("\x1f\x8b") || begins("PK") || begins("BZ"))
    words.fail("the file is compressed, expected plain text; unpack it first, for example by gunzip");
  const std::string_view first = words.peek();
  if (first.empty()) words.fail(std::string("the file is empty; ") + kExpected);
  if (text.find('\0') != std::string::npos)
    words.fail("the file is not text; ", kExpected,
               "; gdal_translate -of AAIGrid in.tif out.asc turns a map of GDAL into one");
  const bool points = words.number(first, number) || first == "x" || first == "X" || first == "\"x\"" || first == "#";
  if (points) words.go_on_with(file->whole());
  RawMap map = points ? read_points(words) : read_esri(words, file);
  HeightGrid& grid = map.grid;
  // Without an origin of its own the middle of the map, and the height of the sample there.
  const Eigen::Vector3d middle(map.x + (grid.columns / 2) * grid.step.x(), map.y + (grid.rows / 2) * grid.step.y(),
                               grid.at(grid.columns / 2, grid.rows / 2));
  const Eigen::Vector3d origin = spec.origin.value_or(middle);
  grid.first = {map.x - origin.x(), map.y - origin.y()};
  grid.below = origin.z();
  grid.scale = spec.height_scale;
  for (double& height : grid.heights) height = (height - grid.below) * grid.scale;
  return std::make_shared<const HeightGrid>(std::move(grid));
}

}  // namespace footfall
