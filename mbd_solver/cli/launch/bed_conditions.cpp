#include "mbd_solver/cli/launch/bed_conditions.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>

#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"

namespace footfall {

std::map<std::string, std::string> elastic_constants(const std::string& log) {
  std::map<std::string, std::string> constants;
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string fix, id, group, style, property, text;
    words >> fix >> id >> group >> style >> property;
    if (fix != "fix" || style != "property/global" || (property != "youngsModulus" && property != "poissonsRatio"))
      continue;
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      text += (text.empty() ? "" : " ") + (*end == '\0' ? number_text(number, 12) : word);
    }
    if (text.find('$') == std::string::npos) constants[property] = text;
  }
  return constants;
}

std::string different_material(const std::string& bed_log, const std::string& run_log) {
  const std::map<std::string, std::string> of_run = elastic_constants(run_log);
  std::string text;
  for (const auto& [property, value] : elastic_constants(bed_log)) {
    const auto other = of_run.find(property);
    if (other == of_run.end() || other->second == value) continue;
    text +=
        (text.empty() ? "" : "; ") + property + ": the bed was poured with " + value + ", the run has " + other->second;
  }
  return text;
}

void BedWatch::operator()() {
  if (bed_log_.empty()) return;
  const std::optional<std::string> log = read_whole_file(run_log_);
  if (!log || log->find("Setting up run") == std::string::npos) return;
  const std::string different = different_material(bed_log_, run_log_);
  bed_log_.clear();
  if (different.empty()) return;
  std::fprintf(
      stderr,
      "footfall: warning: %s (as LIGGGHTS' logs say): the grains lie otherwise than they would in the run; make "
      "them agree if this is not meant\n",
      different.c_str());
}

}  // namespace footfall
