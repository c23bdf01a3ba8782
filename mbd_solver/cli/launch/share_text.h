#pragma once
// Shares in what people read.

#include <string>

#include "coupler/base/text.h"

namespace footfall {

// 0.0123 -> "1.2 %".
inline std::string share_text(double share) { return number_text(100.0 * share, 2) + " %"; }

}  // namespace footfall
