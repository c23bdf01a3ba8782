#pragma once
// Inside of a FuzzySystem: FuzzyLite's engine, read and checked by fuzzy_reader.cpp, evaluated by fuzzy.cpp. The only
// file that includes FuzzyLite.

#include <fl/Headers.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "mbd_solver/model/controllers/fll_text.h"
#include "mbd_solver/model/controllers/fuzzy.h"
#include "mbd_solver/model/controllers/mamdani_grid.h"

namespace footfall {

// FuzzyLite's engine with the variables and rules of a file. Throws InputError "file:line: ...".
std::unique_ptr<fl::Engine> read_fuzzy_engine(const std::string& file, const std::vector<FllBlock>& blocks);

struct FuzzySystem::Engine {
  std::unique_ptr<fl::Engine> engine;
  std::array<fl::InputVariable*, kFuzzyInputs> input{};  // in the order of FuzzyInput
  std::vector<fl::OutputVariable*> output;
  FuzzyInput lower{}, upper{};
  std::optional<MamdaniSystem> plain;  // the same rules for the fast grid, if they are that simple

  // Throw InputError "file:line: ...".
  void take_variables(const std::string& file, const std::vector<FllBlock>& blocks);
  void check_coverage(const std::string& file) const;

  // The ends of an input's range and, rising between them, the corners of its terms. `complete` is false if a term has a
  // shape without corners.
  std::vector<double> corners(std::size_t input_index, bool& complete) const;
  std::optional<MamdaniSystem> plain_system() const;
  void set_inputs(const FuzzyInput& value) const {
    for (std::size_t i = 0; i < kFuzzyInputs; ++i) input[i]->setValue(std::clamp(value[i], lower[i], upper[i]));
  }
};

}  // namespace footfall
