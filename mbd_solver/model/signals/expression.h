#pragma once
// An arithmetic or logical expression of named values, "0.3 - knee.angle", by muParser: + - * / ^, < <= > >= == !=, && ||,
// c ? a : b, min, max, abs, sqrt, exp, ln, sin ... atan2, pi. True is 1, false is 0.

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace mu {
class Parser;
}

namespace footfall {

using NamedValues = std::map<std::string, double>;  // a map keeps its places

class Expression {
 public:
  // The names that a text reads, in alphabetical order. Throws InputError: what is wrong with it, and where.
  static std::vector<std::string> names_in(const std::string& text);

  // Reads the values where they stand; all its names are among them, and stay there. Throws as names_in.
  Expression(std::string text, NamedValues& values);
  ~Expression();
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;

  // Of the values now. Throws NumericalError where it has none (a division by zero, the root of a negative number), with
  // the values of its names.
  double value() const;
  const std::string& text() const { return text_; }

 private:
  [[noreturn]] void complain_of_no_value() const;

  std::string text_;
  std::unique_ptr<mu::Parser> parser_;
};

}  // namespace footfall
