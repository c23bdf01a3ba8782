// The common part of both versions: the library, messages, and numbers as integers.

#include "mbd_solver/fmi/fmu_instance.h"

#include <dlfcn.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "coupler/base/text.h"
#include "mbd_solver/fmi/fmu_file.h"

namespace footfall {

FmuLibrary::FmuLibrary(const FmuDescription& description, const std::string& folder) {
  const std::string path = folder + "/" + library_path(description);
  handle_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  const char* const why = handle_ ? nullptr : dlerror();
  if (!handle_) throw FmuError("its library cannot be loaded: " + std::string(why ? why : "unknown reason"));
}

void* FmuLibrary::find(const std::string& name) const { return dlsym(handle_, name.c_str()); }

void FmuLog::add(const std::string& text) {
  constexpr std::size_t kMost = 1000;  // [bytes]
  if (text.empty()) return;
  last_ += (last_.empty() ? "" : "; ") + text;
  if (last_.size() > kMost) last_.erase(0, last_.size() - kMost);
}

template <class Value>
Value value_as(const FmuVariable& variable, double number) {
  const double whole = std::nearbyint(number);
  using Limits = std::numeric_limits<Value>;
  // 2^63 and 2^64 are beyond the largest integers, and the nearest numbers to them.
  const bool inside =
      whole >= static_cast<double>(Limits::min()) &&
      (sizeof(Value) < 8 ? whole <= static_cast<double>(Limits::max()) : whole < static_cast<double>(Limits::max()));
  if (!inside)
    throw FmuError("its variable \"" + variable.name + "\" of the type " + variable.type + " cannot be " +
                   number_text(number));
  return static_cast<Value>(whole);
}

template std::int8_t value_as(const FmuVariable&, double);
template std::uint8_t value_as(const FmuVariable&, double);
template std::int16_t value_as(const FmuVariable&, double);
template std::uint16_t value_as(const FmuVariable&, double);
template std::int32_t value_as(const FmuVariable&, double);
template std::uint32_t value_as(const FmuVariable&, double);
template std::int64_t value_as(const FmuVariable&, double);
template std::uint64_t value_as(const FmuVariable&, double);
template <>
double value_as(const FmuVariable&, double number) {
  return number;
}
template <>
float value_as(const FmuVariable&, double number) {
  return static_cast<float>(number);
}
template <>
bool value_as(const FmuVariable&, double number) {
  return number != 0.0;
}

}  // namespace footfall
