// Recursive descent, a function per level of precedence: as muParser, a sign binds less than a power.

#include "mbd_solver/model/control/expression_parts.h"
#include "coupler/base/number.h"

#include <cctype>
#include <initializer_list>
#include <utility>

namespace footfall {
namespace {

using PartKind = ExpressionPart::Kind;

struct NotUnderstood {};

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  ExpressionPart whole() {
    ExpressionPart part = choice();
    skip_space();
    if (at_ != text_.size()) throw NotUnderstood{};
    return part;
  }

 private:
  using Level = ExpressionPart (Parser::*)();

  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  // The first of these operators at this place, which is then passed; empty: none.
  std::string accept(std::initializer_list<const char*> operators) {
    skip_space();
    for (const std::string name : operators)
      if (text_.compare(at_, name.size(), name) == 0) {
        at_ += name.size();
        return name;
      }
    return {};
  }
  ExpressionPart made(PartKind kind, std::string name, std::size_t begin, std::vector<ExpressionPart> parts) const {
    return {kind, std::move(name), text_.substr(begin, at_ - begin), std::move(parts)};
  }
  // Operators of one level, from the left.
  ExpressionPart chain(PartKind kind, std::initializer_list<const char*> operators, Level next) {
    skip_space();
    const std::size_t begin = at_;
    ExpressionPart left = (this->*next)();
    for (std::string name = accept(operators); !name.empty(); name = accept(operators)) {
      ExpressionPart right = (this->*next)();
      left = made(kind, name, begin, {std::move(left), std::move(right)});
    }
    return left;
  }

  ExpressionPart choice() {
    skip_space();
    const std::size_t begin = at_;
    ExpressionPart condition = any_of();
    if (accept({"?"}).empty()) return condition;
    ExpressionPart then = choice();
    if (accept({":"}).empty()) throw NotUnderstood{};
    ExpressionPart otherwise = choice();
    return made(PartKind::kChoice, "?", begin, {std::move(condition), std::move(then), std::move(otherwise)});
  }
  ExpressionPart any_of() { return chain(PartKind::kLogic, {"||"}, &Parser::all_of); }
  ExpressionPart all_of() { return chain(PartKind::kLogic, {"&&"}, &Parser::comparison); }
  ExpressionPart comparison() { return chain(PartKind::kCompare, {"<=", ">=", "==", "!=", "<", ">"}, &Parser::sum); }
  ExpressionPart sum() { return chain(PartKind::kSum, {"+", "-"}, &Parser::product); }
  ExpressionPart product() { return chain(PartKind::kProduct, {"*", "/"}, &Parser::prefixed); }
  ExpressionPart prefixed() {
    skip_space();
    const std::size_t begin = at_;
    const std::string name = accept({"-", "+", "!"});
    if (name.empty()) return power();
    ExpressionPart operand = prefixed();
    return made(PartKind::kPrefix, name, begin, {std::move(operand)});
  }
  ExpressionPart power() {
    skip_space();
    const std::size_t begin = at_;
    ExpressionPart base = primary();
    if (accept({"^"}).empty()) return base;
    ExpressionPart exponent = prefixed();
    return made(PartKind::kPower, "^", begin, {std::move(base), std::move(exponent)});
  }
  ExpressionPart primary() {
    skip_space();
    const std::size_t begin = at_;
    if (!accept({"("}).empty()) {
      ExpressionPart inside = choice();
      if (accept({")"}).empty()) throw NotUnderstood{};
      inside.text = text_.substr(begin, at_ - begin);
      return inside;
    }
    if (const std::size_t digits = number_length(); digits > 0) {
      at_ += digits;
      return made(PartKind::kNumber, {}, begin, {});
    }
    while (is_of_name()) ++at_;
    if (at_ == begin) throw NotUnderstood{};
    const std::string name = text_.substr(begin, at_ - begin);
    if (accept({"("}).empty()) {
      at_ = begin + name.size();
      return made(PartKind::kName, name, begin, {});
    }
    std::vector<ExpressionPart> arguments;
    do arguments.push_back(choice());
    while (!accept({","}).empty());
    if (accept({")"}).empty()) throw NotUnderstood{};
    return made(PartKind::kCall, name, begin, std::move(arguments));
  }

  bool is_of_name() const {
    if (at_ >= text_.size()) return false;
    const char c = text_[at_];
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
  }
  std::size_t number_length() const {
    if (at_ >= text_.size()) return 0;
    if (const char c = text_[at_]; std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '.') return 0;
    char* end = nullptr;
    read_number(text_.c_str() + at_, &end);
    return static_cast<std::size_t>(end - (text_.c_str() + at_));
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<ExpressionPart> parts_of(const std::string& text) {
  try {
    return Parser(text).whole();
  } catch (const NotUnderstood&) {
    return std::nullopt;
  }
}

}  // namespace footfall
