#pragma once
// One output of a FuzzyLite file (.fll) over any inputs, in the units of the file. Inputs outside their range are cut to
// it. No memory: lock-previous must be false.

#include <Eigen/Dense>
#include <filesystem>
#include <memory>
#include <string>

namespace footfall {

class FuzzyFunction {
 public:
  // inputs: how many there shall be, in the order of the file's input variables. output: name of an output variable;
  // empty: the only one. Throws InputError "file:line: ...".
  FuzzyFunction(const std::filesystem::path& file, std::size_t inputs, const std::string& output);
  ~FuzzyFunction();

  // Throws NumericalError where no rule fires.
  double value(const Eigen::Ref<const Eigen::VectorXd>& inputs) const;

 private:
  struct Parts;  // FuzzyLite's engine keeps its last values inside: one thread at a time
  std::unique_ptr<Parts> parts_;
};

}  // namespace footfall
