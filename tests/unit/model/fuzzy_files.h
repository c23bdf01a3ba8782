#pragma once
// The lander's controller and altered copies of it, for the tests of the fuzzy system.

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

#include "mbd_solver/assemble/law_files.h"
#include "mbd_solver/model/control/fuzzy.h"
#include "tests/support/temporary_folder.h"

namespace footfall {

inline std::filesystem::path lander_file() {
  return std::string(FOOTFALL_SOURCE_DIR) + "/inputs/controllers/lander.fll";
}

inline const FuzzySystem& lander() {
  static const FuzzySystem system(read_fll(lander_file()));
  return system;
}

inline std::string lander_text() {
  std::ifstream in(lander_file());
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// A .fll file that disappears with the test.
struct TemporaryFll : TemporaryFolder {
  explicit TemporaryFll(const std::string& text) : path(write("controller.fll", text)) {}
  std::filesystem::path path;
};

inline std::string replaced(std::string text, const std::string& what, const std::string& with, bool all = false) {
  if (text.find(what) == std::string::npos) throw std::logic_error("the controller's file no longer has: " + what);
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
    if (!all) break;
  }
  return text;
}

inline FuzzyInput random_input(const FuzzySystem& system, std::mt19937_64& generator) {
  FuzzyInput x{};
  for (std::size_t i = 0; i < kFuzzyInputs; ++i)
    x[i] = std::uniform_real_distribution<double>(system.lower()[i], system.upper()[i])(generator);
  return x;
}

inline Eigen::VectorXd voltages(const FuzzySystem& system, const FuzzyInput& input) {
  Eigen::VectorXd u(system.output_count());
  system.evaluate(input, u);
  return u;
}

}  // namespace footfall
