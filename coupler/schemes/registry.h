#pragma once
// The list of the coupling schemes: every name that a scene may give stands in registry.cpp, and nowhere else.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "coupler/schemes/scheme.h"

namespace footfall {

inline constexpr std::string_view kDefaultScheme = "css-trapezoid";

// Throws InputError for a name that is not in the list, naming all that are.
std::unique_ptr<Scheme> make_scheme(std::string_view name);
const std::vector<std::string>& scheme_names();

}  // namespace footfall
