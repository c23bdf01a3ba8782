#pragma once
// Codes of the messages of fe/ alone: W1322 to W0329. Others: mbd_solver/model/codes.h.

#include "coupler/base/errors.h"

namespace footfall::code {

// The modes with stresses of another code do not span the modes of the body. Write more of them.
inline constexpr MessageCode kStressModes{"W1322", "stress-modes"};

}  // namespace footfall::code
