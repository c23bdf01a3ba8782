// A page that needs nothing but itself.
#include "mbd_solver/cli/analysis/html_page.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

TEST(HtmlPage, Base64IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");  // RFC 4648, section 10
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(HtmlPage, EscapesWhatItIsGiven) {
  HtmlPage page("a < b & \"c\"");
  page.section("x > y");
  page.table({{"<i>", "1e-3"}, {"n", "2.5"}});
  page.folded("file", "plain\nlength = 1  # [A] <assumed>\n", {"[A]"});
  const std::string text = page.text();
  EXPECT_NE(text.find("<h1>a &lt; b &amp; &quot;c&quot;</h1>"), std::string::npos) << text;
  EXPECT_NE(text.find(">x &gt; y</h2>"), std::string::npos);
  EXPECT_NE(text.find("<th>&lt;i&gt;</th>"), std::string::npos);
  EXPECT_NE(text.find("<td class=\"n\">2.5</td>"), std::string::npos);
  EXPECT_NE(text.find("<pre>plain\n<mark>length = 1  # [A] &lt;assumed&gt;</mark>\n"), std::string::npos);
}

TEST(HtmlPage, PicturesStandInThePage) {
  const std::string file =
      (std::filesystem::temp_directory_path() / ("footfall_dot_" + std::to_string(::getpid()) + ".png")).string();
  std::ofstream(file, std::ios::binary) << "PNG!";
  HtmlPage page("t");
  page.picture(file);
  std::filesystem::remove(file);
  EXPECT_NE(page.text().find("src=\"data:image/png;base64,UE5HIQ==\""), std::string::npos);
  EXPECT_THROW(page.picture("/no/such/picture.png"), InputError);
}

}  // namespace
}  // namespace footfall
