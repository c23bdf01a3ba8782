// What other people have made: beds in a shared cache, and scripts on a kernel that does not confine them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/bed/bed.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/bed/script_safety.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

class ForeignBed : public ::testing::Test, protected TemporaryFolder {
 protected:
  std::string bed(const std::string& key) const {
    fs::create_directories(folder_ / key);
    write(key + "/" + kBedRestart, "restart of some grains");
    seal_bed(file(key));
    return file(key);
  }
};

TEST_F(ForeignBed, OfAnotherUserIsRefused) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can give files to others";
  const std::string folder = bed("key");
  EXPECT_TRUE(bed_is_made(folder));
  for (const std::string& path : {folder, folder + "/bed.restart", folder + "/bed.seal"}) {
    ASSERT_EQ(chown(path.c_str(), 12345, 12345), 0);
    EXPECT_TRUE(test::names(test::error_of([&] { bed_is_made(folder); }), {code::kBedOfAnother.number})) << path;
    ASSERT_EQ(chown(path.c_str(), 0, 0), 0);
  }
}

TEST_F(ForeignBed, ThatIsALinkIsRefused) {
  const std::string folder = bed("key");
  fs::create_symlink(folder, file("other"));
  EXPECT_TRUE(test::names(test::error_of([&] { bed_is_made(file("other")); }), {code::kBedOfAnother.number}));
}

TEST_F(ForeignBed, OfOtherConditionsIsDamaged) {
  const std::string folder = bed("key");
  EXPECT_EQ(damage_of_bed(folder), "");
  fs::rename(folder, file("other"));
  EXPECT_NE(damage_of_bed(file("other")), "");
}

// Every script of the checkout that couples or makes a bed runs on every kernel.
TEST(OwnScripts, AreCertainlySafe) {
  int scripts = 0;
  for (const std::string top : {"/inputs", "/examples"})
    for (const auto& entry : fs::recursive_directory_iterator(FOOTFALL_SOURCE_DIR + top)) {
      if (entry.path().filename().string().rfind("in.", 0) != 0) continue;
      ++scripts;
      EXPECT_EQ(uncertain_lines(entry.path().string(), {}, {"out", "bed", "here"}), "") << entry.path();
    }
  EXPECT_GT(scripts, 10);
}

class Uncertain : public ::testing::Test, protected TemporaryFolder {
 protected:
  std::string lines(const std::string& script) const {
    return uncertain_lines(write("in", script), {}, {"out", "here"});
  }
};

TEST_F(Uncertain, IsWhatOnlyLiggghtsCanCompute) {
  EXPECT_EQ(lines("variable n equal 3\nprint \"x ${n}\" file ${out}/a\ndump d all custom ${n} ${out}/d.* id\n"), "");
  for (const char* script :
       {"variable n string print\n${n} x\n", "variable n getenv HOME\nprint x file ${out}/${n}\n", "jump other.in\n",
        "include other.in\n", "python x\n", "fix a all nobody/knows 1\n", "variable out delete\n",
        "variable out string /tmp\n", "variable bed index /tmp\nwrite_restart ${bed}\n",
        "variable n index 1\nvariable n string file\nprint x ${n} ${out}/a\n", "partition yes 1 run 1\n",
        "if \"1==1\" then \"${x} y\"\n", "run 1 every 1 \"shell x\"\n", "processors * * * file ${out}/p\n",
        "she&\nll x\n"})
    EXPECT_NE(lines(script), "") << script;
}

// A file that is included by a command within another one is read as well.
TEST_F(Uncertain, IsAFileThatIsIncludedWithinACommand) {
  write("harmless.in", "print x\n");
  write("harmful.in", "print x file /tmp/a\n");
  for (const std::string within : {"run 1 every 1 ", "if \"1==1\" then "}) {
    EXPECT_EQ(lines(within + "\"include ${here}/harmless.in\"\n"), "");
    EXPECT_NE(lines(within + "\"include ${here}/harmful.in\"\n"), "");
    EXPECT_NE(lines(within + "\"include ${here}/none.in\"\n"), "");
  }
}

}  // namespace
}  // namespace footfall
