// The balance sums columns of history.csv and grains_energy.txt at common times; the rest prints and plots what is there.
#include "mbd_solver/app/results.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/app/plots.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/model/laws/strut_law.h"
#include "mbd_solver/session/observe/requirements.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {
namespace {

const std::string kDissipated = "dissipated.";
constexpr const char* kResidual = "coupling.energy_error";
const std::string kChanges = "coupling.grains_";  // energy that grains got otherwise than by forces
constexpr double kUnknown = 1e299;                // more in a column of grains_energy.txt: not known
constexpr double kSameTime = 1e-6;                // grains_energy.txt has six digits
constexpr double kSameEnergy = 1e-9;              // history.csv has ten

// The values of a column at ascending times within its range, interpolated linearly.
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

// The numbers with which a line begins.
std::vector<double> leading_numbers(TextReader& text) {
  std::vector<double> numbers;
  double value = 0.0;
  for (const std::string_view word : text.fields(Separators::kBlanks)) {
    if (!read_number(word, value) || !std::isfinite(value)) break;
    numbers.push_back(value);
  }
  return numbers;
}

// Energy that the grains have given to floor and side walls, from walls_energy.txt: the rows have the mean power of five samples at
// equal distances, and the mean of their times.
struct WallEnergies {
  std::vector<double> time, floor, sides;  // [s, J, J]
};
WallEnergies read_wall_energies(const std::string& path) {
  WallEnergies walls;
  TextReader text = TextReader::if_there(path);
  for (double floor = 0.0, sides = 0.0; text.next();) {
    if (text.line().empty() || text.line()[0] == '#') continue;
    const std::vector<double> row = leading_numbers(text);  // step, time, power of the floor, of the sides
    if (row.size() < 4) break;
    const double time = row[1];
    if (!walls.time.empty() && time <= walls.time.back())
      text.fail(code::kRunDamaged, "the row at " + plain_text(time) + " s follows a later one");
    const double since = walls.time.empty() ? 0.0 : time - walls.time.back();
    floor += row[2] * since;
    sides += row[3] * since;
    walls.time.push_back(time);
    walls.floor.push_back(floor);
    walls.sides.push_back(sides);
  }
  return walls;
}

std::vector<double> since_start(const std::vector<double>& values, std::size_t count) {
  std::vector<double> change;
  for (std::size_t k = 0; k < count; ++k) change.push_back(values[k] - values.front());
  return change;
}

}  // namespace

GrainEnergies read_grain_energies(const std::string& path) {
  TextReader text(path, code::kRunDamaged, "the energies that the script writes");
  GrainEnergies grains;
  while (text.next()) {
    const std::string line = text.line();
    if (line.empty() || line[0] == '#') continue;
    // step, time, kinetic, rotation, gravity; inserted, left, changed
    const std::vector<double> row = leading_numbers(text);
    if (row.size() < 5) {
      const InputError fault(code::kRunDamaged, text.place() + ": \"" + line +
                                                    "\": expected five numbers: step time kinetic rotation gravity");
      if (!text.next()) break;  // a run in progress, or a killed one
      throw fault;
    }
    if (!grains.time.empty() && row[1] <= grains.time.back())
      text.fail("time " + plain_text(row[1]) + " s: expected a later time than in the row before");
    grains.time.push_back(row[1]);
    grains.kinetic.push_back(row[2] + row[3]);
    grains.gravity.push_back(row[4]);
    if (row.size() > 7 && row[7] < kUnknown) {
      grains.inserted.push_back(row[5]);
      grains.left.push_back(row[6]);
      grains.changed.push_back(row[7]);
    }
  }
  if (grains.changed.size() != grains.time.size()) grains.inserted = grains.left = grains.changed = {};
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
    throw InputError(code::kNoRun, "the history has no energies, and so no balance");
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
  for (const std::string& source : names_of<Supply>()) {
    if (run.find("work." + source) < 0) continue;
    add("work." + source, "J", from_run("work." + source));
    count(ledger.columns.back(), -1.0);
  }
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
      for (const std::string& name : run.names) {
        if (name.rfind(kChanges, 0) != 0) continue;
        const std::string what = name.substr(kChanges.size());
        const std::vector<double>& at_step = what == "inserted" ? grains.inserted
                                             : what == "left"   ? grains.left
                                                                : grains.changed;
        const std::vector<double> change = since_start(at_step.empty() ? from_run(name) : at_step, rows);
        for (std::size_t k = 0; k < rows; ++k) dissipated[k] += change[k];
        add("grains." + what, "J", change);
      }
      add("grains.kinetic", "J", kinetic);
      add("grains.gravity", "J", gravity);
      add("grains.dissipated", "J", dissipated);
    }
  }
  const double reference = reference_energy(run);
  std::vector<double> error;
  double largest = 0.0;  // of all parts, whose round-off is none of the balance
  for (const std::vector<double>& column : ledger.columns)
    if (&column != &ledger.columns.front())
      for (const double value : column) largest = std::max(largest, std::abs(value));
  for (const double s : sum) {
    const double change = std::abs(s - sum.front()) > kSameEnergy * largest ? s - sum.front() : 0.0;
    error.push_back(reference > 0.0 ? change / reference : 0.0);
  }
  add("sum", "J", sum);
  add("closing_error", "-", error);
  return ledger;
}

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// One row of the table, if the summary has the key.
void row(const Json& summary, const char* label, const char* key, double factor, const char* format) {
  if (!summary.contains(key) || !summary[key].is_number()) return;
  std::printf("  %-38s ", label);
  std::printf(format, factor * summary[key].get<double>());
  std::printf("\n");
}

void row_by_size(const Json& summary, const char* label, const char* key, const std::string& unit) {
  if (!summary.contains(key) || !summary[key].is_number()) return;
  std::printf("  %-38s %s\n", label, readable(summary[key].get<double>(), unit).c_str());
}

bool touches_ground(const Json& summary) {
  for (const Json& part : summary.value("active", Json::array()))
    if (part == "plane" || part == "particles" || part == "soil") return true;
  return false;
}

void print_times(const Json& summary) {
  if (!summary.contains("wall_s")) return;
  const double wall = summary.at("wall_s");
  const auto part = [&](const char* key) { return summary.value(key, 0.0); };
  std::printf("  %-38s %.1f s", "wall time", wall);
  if (part("dem_wall_s") > 0.0 && wall > 0.0) {
    std::printf(" (grains %.1f s, waiting for the mechanism %.2f s = %.1f %%, mechanism %.1f s = %.1f %%)",
                part("dem_wall_s"), part("waited_wall_s"), 100.0 * part("waited_wall_s") / wall, part("mbd_wall_s"),
                100.0 * part("mbd_wall_s") / wall);
  }
  std::printf("\n");
}

// Red where they are missed, on a terminal.
void print_requirements(const Json& summary) {
  if (!summary.contains("requirements")) return;
  const bool colours = isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr;
  const std::vector<std::string> lines = requirement_lines(summary);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool red = colours && summary.at("requirements").at(i).value("verdict", "") != "met";
    std::printf("  requirement %s%s%s\n", red ? "\033[1;31m" : "", lines[i].c_str(), red ? "\033[0m" : "");
  }
}

}  // namespace

void print_error(const MessageCode& code, const std::string& text) {
  std::fprintf(stderr, "footfall: %s\n", with_code(code, text).c_str());
}

void warn_missing_file(const std::string& file, const std::exception& error) {
  const std::string text = "no " + file + ": " + error.what();
  const bool coded = dynamic_cast<const CodedError*>(&error) != nullptr;
  std::fprintf(stderr, "footfall: warning: %s\n", (coded ? text : with_code(code::kNoExtraFiles, text)).c_str());
}

void print_results(const std::string& out, const std::vector<std::string>& pictures) {
  const Json summary = read_summary((fs::path(out) / "summary.json").string());
  std::printf("\n%s: %s\n", out.c_str(), end_text(summary).c_str());
  row(summary, "simulated time", "end_time_s", 1.0, "%.4g s");
  row(summary, "peak acceleration", "peak_acceleration_g", 1.0, "%.4g g (Earth's, 9.80665 m/s2)");
  row_by_size(summary, "largest descent", "max_descent_m", "m");
  if (touches_ground(summary)) {
    row_by_size(summary, "largest sinkage below the initial surface", "max_sinkage_m", "m");
    row_by_size(summary, "largest contact force on one body", "max_contact_force_N", "N");
  }
  row(summary, "energy balance of the mechanism", "energy_balance_relative", 100.0, "%.4f %% of the energy exchanged");
  row(summary, "coupling energy error", "coupling_energy_error_relative", 100.0, "%.3f %% of the energy exchanged");
  if (summary.contains("ledger")) {
    row_by_size(summary.at("ledger"), "energy given to the grains", "energy_to_grains_J", "J");
    row_by_size(summary.at("ledger"), "dissipated by the grains", "grains_dissipated_J", "J");
    row(summary.at("ledger"), "of the energy given, at the floor", "energy_to_floor_share", 100.0, "%.2g %% at most");
    row(summary.at("ledger"), "of the energy given, at the sides", "energy_to_sides_share", 100.0, "%.2g %% at most");
  }
  row(summary, "largest overlap of a grain", "max_overlap_over_radius", 100.0, "%.2f %% of its radius");
  row(summary, "grains", "particles", 1.0, "%.0f");
  if (summary.value("grains_lost", 0.0) > 0.0) {
    row(summary, "grains that left the box", "grains_lost", 1.0, "%.0f");
    row(summary, "their mass", "grains_lost_kg", 1.0, "%.4g kg");
  }
  row(summary, "steps", "steps", 1.0, "%.0f");
  row(summary, "windows", "windows", 1.0, "%.0f");
  print_times(summary);
  print_requirements(summary);
  // They have been printed as they came.
  for (const auto& [key, what] : {std::pair{"warnings", ""}, std::pair{"accepted_warnings", "accepted "}})
    if (const std::size_t count = summary.value(key, Json::array()).size(); count > 0)
      std::printf("  %zu %swarning%s: in summary.json\n", count, what, count == 1 ? "" : "s");
  std::printf("Files: %s\n", (fs::path(out) / "history.csv").c_str());
  for (const char* name : {"summary.json", "ledger.csv", "liggghts.log", "vtk"})
    if (fs::exists(fs::path(out) / name)) std::printf("       %s\n", (fs::path(out) / name).c_str());
  for (const std::string& picture : pictures) std::printf("       %s\n", picture.c_str());
}

bool write_ledger(const std::string& out) {
  const fs::path folder(out);
  try {
    if (!fs::exists(folder / "history.csv")) return false;
    const History run = read_history((folder / "history.csv").string());
    if (run.find("energy.total") < 0 || run.column("time").empty()) return false;
    const fs::path grains = folder / "grains_energy.txt";
    const History ledger =
        energy_ledger(run, fs::exists(grains) ? read_grain_energies(grains.string()) : GrainEnergies{});
    write_history((folder / "ledger.csv").string(), ledger);

    const fs::path file = folder / "summary.json";
    if (!fs::exists(file)) return true;
    Json summary = read_summary(file.string());
    Json metrics;
    double error = 0.0;
    for (const double e : ledger.column("closing_error")) error = std::max(error, std::abs(e));
    metrics["closing_error_relative"] = error;
    if (ledger.find("grains.dissipated") >= 0) {
      const double work = ledger.column("work.to_grains").back();
      metrics["energy_to_grains_J"] = work;
      const double initial = reference_energy(run);
      if (initial > 0.0) metrics["energy_to_grains_share"] = work / initial;
      metrics["grains_dissipated_J"] = ledger.column("grains.dissipated").back();
      // What has been there at one time: a wave that comes back is not counted twice.
      const WallEnergies walls = read_wall_energies((folder / "walls_energy.txt").string());
      const std::vector<double>& given = ledger.column("work.to_grains");
      const double most = *std::max_element(given.begin(), given.end());
      for (const bool floor : {true, false}) {
        const std::vector<double>& energy = floor ? walls.floor : walls.sides;
        if (energy.empty()) continue;
        const double largest = std::max(0.0, *std::max_element(energy.begin(), energy.end()));
        metrics[floor ? "energy_to_floor_J" : "energy_to_sides_J"] = largest;
        if (most > 0.0) metrics[floor ? "energy_to_floor_share" : "energy_to_sides_share"] = largest / most;
      }
    }
    summary["ledger"] = metrics;
    judge_ledger(summary, run, ledger);
    write_summary(file.string(), summary);
    return true;
  } catch (const std::exception& e) {
    warn_missing_file("ledger.csv", e);
  }
  return false;
}

std::vector<std::string> make_pictures(const std::string& out) {
  const fs::path plots = fs::path(out) / "plots";
  try {
    const Json summary = read_summary((fs::path(out) / "summary.json").string());
    std::string title = summary.contains("scene") ? summary.at("scene").value("title", "") : "";
    const History history = read_history((fs::path(out) / "history.csv").string());
    if (touches_nothing(history)) title += (title.empty() ? "" : ": ") + std::string("no body touches anything");
    std::vector<Figure> figures = standard_figures(history, summary.value("observed_body", ""));
    mark_figures(history, summary, figures);
    thin_figures(figures, history, plots.string(), "curves");
    const fs::path ledger = fs::path(out) / "ledger.csv";
    if (fs::exists(ledger)) {
      const History energies = read_history(ledger.string());
      std::vector<Figure> more = {ledger_figure(energies)};
      thin_figures(more, energies, plots.string(), "ledger");
      if (!more.front().curves.empty()) figures.push_back(more.front());
    }
    const std::vector<std::string> scripts = write_plot_scripts(plots.string(), figures, title);
    return run_gnuplot(plots.string(), scripts);
  } catch (const InputError& e) {
    warn_missing_file("plots", e);
  }
  return {};
}

}  // namespace footfall
