#include "mbd_solver/cli/analysis/energy_ledger.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/model/laws/energy.h"

namespace footfall {

namespace {

const std::string kDissipated = "dissipated.";
constexpr const char* kResidual = "coupling.energy_residual";
constexpr double kSameTime = 1e-6;  // grains_energy.txt holds six digits

// The values of a column at rising times within its own, along straight lines.
std::vector<double> at_times(const std::vector<double>& time, const std::vector<double>& value,
                             const std::vector<double>& wanted) {
  std::vector<double> result;
  std::size_t k = 0;
  for (const double t : wanted) {
    while (k + 2 < time.size() && time[k + 1] < t) ++k;
    if (time.size() < 2) {
      result.push_back(value.front());
      continue;
    }
    const double share = std::clamp((t - time[k]) / (time[k + 1] - time[k]), 0.0, 1.0);
    result.push_back((1.0 - share) * value[k] + share * value[k + 1]);
  }
  return result;
}

std::vector<double> since_start(const std::vector<double>& values, std::size_t count) {
  std::vector<double> change;
  for (std::size_t k = 0; k < count; ++k) change.push_back(values[k] - values.front());
  return change;
}

}  // namespace

GrainEnergies read_grain_energies(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": cannot be read; expected the energies of the grains that the script writes");
  GrainEnergies grains;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    double step = 0.0, time = 0.0, kinetic = 0.0, rotation = 0.0, gravity = 0.0;
    if (!(words >> step >> time >> kinetic >> rotation >> gravity)) {
      if (file.peek() == std::ifstream::traits_type::eof()) break;
      throw InputError(path + ":" + std::to_string(number) + ": \"" + line +
                       "\": expected five numbers: step time kinetic rotation gravity");
    }
    if (!grains.time.empty() && time <= grains.time.back())
      throw InputError(path + ":" + std::to_string(number) + ": time " + std::to_string(time) +
                       " s: expected one later than that of the row before");
    grains.time.push_back(time);
    grains.kinetic.push_back(kinetic + rotation);
    grains.gravity.push_back(gravity);
  }
  return grains;
}

double reference_energy(const History& run) {
  const std::vector<double>& kinetic = run.column("energy.kinetic");
  const double stored = run.column("energy.total").front() - run.column("energy.gravity").front();
  return std::max(stored, *std::max_element(kinetic.begin(), kinetic.end()));
}

History energy_ledger(const History& run, const GrainEnergies& grains) {
  const std::vector<double>& run_time = run.column("time");
  if (run_time.empty() || run.find("energy.total") < 0)
    throw InputError("the history holds no energies; there is no ledger to make of it");
  std::size_t rows = 0;
  while (rows < grains.time.size() && grains.time[rows] <= run_time.back() * (1.0 + kSameTime)) ++rows;
  const bool both_sides = run.find(kResidual) >= 0 && rows > 0;
  const std::vector<double> time =
      both_sides ? std::vector<double>(grains.time.begin(), grains.time.begin() + static_cast<std::ptrdiff_t>(rows))
                 : run_time;

  History ledger;
  const auto add = [&](const std::string& name, const std::string& unit, std::vector<double> values) {
    ledger.names.push_back(name);
    ledger.units.push_back(unit);
    ledger.columns.push_back(std::move(values));
  };
  std::vector<double> sum(time.size(), 0.0);
  const auto count = [&](const std::vector<double>& values, double sign) {
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += sign * values[k];
  };
  const auto from_run = [&](const std::string& name) { return at_times(run_time, run.column(name), time); };

  add("time", "s", time);
  for (const std::string& part : names_of<Stored>()) {
    add("mechanism." + part, "J", from_run("energy." + part));
    count(ledger.columns.back(), 1.0);
  }
  for (const std::string& name : run.names) {
    if (name.rfind(kDissipated, 0) != 0) continue;
    add(name, "J", from_run(name));
    count(ledger.columns.back(), 1.0);
  }
  add("work.motion", "J", from_run("work.motion"));
  count(ledger.columns.back(), -1.0);
  if (run.find(kResidual) >= 0) {
    std::vector<double> to_grains = from_run("work.contact");
    for (double& work : to_grains) work = -work;
    const std::vector<double> interface = from_run(kResidual);
    count(to_grains, 1.0);
    add("work.to_grains", "J", to_grains);
    add("interface", "J", interface);
    if (both_sides) {
      const std::vector<double> kinetic = since_start(grains.kinetic, rows),
                                gravity = since_start(grains.gravity, rows);
      std::vector<double> dissipated;
      for (std::size_t k = 0; k < rows; ++k)
        dissipated.push_back(to_grains[k] - interface[k] - kinetic[k] - gravity[k]);
      add("grains.kinetic", "J", kinetic);
      add("grains.gravity", "J", gravity);
      add("grains.dissipated", "J", dissipated);
    }
  }
  const double reference = reference_energy(run);
  std::vector<double> error;
  for (const double s : sum) error.push_back(reference > 0.0 ? (s - sum.front()) / reference : 0.0);
  add("sum", "J", sum);
  add("closing_error", "-", error);
  return ledger;
}

}  // namespace footfall
