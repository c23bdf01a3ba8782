#include "coupler/couple_mbd_arguments.h"

#include <gtest/gtest.h>

#include <sstream>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

CoupleMbdArguments parsed_fix(const std::string& after_style) {
  std::istringstream in("m all couple/mbd " + after_style);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  return {static_cast<int>(pointers.size()), pointers.data()};
}

// What the user reads, without the beginning that all messages share.
std::string complaint(const std::string& after_style) {
  const std::string begin = "fix m couple/mbd: ";
  try {
    parsed_fix(after_style);
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.substr(0, begin.size()), begin);
    return message.substr(begin.size());
  }
  return "nothing is wrong";
}

const std::string kUsage =
    "expected: fix ID all couple/mbd every N|auto [patience SECONDS] [gravity scene|script] [end scene|script] "
    "[lost SHARE] [surface smooth|facets|round] [edge DEGREES] [damping_mass grain|pair] [mesh MESH-ID BODY]...";

TEST(CoupleMbdArguments, TakeWhatTheCommandSays) {
  const CoupleMbdArguments all = parsed_fix("every 5 patience 0.5 mesh pad1 foot_1 mesh pad2 foot_2");
  EXPECT_EQ(all.every, 5);
  EXPECT_EQ(all.patience, 0.5);
  ASSERT_EQ(all.meshes.size(), 2U);
  EXPECT_EQ(all.meshes[0].mesh, "pad1");
  EXPECT_EQ(all.meshes[1].body, "foot_2");
}

TEST(CoupleMbdArguments, LeaveOutWhatIsNotSaid) {
  const CoupleMbdArguments least = parsed_fix("every auto");
  EXPECT_EQ(least.every, 0);
  EXPECT_FALSE(least.patience);
  EXPECT_TRUE(least.gravity_of_scene);
  EXPECT_TRUE(least.end_of_scene);
  EXPECT_EQ(least.max_lost, 0.05);
  EXPECT_TRUE(least.meshes.empty());
}

TEST(CoupleMbdArguments, TakeKeywordsInAnyOrder) {
  const CoupleMbdArguments all =
      parsed_fix("every 5 lost 0.2 mesh upper drum end script mesh lower drum gravity script patience 3");
  EXPECT_FALSE(all.gravity_of_scene);
  EXPECT_FALSE(all.end_of_scene);
  EXPECT_EQ(all.max_lost, 0.2);
  EXPECT_EQ(all.patience, 3.0);
  ASSERT_EQ(all.meshes.size(), 2U);
  EXPECT_EQ(all.meshes[1].mesh, "lower");
  EXPECT_EQ(all.meshes[1].body, "drum");
}

TEST(CoupleMbdArguments, SayHowGrainsTouch) {
  using Surface = CoupleMbdArguments::Surface;
  EXPECT_EQ(parsed_fix("every 5").surface, Surface::kSmooth);
  EXPECT_EQ(parsed_fix("every 5 surface facets").surface, Surface::kFacets);
  EXPECT_EQ(parsed_fix("every 5 surface round").surface, Surface::kRound);
  EXPECT_EQ(complaint("every 5 surface flat"), "`surface` needs `smooth`, `facets` or `round`, not \"flat\"");
  EXPECT_DOUBLE_EQ(parsed_fix("every 5").edge_angle, M_PI / 6.0);
  EXPECT_DOUBLE_EQ(parsed_fix("every 5 edge 45").edge_angle, M_PI / 4.0);
  for (const char* angle : {"0", "91", "sharp"})
    EXPECT_EQ(complaint(std::string("every 5 edge ") + angle),
              std::string("`edge` needs an angle above 0 and up to 90 degrees, not \"") + angle + "\"");
  EXPECT_FALSE(parsed_fix("every 5").mass_of_pair);
  EXPECT_TRUE(parsed_fix("every 5 damping_mass pair").mass_of_pair);
  EXPECT_EQ(complaint("every 5 damping_mass wall"), "`damping_mass` needs `grain` or `pair`, not \"wall\"");
}

TEST(CoupleMbdArguments, SayWhatIsExpectedWhereAWordIsMissingOrWrong) {
  EXPECT_EQ(complaint(""), kUsage);
  EXPECT_EQ(complaint("every"), "at \"every\" " + kUsage);
  EXPECT_EQ(complaint("evry 5"), "at \"evry\" (did you mean \"every\"?) " + kUsage);
  EXPECT_EQ(complaint("5"), "at \"5\" " + kUsage);
  EXPECT_EQ(complaint("every 5 mash pad1 foot_1"), "at \"mash\" (did you mean \"mesh\"?) " + kUsage);
  EXPECT_EQ(complaint("every 5 mesh pad1"), "at \"mesh\" " + kUsage);
  EXPECT_EQ(complaint("every 5 patience"), "at \"patience\" " + kUsage);
}

TEST(CoupleMbdArguments, RefuseWindowsThatAreNoNumberOfSteps) {
  for (const char* n : {"0", "-1", "1000001", "5x", "1.5", "many"})
    EXPECT_EQ(complaint(std::string("every ") + n),
              std::string("`every` needs a number of steps from 1 to 1000000 or `auto`, not \"") + n + "\"");
  EXPECT_EQ(complaint("every 1000000"), "nothing is wrong");
}

TEST(CoupleMbdArguments, RefusePatienceThatIsNoTime) {
  for (const char* time : {"0", "-2", "5s", "nan", "long"})
    EXPECT_EQ(complaint(std::string("every 5 patience ") + time),
              std::string("`patience` needs a positive number of seconds, not \"") + time + "\"");
}

TEST(CoupleMbdArguments, RefuseOtherWordsThanThoseTheyOffer) {
  EXPECT_EQ(complaint("every 5 gravity own"), "`gravity` needs `scene` or `script`, not \"own\"");
  EXPECT_EQ(complaint("every 5 end early"), "`end` needs `scene` or `script`, not \"early\"");
  for (const char* share : {"0", "1.5", "5%", "-0.1"})
    EXPECT_EQ(complaint(std::string("every 5 lost ") + share),
              std::string("`lost` needs a share of the grains above 0 and up to 1, not \"") + share + "\"");
}

TEST(CoupleMbdArguments, RefuseAMeshThatIsNamedTwice) {
  EXPECT_EQ(complaint("every 5 mesh pad1 foot mesh pad1 leg"), "mesh pad1: it belongs to body \"foot\" already");
}

}  // namespace
}  // namespace footfall
