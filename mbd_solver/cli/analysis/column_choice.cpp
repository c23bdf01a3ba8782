#include "mbd_solver/cli/analysis/column_choice.h"

#include <fnmatch.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"

namespace footfall {

namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

constexpr const char* kKinds[] = {"bodies", "joints", "struts", "springs", "drives", "controllers"};

// A * stays between two dots.
bool matches(const std::string& pattern, const std::string& name) {
  const auto as_path = [](std::string text) {
    std::replace(text.begin(), text.end(), '.', '/');
    return text;
  };
  return fnmatch(as_path(pattern).c_str(), as_path(name).c_str(), FNM_PATHNAME | FNM_NOESCAPE) == 0;
}

// The columns of what the scene has of this kind.
Names columns_of_kind(const History& history, const Json& scene, const std::string& kind) {
  Names found;
  const Json entries = scene.value(kind, Json::array());
  for (const Json& entry : entries) {
    const std::string owner = entry.value("name", "") + ".";
    for (const std::string& name : history.names)
      if (name.rfind(owner, 0) == 0) found.push_back(name);
  }
  return found;
}

Names columns_for(const History& history, const Json& scene, const std::string& word) {
  if (history.find(word) >= 0) return {word};
  Names found;
  for (const std::string& name : history.names)
    if (name != "time" && matches(word, name)) found.push_back(name);
  const std::size_t dot = word.find('.');
  if (found.empty() && dot != std::string::npos &&
      std::find(std::begin(kKinds), std::end(kKinds), word.substr(0, dot)) != std::end(kKinds)) {
    for (const std::string& name : columns_of_kind(history, scene, word.substr(0, dot)))
      if (matches(word.substr(dot + 1), name)) found.push_back(name);
  }
  for (const std::string between : {"", "."}) {
    if (!found.empty()) break;
    for (const char* axis : {"x", "y", "z"})
      if (history.find(word + between + axis) >= 0) found.push_back(word + between + axis);
  }
  return found;
}

struct Quantity {
  const char* unit;
  const char* name;
  bool grows;    // k, M, G for large values
  bool shrinks;  // m for small ones
};
constexpr Quantity kQuantities[] = {{"N", "force", true, false},    {"N m", "torque", true, false},
                                    {"J", "energy", true, false},   {"W", "power", true, false},
                                    {"Pa", "stress", true, false},  {"m", "length", false, true},
                                    {"m/s", "speed", false, false}, {"m/s2", "acceleration", false, false},
                                    {"rad", "angle", false, false}, {"rad/s", "angular velocity", false, false}};

const Quantity* quantity_of(const std::string& unit) {
  const auto* found =
      std::find_if(std::begin(kQuantities), std::end(kQuantities), [&](const Quantity& q) { return unit == q.unit; });
  return found == std::end(kQuantities) ? nullptr : found;
}

// What stands behind the last dot in all of them: "force" of a.force and b.force. Empty when they differ.
std::string common_ending(const Names& columns) {
  std::string common;
  for (const std::string& name : columns) {
    const std::size_t dot = name.rfind('.');
    const std::string ending = dot == std::string::npos ? "" : name.substr(dot + 1);
    if (ending.empty() || (!common.empty() && ending != common)) return "";
    common = ending;
  }
  return common;
}

// "leg_12_primary.force" -> "leg_12" and "primary.force"; no number: all of it behind an empty key.
std::pair<std::string, std::string> at_number(const std::string& name) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto first = std::find_if(name.begin(), name.end(), digit);
  if (first == name.end()) return {"", name};
  const auto last = std::find_if_not(first, name.end(), digit);
  std::string rest(last, name.end());
  const std::size_t letters = rest.find_first_not_of("_-.");
  return {std::string(name.begin(), last), letters == std::string::npos ? "" : rest.substr(letters)};
}

struct Group {
  std::string title;
  Names columns, labels;
  std::vector<int> colours;
};

// By the first number in the names. Empty where that makes no groups of at most eight.
std::vector<Group> by_number(const Names& columns) {
  std::vector<Group> groups;
  Names roles;
  for (const std::string& name : columns) {
    const auto [key, role] = at_number(name);
    if (key.empty()) return {};
    auto group = std::find_if(groups.begin(), groups.end(), [k = key](const Group& g) { return g.title == k; });
    if (group == groups.end()) group = groups.insert(groups.end(), Group{key, {}, {}, {}});
    auto found = std::find(roles.begin(), roles.end(), role);
    if (found == roles.end()) found = roles.insert(roles.end(), role);
    group->columns.push_back(name);
    group->labels.push_back(role);
    group->colours.push_back(static_cast<int>(found - roles.begin()));
  }
  const bool fit = roles.size() <= kSeriesColours && groups.size() > 1;
  return fit ? groups : std::vector<Group>{};
}

std::vector<Group> by_eights(const Names& columns, const std::string& title) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i % kSeriesColours == 0) groups.push_back({title, {}, {}, {}});
    Group& group = groups.back();
    group.columns.push_back(columns[i]);
    group.labels.push_back(columns[i]);
    group.colours.push_back(static_cast<int>(i % kSeriesColours));
  }
  return groups;
}

// "leg_1_primary.force" -> "leg_1_primary" where all end with ".force", which then stands at the axis.
void shorten(Names& labels, const std::string& ending) {
  if (ending.empty()) return;
  for (std::string& label : labels)
    if (ends_with(label, "." + ending)) label.resize(label.size() - ending.size() - 1);
}

}  // namespace

Names chosen_columns(const History& history, const Json& scene, const Names& words) {
  Names chosen;
  for (const std::string& word : words) {
    const Names found = columns_for(history, scene, word);
    if (found.empty())
      throw InputError("\"" + word + "\" is no column of this run's history, and no pattern of one." +
                       known_names("columns", word, history.names));
    for (const std::string& name : found)
      if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
  }
  return chosen;
}

DrawnUnit drawn_unit(const std::string& unit, double largest) {
  const Quantity* quantity = quantity_of(unit);
  if (quantity && quantity->grows) {
    if (largest >= 1e9) return {1e-9, "G" + unit};
    if (largest >= 1e6) return {1e-6, "M" + unit};
    if (largest >= 1e3) return {1e-3, "k" + unit};
  }
  if (quantity && quantity->shrinks && largest > 0.0 && largest < 0.1) return {1e3, "m" + unit};
  return {1.0, unit};
}

Panels panels_of(const History& history, const Names& columns) {
  std::vector<std::pair<std::string, Names>> of_unit;  // in the order of the columns
  for (const std::string& name : columns) {
    const std::string& unit = history.units[static_cast<std::size_t>(history.find(name))];
    auto same = std::find_if(of_unit.begin(), of_unit.end(), [&](const auto& entry) { return entry.first == unit; });
    if (same == of_unit.end()) same = of_unit.insert(of_unit.end(), {unit, {}});
    same->second.push_back(name);
  }
  Panels panels;
  for (const auto& [unit, names] : of_unit) {
    double low = 0.0, high = 0.0;
    for (const std::string& name : names) {
      for (const double value : history.column(name)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
    const DrawnUnit drawn = drawn_unit(unit, std::max(-low, high));
    const std::string ending = common_ending(names);
    const Quantity* quantity = quantity_of(unit);
    const bool is_word = ending.size() > 3;  // "force", "angle_rate", but not "az"
    const std::string what = is_word ? ending : quantity ? quantity->name : ending;
    std::vector<Group> groups;
    if (names.size() > kSeriesColours) groups = by_number(names);
    if (groups.empty()) groups = by_eights(names, names.size() == 1 ? names.front() : "");
    panels.multiples = panels.multiples || groups.size() > 1;
    for (Group& group : groups) {
      if (group.columns.size() > 1) shorten(group.labels, ending);
      Figure figure;
      figure.title = group.title;
      figure.axis = (what.empty() ? "" : what + " ") + "[" + drawn.name + "]";
      for (std::size_t i = 0; i < group.columns.size(); ++i)
        figure.curves.push_back(
            {group.labels[i], {{{1.0, group.columns[i]}}, 0.0, drawn.factor}, series_colour(group.colours[i])});
      if (groups.size() > 1 && high > low) {
        const double margin = 0.05 * (high - low);
        figure.low = drawn.factor * (low < 0.0 ? low - margin : 0.0);
        figure.high = drawn.factor * (high > 0.0 ? high + margin : 0.0);
      }
      panels.figures.push_back(std::move(figure));
    }
  }
  return panels;
}

}  // namespace footfall
