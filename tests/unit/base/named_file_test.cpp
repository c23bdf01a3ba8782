#include "coupler/base/named_file.h"

#include <gtest/gtest.h>

#include "coupler/base/errors.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

class NamedFile : public ::testing::Test, protected TemporaryFolder {
 protected:
  std::string complaint(const std::string& name) const {
    try {
      demand_file(file(name), "a sweep");
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "good";
  }
};

TEST_F(NamedFile, SaysWhatIsThereAndWhatIsMeant) {
  write("drop.toml", "");
  EXPECT_EQ(complaint("drop.toml"), "good");
  EXPECT_EQ(complaint("drap.toml"),
            "drap.toml: no such file; expected a sweep. Did you mean \"" + file("drop.toml") + "\"?");
  EXPECT_EQ(complaint("something_else"), "something_else: no such file; expected a sweep");
  EXPECT_EQ(complaint("."), ".: is a folder; expected a sweep");
}

}  // namespace
}  // namespace footfall
