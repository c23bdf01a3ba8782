// Scenes are compared as trees: entries of lists by their names, so that a body more in one scene shifts no other. Curves are
// compared at the rows of the first run.
#include "mbd_solver/app/difference/run_pair.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/run_folder.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

using Tree = nlohmann::ordered_json;

constexpr std::size_t kLongestValue = 60;  // characters of a value in a table
constexpr double kRoundOff = 1e-9;         // relative

std::string value_text(const Tree* value) {
  if (value == nullptr || value->is_null()) return "-";
  std::string text = value->is_string()         ? value->get<std::string>()
                     : value->is_number_float() ? number_text(value->get<double>(), 9)
                                                : value->dump(-1, ' ', false, Tree::error_handler_t::replace);
  if (text.size() > kLongestValue) text = text.substr(0, kLongestValue - 3) + "...";
  return text;
}

bool is_list_of_names(const Tree& list) {
  return list.is_array() && !list.empty() && std::all_of(list.begin(), list.end(), [](const Tree& entry) {
           return entry.is_object() && entry.contains("name") && entry.at("name").is_string();
         });
}

const Tree* entry_of(const Tree& list, const std::string& name) {
  for (const Tree& entry : list)
    if (entry.at("name") == name) return &entry;
  return nullptr;
}

void find_differences(const std::string& key, const Tree* a, const Tree* b, std::vector<KeyDifference>& found);

void find_in_lists(const std::string& key, const Tree& a, const Tree& b, std::vector<KeyDifference>& found) {
  std::vector<std::string> names;
  for (const Tree* list : {&a, &b})
    for (const Tree& entry : *list)
      if (const std::string name = entry.at("name"); std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  for (const std::string& name : names) {
    const Tree *one = entry_of(a, name), *other = entry_of(b, name);
    if (one != nullptr && other != nullptr) {
      find_differences(key + "." + name, one, other, found);
    } else {
      found.push_back({key + "." + name, one != nullptr ? "there" : "-", other != nullptr ? "there" : "-"});
    }
  }
}

void find_differences(const std::string& key, const Tree* a, const Tree* b, std::vector<KeyDifference>& found) {
  if (a != nullptr && b != nullptr && *a == *b) return;
  const bool both = a != nullptr && b != nullptr;
  if (both && a->is_object() && b->is_object()) {
    std::vector<std::string> keys;
    for (const Tree* tree : {a, b})
      for (const auto& [name, value] : tree->items())
        if (std::find(keys.begin(), keys.end(), name) == keys.end()) keys.push_back(name);
    for (const std::string& name : keys)
      find_differences(key.empty() ? name : key + "." + name, a->contains(name) ? &a->at(name) : nullptr,
                       b->contains(name) ? &b->at(name) : nullptr, found);
    return;
  }
  if (both && is_list_of_names(*a) && is_list_of_names(*b)) return find_in_lists(key, *a, *b, found);
  found.push_back({key, value_text(a), value_text(b)});
}

// "max_contact_force_N" -> "max contact force" and "N".
std::pair<std::string, std::string> words_and_unit(std::string key) {
  std::string unit = "-";
  for (const auto& [ending, meaning] : {std::pair<const char*, const char*>{"_N", "N"},
                                        {"_m", "m"},
                                        {"_J", "J"},
                                        {"_g", "g"},
                                        {"_rad", "rad"},
                                        {"_m_s", "m/s"},
                                        {"_kg", "kg"},
                                        {"_relative", "-"},
                                        {"_s", "s"}})
    if (ends_with(key, ending)) {
      key.resize(key.size() - std::string(ending).size());
      unit = meaning;
      break;
    }
  std::replace(key.begin(), key.end(), '_', ' ');
  return {key, unit};
}

// Counts, wall-clock times, round-off, and when a peak was: those follow from others.
bool is_no_result(const std::string& key) {
  static const std::set<std::string> kCosts = {"steps",     "windows",   "rejected_steps", "newton_failures",
                                               "residuals", "jacobians", "factorizations"};
  return ends_with(key, "wall_s") || ends_with(key, "_time_s") || key.rfind("drift_", 0) == 0 || kCosts.count(key) > 0;
}

bool differ(double a, double b) { return std::abs(a - b) > kRoundOff * std::max(std::abs(a), std::abs(b)); }

}  // namespace

std::string name_of_run(const std::string& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

FinishedRun::FinishedRun(const std::string& run) : folder(run), name(name_of_run(run)) {
  const fs::path path = fs::absolute(run).lexically_normal();
  if (!fs::exists(path / "summary.json") || !fs::exists(path / "history.csv"))
    throw InputError(code::kNoRun,
                     without_summary(run, "no summary.json and history.csv; expected the folder of a run"));
  summary = read_summary((path / "summary.json").string());
  scene = summary.value("scene", Tree::object());
  history = read_history((path / "history.csv").string());
  if (history.column("time").size() < 2)
    throw InputError(code::kNoRun, (path / "history.csv").string() + ": fewer than two rows, nothing to compare");
}

RunPair::RunPair(const std::string& first, const std::string& second) : a(first), b(second) {
  if (a.name != b.name) return;
  a.name = first;
  b.name = second;
}

std::vector<KeyDifference> scene_differences(const Tree& a, const Tree& b) {
  std::vector<KeyDifference> found;
  find_differences("", &a, &b, found);
  return found;
}

std::vector<FigureDifference> figure_differences(const Tree& a, const Tree& b) {
  std::vector<FigureDifference> found;
  for (const auto& [key, value] : a.items()) {
    if (!value.is_number() || !b.contains(key) || !b.at(key).is_number() || is_no_result(key)) continue;
    const double one = value.get<double>(), other = b.at(key).get<double>();
    if (!differ(one, other)) continue;
    const auto [words, unit] = words_and_unit(key);
    found.push_back({words, unit, one, other, key});
  }
  return found;
}

double value_at(const History& history, const std::vector<double>& column, double t) {
  const std::vector<double>& time = history.columns.front();
  if (time.empty() || t < time.front() || t > time.back()) return std::numeric_limits<double>::quiet_NaN();
  const auto after = std::lower_bound(time.begin(), time.end(), t);
  const auto k = static_cast<std::size_t>(after - time.begin());
  if (k == 0 || time[k] == t) return column[k];
  const double share = (t - time[k - 1]) / (time[k] - time[k - 1]);
  return column[k - 1] + share * (column[k] - column[k - 1]);
}

std::vector<CurveDifference> curve_differences(const History& a, const History& b) {
  std::vector<CurveDifference> found;
  std::map<std::string, double> sizes;  // largest value of each unit
  for (const History* history : {&a, &b})
    for (std::size_t i = 1; i < history->names.size(); ++i)
      for (const double value : history->columns[i]) {
        double& size = sizes[history->units[i]];
        size = std::max(size, std::abs(value));
      }
  const std::vector<double>& time = a.columns.front();
  for (std::size_t i = 1; i < a.names.size(); ++i) {
    const int other = b.find(a.names[i]);
    if (other < 0) continue;
    const std::vector<double>&one = a.columns[i], &two = b.columns[other];
    CurveDifference curve{a.names[i], a.units[i]};
    double low = std::numeric_limits<double>::infinity(), high = -low, squares = 0.0;
    std::size_t rows = 0;
    for (std::size_t k = 0; k < time.size(); ++k) {
      const double theirs = value_at(b, two, time[k]);
      if (std::isnan(theirs)) continue;
      const double way = std::abs(theirs - one[k]);
      if (way > curve.largest) {
        curve.largest = way;
        curve.at = time[k];
      }
      low = std::min({low, one[k], theirs});
      high = std::max({high, one[k], theirs});
      squares += way * way;
      ++rows;
    }
    if (rows == 0 || !(curve.largest > kVisible * sizes[curve.unit])) continue;
    curve.share = high > low ? std::sqrt(squares / static_cast<double>(rows)) / (high - low) : 0.0;
    found.push_back(std::move(curve));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& x, const auto& y) { return x.share > y.share; });
  return found;
}

History on_one_clock(const RunPair& pair, const std::vector<std::string>& columns) {
  const History &a = pair.a.history, &b = pair.b.history;
  History both{{"time"}, {"s"}, {{}}};
  const std::vector<double>& theirs = b.columns.front();
  for (const double t : a.columns.front())
    if (t >= theirs.front() && t <= theirs.back()) both.columns.front().push_back(t);
  if (both.columns.front().size() < 2)
    throw InputError(code::kNotComparable, pair.b.folder + ": its rows and the rows of " + pair.a.folder +
                                               " have no time in common; compare runs of the same span");
  const std::vector<double> time = both.columns.front();
  for (const std::string& name : columns)
    for (const FinishedRun* run : {&pair.a, &pair.b}) {
      const History& history = run->history;
      const std::vector<double>& values = history.column(name);
      both.names.push_back(name + (run == &pair.a ? kFirstRun : kSecondRun));
      both.units.push_back(history.units[history.find(name)]);
      std::vector<double>& all = both.columns.emplace_back();
      for (const double t : time) all.push_back(value_at(history, values, t));
    }
  return both;
}

}  // namespace footfall
