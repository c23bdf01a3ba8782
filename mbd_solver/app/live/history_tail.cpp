// Reads from where the last call ended up to the last complete line. The file may be replaced or cut between two calls.
#include "mbd_solver/app/live/history_tail.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/base/text_reader.h"

namespace footfall {

std::vector<double> row_values(const std::string& line, std::size_t count, const std::string& file) {
  std::vector<double> values;
  values.reserve(count);
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    const std::string_view cell = std::string_view(line).substr(from, comma - from);
    if (!read_number(cell, values.emplace_back()))
      throw InputError(code::kRunDamaged, file + ": " + in_quotes(cell) + " in the last row, expected a number");
    from = comma + 1;
  }
  if (values.size() != count)
    throw InputError(code::kRunDamaged, file + ": its last row has " + std::to_string(values.size()) +
                                            " values, expected " + std::to_string(count));
  return values;
}

void HistoryTail::read_head(const std::string& text) {
  const std::size_t first = text.find('\n'), second = first == std::string::npos ? first : text.find('\n', first + 1);
  if (second == std::string::npos) return;
  const std::string mark = "# units: ";
  units_ = split(text.substr(std::min(first, mark.size()), first - std::min(first, mark.size())), ',');
  names_ = split(text.substr(first + 1, second - first - 1), ',');
  read_ = second + 1;
}

std::string HistoryTail::read(std::size_t most) {
  std::error_code gone;
  const std::uintmax_t size = std::filesystem::file_size(file_, gone);
  if (gone) return "";
  if (size < read_) *this = HistoryTail(file_);  // another run has begun in this folder
  std::ifstream in(file_, std::ios::binary);
  if (names_.empty()) {
    constexpr std::uintmax_t kLongestHead = 1 << 20;
    std::string head(std::min(size, kLongestHead), '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(std::max<std::streamsize>(in.gcount(), 0));
    in.clear();
    read_head(head);
    if (names_.empty()) return "";
  }
  std::string text(std::min<std::uintmax_t>(size - read_, most), '\0');
  in.seekg(static_cast<std::streamoff>(read_));
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(std::max<std::streamsize>(in.gcount(), 0));
  text.resize(text.rfind('\n') + 1);  // 0 where there is no complete line
  if (text.empty()) return text;
  read_ += text.size();
  rows_ += std::count(text.begin(), text.end(), '\n');
  const std::size_t before = text.size() > 1 ? text.rfind('\n', text.size() - 2) : std::string::npos;
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  last_line_ = text.substr(start, text.size() - 1 - start);
  return text;
}

LastRow HistoryTail::last() const {
  LastRow row{names_, {}, rows_};
  if (rows_ > 0) row.values = row_values(last_line_, names_.size(), file_);
  return row;
}

}  // namespace footfall
