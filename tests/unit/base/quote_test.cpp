#include "coupler/base/quote.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

class Quote : public ::testing::Test, protected TemporaryFolder {};

const std::string kNasty = "it's `touch ran` $(touch ran) \"two\" \\ # %d @x {a|b} ; & 'x";

TEST_F(Quote, AShellReadsTheWordBack) {
  for (const std::string& word : {kNasty, std::string(), std::string("plain"), std::string("two words"),
                                  std::string("line\nend"), std::string("~"), std::string("-3e-5")}) {
    ASSERT_EQ(std::system(("cd " + shell_word(file("")) + " && printf %s " + shell_word(word) + " > out").c_str()), 0);
    EXPECT_EQ(text("out"), word);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "ran"));
  EXPECT_EQ(shell_word("plain-3.5_x/y"), "plain-3.5_x/y");
}

TEST_F(Quote, GnuplotReadsTheTextBack) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not here";
  const std::string trailing = kNasty + "\\";
  write("a.gp", "set print 'out'\nprint " + gnuplot_text(trailing) + "\nset title " + gnuplot_text(trailing) +
                    "\nprint " + gnuplot_text("first\nprint 2") + "\n");
  ASSERT_EQ(std::system(("cd " + shell_word(file("")) + " && gnuplot a.gp").c_str()), 0);
  EXPECT_EQ(text("out"), trailing + "\nfirst print 2\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "ran"));
}

TEST_F(Quote, HtmlTextHoldsNoTags) {
  EXPECT_EQ(html_text("<b a=\"1\">&\n\x01\x7f"), "&lt;b a=&quot;1&quot;&gt;&amp;\n");
}

}  // namespace
}  // namespace footfall
