// What the scripts of a page read.
#include "mbd_solver/cli/analysis/viewer/page_parts.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

History history_of(const std::vector<std::string>& names, std::size_t rows) {
  History history{names, std::vector<std::string>(names.size(), "m"), {}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    history.columns.emplace_back();
    for (std::size_t k = 0; k < rows; ++k) history.columns.back().push_back(static_cast<double>(k));
  }
  return history;
}

TEST(PageParts, NoTextOfASceneEndsItsElement) {
  PageParts parts;
  parts.run["title"] = "</script><script>alert(1)</script> ]]> & <!--";
  const std::string text = parts.elements("run();");
  const std::string begin = "id=\"footfall-run\">";
  const std::string json = text.substr(text.find(begin) + begin.size());
  const std::string held = json.substr(0, json.find("</script>"));
  EXPECT_EQ(held.find_first_of("<>&"), std::string::npos) << held;
  EXPECT_EQ(nlohmann::ordered_json::parse(held).at("title"), parts.run.at("title"));
}

// A browser reads a page from its beginning: what the first picture needs comes first, then frame by frame.
TEST(PageParts, StandInTheOrderInWhichTheyAreShown) {
  PageParts parts;
  parts.run["title"] = "order";
  for (const char* name : {"grains", "bodies"})
    for (std::size_t k = 0; k < 11; ++k) parts.add_frame(name, k, "AA==");
  parts.chunks.emplace_back("history", "AA==");
  const std::string text = parts.elements("run();");
  std::size_t last = 0;
  for (const char* mark :
       {"\"footfall-run\"", "run();", "\"footfall-grains-0\"", "\"footfall-bodies-0\"", "\"footfall-history\"",
        "\"footfall-grains-1\"", "\"footfall-bodies-1\"", "\"footfall-grains-2\"", "\"footfall-bodies-10\""}) {
    const std::size_t at = text.find(mark);
    ASSERT_NE(at, std::string::npos) << mark;
    EXPECT_GT(at, last) << mark;
    last = at;
  }
}

TEST(PageParts, TimeIsExactAndNamesFollowTheHistory) {
  PageParts parts;
  History history = history_of({"time", "a.z", "b.z"}, 3);
  history.columns[0] = {0.0, 0.1, 0.30000000000000004};
  add_history(history, {"a.z"}, parts);
  const auto& json = parts.run.at("history");
  EXPECT_EQ(json.at("time").get<std::vector<double>>(), history.columns[0]);
  EXPECT_EQ(json.at("names").get<std::vector<std::string>>(), (std::vector<std::string>{"a.z", "b.z"}));
  EXPECT_EQ(json.at("rows"), 3);
  ASSERT_EQ(parts.chunks.size(), 1u);
  EXPECT_EQ(parts.chunks.front().first, "history");
}

TEST(PageParts, ALongHistoryIsDrawnNotCopied) {
  PageParts parts;
  add_history(history_of({"time", "a.z"}, 100000), {}, parts);
  EXPECT_LE(parts.run.at("history").at("rows").get<int>(), 4000);
}

TEST(FirstColumns, AreThoseThatAUserAsksForFirst) {
  const History landing = history_of({"time", "cabin.az", "pad.contact.fx", "pad.contact.fz", "leg.force"}, 1);
  EXPECT_EQ(first_columns(landing, "cabin"), (std::vector<std::string>{"cabin.az", "pad.contact.fz"}));
  const History swing = history_of({"time", "energy.kinetic", "energy.total"}, 1);
  EXPECT_EQ(first_columns(swing, ""), (std::vector<std::string>{"energy.kinetic", "energy.total"}));
}

}  // namespace
}  // namespace footfall
