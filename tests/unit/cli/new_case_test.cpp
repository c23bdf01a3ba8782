#include "mbd_solver/cli/launch/new_case.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/launch/check_command.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class NewCaseTest : public ::testing::Test, protected TemporaryFolder {};

TEST_F(NewCaseTest, EveryCaseIsACompleteSceneOfItsOwn) {
  for (const CaseKind& kind : case_kinds()) {
    const std::string made = file("my_" + kind.name);
    make_case(made, kind.name);
    EXPECT_NO_THROW(checked_scene(made, {})) << kind.name;
    const std::string page = read_whole_file(made + "/README.md").value_or("");
    EXPECT_EQ(std::count(page.begin(), page.end(), '\n'), 3) << page;
    // Nothing in it leads out of it, but for words of comments.
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(made)) {
      if (!entry.is_regular_file() || entry.path().filename() == "README.md") continue;
      const std::string text = read_whole_file(entry.path().string()).value_or("");
      for (std::string line : split(text, '\n')) {
        line.resize(std::min(line.size(), line.find('#')));
        const bool leads_out = line.find("../") != std::string::npos && entry.path().parent_path() == made;
        EXPECT_FALSE(leads_out) << entry.path() << ": " << line;
      }
    }
  }
}

TEST_F(NewCaseTest, TheCommonCasesAreThere) {
  std::vector<std::string> names;
  for (const CaseKind& kind : case_kinds()) names.push_back(kind.name);
  for (const char* name : {"wheel", "arm", "scoop", "lander", "drop", "pendulum", "auger", "gripper", "rover"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
}

TEST_F(NewCaseTest, NothingIsWrittenOverAndNothingIsLeftOfACaseThatCannotBe) {
  const std::string made = file("mine");
  EXPECT_NE(message_of([&] { make_case(made, "whele"); }).find("Did you mean \"wheel\"?"), std::string::npos);
  EXPECT_FALSE(fs::exists(made));
  make_case(made, "wheel");
  EXPECT_NE(message_of([&] { make_case(made, "wheel"); }).find("is there already"), std::string::npos);
  EXPECT_NE(message_of([&] { make_case(file("my wheel"), "wheel"); }).find("other characters"), std::string::npos);
  EXPECT_FALSE(fs::exists(file("my wheel")));
}

}  // namespace
}  // namespace footfall
