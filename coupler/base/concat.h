#pragma once
// Texts of messages in pieces.

#include <string>
#include <type_traits>

#include "coupler/base/text.h"

namespace footfall {

// The pieces in one text: texts, letters, and numbers; those of double precision as number_text writes them.
template <class... Pieces>
std::string concat(const Pieces&... pieces) {
  std::string text;
  const auto add = [&text](const auto& piece) {
    using Piece = std::decay_t<decltype(piece)>;
    static_assert(!std::is_same_v<Piece, bool>, "say what true and false mean");
    if constexpr (std::is_floating_point_v<Piece>)
      text += number_text(piece);
    else if constexpr (std::is_integral_v<Piece> && !std::is_same_v<Piece, char>)
      text += std::to_string(piece);
    else
      text += piece;
  };
  (add(pieces), ...);
  return text;
}

}  // namespace footfall
