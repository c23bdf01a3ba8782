// Names are resolved once, at the start. At each step columns are reduced; at the end expressions of the rest are evaluated.

#include "mbd_solver/session/observe/requirements.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/output/former_names.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kEarthGravity = 9.80665;  // [m/s2]

std::optional<double> constant_of(const std::string& name) {
  if (name == "g0") return kEarthGravity;
  if (name == "deg") return kPi / 180.0;
  return std::nullopt;
}

// Tables of summary.json, whose keys are names of the scene.
constexpr const char* kTables[] = {"max_omega_h.", "flexible_bodies.", "clearance_"};

bool may_be_figure(const std::string& name) {
  const std::vector<std::string>& known = summary_figures();
  return std::find(known.begin(), known.end(), name) != known.end() ||
         std::any_of(std::begin(kTables), std::end(kTables),
                     [&](const char* table) { return name.rfind(table, 0) == 0; });
}

// KEY or KEY.NAME.KEY; nothing where there is no number.
std::optional<double> figure_of(const Json& summary, const std::string& name) {
  if (summary.contains(name) && summary.at(name).is_number()) return summary.at(name).get<double>();
  for (std::size_t dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1)) {
    const std::string key = name.substr(0, dot);
    if (!summary.contains(key) || !summary.at(key).is_object()) continue;
    if (const std::optional<double> found = figure_of(summary.at(key), name.substr(dot + 1))) return found;
  }
  return std::nullopt;
}

// "cabin.az.max" -> "cabin.az" and kMax.
std::optional<std::pair<std::string, Reduce>> reduced_name(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return std::nullopt;
  for (const Reduce reduce : every<Reduce>())
    if (name.substr(dot + 1) == name_of(reduce)) return std::pair(name.substr(0, dot), reduce);
  return std::nullopt;
}

constexpr const char* kLedger = "ledger.";

// Parts of the names of its columns and of the table in the summary.
bool may_be_of_ledger(const std::string& name) {
  constexpr const char* kBegins[] = {"mechanism.",    "dissipated.",      "work.",
                                     "interface",     "grains.",          "sum",
                                     "closing_error", "energy_to_grains", "grains_dissipated_J"};
  return name.rfind(kLedger, 0) == 0 && std::any_of(std::begin(kBegins), std::end(kBegins), [&](const char* begin) {
           return name.compare(7, std::string(begin).size(), begin) == 0;
         });
}

// Its value and margin, and the verdict.
void tell_value(double value, std::optional<double> least, std::optional<double> most, Json& told) {
  const double above = least ? value - *least : std::numeric_limits<double>::infinity();
  const double margin = std::min(above, most ? *most - value : above);
  told["value"] = value;
  told["margin"] = margin;
  told["verdict"] = margin >= 0.0 ? "met" : "missed";
}

double reduced_column(const std::vector<double>& column, Reduce reduce) {
  const auto [least, largest] = std::minmax_element(column.begin(), column.end());
  switch (reduce) {
    case Reduce::kMax: return *largest;
    case Reduce::kMin: return *least;
    case Reduce::kLargest: return std::max(std::abs(*least), std::abs(*largest));
    case Reduce::kFinal: return column.back();
  }
  FOOTFALL_DEMAND(false);
}

// Of the expression `text`; throws NumericalError with the reason why there is none.
double value_with_ledger(const std::string& text, std::optional<Reduce> reduce, const Json& summary,
                         const History& history, const History& ledger) {
  NamedValues values;
  for (const std::string& name : Expression::names_in(text)) values[name] = 0.0;
  const Expression expression(text, values);
  const auto of_ledger = [&](const std::string& name) { return name.rfind(kLedger, 0) == 0; };
  const auto column_of = [&](const std::string& name) -> const std::vector<double>& {
    const History& table = of_ledger(name) ? ledger : history;
    const std::string column = of_ledger(name) ? name.substr(7) : name;
    if (table.find(column) < 0 || table.column(column).empty())
      throw NumericalError("this run has no \"" + name + "\"");
    return table.column(column);
  };
  std::vector<std::pair<double*, const std::vector<double>*>> rows;
  for (auto& [name, value] : values) {
    const auto split = reduced_name(name);
    if (const auto constant = constant_of(name)) {
      value = *constant;
    } else if (reduce) {
      if (!of_ledger(name)) throw NumericalError("reads \"" + name + "\" together with columns of the ledger");
      rows.emplace_back(&value, &column_of(name));
    } else if (const auto figure = figure_of(summary, name)) {
      value = *figure;
    } else if (split) {
      value = reduced_column(column_of(split->first), split->second);
    } else {
      throw NumericalError("this run has no figure \"" + name + "\"");
    }
  }
  if (!reduce) return expression.value();
  std::vector<double> each(rows.empty() ? 0 : rows.front().second->size());
  for (std::size_t k = 0; k < each.size(); ++k) {
    for (const auto& [place, column] : rows) *place = (*column)[k];
    each[k] = expression.value();
  }
  if (each.empty()) throw NumericalError("the ledger has no row");
  return reduced_column(each, *reduce);
}

// Units that a requirement may state. The same quantity has several; unlike texts of this list are unlike units.
constexpr const char* kKnownUnits[] = {"rad",  "deg",  "m",    "mm", "cm",  "km",   "N",     "kN",   "Pa",
                                       "kPa",  "MPa",  "J",    "kJ", "s",   "ms",   "kg",    "t",    "m/s",
                                       "mm/s", "km/h", "m/s2", "g",  "N m", "kN m", "rad/s", "deg/s"};

bool is_known_unit(const std::string& unit) {
  return std::find(std::begin(kKnownUnits), std::end(kKnownUnits), unit) != std::end(kKnownUnits);
}

// By the end of its name: "max_descent_m"; empty where it names none.
std::string unit_of_figure(const std::string& name) {
  for (const char* unit : {"rad", "m", "N", "s", "J", "kg", "g"}) {
    const std::string end = std::string("_") + unit;
    if (name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0) return unit;
  }
  return "";
}

}  // namespace

std::vector<std::string> requirement_unit_warnings(const Scene& scene, const std::vector<std::string>& names,
                                                   const std::vector<std::string>& units) {
  std::vector<std::string> warnings;
  for (const RequirementSpec& spec : scene.requirements) {
    const std::vector<std::string> read = Expression::names_in(spec.value);
    if (read.size() != 1 || read.front() != trimmed(spec.value) || !is_known_unit(spec.unit)) continue;
    const auto split = reduced_name(read.front());
    const auto column = std::find(names.begin(), names.end(), split ? split->first : read.front());
    const std::string unit = column != names.end() ? units[column - names.begin()] : unit_of_figure(read.front());
    if (!is_known_unit(unit) || unit == spec.unit) continue;
    const bool angle = unit == "rad" && spec.unit == "deg";
    warnings.push_back(
        with_code(code::kRequirementUnit, place_of(scene.file, spec.source, "unit") + "is \"" + spec.unit + "\", but " +
                                              read.front() + " is in " + unit +
                                              ", and nothing is converted: its bounds are taken in " + unit + ". " +
                                              (angle ? "Write value = \"" + read.front() + " / deg\""
                                                     : std::string("Convert the value in its expression")) +
                                              ", or bounds and unit in " + unit));
  }
  return warnings;
}

void judge_ledger(Json& summary, const History& history, const History& ledger) {
  if (!summary.contains("requirements") || summary.value("status", "") != "done") return;
  const Json specs = summary.at("scene").value("requirements", Json::array());
  int missed = 0;
  for (std::size_t i = 0; i < summary.at("requirements").size(); ++i) {
    Json& told = summary.at("requirements")[i];
    const std::string text = i < specs.size() ? specs[i].value("value", "") : "";
    if (text.find(kLedger) != std::string::npos) {
      const auto bound = [&](const char* key) {
        return told.contains(key) ? std::optional<double>(told.at(key).get<double>()) : std::nullopt;
      };
      std::optional<Reduce> reduce;
      for (const Reduce kind : every<Reduce>())
        if (specs[i].value("reduce", "") == name_of(kind)) reduce = kind;
      try {
        tell_value(value_with_ledger(text, reduce, summary, history, ledger), bound("least"), bound("most"), told);
        told.erase("why");
      } catch (const NumericalError& error) {
        told["verdict"] = "not computed";
        told["why"] = error.what();
      }
    }
    missed += told.value("verdict", "") == "met" ? 0 : 1;
  }
  summary["requirements_missed"] = missed;
}

const std::vector<std::string>& summary_figures() {
  static const std::vector<std::string> names = split(
      "end_time_s peak_acceleration_g peak_acceleration_time_s max_descent_m max_descent_time_s max_sinkage_m "
      "max_sinkage_time_s max_contact_force_N max_contact_force_time_s max_step_force_N max_step_force_time_s "
      "creep_speed_m_s stability_distance_m stability_distance_time_s tip_energy_margin_J "
      "tip_energy_margin_time_s tipped max_tilt_rad max_tilt_time_s final_tilt_rad slid_distance_m "
      "pads_touched struts_at_stops reference_energy_J energy_flow_J energy_balance_relative drift_position "
      "drift_velocity drift_removed_position drift_removed_velocity coupling_energy_error_relative "
      "max_overlap_over_radius particles grains_lost grains_lost_kg dt_dem_s steps windows rejected_steps "
      "newton_failures residuals jacobians factorizations wall_s dem_wall_s waited_wall_s mbd_wall_s "
      "mbd_beside_wall_s control_wall_s checkpoint_wall_s exchange_wall_s",
      ' ');
  return names;
}

void Requirements::Range::see(double value) {
  least = seen ? std::min(least, value) : value;
  largest = seen ? std::max(largest, value) : value;
  last = value;
  seen = true;
}

double Requirements::Range::reduced(Reduce reduce) const {
  switch (reduce) {
    case Reduce::kMax: return largest;
    case Reduce::kMin: return least;
    case Reduce::kLargest: return std::max(std::abs(least), std::abs(largest));
    case Reduce::kFinal: return last;
  }
  FOOTFALL_DEMAND(false);
}

void Requirements::Range::visit(Archive& archive) {
  archive.members<&Range::least, &Range::largest, &Range::last, &Range::seen>(*this);
}

Requirements::Requirements(const Scene& scene, std::vector<std::string> columns)
    : scene_(scene), names_(std::move(columns)) {
  std::string faults;
  for (const RequirementSpec& spec : scene_.requirements) entries_.push_back(entry_of(spec, faults));
  if (!faults.empty()) throw InputError(code::kRequirementName, faults);
  for (Entry& entry : entries_) {
    for (auto& [place, name, reduce, column] : entry.reduced) {
      const auto at = std::find(watched_.begin(), watched_.end(), column);
      const auto k = static_cast<std::size_t>(at - watched_.begin());
      if (at == watched_.end()) watched_.push_back(column);
      column = k;
    }
  }
  ranges_.resize(watched_.size());
}

Requirements::Entry Requirements::entry_of(const RequirementSpec& spec, std::string& faults) const {
  const std::string place = place_of(scene_.file, spec.source, "value");
  auto values = std::make_unique<NamedValues>();
  for (const std::string& name : Expression::names_in(spec.value)) (*values)[name] = 0.0;
  Expression expression(spec.value, *values);
  Entry entry{std::move(values), std::move(expression), {}, {}, {}, {}};
  const auto column_of = [&](const std::string& name) -> std::optional<std::size_t> {
    const auto found = std::find(names_.begin(), names_.end(), present_name(name));
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
  };
  const auto fault = [&](const std::string& what) { faults += (faults.empty() ? "" : "\n") + place + what; };
  for (auto& [given, value] : *entry.values) {
    const std::string& name = present_name(given);
    const auto split = reduced_name(name);
    if (const auto constant = constant_of(name)) {
      value = *constant;
    } else if (const auto column = column_of(name)) {
      if (spec.reduce) {
        entry.columns.emplace_back(&value, *column);
      } else {
        fault("reads the column \"" + name + "\", which has a value at each instant; write " + name +
              ".max, .min, "
              ".largest or .final, or give reduce");
      }
    } else if (const auto reduced = split ? column_of(split->first) : std::nullopt; reduced && !spec.reduce) {
      entry.reduced.emplace_back(&value, name, split->second, *reduced);
    } else if (may_be_of_ledger(name)) {
      entry.keys.emplace_back(&value, name);  // known when the ledger is written
    } else if (may_be_figure(name) && !spec.reduce) {
      entry.keys.emplace_back(&value, name);
    } else if (name.rfind("coupling.", 0) == 0 && scene_.touches_particles()) {
      entry.keys.emplace_back(&value, name);  // a column that only a run with grains has
    } else if (spec.reduce && (may_be_figure(name) || reduced)) {
      fault("reads \"" + name + "\", which is one number of the run; leave reduce out, or read columns");
    } else {
      std::vector<std::string> known = names_;
      const std::vector<std::string>& figures = summary_figures();
      known.insert(known.end(), figures.begin(), figures.end());
      fault("unknown name \"" + name + "\"; expected a key of summary.json, or a recorded column of history.csv" +
            (spec.reduce ? "." : " with .max, .min, .largest or .final.") +
            known_names("names", split ? split->first : name, known));
    }
  }
  return entry;
}

void Requirements::see(const std::vector<double>& row) {
  for (std::size_t k = 0; k < watched_.size(); ++k) ranges_[k].see(row[watched_[k]]);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    if (!scene_.requirements[i].reduce) continue;
    for (const auto& [place, column] : entry.columns) *place = row[column];
    const double value = entry.expression.value_or_nan();
    if (std::isfinite(value)) {
      entry.range.see(value);
    } else if (entry.undefined_at < 0.0) {
      entry.undefined_at = row.front();
    }
  }
}

// Throws NumericalError with the reason why there is none.
double Requirements::value_of(Entry& entry, const RequirementSpec& spec, const Json& summary) const {
  if (spec.value.find(kLedger) != std::string::npos)
    throw NumericalError("the ledger is written after the run, by `footfall run` or `footfall report`");
  if (spec.reduce) {
    if (entry.undefined_at >= 0.0)
      throw NumericalError("\"" + spec.value + "\" has no value at t = " + number_text(entry.undefined_at, 6) + " s");
    if (!entry.range.seen) throw NumericalError("the run has no step");
    return entry.range.reduced(*spec.reduce);
  }
  for (const auto& [place, name] : entry.keys) {
    const std::optional<double> figure = figure_of(summary, name);
    if (!figure) throw NumericalError("this run has no figure \"" + name + "\"");
    *place = *figure;
  }
  for (const auto& [place, name, reduce, column] : entry.reduced) {
    if (!ranges_[column].seen) throw NumericalError("the run has no step");
    *place = ranges_[column].reduced(reduce);
  }
  return entry.expression.value();
}

void Requirements::judge(Json& summary) const {
  if (entries_.empty()) return;
  int missed = 0;
  Json list = Json::array();
  const bool complete = summary.value("status", "") == "done";
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const RequirementSpec& spec = scene_.requirements[i];
    Json told{{"name", spec.name}};
    std::string verdict = "not computed", why = "the run is not complete";
    if (complete) {
      try {
        tell_value(value_of(entries_[i], spec, summary), spec.least, spec.most, told);
        verdict = told.at("verdict").get<std::string>();
        why.clear();
      } catch (const NumericalError& error) {
        why = error.what();
      }
    }
    if (spec.least) told["least"] = *spec.least;
    if (spec.most) told["most"] = *spec.most;
    told["unit"] = spec.unit;
    told["verdict"] = verdict;
    if (!why.empty()) told["why"] = why;
    missed += verdict == "met" ? 0 : 1;
    list.push_back(std::move(told));
  }
  summary["requirements"] = std::move(list);
  summary["requirements_missed"] = missed;
}

void Requirements::visit(Archive& archive) {
  archive("ranges", ranges_);
  for (Entry& entry : entries_) {
    archive("range", entry.range);
    archive("undefined_at", entry.undefined_at);
  }
}

}  // namespace footfall
