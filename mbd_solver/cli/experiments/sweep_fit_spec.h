#pragma once
// A power law that a sweep fits to its runs, as the file says it: figure = A factor_1^p_1 factor_2^p_2 ...
//
//   [[fits]]
//     name                             of its picture
//     figure                           what is fitted: one of [[figures]]
//     label                            how the law writes it (default: the figure's name)
//     marks = "density"                a parameter whose values get symbols of their own in the picture; none: all
//     alike where = { diameter = 0.24 }      only the runs with these values of parameters. Default: all
//     [[fits.factors]]
//       name                           how the law writes it
//       sum = ["height", "depth [m]"]  parameters with numbers for values, and figures: the factor is their sum.
//       Default: [name] published = { Uehara = 0.5 }   exponents that others found; who gives all of them gets a law
//       with only A fitted

#include <string>
#include <utility>
#include <vector>

namespace footfall {

struct SweepFitFactor {
  int line = 0;
  std::string name;
  std::vector<std::string> sum;
  std::vector<std::pair<std::string, double>> published;  // who, exponent
};

struct SweepFit {
  int line = 0;
  std::string name, figure, label, marks;
  std::vector<std::pair<std::string, std::string>> where;  // parameter, value
  std::vector<SweepFitFactor> factors;
};

}  // namespace footfall
