// Tables of numbers that summary.json, peaks.csv and history.csv hold; nothing is computed anew.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include "coupler/base/text.h"
#include "mbd_solver/app/plots.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/peaks.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;
using Cells = std::vector<std::vector<std::string>>;

constexpr int kDigits = 4;

std::string with_unit(double value, const std::string& unit) {
  return number_text(value, kDigits) + (unit.empty() || unit == "-" ? "" : " " + unit);
}

std::string limits_of(const Json& r) {
  const std::string unit = r.value("unit", "");
  std::string text;
  if (r.contains("least")) text += "at least " + with_unit(r.at("least"), unit);
  if (r.contains("most")) text += (text.empty() ? "" : ", ") + ("at most " + with_unit(r.at("most"), unit));
  return text;
}

// "1.8 g (36 %)": of the limit that is nearest.
std::string margin_of(const Json& r) {
  const double margin = r.at("margin"), value = r.at("value");
  const bool at_most = r.contains("most") && (!r.contains("least") || r.at("most").get<double>() - value <= margin);
  const double limit = r.at(at_most ? "most" : "least");
  std::string text = with_unit(margin, r.value("unit", ""));
  if (limit != 0.0) text += " (" + number_text(100.0 * margin / std::abs(limit), 3) + " %)";
  return text;
}

bool is_met(const Json& r) { return r.value("verdict", "") == "met"; }

const Json& list_in(const Json& json, const char* key) {
  static const Json none = Json::array();
  return json.contains(key) && json.at(key).is_array() ? json.at(key) : none;
}

std::optional<double> number_in(const Json& json, const char* key) {
  if (!json.contains(key) || !json.at(key).is_number()) return std::nullopt;
  return json.at(key).get<double>();
}

// ---- one run ----

void show_key_numbers(const Json& summary, HtmlPage& page) {
  Cells rows = {{"key number", "value", "at"}};
  for (const KeyNumber& one : key_numbers(summary))
    rows.push_back({one.name, one.value, one.time >= 0.0 ? number_text(one.time, kDigits) + " s" : ""});
  page.subsection("Key numbers and their errors");
  page.table(rows);
}

void show_landing(const Json& summary, HtmlPage& page) {
  if (!summary.contains("landing") || !summary.contains("scene")) return;
  Cells rows = {{"event", "name", "value", "at"}};
  const auto at = [](double time) { return number_text(time, kDigits) + " s"; };
  const Json& landing = summary.at("landing");
  for (const Json& first : list_in(landing, "first_contacts"))
    rows.push_back({"first contact", first.at("name"), "", at(first.at("time_s"))});
  for (const Json& first : list_in(landing, "struts_at_stops"))
    rows.push_back({"strut at its stop", first.at("name"), "", at(first.at("time_s"))});
  for (const auto& [key, value] : summary.items()) {
    if (key.rfind("clearance_", 0) != 0 || !ends_with(key, "_m")) continue;
    const std::string name = key.substr(10, key.size() - 12);
    rows.push_back({"least clearance", name, readable(value, "m"),
                    at(number_in(summary, ("clearance_" + name + "_time_s").c_str()).value_or(0.0))});
  }
  if (rows.size() < 2) return;
  page.subsection("Contacts, stops and clearances");
  page.table(rows);
}

// Signed, of the larger size: "-3.2 kN at 0.041 s".
std::string peak_text(const ColumnPeaks& peaks) {
  const bool least = -peaks.least > peaks.largest;
  return readable(least ? peaks.least : peaks.largest, peaks.unit) + " at " +
         number_text(least ? peaks.least_time : peaks.largest_time, kDigits) + " s";
}

const ColumnPeaks* peaks_of(const std::vector<ColumnPeaks>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const ColumnPeaks& p) { return p.name == name; });
  return found == all.end() ? nullptr : &*found;
}

// The stroke that a strut has, in compression (sign 1) or tension (-1): up to its stop or the end of its honeycomb.
std::optional<double> available_stroke(const Json& strut, int sign) {
  std::optional<double> available;
  const auto limit = [&](double stroke) { available = std::min(stroke, available.value_or(stroke)); };
  if (strut.contains("stops") && strut.at("stops").is_object())
    if (const auto stop = number_in(strut.at("stops"), sign > 0 ? "max" : "min")) limit(sign * *stop);
  if (strut.contains("honeycomb") && strut.at("honeycomb").is_object()) {
    const Json& honeycomb = strut.at("honeycomb");
    double length = 0.0;
    for (const Json& stage : list_in(honeycomb, "stages")) length += number_in(stage, "length").value_or(0.0);
    if (honeycomb.value(sign > 0 ? "compression" : "tension", true) && length > 0.0) limit(length);
  }
  return available;
}

void show_struts(const Json& scene, const std::vector<ColumnPeaks>& peaks, HtmlPage& page) {
  Cells rows = {{"strut", "largest compression", "at", "largest tension", "at", "stroke in", "of available",
                 "stroke out", "of available"}};
  std::vector<std::string> classes = {""};
  double longest = 0.0, highest = 0.0;  // stroke [m], force [N]
  for (const Json& strut : list_in(scene, "struts")) {
    if (const ColumnPeaks* const stroke = peaks_of(peaks, strut.value("name", "") + ".stroke"))
      longest = std::max({longest, stroke->largest, -stroke->least});
    if (const ColumnPeaks* const force = peaks_of(peaks, strut.value("name", "") + ".force"))
      highest = std::max({highest, force->largest, -force->least});
  }
  constexpr double kNoStroke = 1e-4;  // of it: elastic, or round-off
  constexpr double kNoForce = 1e-6;   // of it: round-off
  for (const Json& strut : list_in(scene, "struts")) {
    const std::string name = strut.value("name", "");
    const ColumnPeaks *force = peaks_of(peaks, name + ".force"), *stroke = peaks_of(peaks, name + ".stroke");
    if (!force || !stroke) continue;
    std::vector<std::string> row = {name};
    for (const int sign : {1, -1}) {
      const double value = sign > 0 ? std::max(0.0, force->largest) : std::max(0.0, -force->least);
      const bool loaded = value > kNoForce * highest;
      row.push_back(loaded ? readable(value, "N") : "none");
      row.push_back(loaded ? number_text(sign > 0 ? force->largest_time : force->least_time, kDigits) + " s" : "");
    }
    bool used_up = false;
    for (const int sign : {1, -1}) {
      double used = sign > 0 ? stroke->largest : -stroke->least;
      if (used < kNoStroke * longest) used = 0.0;
      const std::optional<double> available = available_stroke(strut, sign);
      row.push_back(readable(used, "m"));
      row.push_back(available && *available > 0.0
                        ? number_text(100.0 * used / *available, 3) + " % of " + readable(*available, "m")
                        : "no stop");
      used_up = used_up || (available && *available > 0.0 && used >= *available);
    }
    rows.push_back(std::move(row));
    classes.push_back(used_up ? "missed" : "");
  }
  if (rows.size() < 2) return;
  page.subsection("Struts: loads and strokes");
  page.table(rows, true, classes);
}

// One row per owner with the signed peaks of these columns, where there are any that are not zero.
void show_peaks(const std::string& heading, const std::string& what, const Json& owners, const char* name_key,
                const std::vector<std::string>& endings, const std::vector<ColumnPeaks>& peaks, HtmlPage& page) {
  std::vector<std::string> head = {what};
  head.insert(head.end(), endings.begin(), endings.end());
  Cells rows = {head};
  std::map<std::string, double> largest;  // of each unit: far below it is round-off
  for (const Json& owner : owners)
    for (const std::string& ending : endings)
      if (const ColumnPeaks* const found = peaks_of(peaks, owner.value(name_key, "") + "." + ending))
        largest[found->unit] = std::max({largest[found->unit], found->largest, -found->least});
  constexpr double kRoundOff = 1e-7;
  for (const Json& owner : owners) {
    std::vector<std::string> row = {owner.value(name_key, "")};
    bool any = false;
    for (const std::string& ending : endings) {
      const ColumnPeaks* const found = peaks_of(peaks, row.front() + "." + ending);
      const bool loaded = found && std::max(found->largest, -found->least) > kRoundOff * largest[found->unit];
      row.push_back(loaded ? peak_text(*found) : "");
      any = any || loaded;
    }
    if (any) rows.push_back(std::move(row));
  }
  if (rows.size() < 2) return;
  page.subsection(heading);
  page.table(rows);
}

void show_energies(const std::filesystem::path& folder, HtmlPage& page) {
  const History history = read_history((folder / "history.csv").string());
  if (history.columns.empty() || history.columns.front().empty()) return;
  Cells rows = {{"energy", "start", "end"}};
  double largest = 0.0;
  const auto is_energy = [&](std::size_t k) {
    const std::string& name = history.names[k];
    return history.units[k] == "J" &&
           (name.rfind("energy.", 0) == 0 || name.rfind("dissipated.", 0) == 0 || name.rfind("work.", 0) == 0);
  };
  for (std::size_t k = 0; k < history.names.size(); ++k)
    if (is_energy(k))
      largest = std::max({largest, std::abs(history.columns[k].front()), std::abs(history.columns[k].back())});
  for (std::size_t k = 0; k < history.names.size(); ++k) {
    const double start = history.columns[k].front(), end = history.columns[k].back();
    constexpr double kVisible = 1e-6;  // of the largest
    if (!is_energy(k) || std::max(std::abs(start), std::abs(end)) <= kVisible * largest) continue;
    std::string words = history.names[k];
    std::replace(words.begin(), words.end(), '.', ' ');
    std::replace(words.begin(), words.end(), '_', ' ');
    rows.push_back({words, readable(start, "J"), readable(end, "J")});
  }
  if (rows.size() < 2) return;
  page.subsection("Energy");
  page.table(rows);
}

}  // namespace

void show_requirements(const Json& summary, HtmlPage& page) {
  const Json& list = list_in(summary, "requirements");
  if (list.empty()) return;
  page.section("Requirements");
  Cells rows = {{"requirement", "result", "limit", "margin", "verdict"}};
  std::vector<std::string> classes = {""};
  for (const Json& r : list) {
    const bool known = r.contains("value");
    rows.push_back({r.value("name", ""), known ? with_unit(r.at("value"), r.value("unit", "")) : "-", limits_of(r),
                    known ? margin_of(r) : r.value("why", ""), r.value("verdict", "")});
    classes.push_back(is_met(r) ? "met" : known ? "missed" : "open");
  }
  page.table(rows, true, classes);
}

std::vector<KeyNumber> key_numbers(const Json& summary) {
  std::vector<KeyNumber> all;
  const auto add = [&](const std::string& label, const char* key, const std::string& unit, const char* time) {
    const std::optional<double> value = number_in(summary, key), at = number_in(summary, time);
    if (value) all.push_back({label, readable(*value, unit), at.value_or(-1.0)});
  };
  const auto add_share = [&](const std::string& label, const char* key, const char* of) {
    if (const std::optional<double> value = number_in(summary, key))
      all.push_back({label, number_text(100.0 * *value, 3) + " % " + of, -1.0});
  };
  const std::string body = summary.value("observed_body", "");
  add("peak acceleration of " + body + ", g = 9.80665 m/s2 (Earth)", "peak_acceleration_g", "g",
      "peak_acceleration_time_s");
  add("largest descent of " + body, "max_descent_m", "m", "max_descent_time_s");
  if (number_in(summary, "max_sinkage_m").value_or(0.0) > 0.0)
    add("largest sinkage below the initial surface", "max_sinkage_m", "m", "max_sinkage_time_s");
  if (number_in(summary, "max_contact_force_N").value_or(0.0) > 0.0)
    add("largest contact force on one body", "max_contact_force_N", "N", "max_contact_force_time_s");
  else if (summary.contains("max_contact_force_N"))
    all.push_back({"contact", "no body touched the ground or the grains", -1.0});
  add("stability distance, least", "stability_distance_m", "m", "stability_distance_time_s");
  add("energy margin to tip-over, least", "tip_energy_margin_J", "J", "tip_energy_margin_time_s");
  for (const auto& [label, key] :
       {std::pair{"tilt, largest", "max_tilt_rad"}, std::pair{"tilt, final", "final_tilt_rad"}})
    if (const std::optional<double> tilt = number_in(summary, key)) {
      const double hundredths = std::round(1e4 * *tilt * 180.0 / kPi) / 1e4;  // of a hundredth of a degree
      all.push_back({label, number_text(hundredths, kDigits) + " deg", -1.0});
    }
  add("slid distance", "slid_distance_m", "m", "");
  if (const std::optional<double> tipped = number_in(summary, "tipped"))
    all.push_back({"tipped over", *tipped != 0.0 ? "yes" : "no", -1.0});
  add_share("error of the time integration", "energy_balance_relative", "of the energy exchanged");
  add_share("coupling energy error", "coupling_energy_error_relative", "of the energy exchanged");
  return all;
}

bool requirements_met(const Json& summary) {
  const Json& list = list_in(summary, "requirements");
  return std::all_of(list.begin(), list.end(), is_met);
}

std::vector<std::string> requirement_lines(const Json& summary) {
  std::vector<std::string> lines;
  for (const Json& r : list_in(summary, "requirements")) {
    std::string line = r.value("name", "") + ": ";
    if (r.contains("value")) {
      line += with_unit(r.at("value"), r.value("unit", "")) + ", " + limits_of(r) + ": " + r.value("verdict", "") +
              ", margin " + margin_of(r);
    } else {
      line += "could not be computed, " + limits_of(r) + ": " + r.value("why", "");
    }
    lines.push_back(line);
  }
  return lines;
}

std::string readable(double value, const std::string& unit) {
  const DrawnUnit drawn = drawn_unit(unit, std::abs(value));
  return with_unit(drawn.factor * value, drawn.name);
}

void show_sheet(const std::string& run, const Json& summary, HtmlPage& page) {
  const std::filesystem::path folder(run);
  show_key_numbers(summary, page);
  const std::vector<ColumnPeaks> peaks = read_peaks((folder / "peaks.csv").string());
  const Json scene = summary.value("scene", Json::object());
  show_landing(summary, page);
  show_struts(scene, peaks, page);
  const std::vector<std::string> wrench = {"fx", "fy", "fz", "mx", "my", "mz"};
  show_peaks("Joints: signed peaks of the loads on the second body", "joint", list_in(scene, "joints"), "name", wrench,
             peaks, page);
  if (!list_in(scene, "joints").empty() && !scene.value("output", Json::object()).value("reactions", false))
    page.paragraph("Loads of joints are recorded with output.reactions = true.");
  show_peaks("Drives: signed peaks", "drive", list_in(scene, "drives"), "name",
             {"joint_torque", "joint_force", "power"}, peaks, page);
  show_peaks("Ground: signed peaks of the contact forces", "body", list_in(scene, "boundaries"), "body",
             {"contact.fx", "contact.fy", "contact.fz"}, peaks, page);
  if (std::filesystem::exists(folder / "history.csv")) show_energies(folder, page);
}

void show_worst_cases(const NamedSummaries& runs, HtmlPage& page) {
  struct Worst {
    const Json* entry = nullptr;
    std::string run;
    int met = 0, missed = 0, open = 0;
  };
  std::vector<std::pair<std::string, Worst>> all;
  for (const auto& [run, summary] : runs) {
    for (const Json& r : list_in(summary, "requirements")) {
      const std::string name = r.value("name", "");
      auto at = std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.first == name; });
      if (at == all.end()) at = all.insert(all.end(), {name, Worst{}});
      Worst& worst = at->second;
      const bool known = r.contains("margin");
      (!known ? worst.open : is_met(r) ? worst.met : worst.missed) += 1;
      const bool first = worst.entry == nullptr || !worst.entry->contains("margin");
      if (worst.entry != nullptr && !known) continue;
      if (!first && !(r.at("margin").get<double>() < worst.entry->at("margin").get<double>())) continue;
      worst.entry = &r;
      worst.run = run;
    }
  }
  if (all.empty()) return;
  page.section("Requirements: worst cases");
  Cells rows = {{"requirement", "worst result", "limit", "margin", "run", "met", "missed", "not computed"}};
  std::vector<std::string> classes = {""};
  for (const auto& [name, worst] : all) {
    const Json& r = *worst.entry;
    const bool known = r.contains("value");
    rows.push_back({name, known ? with_unit(r.at("value"), r.value("unit", "")) : "-", limits_of(r),
                    known ? margin_of(r) : r.value("why", ""), worst.run, std::to_string(worst.met),
                    std::to_string(worst.missed), std::to_string(worst.open)});
    classes.push_back(worst.missed > 0 ? "missed" : worst.open > 0 ? "open" : "met");
  }
  page.table(rows, true, classes);
}

}  // namespace footfall
