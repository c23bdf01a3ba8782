#pragma once
// A passive strut given by measured forces over stroke and rate: F(x, v) = E(x) + D(x, v).
//
//   E(x)     the column of rate 0: elastic, recoverable.
//            Linear between strokes, continued with its end slopes.
//   D(x, v)  the rest, F - E: dissipated.
//            Bilinear between entries, held at the table's edge outside it, in stroke and in rate.
//
// Bilinear interpolation keeps the sign of D and the monotony of the table: if all entries dissipate (D v >= 0), the law
// dissipates everywhere, extrapolation included. The force is continuous; its derivatives jump at the table's lines
// (one-sided: the side of the larger stroke or rate). A table that delivers energy (D v < 0 somewhere) is an InputError
// that names the entry. Beyond the last stroke the table is a guess: put an end stop there.

#include <string>
#include <vector>

#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

struct TableLawParameters {
  std::vector<double> stroke;        // rising strictly, at least two [m]
  std::vector<double> rate;          // rising strictly, contains 0, at least two [m/s]
  Eigen::MatrixXd force;             // strokes x rates [N]
  std::string source = "table_law";  // file name, for messages
  std::vector<int> lines;            // line of each stroke in `source`, for messages; may be empty
};

class TableLaw final : public StrutLaw {
 public:
  // Throws InputError if the shape is wrong, stroke or rate do not rise, 0 is not among the rates, or an entry delivers
  // energy.
  explicit TableLaw(const TableLawParameters& parameters);

  std::string_view kind() const override { return "table_law"; }
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override;  // integral of E from the stroke 0 [J]
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kDamper >= 0

 private:
  struct Split;  // E, D and their derivatives
  Split split(double stroke, double rate) const;
  double elastic_integral(double stroke) const;  // of E from the first stroke [J]

  std::vector<double> stroke_, rate_;
  Eigen::VectorXd elastic_;      // E at the strokes [N]
  Eigen::MatrixXd dissipative_;  // D at the entries [N]
  std::vector<double> stored_;   // integral of E from the first stroke to each stroke [J]
  double stored_at_zero_ = 0.0;  // the same to the stroke 0 [J]
};

}  // namespace footfall
