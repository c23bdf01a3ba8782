// The runs are a sweep; the fit moves the pad of each run through the law, row by row of its history.

#include "mbd_solver/campaign/ground/ground_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/bed/bed.h"
#include "mbd_solver/bed/bed_measures.h"
#include "mbd_solver/campaign/optimum.h"
#include "mbd_solver/campaign/sampling.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/sweep_file.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {
namespace {

constexpr int kMostFitRuns = 20, kLeastFitRuns = 5;
constexpr int kHeldBack = 5;    // every fifth run
constexpr int kFitBins = 20;    // of time, from the first touch on
constexpr int kRowsPerBin = 4;  // of a run that has more
constexpr double kConfidenceOfFit = 0.95;
constexpr double kPoorFit = 0.9;                             // R^2 below this is reported
constexpr int kMostFitTrials = 60, kMostTrialsWithout = 30;  // of the fit, and of the fits without one run
constexpr double kReboundOfRadius = 0.25;                    // of the smallest grains: the rebound, which is not fitted
// Of the work of a run, relative to a bin of its force: it decides how deep a pad comes to rest.
constexpr double kWorkWeight = 3.0;
constexpr double kAssumedGrainDensity = 2600.0;  // of a bed from a script, which does not contain it [kg/m3]

// A number that is fitted: its logarithm.
struct Unknown {
  const char* key;
  const char* unit;
  double start, least, most;
};

// What grows with speed. Inertia is not fitted next to speed_resistance: it is 1 by theory. The depth
// to which jammed grains under a fast pad grow is some radii of the grains; at its upper bound the
// stress grows with the depth throughout.
std::vector<Unknown> speed_of(const SoilForm& form) {
  if (form.speed == SpeedForm::kDepth)
    return {{"speed_resistance", "Pa s/m2", 1e6, 1.0, 1e9}, {"speed_depth", "m", 0.05, 1e-3, 1.0}};
  return {{"inertia", "", 1.0, 1e-3, 200.0}};
}

// Those of strength, of speed, and of shear.
std::vector<Unknown> unknowns_of(const SoilForm& form) {
  const Unknown cohesion{"cohesion", "Pa", 50.0, 1e-2, 1e6};
  std::vector<Unknown> all = {{"resistance", "Pa/m", 3e5, 1e2, 1e9}};
  std::vector<Unknown> shear = {cohesion, {"surface_friction", "", 0.3, 0.01, 3.0}};
  if (form.law != "rft") {
    all = {{"frictional_modulus", "Pa/m^n", 3e5, 1.0, 1e10}, {"exponent", "", 1.0, 0.1, 3.0}};
    shear = {{"friction", "", 0.4, 0.01, 3.0}, cohesion};
    shear.push_back({"shear_length", "m", 0.01, 1e-4, 1.0});
  }
  const std::vector<Unknown> speed = speed_of(form);
  all.insert(all.end(), speed.begin(), speed.end());
  all.insert(all.end(), shear.begin(), shear.end());
  return all;
}

constexpr double kFitFriction = 0.4;  // mu of the bearing factor N_c of the resistive law, whose resistance is given

// The numbers in the order of unknowns_of, from `next` on.
void set_speed(const SoilForm& form, const double*& next, SoilLaw::Common& p) {
  if (form.speed == SpeedForm::kDepth) {
    p.speed_resistance = *next++;
    p.speed_depth = *next++;
  } else {
    p.inertia = *next++;
  }
}

std::shared_ptr<const SoilLaw> law_of(const SoilForm& form, const Eigen::VectorXd& x, double density, double rebound) {
  const double* next = x.data();
  if (form.law == "rft") {
    RftParameters p;
    p.density = density;
    p.friction = kFitFriction;
    p.rebound = rebound;
    p.resistance = *next++;
    set_speed(form, next, p);
    p.cohesion = *next++;
    p.surface_friction = *next++;
    return make_rft(p, "fit: ");
  }
  SinkageParameters p;
  p.density = density;
  p.rebound = rebound;
  p.stiffness = *next++;
  p.exponent = *next++;
  set_speed(form, next, p);
  p.friction = *next++;
  p.cohesion = *next++;
  p.shear_length = *next++;
  return make_pressure_sinkage(p, "fit: ");
}

std::vector<Eigen::Vector3d> forces_on(const PadRun& run, std::shared_ptr<const SoilLaw> law) {
  std::vector<SoilFacet> facets = run.facets;
  for (SoilFacet& facet : facets) {
    facet.marker.body = 0;
    facet.start = run.place.front() + run.R_WB * facet.marker.s0;
  }
  const SoilContact soil("fit", std::move(facets), run.two_sided,
                         SoilContact::Surface{{0.0, 0.0, run.surface}, Eigen::Vector3d::UnitZ(), nullptr},
                         std::move(law), std::make_shared<const SoilGround>(1.0), true);
  SharedCopies shared;
  const std::unique_ptr<ElementScratch> scratch = soil.scratch(shared);
  BodyKinematics body, ground;
  body.ground = false;
  body.A = run.R_WB;
  const Eigen::Quaterniond L(run.R_WB);
  body.L << L.w(), L.x(), L.y(), L.z();
  const Eigen::VectorXd none;
  std::vector<Eigen::Vector3d> out;
  for (std::size_t row = 0; row < run.place.size(); ++row) {
    body.r = run.place[row];
    body.dr = run.velocity[row];
    ElementInput in{PairMotion{{&body, &ground}}, none, none, 0.0};
    in.scratch = scratch.get();
    out.push_back(soil.wrench(in).head<3>());
    soil.remember(in);
  }
  return out;
}

// A run with fewer rows in the ground is not used.
constexpr std::size_t kLeastRows = 3;

// The first row in which a facet is in the ground.
std::size_t first_touch(const PadRun& run) {
  for (std::size_t row = 0; row < run.place.size(); ++row)
    for (const SoilFacet& facet : run.facets)
      if ((run.place[row] + run.R_WB * facet.marker.s0).z() < run.surface) return row;
  return run.place.size();
}

struct Binned {
  Eigen::VectorXd value;  // axes of a bin one after the other
  std::vector<double> time_share;
};

Binned means_of(const PadRun& run, const std::vector<Eigen::Vector3d>& force) {
  const std::size_t from = first_touch(run), rows = run.place.size();
  const auto bins = std::min<std::size_t>(kFitBins, rows - from);
  Binned out;
  out.value = Eigen::VectorXd::Zero(3 * bins);
  for (std::size_t b = 0; b < bins; ++b) {
    const std::size_t begin = from + (rows - from) * b / bins, end = from + (rows - from) * (b + 1) / bins;
    for (std::size_t row = begin; row < end; ++row)
      out.value.segment<3>(3 * b) += force[row] / static_cast<double>(end - begin);
    out.time_share.push_back((static_cast<double>(b) + 0.5) / static_cast<double>(bins));
  }
  return out;
}

// Work of the forces on the pad along its way [J].
double work_of(const PadRun& run, const std::vector<Eigen::Vector3d>& force) {
  double work = 0.0;
  for (std::size_t row = 1; row < run.place.size(); ++row) work += force[row].dot(run.place[row] - run.place[row - 1]);
  return work;
}

// A run as the fit sees it.
struct Target {
  const PadRun* run;
  Binned measured;
  double scale;  // largest force [N]
  double work;   // [J]
};

class Problem {
 public:
  Problem(SoilForm form, double density, double rebound, std::vector<Target> targets)
      : form_(std::move(form)),
        density_(density),
        rebound_(rebound),
        unknowns_(unknowns_of(form_)),
        targets_(std::move(targets)) {}

  Eigen::VectorXd start() const {
    Eigen::VectorXd x(unknowns_.size());
    for (std::size_t k = 0; k < unknowns_.size(); ++k) x[k] = std::log(unknowns_[k].start);
    return x;
  }
  // skip: a target that is left out; -1: none.
  Eigen::VectorXd residuals(const Eigen::VectorXd& log_x, int skip) const {
    const std::shared_ptr<const SoilLaw> law = law_of(form_, log_x.array().exp(), density_, rebound_);
    Eigen::VectorXd out(size(skip));
    Eigen::Index at = 0;
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      if (static_cast<int>(k) == skip) continue;
      const Target& target = targets_[k];
      const std::vector<Eigen::Vector3d> forces = forces_on(*target.run, law);
      const Eigen::VectorXd now = means_of(*target.run, forces).value;
      out.segment(at, now.size()) = (now - target.measured.value) / target.scale;
      at += now.size();
      out[at++] = kWorkWeight * (work_of(*target.run, forces) / target.work - 1.0);
    }
    return out;
  }
  // free: the unknowns that are searched; the others keep their values.
  Eigen::VectorXd solve(const Eigen::VectorXd& x, int skip, int most, const std::vector<Eigen::Index>& free) const {
    OptimumTask task{{}, {}, {}, kLogStep, kLogPrecision, most};
    for (const Eigen::Index k : free) {
      task.start.push_back(x[k]);
      task.least.push_back(std::log(unknowns_[k].least));
      task.most.push_back(std::log(unknowns_[k].most));
    }
    const auto completed = [&](const std::vector<double>& point) {
      Eigen::VectorXd all = x;
      for (std::size_t i = 0; i < free.size(); ++i) all[free[i]] = point[i];
      return all;
    };
    const std::vector<double> best = least_squares(task, [&](const std::vector<std::vector<double>>& points) {
      std::vector<std::vector<double>> all;
      for (const std::vector<double>& point : points) {
        const Eigen::VectorXd r = residuals(completed(point), skip);
        all.emplace_back(r.begin(), r.end());
      }
      return all;
    });
    return completed(best);
  }
  std::vector<Eigen::Index> all_unknowns() const {
    std::vector<Eigen::Index> all;
    for (std::size_t k = 0; k < unknowns_.size(); ++k) all.push_back(k);
    return all;
  }
  // Those away from their bounds: at a bound a search only loses its way.
  std::vector<Eigen::Index> within_bounds(const Eigen::VectorXd& x) const {
    constexpr double kAway = 0.02;
    std::vector<Eigen::Index> inner;
    for (const Eigen::Index k : all_unknowns()) {
      const Unknown& unknown = unknowns_[k];
      if (x[k] > std::log(unknown.least) + kAway && x[k] < std::log(unknown.most) - kAway) inner.push_back(k);
    }
    return inner;
  }
  int count() const { return static_cast<int>(targets_.size()); }
  const std::vector<Unknown>& unknowns() const { return unknowns_; }

 private:
  static constexpr double kLogStep = 1e-4, kLogPrecision = 1e-5;

  Eigen::Index size(int skip) const {
    Eigen::Index sum = 0;
    for (std::size_t k = 0; k < targets_.size(); ++k)
      if (static_cast<int>(k) != skip) sum += targets_[k].measured.value.size() + 1;
    return sum;
  }

  SoilForm form_;
  double density_, rebound_;
  std::vector<Unknown> unknowns_;
  std::vector<Target> targets_;
};

Eigen::VectorXd values_of(const GroundFit& fit) {
  Eigen::VectorXd x(fit.numbers.size());
  for (std::size_t k = 0; k < fit.numbers.size(); ++k) x[k] = fit.numbers[k].value;
  return x;
}

// How well the law meets these runs, R^2 and root mean square error over the largest force; and the worst bin of each.
std::pair<double, double> quality(const std::vector<Target>& targets, const std::shared_ptr<const SoilLaw>& law,
                                  std::vector<GroundFit::Residual>& worst) {
  double wrong = 0.0, about_mean = 0.0, relative = 0.0, count = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double bins = 0.0;
  for (const Target& target : targets) {
    for (Eigen::Index i = 0; i < target.measured.value.size(); i += 3) mean += target.measured.value.segment<3>(i);
    bins += static_cast<double>(target.measured.value.size() / 3);
  }
  mean /= std::max(1.0, bins);
  for (const Target& target : targets) {
    const Eigen::VectorXd now = means_of(*target.run, forces_on(*target.run, law)).value;
    GroundFit::Residual largest;
    for (Eigen::Index i = 0; i < now.size(); ++i) {
      const double measured = target.measured.value[i], difference = now[i] - measured;
      wrong += difference * difference;
      about_mean += (measured - mean[i % 3]) * (measured - mean[i % 3]);
      relative += difference * difference / (target.scale * target.scale);
      count += 1.0;
      if (std::abs(difference) / target.scale <= largest.over) continue;
      largest = {target.run->name,
                 "xyz"[i % 3],
                 target.measured.time_share[i / 3],
                 measured,
                 now[i],
                 std::abs(difference) / target.scale,
                 target.run->held_back};
    }
    worst.push_back(largest);
  }
  return {about_mean > 0.0 ? 1.0 - wrong / about_mean : std::nan(""), std::sqrt(relative / std::max(1.0, count))};
}

}  // namespace

bool reaches_the_bed(const PadRun& run) { return first_touch(run) + kLeastRows <= run.place.size(); }

GroundFit fit_ground(const std::vector<PadRun>& runs, const SoilForm& form, double density, double gravity,
                     double rebound) {
  FOOTFALL_DEMAND(gravity >= 0.0);
  std::vector<Target> fitted, held;
  for (const PadRun& run : runs) {
    if (!reaches_the_bed(run))
      throw InputError(code::kGroundFit, "run " + run.name + ": the pad does not reach the bed; let it go deeper");
    Target target{&run, means_of(run, run.force), 0.0, work_of(run, run.force)};
    for (Eigen::Index i = 0; i < target.measured.value.size(); i += 3)
      target.scale = std::max(target.scale, target.measured.value.segment<3>(i).norm());
    if (!(target.scale > 0.0))
      throw InputError(code::kGroundFit, "run " + run.name + ": the bed exerts no force on the pad; let it go deeper");
    if (!(target.work < 0.0))
      throw InputError(code::kGroundFit, "run " + run.name + ": the bed does no work on the pad; let it go deeper");
    (run.held_back ? held : fitted).push_back(std::move(target));
  }
  if (fitted.size() < 3)
    throw InputError(code::kGroundFit, "only " + std::to_string(fitted.size()) +
                                           " runs are fitted; a fit requires at least 3 besides those held back");
  const Problem problem(form, density, rebound, fitted);
  const Eigen::VectorXd first = problem.solve(problem.start(), -1, kMostFitTrials, problem.all_unknowns());
  const std::vector<Eigen::Index> inner = problem.within_bounds(first);
  const Eigen::VectorXd best = problem.solve(first, -1, kMostFitTrials, inner);
  const auto n = static_cast<double>(problem.count());
  Eigen::MatrixXd without(best.size(), problem.count());
  for (int k = 0; k < problem.count(); ++k) without.col(k) = problem.solve(best, k, kMostTrialsWithout, inner);
  const Eigen::VectorXd mean = without.rowwise().mean();
  const Eigen::VectorXd spread = ((without.colwise() - mean).rowwise().squaredNorm() * ((n - 1.0) / n)).array().sqrt();
  const double t = two_sided_quantile(kConfidenceOfFit, problem.count() - 1);

  GroundFit fit;
  fit.form = form;
  fit.rebound = rebound;
  for (std::size_t k = 0; k < problem.unknowns().size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const Unknown& unknown = problem.unknowns()[k];
    fit.numbers.push_back({unknown.key, unknown.unit, std::exp(best[i]), std::exp(best[i] - t * spread[i]),
                           std::exp(best[i] + t * spread[i])});
  }
  const std::shared_ptr<const SoilLaw> found = law_of(form, values_of(fit), density, rebound);
  std::tie(fit.r_squared, fit.error) = quality(fitted, found, fit.worst);
  std::tie(fit.held_r_squared, fit.held_error) = quality(held, found, fit.worst);
  std::sort(fit.worst.begin(), fit.worst.end(), [](const auto& a, const auto& b) { return a.over > b.over; });
  return fit;
}

std::vector<Eigen::Vector3d> predicted_forces(const PadRun& run, const GroundFit& fit, double density) {
  return forces_on(run, law_of(fit.form, values_of(fit), density, fit.rebound));
}

namespace {

// The scene of a run on the soil, for its facets.
Scene on_the_soil(const RunRequest& request) {
  std::vector<std::string> settings = request.settings;
  append(settings, {"ground.kind=soil", "ground.law.kind=rft", "ground.law.resistance=1e6"});
  return read_scene(request.scene, settings);
}

// The bed under the pad, from its grains.
struct MeasuredBed {
  double surface = 0.0;   // mean height of the grains as seen from above [m]
  double highest = 0.0;   // of the grains under the pad [m]
  double fraction = 0.0;  // of its volume that grains fill [-]
  double radius = 0.0;    // of its smallest grains [m]
};

MeasuredBed measured_bed(const Scene& scene, const Eigen::Vector2d& centre, double width) {
  if (!scene.particles || !scene.particles->bed)
    throw InputError(code::kGroundFit, scene.file + ": a fit requires a bed, by [particles.box] or particles.bed");
  const std::string file = (std::filesystem::path(bed_folder(*scene.particles->bed)) / kBedGrains).string();
  if (!std::filesystem::is_regular_file(file))
    throw InputError(code::kGroundFit, scene.file + ": the script of the bed writes no " + std::string(kBedGrains) +
                                           ", from which the height of its surface is measured; let it dump x y z "
                                           "radius of its grains, as inputs/regolith/in.bed does");
  const std::vector<GrainPlace> grains = read_grains(file);
  BedFrame bed;
  bed.x.resize(3, grains.size());
  for (std::size_t i = 0; i < grains.size(); ++i) {
    bed.id.push_back(static_cast<int>(i));
    bed.x.col(i) = grains[i].centre;
    bed.radius.push_back(grains[i].radius);
  }
  MeasuredBed out;
  out.radius = *std::min_element(bed.radius.begin(), bed.radius.end());
  const double column = 0.25 * out.radius, half = std::max(0.5 * width, 2.0 * out.radius);
  const std::vector<double> height =
      surface_profile(bed, centre, column, std::max(1, static_cast<int>(std::lround(half / column))));
  double area = 0.0;
  out.highest = bed.x.row(2).minCoeff();
  for (std::size_t k = 0; k < height.size(); ++k) {
    if (std::isnan(height[k])) continue;
    const double ring = 2.0 * static_cast<double>(k) + 1.0;
    out.surface += ring * height[k];
    area += ring;
  }
  for (std::size_t i = 0; i < grains.size(); ++i)
    if ((bed.x.col(i).head<2>() - centre).norm() < half)
      out.highest = std::max(out.highest, bed.x(2, i) + bed.radius[i]);
  if (!(area > 0.0)) throw InputError(code::kGroundFit, scene.file + ": there are no grains under the pad");
  out.surface /= area;
  const double depth = std::min(half, 0.5 * (out.surface - bed.x.row(2).minCoeff()));
  out.fraction = packing_fraction(bed, {centre.x(), centre.y(), out.surface - out.radius}, half, depth);
  return out;
}

// The middle of the facets over the ground, half-way of a run.
Eigen::Vector2d centre_of(const PadRun& run, const std::vector<double>& x, const std::vector<double>& y) {
  Eigen::Vector2d centre(0.5 * (x.front() + x.back()), 0.5 * (y.front() + y.back()));
  for (const SoilFacet& facet : run.facets)
    centre += (run.R_WB * facet.marker.s0).head<2>() / static_cast<double>(run.facets.size());
  return centre;
}

double width_of(const PadRun& run) {
  double reach = 0.0;
  for (const SoilFacet& a : run.facets)
    for (const SoilFacet& b : run.facets) reach = std::max(reach, (a.marker.s0 - b.marker.s0).norm());
  return reach;
}

bool has_boundary(const Mechanism& mechanism, int body) {
  return std::any_of(mechanism.boundaries.begin(), mechanism.boundaries.end(),
                     [&](const BodyBoundary& entry) { return entry.body == body; });
}

PadRun pad_run(const RunRequest& request, const std::string& folder, SpeedForm speed) {
  const Scene scene = on_the_soil(request);
  const Mechanism mechanism = build_mechanism(scene);
  std::vector<const SoilContact*> soils;
  for (const ContactEntry& entry : mechanism.contacts)
    if (const auto* soil = dynamic_cast<const SoilContact*>(&entry.force.of(mechanism.model)))
      if (has_boundary(mechanism, soil->bodies()[0])) soils.push_back(soil);
  if (soils.size() != 1)
    throw InputError(code::kGroundFit, scene.file + ": has " + std::to_string(soils.size()) +
                                           " boundaries on the bed; a fit requires one pad with a surface");
  const SoilContact& soil = *soils.front();
  PadRun run;
  run.name = request.name;
  run.facets = soil.facets();
  run.two_sided = soil.two_sided();
  const int body = soil.bodies()[0];
  run.R_WB = rotation_matrix(mechanism.model.initial(body).L);
  const std::string& name = mechanism.model.body(body).name();
  const History history = read_history((std::filesystem::path(folder) / "history.csv").string());
  const auto column = [&](const char* what) -> const std::vector<double>& { return history.column(name + what); };
  const auto &x = column(".x"), &y = column(".y"), &z = column(".z"), &u = column(".vx"), &v = column(".vy"),
             &w = column(".vz"), &fx = column(".contact.fx"), &fy = column(".contact.fy"), &fz = column(".contact.fz");
  const MeasuredBed bed =
      measured_bed(read_scene(request.scene, request.settings), centre_of(run, x, y), width_of(run));
  run.surface = speed == SpeedForm::kDepth ? bed.highest : bed.surface;
  const std::size_t stride = std::max<std::size_t>(1, x.size() / (kFitBins * kRowsPerBin));
  // The force of a row is a mean up to it; rows that are left out give theirs to the next.
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (std::size_t row = 0; row < x.size(); ++row) {
    sum += Eigen::Vector3d(fx[row], fy[row], fz[row]);
    count += 1.0;
    if (row % stride != 0) continue;
    run.place.emplace_back(x[row], y[row], z[row]);
    run.velocity.emplace_back(u[row], v[row], w[row]);
    run.force.push_back(sum / count);
    sum.setZero();
    count = 0.0;
  }
  return run;
}

// Every fit without one of the runs has the same number: no force depends on it, or it is at its bound.
std::string interval_text(const FittedNumber& number) {
  if (number.high - number.low <= 1e-6 * number.value) return "not determined";
  return number_text(number.low, 3) + " to " + number_text(number.high, 3);
}

std::string toml_number(double value) {
  std::string text = number_text(value, 5);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

// Over all runs: the largest speed into the bed, and the largest depth of a facet.
struct FittedRange {
  double speed = 0.0, depth = 0.0;  // [m/s], [m]
};

FittedRange range_of(const std::vector<PadRun>& runs) {
  FittedRange range;
  for (const PadRun& run : runs)
    for (std::size_t row = first_touch(run); row < run.place.size(); ++row) {
      range.speed = std::max(range.speed, -run.velocity[row].z());
      for (const SoilFacet& facet : run.facets)
        range.depth = std::max(range.depth, run.surface - (run.place[row] + run.R_WB * facet.marker.s0).z());
    }
  return range;
}

std::string ground_file(const GroundFit& fit, const Scene& scene, const MeasuredBed& bed, double density,
                        const FittedRange& range, std::size_t runs, std::size_t held, const std::string& command) {
  std::ostringstream out;
  out << "# A soil without grains, fitted to grains by `" << command << "`.\n"
      << "#   [ground] kind = \"soil\", soil = \"THIS FILE\"\n[law]\nkind = \"" << fit.form.law << "\"\n"
      << "density = " << toml_number(density) << "  # kg/m3, of the bed: solid fraction "
      << number_text(bed.fraction, 3) << (scene.particles->box ? "" : ", grains of 2600 kg/m3 assumed") << "\n"
      << "rebound = " << toml_number(fit.rebound)
      << "  # m, not fitted: a quarter of the smallest radius of the grains\n";
  if (fit.form.speed == SpeedForm::kDepth) out << "inertia = 1.0  # not fitted\n";
  out << "fitted_speed = " << toml_number(range.speed)
      << "  # m/s, largest of the runs\nfitted_depth = " << toml_number(range.depth) << "  # m, likewise\n";
  if (fit.form.law == "rft")
    out << "friction = " << toml_number(kFitFriction) << "  # of the factor of cohesion, not fitted\n"
        << "gravity = " << toml_number(scene.gravity.norm()) << "  # m/s2, of the runs\n";
  for (const FittedNumber& number : fit.numbers)
    out << number.key << " = " << toml_number(number.value) << "  # " << number.unit
        << (number.unit.empty() ? "" : ", ") << "95 %: " << interval_text(number) << "\n";
  out << "\n[fit]\nscene = \"" << std::filesystem::path(scene.file).filename().string() << "\"\nruns = " << runs
      << "\nheld_back = " << held << "\nr_squared = " << toml_number(fit.r_squared)
      << "\nheld_back_r_squared = " << toml_number(fit.held_r_squared) << "\nerror = " << toml_number(fit.error)
      << "  # root mean square over the largest force of a run"
      << "\nheld_back_error = " << toml_number(fit.held_error) << "\ngrain_radius = " << toml_number(bed.radius)
      << "  # m, of the smallest grains\n";
  return out.str();
}

std::string fit_page(const GroundFit& fit, std::size_t runs, std::size_t held, const std::string& title,
                     const std::string& command) {
  std::string page = "## " + title + "\n\nMade by `" + command + "`: law `" + fit.form.law + "`, " +
                     std::to_string(runs) + " runs, " + std::to_string(held) + " of them held back.\n\n";
  Table numbers({"number", "unit", "value", "95 % interval"});
  for (const FittedNumber& number : fit.numbers)
    numbers.add({number.key, number.unit, number_text(number.value, 4), interval_text(number)});
  page += numbers.page() + "\n";
  Table how({"runs", "R^2", "error over the largest force"});
  how.add({"fitted", number_text(fit.r_squared, 3), share_text(fit.error)});
  how.add({"held back", number_text(fit.held_r_squared, 3), share_text(fit.held_error)});
  page += how.page() + "\n";
  Table worst({"run", "axis", "at", "measured [N]", "predicted [N]", "difference over the largest force"});
  for (const GroundFit::Residual& r : fit.worst)
    worst.add({r.run + (r.held_back ? " (held back)" : ""), std::string(1, r.axis),
               share_text(r.time_share) + " of its way", number_text(r.measured, 3), number_text(r.predicted, 3),
               share_text(r.over)});
  page += worst.page();
  if (!(fit.r_squared >= kPoorFit) || !(fit.held_r_squared >= kPoorFit)) {
    const GroundFit::Residual& r = fit.worst.front();
    page += "\n" +
            with_code(code::kPoorGroundFit,
                      "warning: the law meets these grains poorly: R^2 " + number_text(fit.r_squared, 3) +
                          ", held back " + number_text(fit.held_r_squared, 3) + "; worst in run " + r.run + " along " +
                          std::string(1, r.axis) + ", " + number_text(r.predicted, 3) + " N for " +
                          number_text(r.measured, 3) + " N. Try the other law, or fit the range that matters alone") +
            "\n";
  }
  return page;
}

bool write_fit(const GroundArguments& a, const SweepSpec& spec, const Plan& plan, const Results& results,
               const OutputFolder& output) {
  std::vector<PadRun> runs;
  std::size_t held = 0;
  bool all = true;
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const RunEnd& end = results.runs[i].end;
    if (!end.done()) {
      std::printf("%s ended with exit code %d: %s; it is left out\n", plan.runs[i].name.c_str(), end.code,
                  end.message.c_str());
      all = false;
      continue;
    }
    PadRun run = pad_run(plan.runs[i], end.folder, a.speed_form());
    if (!reaches_the_bed(run)) {
      std::printf("%s: the pad does not reach the bed, or at the end of its way alone; it is left out\n",
                  run.name.c_str());
      continue;
    }
    run.held_back = i % kHeldBack == kHeldBack - 1;
    held += run.held_back ? 1 : 0;
    runs.push_back(std::move(run));
  }
  if (runs.empty())
    throw InputError(code::kGroundFit, output.folder + ": no finished run reaches the bed, nothing to fit");
  const Scene scene = read_scene(plan.runs.front().scene, plan.runs.front().settings);
  const PadRun& first = runs.front();
  const Eigen::Vector3d& at = first.place.front();
  const MeasuredBed bed = measured_bed(scene, centre_of(first, {at.x(), at.x()}, {at.y(), at.y()}), width_of(first));
  const double density =
      bed.fraction * (scene.particles->box ? scene.particles->box->material.density : kAssumedGrainDensity);
  const double gravity = scene.gravity.norm();
  const GroundFit fit = fit_ground(runs, {a.law, a.speed_form()}, density, gravity, kReboundOfRadius * bed.radius);
  const std::string page = fit_page(fit, runs.size(), held, spec.title, output.command);
  Table rows({"run", "held_back", "row", "x", "y", "z", "fx", "fy", "fz", "law_fx", "law_fy", "law_fz"});
  for (const PadRun& run : runs) {
    const std::vector<Eigen::Vector3d> now = predicted_forces(run, fit, density);
    for (std::size_t k = 0; k < now.size(); ++k) {
      std::vector<std::string> row = {run.name, run.held_back ? "1" : "0", std::to_string(k)};
      for (const Eigen::Vector3d& three : {run.place[k], run.force[k], now[k]})
        for (int axis = 0; axis < 3; ++axis) row.push_back(number_text(three[axis], 6));
      rows.add(row);
    }
  }
  write_whole_file(output.path("forces.csv"), rows.csv());
  write_whole_file(output.path("ground.md"), page);
  write_whole_file(output.path("ground.toml"),
                   ground_file(fit, scene, bed, density, range_of(runs), runs.size(), held, output.command));
  std::printf("%s\n%s\n%s\n%s\n", page.c_str(), output.path("ground.md").c_str(), output.path("forces.csv").c_str(),
              output.path("ground.toml").c_str());
  return all;
}

}  // namespace

int ground_command(const GroundArguments& a) {
  SweepArguments e = a;
  e.again = {"ground", "fit", a.file, "--law", a.law, "--speed", a.speed};
  for (const std::string& setting : a.settings) append(e.again, {"--set", setting});
  e.change = [&](SweepSpec& spec) {
    if (!spec.curves.empty() || spec.parameters.empty())
      throw InputError(code::kGroundFit, spec.file + ": a fit requires [[parameters]], without [[curves]]");
    append(spec.settings, a.settings);
    append(spec.short_form.settings, a.settings);
  };
  e.extend = [&](Plan& plan) {
    if (plan.runs.size() > static_cast<std::size_t>(kMostFitRuns) ||
        plan.runs.size() < static_cast<std::size_t>(kLeastFitRuns))
      throw InputError(code::kGroundFit, a.file + ": has " + std::to_string(plan.runs.size()) + " runs, expected " +
                                             std::to_string(kLeastFitRuns) + " to " + std::to_string(kMostFitRuns));
    for (const RunRequest& run : plan.runs) {  // before the runs, which take minutes
      if (const Scene scene = read_scene(run.scene, run.settings); !scene.particles || !scene.particles->bed)
        throw InputError(code::kGroundFit, scene.file + ": a fit requires a bed, by [particles.box] or particles.bed");
      on_the_soil(run);
    }
  };
  e.write = [&](const SweepSpec& spec, const Plan& plan, const Results& results, const OutputFolder& output) {
    return write_fit(a, spec, plan, results, output);
  };
  return sweep_command(e);
}

}  // namespace footfall
