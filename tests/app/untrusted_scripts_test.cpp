// Scripts of other people that try to run programs or to write outside the folder of results. Each of them succeeds under
// stock LIGGGHTS, or the list would prove nothing; none may succeed under footfall, which confines them by the kernel
// whether or not it understands what they do.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "coupler/base/confinement.h"
#include "mbd_solver/bed/script_safety.h"
#include "tests/app/programs.h"

namespace footfall::app {
namespace {

namespace fs = std::filesystem;

// @ is the folder outside, which holds the file `kept`. The script has made its box and grains before.
struct Attack {
  std::string name, lines;
  std::map<std::string, std::string> files;  // next to the script
};

const std::vector<Attack> kAttacks = {
    // Programs.
    {"shell", "shell touch @/evil", {}},
    {"shell_in_two_lines", "she&\nll touch @/evil", {}},
    {"shell_of_a_variable", "variable c string shell\n${c} touch @/evil", {}},
    {"shell_of_a_letter", "variable c string shell\n$c touch @/evil", {}},
    {"shell_in_if", "if \"1==1\" then \"shell touch @/evil\"", {}},
    {"shell_in_nested_if", "if \"1==1\" then \"if '1==1' then 'shell touch @/evil'\"", {}},
    {"shell_in_run", "run 2 every 1 \"shell touch @/evil\"", {}},
    {"shell_in_a_file", "jump ${here}/more.in", {{"more.in", "shell touch @/evil\nrun 1\n"}}},
    {"shell_in_quotes", "'shell' touch @/evil", {}},
    {"shell_removes", "shell rm @/kept", {}},
    {"shell_moves", "shell mv @/kept @/evil", {}},
    {"shell_makes_folder", "shell mkdir @/evil", {}},
    // Files, by commands that name them.
    {"print", "print \"x\" file @/evil", {}},
    {"print_append", "print \"x\" append @/kept", {}},
    {"print_in_two_lines", "print \"x\" fi&\nle @/evil", {}},
    {"print_with_a_word_of_a_variable", "variable k string file\nprint \"x\" ${k} @/evil", {}},
    {"print_with_a_letter", "variable k string file\nprint \"x\" $k @/evil", {}},
    {"print_with_several_words", "variable k string \"file @/evil\"\nprint \"x\" ${k}", {}},
    {"print_by_a_file_of_words", "variable f file ${here}/w.txt\n${f} \"x\" file @/evil", {{"w.txt", "print\n"}}},
    {"print_in_run", "run 2 every 1 \"print 'x' file @/evil\"", {}},
    {"print_in_if", "if \"1==1\" then \"print 'x' file @/evil\"", {}},
    {"print_in_else", "if \"1==2\" then \"print a\" else \"print 'x' file @/evil\"", {}},
    {"print_by_a_loop", "variable n index print\nlabel again\n${n} \"x\" file @/evil\nnext n\njump SELF again", {}},
    {"print_after_a_jump", "jump ${here}/more.in", {{"more.in", "print \"x\" file @/evil\nrun 1\n"}}},
    {"print_in_an_include_of_a_variable",
     "variable n string more\ninclude ${here}/${n}.in",
     {{"more.in", "print \"x\" file @/evil\n"}}},
    {"print_out_of_the_folder", "print \"x\" file ${out}/../outside/evil", {}},
    {"out_made_anew", "variable out delete\nvariable out string @\nprint \"x\" file ${out}/evil", {}},
    {"here_made_anew", "variable here delete\nvariable here string @\nprint \"x\" file ${here}/evil", {}},
    {"path_of_the_environment", "variable h getenv FOOTFALL_TEST_OUTSIDE\nprint \"x\" file ${h}/evil", {}},
    {"log", "log @/evil", {}},
    {"log_append", "log @/kept append", {}},
    {"dump", "dump d all custom 1 @/evil id\nrun 1", {}},
    {"dump_overwrites", "dump d all custom 1 @/kept id\nrun 1", {}},
    {"dump_of_a_variable", "variable p string @/evil\ndump d all custom 1 ${p}.* id\nrun 1", {}},
    {"dump_image", "dump d all image 1 @/evil.*.ppm type type\nrun 1", {}},
    {"dump_vtk", "dump d all custom/vtk 1 @/evil*.vtk id type\nrun 1", {}},
    {"dump_mesh", "dump d all mesh/stl 1 @/evil*.stl\nrun 1", {}},
    {"write_dump", "write_dump all custom @/evil id", {}},
    {"write_restart", "write_restart @/evil", {}},
    {"restart", "restart 1 @/evil_a @/evil_b\nrun 2", {}},
    {"restart_of_many", "restart 1 @/evil.*\nrun 1", {}},
    {"fix_print", "fix p all print 1 \"x\" file @/evil\nrun 1", {}},
    {"fix_print_append", "fix p all print 1 \"x\" append @/kept\nrun 1", {}},
    {"fix_ave_time", "variable v equal step\nfix a all ave/time 1 1 1 v_v file @/evil\nrun 1", {}},
    {"fix_ave_histo", "variable v equal step\nfix a all ave/histo 1 1 1 0 1 2 v_v mode scalar file @/evil\nrun 1", {}},
    {"processors", "clear\nprocessors 1 1 1 file @/evil\ninclude ${here}/box.lammps\nrun 1", {}},
};

// Everything below a folder: paths with what they hold.
std::string contents(const fs::path& folder) {
  std::vector<std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    all.push_back(entry.path().string() + " " + (entry.is_regular_file() ? std::to_string(entry.file_size()) : ""));
  std::sort(all.begin(), all.end());
  std::string text;
  for (const std::string& line : all) text += line + "\n";
  return text;
}

class AttackedFolder {
 public:
  explicit AttackedFolder(const Attack& attack) : folder_("foreign_" + attack.name) {
    renew();
    setenv("FOOTFALL_TEST_OUTSIDE", outside().c_str(), 1);
    for (const std::string name : {"scene.toml", "box.lammps", "couple.lammps"})
      fs::copy_file(kPlate + "/" + name, folder_.path() / name);
    for (const auto& [name, text] : attack.files) folder_.write(name, placed(text));
    const std::string head = "include ${here}/box.lammps\n" + placed(attack.lines) + "\n";
    folder_.write("alone.in", head + "run 2\n");
    folder_.write("coupled.in", head + "include ${here}/couple.lammps\nrun 1000000\n");
  }

  const Folder& folder() const { return folder_; }
  std::string outside() const { return (folder_.path() / "outside").string(); }
  std::string out() const { return (folder_.path() / "out").string(); }
  // Folders as before, for the next program.
  void renew() const {
    fs::remove_all(outside());
    fs::remove_all(out());
    fs::create_directories(outside());
    fs::create_directories(out());
    folder_.write("outside/kept", "as it was\n");
    before_ = contents(outside());
  }
  bool is_touched() const { return contents(outside()) != before_; }
  // LIGGGHTS on the script without coupling.
  std::string alone(const std::string& program) const {
    const std::string line = program + " -in alone.in -var here " + folder_.path().string() + " -var out " + out() +
                             " -log " + out() + "/log";
    return folder_.command(line, 60).text;
  }

 private:
  std::string placed(std::string text) const {
    for (std::size_t at = 0; (at = text.find('@', at)) != std::string::npos;) text.replace(at, 1, outside());
    return text;
  }

  Folder folder_;
  mutable std::string before_;
};

void PrintTo(const Attack& attack, std::ostream* out) { *out << attack.name; }

class UntrustedScripts : public ::testing::TestWithParam<Attack> {};

TEST_P(UntrustedScripts, ReachNothingOutside) {
  const AttackedFolder place(GetParam());
  const std::string stock = LIGGGHTS_EXECUTABLE, footfall = Folder::program("footfall");
  const std::string rights = "env FOOTFALL_MAY_WRITE=" + place.out() + " ";

  std::string said = place.alone(stock);
  EXPECT_TRUE(place.is_touched()) << "no attack: " << said;

  place.renew();
  said =
      place.folder().footfall("run scene.toml --set 'particles.script=\"coupled.in\"' --quiet --force --out out").text;
  EXPECT_FALSE(place.is_touched()) << "footfall run: " << said;

  if (!kernel_confines_files()) return;
  place.renew();  // as if the check of the text had found nothing
  said = place.alone(rights + "FOOTFALL_TEST_OUTSIDE=" + place.outside() + " " + Folder::program("liggghts_mbd"));
  EXPECT_FALSE(place.is_touched()) << "liggghts_mbd: " << said;
  EXPECT_TRUE(fs::exists(place.out() + "/log")) << said;

  place.renew();
  said = place.alone(rights + "mpirun --oversubscribe -np 1 " + footfall + " confined " + stock);
  EXPECT_FALSE(place.is_touched()) << "stock LIGGGHTS: " << said;
  EXPECT_TRUE(fs::exists(place.out() + "/log")) << said;
}

// Where the kernel does not confine, only certainly safe scripts are run.
TEST_P(UntrustedScripts, AreNeverCertainlySafe) {
  const AttackedFolder place(GetParam());
  EXPECT_NE(uncertain_lines((place.folder().path() / "coupled.in").string(), {{"every", "5"}, {"dt", "1e-4"}},
                            {"out", "here"}),
            "");
}

// Values of variables become words of mpirun, by whatever door they come: scene, option, sweep, summary of a run.
TEST(UntrustedValues, StartNothing) {
  const Folder folder("foreign_values");
  folder.shell("cp " + kPlate + "/* .");
  const std::string value = "1\\n:\\nsh\\n-c\\ntouch evil; kill $PPID";
  const auto refused = [&](const std::string& line) {
    const test::Outcome outcome = folder.footfall(line);
    EXPECT_EQ(outcome.exit_code, 2) << line << ": " << outcome.text;
    EXPECT_NE(outcome.text.find("E0214"), std::string::npos) << line << ": " << outcome.text;
    EXPECT_FALSE(fs::exists(folder.path() / "evil")) << line;
  };
  for (const std::string key : {"particles.variables.every", "particles.variables.here"}) {
    const std::string setting = " --set '" + key + "=\"" + value + "\"'";
    refused("check scene.toml" + setting);
    refused("run scene.toml --out out" + setting);
    EXPECT_FALSE(fs::exists(folder.path() / "out")) << "nothing is written";
    folder.write("sweep.toml",
                 "title = \"t\"\nscene = \"scene.toml\"\nsettings = ['" + key + "=\"" + value +
                     "\"']\n[[parameters]]\nname = \"u\"\nvalues = [1]\nsettings = [\"initial.velocity=[0, 0, "
                     "-{value}]\"]\n[[figures]]\nname = \"a\"\nkey = \"peak_acceleration_g\"\n");
    refused("sweep sweep.toml --out swept");
  }
  ASSERT_EQ(folder.footfall("run scene.toml --quiet --out out").exit_code, 0);
  ASSERT_EQ(folder
                .shell("python3 -c \"import json; s = json.load(open('out/summary.json')); "
                       "s['scene']['particles']['variables']['k'] = '1\\n:\\nsh\\n-c\\ntouch evil'; "
                       "json.dump(s, open('out/summary.json', 'w'))\"")
                .exit_code,
            0);
  refused("compare out");
}

INSTANTIATE_TEST_SUITE_P(Attack, UntrustedScripts, ::testing::ValuesIn(kAttacks),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace footfall::app
