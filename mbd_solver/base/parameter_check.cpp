// Range checks that all end in one message.

#include "mbd_solver/base/parameter_check.h"

#include <cmath>
#include <string>

#include "coupler/base/concat.h"
#include "coupler/base/errors.h"
#include "mbd_solver/base/codes.h"

namespace footfall {
namespace {

[[noreturn]] void refuse(std::string_view law, std::string_view name, double value, std::string_view unit,
                         const std::string& expected) {
  const std::string suffix = unit.empty() ? std::string() : concat(" ", unit);
  throw InputError(code::kParameterOutOfRange, law, ": ", name, " is ", value, suffix, "; expected ", expected, suffix,
                   ".");
}

}  // namespace

void require_positive(std::string_view law, std::string_view name, double value, std::string_view unit) {
  if (!(std::isfinite(value) && value > 0.0)) refuse(law, name, value, unit, "a number above 0");
}

void require_not_negative(std::string_view law, std::string_view name, double value, std::string_view unit) {
  if (!(std::isfinite(value) && value >= 0.0)) refuse(law, name, value, unit, "a number of at least 0");
}

void require_finite(std::string_view law, std::string_view name, double value, std::string_view unit) {
  if (!std::isfinite(value)) refuse(law, name, value, unit, "a finite number");
}

void require_within(std::string_view law, std::string_view name, double value, double low, double high,
                    std::string_view unit) {
  if (!(value >= low && value <= high)) refuse(law, name, value, unit, concat("a number from ", low, " to ", high));
}

}  // namespace footfall
