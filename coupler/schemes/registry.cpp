// The table of schemes.

#include "coupler/schemes/registry.h"

#include "coupler/base/errors.h"
#include "coupler/codes.h"
#include "coupler/schemes/constant_load.h"
#include "coupler/schemes/tangent.h"

namespace footfall {
namespace {

struct Entry {
  std::string_view name;
  std::unique_ptr<Scheme> (*make)();
};

template <class OneScheme>
constexpr Entry entry() {
  return {OneScheme::kName, [] { return std::unique_ptr<Scheme>(std::make_unique<OneScheme>()); }};
}

// In the order in which tables show them.
constexpr Entry kSchemes[] = {entry<CssTrapezoid>(), entry<Css>(), entry<Quadratic>(), entry<Tangent>(),
                              entry<Frozen>()};

static_assert(kDefaultScheme == CssTrapezoid::kName, "the default must be in the list");

}  // namespace

std::unique_ptr<Scheme> make_scheme(std::string_view name) {
  std::string known;
  for (const Entry& one : kSchemes) {
    if (one.name == name) return one.make();
    known += (known.empty() ? "" : ", ") + std::string(one.name);
  }
  throw InputError(code::kUnknownScheme,
                   "unknown coupling scheme \"" + std::string(name) + "\". Known schemes: " + known + ".");
}

const std::vector<std::string>& scheme_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Entry& one : kSchemes) all.emplace_back(one.name);
    return all;
  }();
  return names;
}

}  // namespace footfall
