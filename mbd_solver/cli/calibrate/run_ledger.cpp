#include "mbd_solver/cli/calibrate/run_ledger.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/fingerprint.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/scene/field_reader.h"

namespace footfall {

using Json = nlohmann::ordered_json;

namespace {

// A target that this scene's runs have to answer.
bool asks(const TargetSpec& target, const std::string& scene) {
  return target.scene == scene || target.against == scene;
}

std::string text_of(const FigureSpec& f) {
  std::ostringstream text;
  text.precision(17);
  text << f.name << '\n' << f.key << '\n' << joined(f.columns, ",") << '\n' << name_of(f.reduction) << ' ' << f.average;
  text << ' ' << f.prominence << ' ' << f.over;
  for (const double height : f.slope) text << ' ' << height;
  return text.str();
}

}  // namespace

std::string RunLedger::asked_of(const std::string& scene) const {
  std::ostringstream text;
  text.precision(17);
  for (const TargetSpec& target : spec_.targets) {
    if (!asks(target, scene)) continue;
    if (target.is_curve()) {
      text << target.name << '\n' << target.column << '\n' << target.over;
      for (const Eigen::Vector2d& row : read_two_columns(target.file)) text << ' ' << row.x();
    } else {
      text << text_of(spec_.figures[static_cast<std::size_t>(index_of(spec_.figures, target.figure))]);
    }
    text << '\n';
  }
  return fingerprint(text.str()).substr(0, 16);
}

RunLedger::RunLedger(const CalibrationSpec& spec, std::string file) : spec_(spec), file_(std::move(file)) {
  if (file_.empty()) return;
  for (const CalibrationScene& scene : spec_.scenes) asked_[scene.name] = asked_of(scene.name);
  std::istringstream in(read_whole_file(file_).value_or(""));
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty()) continue;
    const Json json = Json::parse(line, nullptr, false);
    if (in.eof() && json.is_discarded()) break;  // cut short
    try {
      const std::string scene = json.at("scene"), asked = json.at("asked");
      const auto known = asked_.find(scene);
      if (known == asked_.end() || known->second != asked) {
        other_lines_ += line + "\n";
        continue;
      }
      Entry entry;
      entry.run = json.at("run");
      entry.wall = json.at("wall_s"), entry.cpu = json.at("cpu_s");
      entry.numbers.figures.assign(spec_.figures.size(), std::nan(""));
      entry.numbers.curves.resize(spec_.targets.size());
      for (const auto& [name, value] : json.at("figures").items())
        if (const int k = index_of(spec_.figures, name); k >= 0)
          entry.numbers.figures[static_cast<std::size_t>(k)] = value.get<double>();
      for (const auto& [name, values] : json.at("curves").items())
        if (const int t = index_of(spec_.targets, name); t >= 0)
          entry.numbers.curves[static_cast<std::size_t>(t)] = values.get<std::vector<double>>();
      entries_[{scene, json.at("recipe")}] = entry;
    } catch (const Json::exception&) {
      throw InputError(file_ + ":" + std::to_string(number) +
                       ": is no entry of a ledger of runs; expected a line as footfall calibrate writes it. Remove the "
                       "line, and the run is done again");
    }
  }
}

const RunLedger::Entry* RunLedger::find(const std::string& scene, const std::string& recipe) const {
  const auto found = entries_.find({scene, recipe});
  return recipe.empty() || found == entries_.end() ? nullptr : &found->second;
}

void RunLedger::note(const std::string& scene, const std::string& recipe, const Entry& entry) {
  if (file_.empty() || recipe.empty()) return;
  changed_ = entries_.emplace(std::make_pair(scene, recipe), entry).second || changed_;
}

void RunLedger::write() {
  if (!changed_) return;
  std::string text = other_lines_;
  for (const auto& [key, entry] : entries_) {
    Json figures = Json::object(), curves = Json::object();
    for (std::size_t k = 0; k < entry.numbers.figures.size(); ++k)
      if (!std::isnan(entry.numbers.figures[k])) figures[spec_.figures[k].name] = entry.numbers.figures[k];
    for (std::size_t t = 0; t < entry.numbers.curves.size(); ++t)
      if (!entry.numbers.curves[t].empty()) curves[spec_.targets[t].name] = entry.numbers.curves[t];
    const Json line = {{"scene", key.first}, {"recipe", key.second}, {"asked", asked_.at(key.first)},
                       {"run", entry.run},   {"wall_s", entry.wall}, {"cpu_s", entry.cpu},
                       {"figures", figures}, {"curves", curves}};
    text += line.dump() + "\n";
  }
  write_whole_file(file_, text);
  changed_ = false;
}

}  // namespace footfall
