#pragma once
// footfall ground fit FILE: the numbers of a soil without grains (theory 6.7) from short runs of one pad on a bed of grains.
//
// FILE is a sweep file. Its runs move one pad as prescribed; from the places and speeds in a run's history the law predicts the
// force on the pad, and its numbers minimize the sum of squares of
//   (predicted - measured) / (largest force of the run),   means over bins of time, along the three axes,
//   and of the work on the way, over the measured work, which decides how deep a pad comes to rest,
// by Levenberg and Marquardt on their logarithms. Every fifth run is held back. Intervals are computed by the
// jackknife over runs [Efron 1982]: the fit is repeated without each of them.

#include <string>
#include <vector>

#include "mbd_solver/model/elements/soil_contact.h"
#include "mbd_solver/studies/sweep_command.h"

namespace footfall {

// Places, speeds and forces of the pad in one run.
struct PadRun {
  std::string name;
  std::vector<SoilFacet> facets;  // in the axes of the body
  bool two_sided = false;
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();   // constant
  double surface = 0.0;                                 // height of the bed [m]
  std::vector<Eigen::Vector3d> place, velocity, force;  // of Bo, of each row [m], [m/s], [N]
  bool held_back = false;
};

struct FittedNumber {
  std::string key;  // of [ground.law]
  std::string unit;
  double value = 0.0, low = 0.0, high = 0.0;  // with its 95 % interval
};

// The part of the force that grows with speed: with its square (inertia, with a fitted factor; the ground is the mean height
// of the grains), or with speed times depth (speed_resistance, inertia 1; the ground is the highest grain under the pad).
enum class SpeedForm { kSquare, kDepth };

struct SoilForm {
  std::string law;  // rft or pressure_sinkage
  SpeedForm speed = SpeedForm::kSquare;
};

struct GroundFit {
  SoilForm form;
  double rebound = 1e-3;  // of the law, not fitted [m]
  std::vector<FittedNumber> numbers;
  // R^2 of fitted and held-back runs, over bins and axes: 1 - sum of squares of errors / sum of squares of (force - mean).
  double r_squared = 0.0, held_r_squared = 0.0;
  double error = 0.0, held_error = 0.0;  // root mean square, over the largest force of the run
  struct Residual {
    std::string run;
    char axis = 'z';
    double time_share = 0.0, measured = 0.0, predicted = 0.0;  // [N]
    double over = 0.0;                                         // |difference| over the largest force of the run
    bool held_back = false;
  };
  std::vector<Residual> worst;  // of each run, the largest first
};

// False where fewer than three rows have a facet in the ground.
bool reaches_the_bed(const PadRun& run);
// gravity [m/s2], density of the bed [kg/m3]. Throws InputError for too few runs, or runs without contact.
GroundFit fit_ground(const std::vector<PadRun>& runs, const SoilForm& form, double density, double gravity,
                     double rebound = 1e-3);
// The forces of the law on the pad, one per row [N].
std::vector<Eigen::Vector3d> predicted_forces(const PadRun& run, const GroundFit& fit, double density);

struct GroundArguments : SweepArguments {
  GroundArguments() { command = "ground", runs = "runs/grounds", resume = true; }
  std::string action = "fit", law = "rft", speed = "square";
  SpeedForm speed_form() const { return speed == "depth" ? SpeedForm::kDepth : SpeedForm::kSquare; }
};

// Returns the exit code: 0; 1 when a run failed; 3 when interrupted. Throws InputError.
int ground_command(const GroundArguments& arguments);

}  // namespace footfall
