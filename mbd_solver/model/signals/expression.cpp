#include "mbd_solver/model/signals/expression.h"

#include <muParser.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

constexpr const char* kNameCharacters = "0123456789_.abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

double opposite(double value) { return value == 0.0 ? 1.0 : 0.0; }

[[noreturn]] void complain(const std::string& text, const std::string& what) {
  throw InputError("\"" + text + "\": " + what);
}

[[noreturn]] void complain_of(const std::string& text, const mu::Parser::exception_type& error) {
  std::string what = error.GetMsg();
  while (!what.empty() && (what.back() == '.' || what.back() == '\n')) what.pop_back();
  complain(text, what + "; expected an expression such as \"0.3 - 2 * knee.angle\"");
}

// muParser takes an assignment and a list for expressions, too.
void demand_one_value(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    const char before = i > 0 ? text[i - 1] : ' ', after = i + 1 < text.size() ? text[i + 1] : ' ';
    if (before == '<' || before == '>' || before == '!' || before == '=' || after == '=') continue;
    complain(text, "sets a value; expected a comparison by ==, or no \"=\"");
  }
}

std::unique_ptr<mu::Parser> parser_of(const std::string& text) {
  demand_one_value(text);
  auto parser = std::make_unique<mu::Parser>();
  parser->DefineNameChars(kNameCharacters);
  parser->DefineConst("pi", kPi);
  parser->DefineInfixOprt("!", opposite);
  parser->SetExpr(text);
  return parser;
}

}  // namespace

std::vector<std::string> Expression::names_in(const std::string& text) {
  std::vector<std::string> names;
  try {
    const std::unique_ptr<mu::Parser> parser = parser_of(text);
    double any = 1.0;
    for (const auto& [name, place] : parser->GetUsedVar()) names.push_back(name);
    for (const std::string& name : names) parser->DefineVar(name, &any);
    parser->Eval();
    if (parser->GetNumResults() != 1) complain(text, "has several values; expected one");
  } catch (const mu::Parser::exception_type& error) {
    complain_of(text, error);
  }
  return names;
}

Expression::Expression(std::string text, NamedValues& values) : text_(std::move(text)) {
  try {
    parser_ = parser_of(text_);
    for (const std::string& name : names_in(text_)) {
      const auto found = values.find(name);
      FOOTFALL_DEMAND(found != values.end());
      parser_->DefineVar(name, &found->second);
    }
    parser_->Eval();  // compiles it
  } catch (const mu::Parser::exception_type& error) {
    complain_of(text_, error);
  }
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

void Expression::complain_of_no_value() const {
  std::vector<std::string> arguments;
  for (const auto& [name, place] : parser_->GetVar()) arguments.push_back(name + " = " + number_text(*place, 4));
  throw NumericalError("\"" + text_ + "\" has no value" + (arguments.empty() ? "" : " where " + joined(arguments)) +
                       "; guard what divides, a root or a logarithm, for example \"x > 0 ? sqrt(x) : 0\"");
}

double Expression::value() const {
  double value = std::nan("");
  try {
    value = parser_->Eval();
  } catch (const mu::Parser::exception_type&) {
  }
  if (!std::isfinite(value)) complain_of_no_value();
  return value;
}

}  // namespace footfall
