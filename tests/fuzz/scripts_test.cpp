// Random LIGGGHTS scripts of a small grammar: commands that write or run something, their words hidden in variables, loops,
// branches, included files and joined lines, with paths in and out of the folder of results. Two claims:
//   whatever the text, LIGGGHTS that is confined touches nothing outside;
//   a script that is called certainly safe touches nothing outside under stock LIGGGHTS, which nothing confines.
// FOOTFALL_SCRIPTS: how many (default 40). FOOTFALL_SEED: of the first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "coupler/base/confinement.h"
#include "mbd_solver/bed/script_safety.h"
#include "tests/support/run_folder.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

class Grammar {
 public:
  Grammar(unsigned seed, fs::path folder) : random_(seed), folder_(std::move(folder)) {}

  // Statements of a script, and the files that they name.
  std::string script() {
    std::string text;
    for (int k = 0, count = 1 + below(4); k < count; ++k) text += statement(0) + "\n";
    return text;
  }

  const std::vector<std::pair<std::string, std::string>>& files() const { return files_; }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  template <class T>
  const T& one_of(const std::vector<T>& all) {
    return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
  }
  std::string name() { return "n" + std::to_string(++names_); }

  std::string path() {
    const std::string file = "/f" + std::to_string(below(3)), outside = folder_.string() + "/outside";
    switch (below(8)) {
      case 0: return outside + file;
      case 1: return "${out}/../outside" + file;
      case 2: return outside + "/kept";
      case 3: return "outside" + file;
      default: return "${out}" + file;
    }
  }

  // A command that may write or run something.
  std::string command() {
    const std::string at = path();
    switch (below(13)) {
      case 0: return "print \"x\" file " + at;
      case 1: return "print \"x\" append " + at;
      case 2: return "shell touch " + at;
      case 3: return "log " + at;
      case 4: return "write_restart " + at;
      case 5: return "dump " + name() + " all custom 1 " + at + ".* id x";
      case 6: return "fix " + name() + " all print 1 \"x\" file " + at;
      case 7: return "restart 1 " + at + ".a " + at + ".b";
      case 8: return "write_dump all custom " + at + " id";
      case 9: return "dump " + name() + " all custom 1 " + at + ".gz id";
      case 10: return "processors * * * file " + at;
      case 11: return "print \"nothing\"";
      default: return "variable " + name() + " equal step";
    }
  }

  // The same command, written so that the text shows it less and less.
  std::string hidden(std::string text) {
    const std::size_t blank = text.find(' ');
    switch (below(7)) {
      case 0: {  // the first word, or a later one, from a variable
        const std::string v = name(), kind = one_of<std::string>({"string", "index"});
        const std::size_t last = text.rfind(' '), from = below(2) == 0 || last == std::string::npos ? 0 : last + 1;
        const std::size_t end = from == 0 ? blank : text.size();
        const std::string word = text.substr(from, end - from);
        if (word.find('"') != std::string::npos || word.find('$') != std::string::npos) return text;
        return "variable " + v + " " + kind + " " + word + "\n" + text.replace(from, end - from, "${" + v + "}");
      }
      case 1: {  // joined lines
        const std::size_t cut = 1 + static_cast<std::size_t>(below(static_cast<int>(text.size()) - 1));
        return text.substr(0, cut) + "&\n" + text.substr(cut);
      }
      case 2: return quoted("if \"1==1\" then ", text);
      case 3: return quoted("run 1 every 1 ", text);
      case 4: {  // a file
        const std::string file = "i" + std::to_string(files_.size()) + ".in";
        files_.emplace_back(file, text + "\n");
        return one_of<std::string>({"include ${here}/", "include "}) + file;
      }
      case 5: {  // a loop
        const std::string v = name(), label = name();
        return "variable " + v + " index " + text.substr(0, blank) + "\nlabel " + label + "\n${" + v + "}" +
               text.substr(blank) + "\nnext " + v + "\njump SELF " + label;
      }
      default: return text;
    }
  }

  static std::string quoted(const std::string& head, const std::string& text) {
    if (text.find('\n') != std::string::npos || text.find('\'') != std::string::npos) return text;
    std::string inner = text;
    for (char& c : inner)
      if (c == '"') c = '\'';
    return head + "\"" + inner + "\"";
  }

  std::string statement(int depth) {
    if (below(12) == 0) return "variable out delete\nvariable out string " + folder_.string() + "/outside";
    std::string text = command();
    for (; depth < 2 && below(2) == 0; ++depth) text = text.find('\n') == std::string::npos ? hidden(text) : text;
    return text;
  }

  std::mt19937 random_;
  fs::path folder_;
  std::vector<std::pair<std::string, std::string>> files_;
  int names_ = 0;
};

std::string contents(const fs::path& folder) {
  std::string text;
  std::vector<std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    all.push_back(entry.path().string() + (entry.is_regular_file() ? " " + std::to_string(entry.file_size()) : ""));
  std::sort(all.begin(), all.end());
  for (const std::string& line : all) text += line + "\n";
  return text;
}

int number_from(const char* variable, int usual) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : usual;
}

TEST(RandomScripts, NeverReachOutside) {
  const int count = number_from("FOOTFALL_SCRIPTS", 40), first = number_from("FOOTFALL_SEED", 1);
  int certain = 0;
  for (int k = 0; k < count; ++k) {
    const test::RunFolder folder("random_scripts");
    const fs::path outside = folder.path() / "outside";
    Grammar grammar(static_cast<unsigned>(first + k), folder.path());
    const std::string lines = grammar.script();
    fs::copy_file(FOOTFALL_SOURCE_DIR "/tests/app/plate/box.lammps", folder.path() / "box.lammps");
    for (const auto& [name, text] : grammar.files()) folder.write(name, text);
    folder.write("s.in", "include ${here}/box.lammps\n" + lines + "run 2\n");
    std::string before;
    const auto renew = [&] {
      for (const char* name : {"outside", "out"}) {
        fs::remove_all(folder.path() / name);
        fs::create_directories(folder.path() / name);
      }
      folder.write("outside/kept", "as it was\n");
      before = contents(outside);
    };
    const std::string out = (folder.path() / "out").string();
    const std::string line =
        " -in s.in -var here " + folder.path().string() + " -var out " + out + " -log " + out + "/log";

    if (kernel_confines_files()) {
      renew();
      const test::Outcome confined =
          folder.command("env FOOTFALL_MAY_WRITE=" + out + " " + test::RunFolder::program("liggghts_mbd") + line, 60);
      ASSERT_EQ(contents(outside), before) << "confined, seed " << first + k << ":\n" << lines << confined.text;
    }
    if (!uncertain_lines((folder.path() / "s.in").string(), {}, {"out", "here"}).empty()) continue;
    ++certain;
    renew();
    const test::Outcome stock = folder.command(LIGGGHTS_EXECUTABLE + line, 60);
    ASSERT_EQ(contents(outside), before) << "called safe, seed " << first + k << ":\n" << lines << stock.text;
  }
  EXPECT_GT(certain, count / 20) << "the grammar makes no safe scripts: the second claim is not tested";
}

}  // namespace
}  // namespace footfall
