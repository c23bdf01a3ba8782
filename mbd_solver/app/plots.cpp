// Chooses columns by kind and name, groups them into panels by unit, and hands figures to plot_script.
#include "mbd_solver/app/plots.h"

#include <fnmatch.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/run_directory.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/difference/pair_page.h"
#include "mbd_solver/app/difference/samples.h"
#include "mbd_solver/app/run_folder.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/session/output/spectra.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr double kKilo = 1e-3;
constexpr double kEarthGravity = 9.80665;  // [m/s2]
constexpr std::size_t kCrowded = 8;  // more curves of one unit become small multiples, if their names have numbers

// factor times one column
Formula of(const std::string& column, double factor = 1.0) { return {{{1.0, column}}, 0.0, factor}; }

// "energy.kinetic" -> "kinetic", "dissipated.mr_yield" -> "mr yield"
std::string words_after_dot(const std::string& name) {
  std::string words = name.substr(name.find('.') + 1);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

double largest(const History& history, const std::string& name) {
  double size = 0.0;
  for (double value : history.column(name)) size = std::max(size, std::abs(value));
  return size;
}

// Curves for every column that ends so, by the name before it.
std::vector<Curve> curves_of(const History& history, const std::string& ending, double factor) {
  std::vector<Curve> curves;
  for (const std::string& name : history.names)
    if (ends_with(name, ending)) curves.push_back({name.substr(0, name.size() - ending.size()), of(name, factor)});
  return curves;
}

std::string first_accelerated(const History& history) {
  for (const std::string& name : history.names)
    if (ends_with(name, ".az")) return name.substr(0, name.size() - 3);
  return "";
}

// Magnitude of the contact force on each body that touches something.
std::vector<Curve> contact_curves(const History& history) {
  std::vector<Curve> curves;
  for (const Curve& z : curves_of(history, ".contact.fz", 1.0)) {
    const std::string b = z.title + ".contact.f";
    if (largest(history, b + "x") == 0.0 && largest(history, b + "y") == 0.0 && largest(history, b + "z") == 0.0)
      continue;
    curves.push_back({z.title, {{{1.0, b + "x"}, {1.0, b + "y"}, {1.0, b + "z"}}, 0.0, 1.0, true}});
  }
  return curves;
}

// Columns that start so; parts too small to be seen are left out.
std::vector<Curve> energy_curves(const History& history, const std::string& start) {
  constexpr double kVisible = 2e-3;  // of the largest
  double scale = 0.0;
  std::vector<Curve> curves;
  for (const std::string& name : history.names)
    if (name.rfind(start, 0) == 0) scale = std::max(scale, largest(history, name));
  for (const std::string& name : history.names)
    if (name.rfind(start, 0) == 0 && largest(history, name) > kVisible * scale)
      curves.push_back({words_after_dot(name), of(name)});
  return curves;
}

std::vector<Curve> dissipation_curves(const History& history) {
  std::vector<Curve> curves = energy_curves(history, "dissipated.");
  const bool grains = history.find("coupling.energy_error") >= 0;
  if (grains && largest(history, "work.contact") > 0.0) curves.push_back({"to the grains", of("work.contact", -1.0)});
  return curves;
}

// "leg_2_primary" -> "leg_*_primary"
std::string with_stars_for_numbers(const std::string& name) {
  std::string out;
  for (const char c : name) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0)
      out += c;
    else if (out.empty() || out.back() != '*')
      out += '*';
  }
  return out;
}

// With more series than colours: a figure for each group whose names differ only in numbers, as the primary struts of all
// legs. Names like no other share figures.
void add_split(const Figure& figure, std::vector<Figure>& out) {
  if (figure.curves.size() <= kCrowded) {
    out.push_back(figure);
    return;
  }
  std::vector<std::pair<std::string, std::vector<Curve>>> groups;
  for (const Curve& curve : figure.curves) {
    const std::string group = with_stars_for_numbers(curve.title);
    const auto at = std::find_if(groups.rbegin(), groups.rend(), [&](const auto& g) { return g.first == group; });
    if (at == groups.rend() || at->second.size() == kCrowded)
      groups.push_back({group, {curve}});
    else
      at->second.push_back(curve);
  }
  std::vector<std::pair<std::string, std::vector<Curve>>> singles;
  for (const auto& [name, curves] : groups) {
    if (curves.size() > 1) continue;
    if (singles.empty() || singles.back().second.size() == kCrowded) singles.push_back({"", {}});
    singles.back().second.push_back(curves.front());
  }
  groups.erase(std::remove_if(groups.begin(), groups.end(), [](const auto& g) { return g.second.size() == 1; }),
               groups.end());
  groups.insert(groups.end(), singles.begin(), singles.end());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Figure part = figure;
    if (i > 0) part.name += "_" + std::to_string(i + 1);
    if (!groups[i].first.empty()) part.title += ": " + groups[i].first;
    part.curves = groups[i].second;
    out.push_back(part);
  }
}

// The axis "words [unit]" in a unit by the size of the curves, whose formulas give it in SI.
void fit_unit(const History& history, const std::string& words, const std::string& unit, Figure& figure) {
  double size = 0.0;
  for (const Curve& curve : figure.curves)
    for (const double value : curve.formula.values(history)) size = std::max(size, std::abs(value));
  const DrawnUnit drawn = drawn_unit(unit, size);
  for (Curve& curve : figure.curves) curve.formula.factor *= drawn.factor;
  figure.axis = words + " [" + drawn.name + "]";
}

// Leaves out curves that stay where they are, and all where what is drawn is round-off. The total of energies may be constant.
void keep_what_moves(const History& history, std::vector<Curve>& curves) {
  constexpr double kVisible = 1e-6;   // of the largest value
  constexpr double kRoundOff = 1e-9;  // in SI units
  std::vector<double> ranges;
  double size = 0.0;
  for (const Curve& curve : curves) {
    const std::vector<double> values = curve.formula.values(history);
    if (values.empty()) return;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    ranges.push_back(*high - *low);
    size = std::max({size, std::abs(*low), std::abs(*high)});
  }
  std::vector<Curve> moving;
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (size > kRoundOff && (ranges[i] > kVisible * size || curves[i].title == "total")) moving.push_back(curves[i]);
  curves = std::move(moving);
}

}  // namespace

std::vector<Figure> standard_figures(const History& history, const std::string& observed) {
  const bool known = !observed.empty() && history.find(observed + ".az") >= 0;
  const std::string body = known ? observed : first_accelerated(history);
  std::vector<Figure> figures;
  const auto add = [&](const std::string& name, const std::string& title, const std::string& words,
                       const std::string& unit, std::vector<Curve> curves) {
    keep_what_moves(history, curves);
    if (curves.empty()) return;
    Figure figure{name, title, "", std::move(curves)};
    fit_unit(history, words, unit, figure);
    figures.push_back(std::move(figure));
  };
  if (!body.empty() && !history.columns.front().empty()) {
    const double start = history.column(body + ".z").front();
    add("acceleration", "Acceleration of " + body, "vertical acceleration, Earth's", "g",
        {{body, of(body + ".az", 1.0 / kEarthGravity)}});
    add("velocity", "Velocity of " + body, "vertical velocity", "m/s", {{body, of(body + ".vz")}});
    add("descent", "Descent of " + body, "descent", "m", {{body, {{{-1.0, body + ".z"}}, start}}});
  }
  add("energy", "Mechanical energy and its parts", "energy", "J", energy_curves(history, "energy."));
  add("dissipation", "Dissipated energy and work on the grains", "energy", "J", dissipation_curves(history));
  add("strokes", "Strut strokes, compression positive", "stroke", "m", curves_of(history, ".stroke", 1.0));
  add("strut_forces", "Strut forces, compression positive", "force", "N", curves_of(history, ".force", 1.0));
  add("contact_forces", "Contact forces", "force on the body", "N", contact_curves(history));
  std::vector<Figure> split;
  for (const Figure& figure : figures) add_split(figure, split);
  return split;
}

namespace {

// The time at which the first body touches; none for a run that begins in contact, or never touches.
std::optional<double> touchdown_of(const History& history, const Json& summary) {
  if (summary.contains("landing") && summary.at("landing").contains("first_contacts")) {
    const Json& contacts = summary.at("landing").at("first_contacts");
    if (!contacts.empty()) return contacts.front().at("time_s").get<double>();
  }
  std::size_t first = history.columns.front().size();
  for (std::size_t i = 0; i < history.names.size(); ++i) {
    if (history.names[i].find(".contact.f") == std::string::npos) continue;
    const std::vector<double>& force = history.columns[i];
    const auto at = std::find_if(force.begin(), force.end(), [](double f) { return f != 0.0; });
    first = std::min(first, static_cast<std::size_t>(at - force.begin()));
  }
  if (first == 0 || first == history.columns.front().size()) return std::nullopt;
  return history.column("time")[first];
}

struct ColumnLimit {
  std::string column, text;
  double value;  // SI
};

// Requirements of one column, "cabin.az.max" or "cabin.az.largest / g0", and the stops of struts.
std::vector<ColumnLimit> column_limits(const Json& scene) {
  std::vector<ColumnLimit> limits;
  for (const Json& r : scene.value("requirements", Json::array())) {
    std::string text = r.value("value", "");
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    double scale = 1.0;
    if (ends_with(text, "/g0")) scale = kEarthGravity;
    if (ends_with(text, "/deg")) scale = std::atan(1.0) / 45.0;
    const std::string name = text.substr(0, text.find('/'));
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos || name.find_first_of("+-*()^<>?") != std::string::npos) continue;
    const std::string reduce = name.substr(dot + 1);
    for (const char* bound : {"least", "most"}) {
      if (!r.contains(bound) || !r.at(bound).is_number()) continue;
      const double value = scale * r.at(bound).get<double>();
      limits.push_back({name.substr(0, dot), r.value("name", ""), value});
      if (reduce == "largest") limits.push_back({name.substr(0, dot), r.value("name", ""), -value});
    }
  }
  for (const Json& strut : scene.value("struts", Json::array())) {
    if (!strut.contains("stops") || !strut.at("stops").is_object()) continue;
    for (const char* end : {"min", "max"})
      if (strut.at("stops").contains(end) && strut.at("stops").at(end).is_number())
        limits.push_back({strut.value("name", "") + ".stroke", "stop", strut.at("stops").at(end).get<double>()});
  }
  return limits;
}

// Only limits that the curves come near to: others would flatten them.
void add_limits(const std::vector<ColumnLimit>& limits, double low, double high, Figure& figure) {
  for (const ColumnLimit& limit : limits) {
    for (const Curve& curve : figure.curves) {
      const Formula& f = curve.formula;
      if (f.is_norm || f.columns.size() != 1 || f.columns.front().second != limit.column) continue;
      const double value = f.factor * (f.constant + f.columns.front().first * limit.value);
      const bool near = value <= high + 0.6 * (high - low) && value >= low - 0.6 * (high - low);
      const bool twice = std::any_of(figure.limits.begin(), figure.limits.end(), [&](const Mark& m) {
        return std::abs(m.value - value) <= 1e-6 * std::max(std::abs(value), high - low);
      });
      if (near && !twice) figure.limits.push_back({0.0, value, limit.text});
    }
  }
}

// Lowest and highest value of a curve in each of equal spans of time, with the ends of the lines that reach into it.
struct Envelope {
  static constexpr int kSpans = 400;
  std::vector<double> low = std::vector<double>(kSpans, std::numeric_limits<double>::infinity());
  std::vector<double> high = std::vector<double>(kSpans, -std::numeric_limits<double>::infinity());

  Envelope(const std::vector<double>& time, const std::vector<double>& values) {
    const double all = time.back() - time.front();
    const auto span = [&](double t) {
      return std::clamp(static_cast<int>(kSpans * (t - time.front()) / all), 0, kSpans - 1);
    };
    for (std::size_t k = 0; k < time.size() && all > 0.0; ++k) {
      const std::size_t next = std::min(k + 1, time.size() - 1);
      for (int s = span(time[k]); s <= span(time[next]); ++s) {
        // The part of the line that lies in the span.
        for (const double t : {std::max(time[k], time.front() + s * all / kSpans),
                               std::min(time[next], time.front() + (s + 1) * all / kSpans)}) {
          const double over = time[next] > time[k] ? std::clamp((t - time[k]) / (time[next] - time[k]), 0.0, 1.0) : 0.0;
          const double y = values[k] + over * (values[next] - values[k]);
          if (!std::isfinite(y)) continue;
          low[s] = std::min(low[s], y);
          high[s] = std::max(high[s], y);
        }
      }
    }
  }
  bool meets(int from, int to, double below, double above) const {
    for (std::size_t s = static_cast<std::size_t>(from); s <= static_cast<std::size_t>(to); ++s)
      if (low[s] < above && high[s] > below) return true;
    return false;
  }
};

// The place for the text of a peak that is nearest to the peak and meets neither a curve nor a limit: its middle. low, high: of
// the axis, in its unit.
std::optional<std::pair<double, double>> free_place(const Mark& peak, const std::vector<Envelope>& curves,
                                                    const std::vector<Mark>& limits, double start, double end,
                                                    double low, double high) {
  constexpr int kPlaces = 60;  // along each axis
  const double across = text_width(peak.text.size()), up = kTextHeight * (high - low);
  const auto share = [&](double t) { return (t - start) / (end - start); };
  std::optional<std::pair<double, double>> best;
  if (!(end > start) || !(high > low)) return best;
  double least = std::numeric_limits<double>::infinity();
  for (int j = 0; j <= kPlaces; ++j) {
    const double y = low + 0.5 * up + (high - low - up) * j / kPlaces, below = y - 0.5 * up, above = y + 0.5 * up;
    // The word of a limit is above its line.
    if (std::any_of(limits.begin(), limits.end(),
                    [&](const Mark& m) { return m.value < above && m.value + up > below; }))
      continue;
    for (int i = 0; i <= kPlaces && across < 1.0; ++i) {
      const double left = (1.0 - across) * i / kPlaces, right = left + across, x = share(peak.time);
      const double aside = std::max({left - x, x - right, 0.0});
      const double apart = std::max({below - peak.value, peak.value - above, 0.0}) / (high - low);
      const double way = std::hypot(aside, apart) + 1e-3 * std::abs(0.5 * (left + right) - x);
      if (!(way < least)) continue;
      const int from = std::max(0, static_cast<int>(Envelope::kSpans * left)),
                to = std::min(Envelope::kSpans - 1, static_cast<int>(Envelope::kSpans * right));
      if (std::any_of(curves.begin(), curves.end(), [&](const Envelope& e) { return e.meets(from, to, below, above); }))
        continue;
      least = way;
      best = {start + 0.5 * (left + right) * (end - start), y};
    }
  }
  return best;
}

}  // namespace

bool touches_nothing(const History& history) {
  bool has_contacts = false;
  for (const std::string& name : history.names) {
    if (name.find(".contact.f") == std::string::npos) continue;
    has_contacts = true;
    if (largest(history, name) > 0.0) return false;
  }
  return has_contacts;
}

void mark_figures(const History& history, const Json& summary, std::vector<Figure>& figures) {
  if (history.columns.empty() || history.columns.front().empty()) return;
  const std::optional<double> touchdown = touchdown_of(history, summary);
  const std::vector<ColumnLimit> limits = column_limits(summary.value("scene", Json::object()));
  const std::vector<double>& time = history.column("time");
  for (Figure& figure : figures) {
    if (touchdown) figure.times.push_back({*touchdown, 0.0, "touchdown"});
    double low = 0.0, high = 0.0, size = 0.0;
    Mark peak;
    std::vector<Envelope> envelopes;
    for (const Curve& curve : figure.curves) {
      const std::vector<double> values = curve.formula.values(history);
      envelopes.emplace_back(time, values);
      for (std::size_t k = 0; k < values.size(); ++k) {
        low = std::min(low, values[k]);
        high = std::max(high, values[k]);
        if (!(std::abs(values[k]) > size)) continue;
        size = std::abs(values[k]);
        peak = {time[k], values[k], ""};
      }
    }
    add_limits(limits, low, high, figure);
    const bool is_energy = figure.axis.rfind("energy", 0) == 0;
    if (size > 0.0 && !is_energy) {
      peak.text = number_text(peak.value, 3) + " at " + number_text(peak.time, 3) + " s";
      const bool fixed = figure.high > figure.low;
      peak.text_at = free_place(peak, envelopes, figure.limits, time.front(), time.back(), fixed ? figure.low : low,
                                fixed ? figure.high : high);
      figure.peaks.push_back(peak);
    }
  }
}

Figure ledger_figure(const History& ledger) {
  constexpr double kVisible = 2e-3;  // of the largest
  struct Band {
    std::string title, colour;
    std::vector<std::string> columns;
  };
  std::vector<Band> bands = {
      {"mechanism, kinetic", "#08519c", {"mechanism.kinetic"}},
      {"mechanism, gravity", "#4292c6", {"mechanism.gravity"}},
      {"mechanism, elastic", "#9ecae1", {"mechanism.strain", "mechanism.gas", "mechanism.contact"}}};
  const std::vector<std::string> warm = {"#a63603", "#e6550d", "#fd8d3c", "#fdae6b",
                                         "#fdd0a2", "#feedde", "#c51b8a", "#fa9fb5"};
  std::size_t next = 0;
  for (const std::string& name : ledger.names)
    if (name.rfind("dissipated.", 0) == 0)
      bands.push_back({"dissipated, " + words_after_dot(name), warm[next++ % warm.size()], {name}});
  if (ledger.find("grains.kinetic") >= 0) {
    bands.push_back({"grains, kinetic", "#00441b", {"grains.kinetic"}});
    bands.push_back({"grains, gravity", "#41ab5d", {"grains.gravity"}});
    bands.push_back({"grains, dissipated and elastic", "#c7e9c0", {"grains.dissipated"}});
  } else if (ledger.find("work.to_grains") >= 0) {
    bands.push_back({"to the grains", "#41ab5d", {"work.to_grains"}});
  }
  // Each band counts from its own lowest value: only changes of energy matter, and no band is negative.
  const auto height = [&](const Band& band) {
    Formula sum;
    for (const std::string& name : band.columns) sum.columns.emplace_back(1.0, name);
    return sum.values(ledger);
  };
  double scale = 0.0;
  std::vector<std::pair<double, double>> range;
  for (const Band& band : bands) {
    const std::vector<double> value = height(band);
    const auto [low, high] = std::minmax_element(value.begin(), value.end());
    range.emplace_back(*low, *high);
    scale = std::max(scale, *high - *low);
  }
  Formula edge{{}, 0.0, kKilo};  // upper edge of the band
  Figure figure{"ledger", "Energy balance by part, each from its lowest value", "energy [kJ]", {}, "../ledger.csv",
                true};
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (!(range[i].second - range[i].first > kVisible * scale)) continue;
    for (const std::string& name : bands[i].columns) edge.columns.emplace_back(1.0, name);
    edge.constant -= range[i].first;
    figure.curves.push_back({bands[i].title, edge, bands[i].colour});
  }
  return figure;
}

namespace {

using Names = std::vector<std::string>;

constexpr const char* kKinds[] = {"bodies", "joints", "struts", "cables", "springs", "drives", "controllers"};

// A * matches within two dots.
bool matches(const std::string& pattern, const std::string& name) {
  const auto as_path = [](std::string text) {
    std::replace(text.begin(), text.end(), '.', '/');
    return text;
  };
  return fnmatch(as_path(pattern).c_str(), as_path(name).c_str(), FNM_PATHNAME | FNM_NOESCAPE) == 0;
}

// The columns of all entries of this kind in the scene.
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
  bool shrinks;  // m, µ for small ones
};
constexpr Quantity kQuantities[] = {{"N", "force", true, true},     {"N m", "torque", true, true},
                                    {"J", "energy", true, true},    {"W", "power", true, true},
                                    {"Pa", "stress", true, false},  {"m", "length", false, true},
                                    {"m/s", "speed", false, true},  {"m/s2", "acceleration", false, false},
                                    {"rad", "angle", false, false}, {"rad/s", "angular velocity", false, false}};

const Quantity* quantity_of(const std::string& unit) {
  const auto* found =
      std::find_if(std::begin(kQuantities), std::end(kQuantities), [&](const Quantity& q) { return unit == q.unit; });
  return found == std::end(kQuantities) ? nullptr : found;
}

// The word after the last dot, if it is the same in all: "force" of a.force and b.force.
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

// "leg_12_primary.force" -> "leg_12" and "primary.force"; without a number an empty key and the whole name.
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

// By the first number in the names. Empty if that does not give groups of fewer series than colours.
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

std::vector<Group> by_colours(const Names& columns, const std::string& title) {
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

// "leg_1_primary.force" -> "leg_1_primary" if all end with ".force", which is then the label of the axis.
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
      throw InputError(code::kUnknownColumn, "\"" + word + "\" matches no column of this run's history." +
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
  if (quantity && quantity->shrinks && largest > 0.0) {
    if (largest < 1e-4) return {1e6, "µ" + unit};
    if (largest < 0.1) return {1e3, "m" + unit};
  }
  return {1.0, unit};
}

Panels panels_of(const History& history, const Names& columns) {
  std::vector<std::pair<std::string, Names>> of_unit;  // in the order of the columns
  for (const std::string& name : columns) {
    const std::string& unit = history.units[history.find(name)];
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
    if (names.size() > kCrowded) groups = by_number(names);
    if (groups.empty()) groups = by_colours(names, names.size() == 1 ? names.front() : "");
    panels.multiples = panels.multiples || groups.size() > 1;
    for (Group& group : groups) {
      if (group.columns.size() > 1) shorten(group.labels, ending);
      Figure figure;
      figure.title = group.title;
      figure.axis = (what.empty() ? "" : what + " ") + "[" + drawn.name + "]";
      for (std::size_t i = 0; i < group.columns.size(); ++i)
        figure.curves.push_back(
            {group.labels[i], {{{1.0, group.columns[i]}}, 0.0, drawn.factor}, "", group.colours[i]});
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

namespace {

constexpr std::size_t kLongestFile = 60;  // characters of a picture's name

// "struts.*.force" -> "struts.all.force"
std::string file_name(const std::vector<std::string>& words) {
  std::string name;
  for (const char c : joined(words, "-")) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-';
    name += c == '*' ? "all" : std::string(1, plain ? c : '_');
  }
  return name.substr(0, kLongestFile);
}

// A run in progress has none yet.
Json summary_of(const fs::path& run) {
  const fs::path file = run / "summary.json";
  return fs::exists(file) ? read_summary(file.string()) : Json::object();
}

void require_picture_ending(const std::string& out) {
  const std::string ending = fs::path(out).extension().string();
  if (!out.empty() && ending != ".png" && ending != ".svg" && ending != ".pdf")
    throw InputError(code::kWrongOption,
                     "--out " + out + ": ends with \"" + ending + "\", expected .png, .svg or .pdf");
}

PlotPage page_of(const std::string& name, const std::string& title, Panels panels) {
  PlotPage page{name, title, std::move(panels.figures), panels.multiples ? 2 : 1};
  const int count = static_cast<int>(page.figures.size()), rows = (count + page.columns - 1) / page.columns;
  page.width = page.columns == 1 ? 900 : 1500;
  page.height = count == 1 ? 520 : 60 + 330 * rows;
  // gnuplot's names of data blocks have letters, digits and _ only.
  std::string block = name;
  std::replace_if(
      block.begin(), block.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  for (int i = 0; i < count; ++i) page.figures[i].name = "columns_" + block + "_" + std::to_string(i + 1);
  if (count == 1 && !title.empty() && page.figures.front().title.find(title) == std::string::npos)
    page.figures.front().title = title + (page.figures.front().title.empty() ? "" : ": " + page.figures.front().title);
  return page;
}

std::vector<std::string> column_list(const History& history) {
  std::vector<std::string> lines;
  for (std::size_t i = 1; i < history.names.size(); ++i)
    lines.push_back(history.names[i] + " [" + history.units[i] + "]");
  return lines;
}

// The unit in which a spectrum of this column is drawn: g for accelerations.
std::pair<double, std::string> spectrum_unit(const std::string& unit) {
  return unit == "m/s2" ? std::pair(1.0 / kEarthGravity, std::string("g, Earth's 9.81 m/s2")) : std::pair(1.0, unit);
}

// Writes the spectra of the columns to FOLDER/NAME.csv in SI, and returns their figure.
Figure spectrum_figure(const ColumnPlot& plot, const History& history, const Names& columns, const std::string& file,
                       const std::string& folder, const std::string& name) {
  const EvenTimes times = even_times(history.column("time"), file);
  const bool shock = plot.srs > 0.0;
  History table{{"frequency"}, {"Hz"}, {}};
  Figure figure;
  figure.name = name;
  std::string unit;
  for (const std::string& column : columns) {
    std::vector<double> x = history.column(column);
    x.resize(times.rows);
    const auto window =
        plot.psd > 0.0 ? static_cast<std::size_t>(std::lround(plot.psd / times.step)) : default_window(times.rows);
    if (!shock && (window < 4 || window > times.rows))
      throw InputError(code::kOutOfData, "--psd: a window of " + number_text(plot.psd, 6) +
                                             " s, expected at least four rows and at most the run, from " +
                                             number_text(4.0 * times.step, 4) + " to " +
                                             number_text(times.step * static_cast<double>(times.rows), 4) + " s");
    Spectrum spectrum = shock ? shock_response(x, times.step, plot.srs, shock_frequencies(times.step, times.rows))
                              : power_density(x, times.step, window);
    if (!shock) {  // the mean has no place on a logarithmic axis
      spectrum.frequency.erase(spectrum.frequency.begin());
      spectrum.value.erase(spectrum.value.begin());
    }
    const std::string own = history.units[history.find(column)];
    if (!unit.empty() && own != unit)
      throw InputError(code::kWrongOption, "columns in " + unit + " and in " + own +
                                               " have no common axis of spectra; draw one kind at a time");
    unit = own;
    if (table.columns.empty()) table.columns.push_back(spectrum.frequency);
    table.names.push_back(column);
    table.units.push_back(shock ? own : "(" + own + ")2/Hz");
    table.columns.push_back(std::move(spectrum.value));
    const double factor = spectrum_unit(own).first;
    figure.curves.push_back({column, of(column, shock ? factor : factor * factor)});
  }
  const std::string drawn = spectrum_unit(unit).second;
  figure.axis = shock ? "largest response [" + drawn + "]" : "power density [(" + drawn + ")²/Hz]";
  figure.title = shock ? "Shock response spectrum, Q = " + number_text(plot.srs, 4) : "Power spectral density";
  figure.x = "frequency";
  figure.x_axis = "frequency [Hz]";
  figure.logarithmic = true;
  figure.file = name + ".csv";
  make_folder(folder);
  write_history((fs::path(folder) / figure.file).string(), table);
  return figure;
}

constexpr const char* kFilteredMark = "_CFC";  // of a filtered column

// The history with the filtered columns added; columns: they and the measured ones.
History with_filtered(const History& history, const ColumnPlot& plot, const std::string& file, Names& columns) {
  const History filtered = filtered_history(history, columns, plot.cfc, file);
  History both{{"time"}, {"s"}, {filtered.columns.front()}};
  Names names;
  for (std::size_t i = 1; i < filtered.names.size(); ++i) {
    std::vector<double> measured = history.column(filtered.names[i]);
    measured.resize(both.columns.front().size());
    for (const bool is_filtered : {false, true}) {
      names.push_back(filtered.names[i] + (is_filtered ? kFilteredMark + std::to_string(plot.cfc) : ""));
      both.names.push_back(names.back());
      both.units.push_back(filtered.units[i]);
      both.columns.push_back(is_filtered ? filtered.columns[i] : measured);
    }
  }
  columns = names;
  return both;
}

// Draws the page in `plots`, and returns the pictures.
std::vector<std::string> drawn(const ColumnPlot& plot, PlotPage page, const fs::path& plots) {
  page.style = plot.style;
  page.pdf = fs::path(plot.out).extension() == ".pdf";
  const std::string script = write_page_script(plots.string(), page);
  const std::string picture = run_gnuplot(plots.string(), {script}).front();
  if (plot.out.empty()) return {short_path(picture), short_path(fs::path(picture).replace_extension(".svg").string())};
  const std::string drawn = fs::path(picture).replace_extension(fs::path(plot.out).extension()).string();
  const std::optional<std::string> bytes = read_whole_file(drawn);
  if (!bytes)
    throw InputError(code::kGnuplotFailed,
                     drawn + ": gnuplot did not draw it; see " + (plots / "gnuplot.log").string());
  write_whole_file(plot.out, *bytes);
  return {plot.out};
}

// The figures read FOLDER/NAME.csv, which gets this history.
void draw_from(const History& history, const std::string& name, const fs::path& plots, PlotPage& page) {
  make_folder(plots.string());
  write_history((plots / (name + ".csv")).string(), history);
  for (Figure& figure : page.figures) figure.file = name + ".csv";
  if (is_long(history)) thin_figures(page.figures, history, plots.string(), page.name + "_drawn");
}

// Columns of a sweep, or of two folders of which one is a sweep: mean and band of each case.
std::vector<std::string> plot_samples(const ColumnPlot& plot) {
  require_picture_ending(plot.out);
  guard_folder(plot.run);
  const std::vector<SampledCase> cases = plot.other.empty() ? cases_in(plot.run) : cases_in(plot.run, plot.other);
  const fs::path first(cases.front().runs.front());
  const History history = read_history((first / "history.csv").string());
  if (plot.columns.empty()) return column_list(history);
  const Json scene = summary_of(first).value("scene", Json::object());
  const Names columns = chosen_columns(history, scene, plot.columns);
  const History bands = bands_on_one_clock(cases, columns);
  const fs::path plots = fs::path(plot.run) / "plots";
  const std::string name = plot.other.empty() ? file_name(plot.columns)
                                              : file_name({file_name(plot.columns), "with", name_of_run(plot.other)});
  PlotPage page = page_of(name, plot.title.empty() ? scene.value("title", "") : plot.title,
                          {figures_of_bands(cases, bands, columns)});
  draw_from(bands, name, plots, page);
  return drawn(plot, std::move(page), plots);
}

}  // namespace

std::vector<std::string> plot_columns(const ColumnPlot& plot) {
  if (is_sweep(plot.run) || (!plot.other.empty() && is_sweep(plot.other))) return plot_samples(plot);
  const fs::path run(plot.run);
  const std::string file = (run / "history.csv").string();
  if (!fs::exists(file))
    throw InputError(code::kNoRun, without_summary(plot.run, "no history.csv; expected the folder of a run"));
  require_picture_ending(plot.out);
  guard_folder(plot.run);
  History history = read_history(file);
  if (plot.columns.empty()) return column_list(history);
  if (history.columns.front().size() < 2)
    throw InputError(code::kNoRun,
                     without_summary(plot.run, "history.csv has fewer than two rows, nothing to draw yet"));
  const Json summary = summary_of(run);
  const Json scene = summary.value("scene", Json::object());
  Names columns = chosen_columns(history, scene, plot.columns);

  const fs::path plots = run / "plots";
  const std::string title = plot.title.empty() ? scene.value("title", "") : plot.title;
  std::string name = file_name(plot.columns);
  PlotPage page;
  if (!plot.other.empty()) {
    const RunPair pair(plot.run, plot.other);
    PairPlots pairs = plots_of_columns(pair, columns);
    name = file_name({name, "with", pair.b.name});
    page = page_of(name, pair.a.name + " and " + pair.b.name, std::move(pairs.panels));
    draw_from(pairs.history, name, plots, page);
  } else if (plot.srs > 0.0 || plot.psd >= 0.0) {
    name += plot.srs > 0.0 ? "_srs" : "_psd";
    Panels panels;
    panels.figures = {spectrum_figure(plot, history, columns, file, plots.string(), name)};
    page = page_of(name, title, std::move(panels));
  } else {
    if (plot.cfc > 0) {
      history = with_filtered(history, plot, file, columns);
      name += kFilteredMark + std::to_string(plot.cfc);
    }
    page = page_of(name, title, panels_of(history, columns));
    mark_figures(history, summary, page.figures);
    if (plot.cfc > 0)
      draw_from(history, name, plots, page);
    else if (is_long(history))
      thin_figures(page.figures, history, plots.string(), page.name + "_drawn");
  }
  return drawn(plot, std::move(page), plots);
}

}  // namespace footfall
