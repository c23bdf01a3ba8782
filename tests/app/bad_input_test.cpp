// Every wrong input in the tables of bad_input/ ends with its exit code and its findings: place and code of a message.
// bad_input/README.md describes the tables. `check` runs in this process, other commands as programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "mbd_solver/app/command_line.h"
#include "tests/app/programs.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

constexpr double kPatience = 10.0;  // [s] wrong input is reported within it

struct Finding {
  std::string place, code, text;  // code: E0123, - (LIGGGHTS' own message) or ? (not known yet: text is compared)
};

struct Case {
  std::string table, name, command = "check";
  Lines text;
  std::map<std::string, Lines> files;
  Lines settings, options;
  std::string scene;  // of a script; empty: the text is the scene
  int exit_code = 2;
  bool base = false, quick = false;
  std::vector<Finding> findings;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.table << ".txt: " << c.name; }

Lines split(const std::string& text) {
  Lines parts;
  std::size_t from = 0;
  for (std::size_t at; (at = text.find(" ; ", from)) != std::string::npos; from = at + 3)
    parts.push_back(text.substr(from, at - from));
  parts.push_back(text.substr(from));
  return parts;
}

std::string stripped(const std::string& text) {
  const std::size_t from = text.find_first_not_of(' ');
  return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(' ') - from + 1);
}

[[noreturn]] void refuse(const std::string& where, const std::string& line) {
  throw std::runtime_error(where + ": not understood: " + line);
}

// OLD -> NEW: the one line OLD becomes the lines NEW.
void replace(Lines& lines, const std::string& change, const std::string& where) {
  const std::size_t arrow = change.find(" ->");
  if (arrow == std::string::npos) refuse(where, change);
  const std::string old = stripped(change.substr(0, arrow)), now = stripped(change.substr(arrow + 3));
  const auto is_old = [&](const std::string& line) { return stripped(line) == old; };
  if (std::count_if(lines.begin(), lines.end(), is_old) != 1) refuse(where, change);
  const auto at = lines.erase(std::find_if(lines.begin(), lines.end(), is_old));
  const Lines added = now.empty() ? Lines{} : split(now);
  lines.insert(at, added.begin(), added.end());
}

Finding finding(const std::string& text) {
  static const std::regex form("(.*?) ([EW][0-9]{4}|-|\\?)(?: \\| (.*))?");
  std::smatch part;
  if (!std::regex_match(text, part, form)) refuse("finds", text);
  return {part[1], part[2], part[3]};
}

// All cases of a table; files of the table belong to each of them.
std::vector<Case> read_table(const fs::path& path) {
  std::vector<Case> cases;
  std::map<std::string, Lines> files;
  std::map<std::string, std::vector<std::string>> changes;  // of files, by case
  std::string scene;
  Lines* into = nullptr;
  std::ifstream stream(path);
  int number = 0;
  const std::regex head("== (base )?(\\w+)(?: of (\\w+))?( quick)?");
  for (std::string line; std::getline(stream, line);) {
    const std::string where = path.filename().string() + ":" + std::to_string(++number);
    std::smatch part;
    if (line.empty() || line[0] == '#') continue;
    if (line.rfind("== file ", 0) == 0) {
      into = &files[line.substr(8)];
    } else if (std::regex_match(line, part, head)) {
      Case next;
      if (part[3].matched) {
        const auto base =
            std::find_if(cases.begin(), cases.end(), [&](const Case& c) { return c.name == part[3].str(); });
        if (base == cases.end()) refuse(where, line);
        next = *base;
        changes[part[2]] = changes[part[3]];
      }
      next.table = path.stem().string();
      next.name = part[2];
      next.base = part[1].matched;
      next.quick = part[4].matched;
      next.exit_code = next.base ? 0 : 2;
      next.findings.clear();
      next.scene = scene;
      cases.push_back(next);
      into = &cases.back().text;
    } else if (line.rfind("  ", 0) == 0 && into) {
      const bool file = !cases.empty() && into != &cases.back().text;
      const Lines parts = file ? Lines{line.substr(2)} : split(line.substr(2));
      into->insert(into->end(), parts.begin(), parts.end());
    } else {
      const std::size_t blank = line.find(' ');
      const std::string word = line.substr(0, blank), rest = blank == std::string::npos ? "" : line.substr(blank + 1);
      if (word == "scene" && cases.empty()) {
        scene = rest;
        continue;
      }
      if (cases.empty()) refuse(where, line);
      Case& c = cases.back();
      const auto key = [](const std::string& setting) { return setting.substr(0, setting.find('=')); };
      if (word == "~") {
        replace(c.text, rest, where);
      } else if (word == "file") {
        changes[c.name].push_back(rest);
      } else if (word == "set") {
        c.settings.erase(std::remove_if(c.settings.begin(), c.settings.end(),
                                        [&](const std::string& s) { return key(s) == key(rest); }),
                         c.settings.end());
        c.settings.push_back(rest);
      } else if (word == "option") {
        c.options.push_back(rest);
      } else if (word == "command") {
        c.command = rest;
      } else if (word == "exit") {
        c.exit_code = std::stoi(rest);
      } else if (word == "finds") {
        c.findings.push_back(finding(rest));
      } else {
        refuse(where, line);
      }
    }
  }
  for (Case& c : cases) {
    c.files = files;
    for (const std::string& change : changes[c.name]) {
      const std::size_t colon = change.find(": ");
      if (const std::size_t empty = change.find(" is empty"); empty != std::string::npos)
        c.files[change.substr(0, empty)].clear();
      else
        replace(c.files[change.substr(0, colon)], change.substr(colon + 2), path.filename().string() + ": " + c.name);
    }
  }
  return cases;
}

std::vector<Case> cases_of(const std::string& kind) {
  std::vector<Case> chosen;
  for (const auto& entry : fs::directory_iterator(FOOTFALL_SOURCE_DIR "/tests/app/bad_input")) {
    if (entry.path().extension() != ".txt") continue;
    for (const Case& c : read_table(entry.path())) {
      const bool runs = c.command == "run" && !c.quick;
      if (c.base && c.command == "run") continue;
      if (kind == (c.command == "check" ? "check" : runs ? "run" : "quick")) chosen.push_back(c);
    }
  }
  std::sort(chosen.begin(), chosen.end(),
            [](const Case& a, const Case& b) { return std::tie(a.table, a.name) < std::tie(b.table, b.name); });
  return chosen;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

// @repeat N TEXT@ is TEXT N times; @here/ the folder of the case; @/ the checkout.
std::string filled(const Lines& lines, const std::string& here) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  static const std::regex repeat("@repeat ([0-9]+) ([^@]*)@");
  for (std::smatch part; std::regex_search(text, part, repeat);) {
    std::string many;
    for (int n = std::stoi(part[1]); n > 0; --n) many += part[2];
    text = part.prefix().str() + many + part.suffix().str();
  }
  return replaced(replaced(text, "@here/", here + "/"), "@/", FOOTFALL_SOURCE_DIR "/");
}

class BadInput : public ::testing::TestWithParam<Case> {};

TEST_P(BadInput, IsFoundAndNamed) {
  const Case& c = GetParam();
  const app::Folder folder("bad_input_" + c.table + "_" + c.name);
  const std::string here = folder.path().string();
  for (const auto& [name, lines] : c.files) folder.write(name, filled(lines, here));
  const std::string file = c.scene.empty() ? "case.toml" : "case.in";
  folder.write(file, filled(c.text, here));
  Lines words = {c.command, c.scene.empty() ? file : filled({c.scene}, here)};
  words[1] = stripped(replaced(words[1], "\n", ""));
  if (!c.scene.empty()) words.insert(words.end(), {"--set", "particles.script=\"" + here + "/case.in\""});
  for (const std::string& setting : c.settings) words.insert(words.end(), {"--set", setting});
  words.insert(words.end(), c.options.begin(), c.options.end());
  if (c.command == "run") words.insert(words.end(), {"--out", "run", "--quiet"});

  test::Outcome outcome;
  if (c.command == "check") {
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    words.insert(words.begin(), "footfall");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    outcome.exit_code = run_command_line(static_cast<int>(words.size()), argv.data(), subcommands());
    std::fflush(stdout);
    outcome.text = ::testing::internal::GetCapturedStderr() + ::testing::internal::GetCapturedStdout();
    fs::current_path(before);
  } else {
    std::string line;
    for (const std::string& word : words) line += app::quoted(word) + " ";
    outcome = folder.footfall(line, 40);
    EXPECT_LE(outcome.seconds, kPatience);
    EXPECT_EQ(app::processes_in(folder.path()), "") << "still running";
  }
  EXPECT_EQ(outcome.exit_code, c.exit_code) << outcome.text;
  const std::string text = replaced(replaced(outcome.text, here + "/", ""), FOOTFALL_SOURCE_DIR "/", "");
  if (std::getenv("FOOTFALL_SHOW") != nullptr) std::printf("%s\n", text.c_str());  // for tests/docs/blocks.py
  for (const Finding& wanted : c.findings) {
    std::string place = wanted.place == "-" ? "" : wanted.place;
    if (std::isdigit(static_cast<unsigned char>(place[0]))) {
      const std::size_t blank = place.find(' ');
      place = file + ":" + (blank == std::string::npos ? place + ":" : place.replace(blank, 1, ": ") + ":");
    }
    bool found = false;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      const bool coded = wanted.code.size() == 1 || line.find("[" + wanted.code + " ") != std::string::npos;
      found = found || (coded && line.find(place) != std::string::npos && line.find(wanted.text) != std::string::npos);
    }
    EXPECT_TRUE(found) << "no line has: " << place << " ... " << wanted.text << " [" << wanted.code << "]\n" << text;
  }
}

std::string name_of(const ::testing::TestParamInfo<Case>& info) { return info.param.table + "_" + info.param.name; }
INSTANTIATE_TEST_SUITE_P(Check, BadInput, ::testing::ValuesIn(cases_of("check")), name_of);
INSTANTIATE_TEST_SUITE_P(Quick, BadInput, ::testing::ValuesIn(cases_of("quick")), name_of);
INSTANTIATE_TEST_SUITE_P(Run, BadInput, ::testing::ValuesIn(cases_of("run")), name_of);

}  // namespace
}  // namespace footfall
