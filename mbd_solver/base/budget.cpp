// One message for all limits.

#include "mbd_solver/base/budget.h"

#include <algorithm>

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

}  // namespace footfall
