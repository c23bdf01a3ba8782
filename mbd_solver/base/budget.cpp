// One message for all limits. Lines are read in pieces, so that a file without line ends is not read whole.

#include "mbd_solver/base/budget.h"

#include <algorithm>
#include <array>

#include "coupler/base/errors.h"
#include "mbd_solver/base/codes.h"

namespace footfall {

std::string ReadBudget::excess() const {
  const std::string most = limit_.bytes ? std::to_string(most_ / limit::kMegabyte) + " MB" : std::to_string(most_);
  return "has more than " + most + " " + limit_.what + ", the most that is read; " + limit_.remedy;
}

void ReadBudget::fail() const { throw InputError(code::kReadLimit, place_ + ": " + excess()); }

std::uint64_t xml_parts(std::string_view text) {
  return static_cast<std::uint64_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return c == '<' || c == '='; }));
}

bool read_line(std::istream& in, std::string& line, const std::string& file) {
  line.clear();
  std::array<char, 4096> piece;
  ReadBudget bytes(limit::kLine, file);
  while (in.good()) {
    in.getline(piece.data(), piece.size());
    const auto count = static_cast<std::size_t>(in.gcount());
    const bool whole = !in.fail();  // a full piece sets failbit; so does an end at once
    const std::size_t text = whole && !in.eof() ? count - 1 : count;  // the line end is counted
    bytes.take(text);
    line.append(piece.data(), text);
    if (whole) return true;
    if (in.eof() || in.bad()) return false;
    in.clear();
  }
  return false;
}

}  // namespace footfall
