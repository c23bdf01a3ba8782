#pragma once
// The structure of an expression, for finding the times at which it has corners.

#include <optional>
#include <string>
#include <vector>

namespace footfall {

struct ExpressionPart {
  enum class Kind {
    kNumber,
    kName,     // a value or a constant
    kCall,     // name(parts...)
    kChoice,   // parts[0] ? parts[1] : parts[2]
    kLogic,    // && ||
    kCompare,  // < <= > >= == !=
    kSum,      // + -
    kProduct,  // * /
    kPower,    // ^
    kPrefix    // - + !
  };
  Kind kind = Kind::kNumber;
  std::string name;  // of value, function or operator
  std::string text;  // an expression by itself
  std::vector<ExpressionPart> parts;
};

// Nothing for a text that the grammar of Expression (signal_chain.h) does not contain.
std::optional<ExpressionPart> parts_of(const std::string& text);

}  // namespace footfall
