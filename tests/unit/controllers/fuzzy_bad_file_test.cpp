// mbd_solver/model/controllers/fll_text.h:
// every kind of broken .fll file must be named with its line, what was expected and what to do.
#include <gtest/gtest.h>

#include <algorithm>

#include "coupler/base/errors.h"
#include "tests/unit/controllers/fuzzy_files.h"

namespace footfall {
namespace {

int line_of(const std::string& text, const std::string& what) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << "the lander's file no longer has: " << what;
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

// Loads the lander's file with `what` replaced by `with`; the message must name the file, the line of the
// change (0: none), and `part`.
void expect_refused(const std::string& what, const std::string& with, bool has_line, const std::string& part) {
  const std::string text = lander_text();
  const TemporaryFll file(replaced(text, what, with));
  const int line = line_of(text, what);
  try {
    FuzzySystem system(file.path);
    ADD_FAILURE() << "accepted: " << with;
  } catch (const InputError& error) {
    const std::string message = error.what();
    const std::string where = file.path.string() + (has_line ? ":" + std::to_string(line) + ": " : ": ");
    EXPECT_EQ(message.substr(0, where.size()), where) << message;
    EXPECT_NE(message.find(part), std::string::npos) << "message: " << message << "\nshould contain: " << part;
  }
}

TEST(FuzzyBadFile, MalformedLine) {
  expect_refused("  range: 0 5\n", "  range 0 5\n", true, "has no colon");
  expect_refused("  range: 0 5\n", "  rnage: 0 5\n", true, "unknown key \"rnage\" in InputVariable \"a\". Known keys:");
  expect_refused("  range: 0 5\n", "  range: 0 five\n", true, "is not understood");
  expect_refused("  term: S Triangle 0 1.6667 3.3333\n", "  term: S Trinagle 0 1.6667 3.3333\n", true,
                 "is not understood");
  expect_refused("  term: S Triangle 0 1.6667 3.3333\n", "  term: Z Triangle 0 1.6667 3.3333\n", true,
                 "already defined in line");
  expect_refused("  defuzzifier: Centroid 140\n", "  defuzzifier: Centre 140\n", true, "is not understood");
  expect_refused("Engine: lander\n", "name: lander\n", true, "stands before any block");
}

TEST(FuzzyBadFile, MissingOrUnknownVariable) {
  const auto message = [](const std::string& text) {
    const TemporaryFll file(text);
    try {
      FuzzySystem system(file.path);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto expect_contains = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << "message: " << text << "\nshould contain: " << part;
  };
  expect_contains(message(replaced(replaced(lander_text(), "InputVariable: alpha", "InputVariable: pitch"), "alpha is",
                                   "pitch is", true)),
                  "there is no InputVariable \"alpha\"; expected a, da, alpha and beta. Found: a, da, pitch, beta");
  expect_contains(
      message(replaced(replaced(lander_text(), "OutputVariable: U2", "OutputVariable: V2"), "U2 is", "V2 is", true)),
      "OutputVariable \"V2\" is output number 2; expected the outputs U1, U2, ...");
  expect_refused("InputVariable: a\n", "InputVariable: speed\n  range: 0 1\n  term: Z Ramp 0 1\nInputVariable: a\n",
                 true, "is not measured");
  expect_refused("InputVariable: beta\n", "InputVariable: alpha\n", true, "already defined in line");
}

TEST(FuzzyBadFile, RuleThatNamesWhatDoesNotExist) {
  const std::string rule = "  rule: if a is S and da is B and alpha is Z and beta is Z then";
  expect_refused(rule, "  rule: if a is S and da is B and alpha is Z and beta is Q then", true,
                 "variable \"beta\" has no term \"Q\". Its terms: N, Z, P.");
  expect_refused(rule, "  rule: if a is S and da is B and gamma is Z and beta is Z then", true,
                 "unknown variable \"gamma\". Known variables: a, da");
  expect_refused(rule, "  rule: if a is S and da is B and alpha is Z or then", true, "is not understood");
  expect_refused(rule, "  rule: a is S and da is B and alpha is Z and beta is Z then", true, "is not understood");
}

TEST(FuzzyBadFile, WrongRange) {
  expect_refused("  range: 0 5\n", "  range: 1 5\n", true, "range of \"a\" is 1 to 5; expected 0 to a_max > 0, in g");
  expect_refused("  range: 0 5\n", "  range: 0 -5\n", true, "range of \"a\" is 0 to -5");
  expect_refused("  range: -10 10\n", "  range: -10 20\n", true, "range of \"da\" is -10 to 20; expected -r to r");
  expect_refused("  range: -4 4\n", "  range: 0 4\n", true, "range of \"alpha\"");
  expect_refused("  range: 0 1\n", "  range: 0 2\n", true, "range of \"U1\" is 0 to 2; expected 0 to 1");
}

TEST(FuzzyBadFile, SamplesThatCannotBeTaken) {
  for (const char* integral :
       {"Centroid 0", "Centroid -3", "Centroid 100001", "Centroid 28888888888888888888", "Bisector -1"})
    expect_refused(
        "  defuzzifier: Centroid 140\n", "  defuzzifier: " + std::string(integral) + "\n", true,
        std::string(integral) + "\" of OutputVariable \"U1\" is not understood: expected 1 to 100000 samples.");
}

TEST(FuzzyBadFile, UncoveredRegion) {
  expect_refused("  rule: if a is B and da is B and alpha is P and beta is P then", "  #", false,
                 "no rule fires for U1 at a = 5, da = 10, alpha = 4, beta = 4");
  expect_refused("  term: Z Triangle -4 0 4\n", "  term: Z Triangle 1 2 3\n", false,
                 "no rule fires for U1 at a = 0, da = -10, alpha = 0, beta = -4");
  // A gap of a hundredth of a degree.
  expect_refused("  term: N Ramp 0 -4\n  term: Z Triangle -4 0 4\n",
                 "  term: N Ramp -1.01 -4\n  term: Z Triangle -1 0 4\n", false, "alpha = -1.01, beta");
}

TEST(FuzzyBadFile, HiddenMemoryOrMissingParts) {
  expect_refused("  lock-previous: false\n", "  lock-previous: true\n", true, "a hidden memory could not be resumed");
  expect_refused("  implication: Minimum\n", "  implication: none\n", false, "the controller is not complete");
  const TemporaryFll empty("Engine: nothing\n");
  EXPECT_THROW(FuzzySystem{empty.path}, InputError);
  EXPECT_THROW(FuzzySystem{"no_such_file.fll"}, InputError);
}

}  // namespace
}  // namespace footfall
