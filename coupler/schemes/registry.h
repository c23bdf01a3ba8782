#pragma once
// The coupling schemes by name. registry.cpp alone lists the names that a scene may use.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "coupler/schemes/scheme.h"

namespace footfall {

inline constexpr std::string_view kDefaultScheme = "css-trapezoid";

// Throws InputError for an unknown name; the message lists the known ones.
std::unique_ptr<Scheme> make_scheme(std::string_view name);
const std::vector<std::string>& scheme_names();

}  // namespace footfall
