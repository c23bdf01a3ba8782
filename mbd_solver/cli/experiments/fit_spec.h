#pragma once
// A power law that is fitted to the runs of an experiment: figure = A factor_1^p_1 factor_2^p_2 ...
//
//   [[fits]]
//     name                   of its picture
//     figure                 what is fitted: one of [[figures]]
//     label                  how the law writes it (default: the figure's name)
//     marks                  a parameter whose values get symbols of their own in the picture (default: all alike)
//     where                  { diameter = 0.24 }: only the runs with these values of parameters (default: all)
//     [[fits.factors]]
//       name                   how the law writes it
//       sum                    ["height", "depth [m]"]: parameters with numbers for values, and figures, that the
//                              factor is the sum of (default: [name])
//       published              { Uehara = 0.5 }: exponents that others found; who gives all of them gets a law with
//                              only A fitted

#include <map>
#include <string>
#include <vector>

#include "mbd_solver/scene/source.h"

namespace footfall {

struct FitFactor {
  std::string name;
  std::vector<std::string> sum;
  std::map<std::string, std::string> published;  // exponents, by who found them
  Source source;
};

struct FitSpec {
  std::string name, figure, label, marks;
  std::map<std::string, std::string> where;  // values, by their parameters
  std::vector<FitFactor> factors;
  Source source;
};

}  // namespace footfall
