// A Nastran card joins its lines as long as they are continuations.

#include "mbd_solver/fe/model_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <optional>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/codes.h"

namespace footfall {

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string bytes_of_model(const std::string& path) {
  if (std::optional<std::string> bytes = read_whole_file(path)) return *std::move(bytes);
  throw InputError(code::kModelFile,
                   path + ": the file cannot be read. Check the name; it is relative to the scene file.");
}

ModelText::ModelText(std::string bytes, std::string name)
    : TextReader(std::move(bytes), std::move(name), code::kModelFile) {}

std::vector<std::string> ModelText::cells() {
  const std::vector<std::string_view>& cells =
      fields(line().find(',') == std::string::npos ? Separators::kBlanks : Separators::kComma);
  std::size_t count = cells.size();
  while (count > 0 && cells[count - 1].empty()) --count;
  return {cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(count)};
}

double ModelText::number(std::string_view word) const {
  double value = 0.0;
  bool is_number = read_number(word, value);
  if (const std::size_t at = is_number ? std::string_view::npos : word.find_first_of("dD+-", 1);
      at != std::string_view::npos) {  // an exponent after D, or after its sign alone
    std::string plain(word);
    word[at] == '+' || word[at] == '-' ? plain.insert(at, 1, 'e') : plain.replace(at, 1, 1, 'e');
    is_number = read_number(plain, value);
  }
  return is_number && std::isfinite(value) ? value : TextReader::number(word);
}

namespace {

constexpr std::size_t kSmallField = 8, kLargeField = 16;
constexpr std::size_t kLongestCard = 100000;  // fields; longer ones are no cards

// Fields of one line of a card: its name or mark, then the data.
std::vector<std::string> fields_of_line(const std::string& given, bool& large) {
  const std::string line = given.substr(0, given.find('$'));
  std::vector<std::string> fields;
  if (line.find(',') != std::string::npos) {
    fields = split(line, ',');
    for (std::string& field : fields) field = trimmed(field);
    large = !fields[0].empty() && fields[0].back() == '*';
    fields.resize(std::min(fields.size(), large ? std::size_t{5} : std::size_t{9}));
    return fields;
  }
  std::string expanded;
  for (const char c : line) {
    if (c != '\t') {
      expanded += c;
    } else {
      expanded.append(kSmallField - expanded.size() % kSmallField, ' ');
    }
  }
  fields.push_back(trimmed(expanded.substr(0, kSmallField)));
  large = !fields[0].empty() && (fields[0].back() == '*' || fields[0][0] == '*');
  const std::size_t width = large ? kLargeField : kSmallField, most = large ? 4 : 8;
  for (std::size_t i = 0; i < most && kSmallField + i * width < expanded.size(); ++i)
    fields.push_back(trimmed(expanded.substr(kSmallField + i * width, width)));
  return fields;
}

bool continues(const std::string& line) {
  if (line.empty()) return false;
  const std::size_t from = line.find_first_not_of(" \t");
  if (from == std::string::npos) return false;
  if (line[from] == '+' || line[from] == '*') return true;
  if (line[from] == ',') return true;
  return line[0] == '\t' || line.compare(0, kSmallField, std::string(kSmallField, ' ')) == 0;
}

}  // namespace

bool NastranCards::next() {
  fields_.clear();
  while (fields_.empty()) {
    if (!text_.next()) return false;
    const std::string& line = text_.line();
    const std::size_t from = line.find_first_not_of(" \t");
    if (from == std::string::npos || line[from] == '$' || continues(line)) continue;
    line_ = trimmed(line);
    if (upper_case(line_.substr(0, std::strlen("INCLUDE"))) == "INCLUDE") {  // wherever it begins
      fields_ = {"INCLUDE"};
      return true;
    }
    bool large = false;
    fields_ = fields_of_line(line, large);
    std::string& name = fields_[0];
    name = upper_case(name.substr(0, name.find_first_of("* \t=")));
    std::size_t filled = fields_.size() - 1, expected = large ? 4 : 8;
    while (text_.next()) {
      const std::string& more = text_.line();
      if (!more.empty() && more[0] == '$') continue;
      if (!continues(more)) {
        text_.back();
        break;
      }
      bool is_large = false;
      const std::vector<std::string> fields = fields_of_line(more, is_large);
      for (; filled < expected; ++filled) fields_.emplace_back();  // empty fields at the end of the line before
      fields_.insert(fields_.end(), fields.begin() + 1, fields.end());
      filled = fields.size() - 1;
      expected = is_large ? 4 : 8;
      if (fields_.size() > kLongestCard) fail("a card of more than " + std::to_string(kLongestCard) + " fields.");
    }
  }
  return true;
}

double NastranCards::number(std::size_t i, double otherwise) const {
  return given(i) ? text_.number(fields_[i]) : otherwise;
}

long NastranCards::whole(std::size_t i, long low, long high) const {
  if (!given(i)) fail(fields_[0] + ": field " + std::to_string(i + 1) + " is empty, expected a whole number.");
  return text_.whole(fields_[i], low, high);
}

}  // namespace footfall
