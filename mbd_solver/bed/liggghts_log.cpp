// Reads the log of LIGGGHTS as text. The place of an error is found by following the commands of the script that the log
// repeats, one after the other.
#include "mbd_solver/bed/liggghts_log.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "coupler/base/clock.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/scene/particle_script.h"

namespace footfall {
LogProgress log_progress(const std::string& log) {
  LogProgress p;
  for (TextReader text = TextReader::if_there(log); text.next();) {
    const std::string& line = text.line();
    long number = 0;
    char rest = 0;
    double columns[2];
    if (std::sscanf(line.c_str(), "run %ld %c", &number, &rest) == 1 && number > 0) {
      p.first = std::max(0L, p.step);
      p.last = p.first + number;
      ++p.runs;
    } else if (std::sscanf(line.c_str(), "reset_timestep %ld %c", &number, &rest) == 1) {
      p.step = number;
    } else if (std::sscanf(line.c_str(), "%ld %lf %lf", &number, &columns[0], &columns[1]) == 3) {
      p.step = number;
    }
  }
  return p;
}

double LogProgress::share() const {
  return begun() ? std::clamp(static_cast<double>(step - first) / static_cast<double>(last - first), 0.0, 1.0) : 0.0;
}

std::string LogProgress::text() const {
  if (!begun()) return "setting up";
  return (runs > 1 ? "run " + std::to_string(runs) + ", " : "") + "step " + std::to_string(step - first) + " of " +
         std::to_string(last - first) + " (" + percent_text(share()) + ")";
}

SettlingLine::SettlingLine(std::string log, std::string begun, bool quiet)
    : log_(std::move(log)),
      begun_(std::move(begun)),
      live_(quiet, isatty(STDOUT_FILENO) == 1),
      started_(wall_clock()) {}

void SettlingLine::operator()() {
  constexpr long kEndless = 100000000;  // a run command of so many steps lasts until the scene ends
  const double now = wall_clock();
  if (over_ || now < next_look_) return;
  next_look_ = now + 0.5;
  if (std::error_code none; std::filesystem::exists(begun_, none)) {
    over_ = true;
    live_.finish(true);
    return;
  }
  const LogProgress p = log_progress(log_);
  if (!p.begun() || p.last - p.first >= kEndless || p.step == p.first) return;
  if (p.runs != runs_) {
    runs_ = p.runs;
    started_ = now;
    share_ = p.share();
  }
  const std::string left = time_left({p.share(), p.share() - share_, now - started_});
  if (live_.due(p.share())) live_.show("before the coupling: " + p.text() + (left.empty() ? "" : ", " + left));
}

std::vector<std::string> log_lines(const std::string& log) {
  constexpr int kMostLogs = 8;
  std::vector<std::string> lines;
  std::string name = log;
  for (int logs = 0; logs < kMostLogs && !name.empty(); ++logs) {
    TextReader text = TextReader::if_there(name);
    name.clear();
    while (text.next()) {
      lines.push_back(text.line());
      const std::vector<std::string_view>& words = text.fields(Separators::kBlanks);
      if (words.size() > 1 && words[0] == "log" && words[1].find('$') == std::string_view::npos) name = words[1];
    }
  }
  return lines;
}

std::string liggghts_errors(const std::string& log) {
  std::string errors;
  for (const std::string& line : log_lines(log))
    if (line.rfind("ERROR", 0) == 0 || line.rfind("Fix couple", 0) == 0) errors += (errors.empty() ? "" : "\n") + line;
  return errors;
}

std::string ReadingWatch::operator()() {
  const double now = wall_clock();
  if (now < next_look_) return "";
  next_look_ = now + 1.0;
  const std::string line = TextReader::last_line_of(log_);
  const bool reads = line.rfind("read_restart", 0) == 0 || line.rfind("Reading restart", 0) == 0;
  since_ = !reads ? 0.0 : since_ > 0.0 ? since_ : now;
  if (!reads || now - since_ < limit_) return "";
  return with_code(code::kRestartDamaged, "LIGGGHTS has been at \"" + line + "\" for " + number_text(limit_) +
                                              " s: the restart file is damaged; make it again");
}

namespace {

// `line` is `written` with some of its variables replaced: LIGGGHTS repeats a line after each replacement.
bool is_repeated(const std::vector<std::string>& line, const std::vector<std::string>& written) {
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (written[i].find('$') != std::string::npos) return true;  // a value may be several words
    if (i >= line.size() || line[i] != written[i]) return false;
  }
  return false;
}

}  // namespace

std::string why_liggghts_stopped(const std::string& log, const std::string& script,
                                 const std::map<std::string, std::string>& variables) {
  const std::string errors = liggghts_errors(log);
  std::string meaning;
  const std::size_t internal = errors.find("Internal error (");
  if (internal != std::string::npos && errors.find("/tri_mesh_I.h", internal) != std::string::npos)
    meaning =
        "\nThe position of a grain at a mesh is not a number. Usually its centre lay exactly on the mesh, where stock "
        "LIGGGHTS stops too: start the body a little higher (initial.clearance), or move the grain. Otherwise reduce "
        "the time step.";
  return where_liggghts_stopped(log, script, variables) + "\n" + errors + meaning;
}

std::string where_liggghts_stopped(const std::string& log, const std::string& script,
                                   const std::map<std::string, std::string>& variables) {
  const ScriptText text(script, variables);
  std::vector<const ScriptCommand*> commands;
  std::vector<std::vector<std::string>> written;
  for (const ScriptCommand& command : text.commands()) {
    if (command.conditional) continue;
    commands.push_back(&command);
    written.push_back(blank_words(command.text));
  }
  const std::size_t none = commands.size();
  std::size_t at = none;
  for (const std::string& logged : log_lines(log)) {
    if (logged.rfind("ERROR", 0) == 0) break;
    const std::vector<std::string> line = blank_words(logged);
    if (line.empty() || (at != none && is_repeated(line, written[at]))) continue;
    // Usually the next command; after a loop an earlier one.
    const std::size_t first = at == none ? 0 : at + 1;
    for (std::size_t k = 0; k < none; ++k) {
      const std::size_t candidate = (first + k) % none;
      if (written[candidate] != line) continue;
      at = candidate;
      break;
    }
  }
  if (at == none) return script;
  std::string command;
  for (const std::string& word : written[at]) command += (command.empty() ? "" : " ") + word;
  return commands[at]->place() + ": " + command;
}

}  // namespace footfall
