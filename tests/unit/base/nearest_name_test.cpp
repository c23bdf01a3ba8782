#include "coupler/base/nearest_name.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

const std::vector<std::string> kBodies = {"cabin", "leg_1", "leg_2"};

TEST(NearestName, FindsOneEditOfEachKind) {
  EXPECT_EQ(nearest_name("cabn", kBodies), "cabin") << "a letter is missing";
  EXPECT_EQ(nearest_name("cabbin", kBodies), "cabin") << "one too many";
  EXPECT_EQ(nearest_name("cavin", kBodies), "cabin") << "another letter";
  EXPECT_EQ(nearest_name("acbin", kBodies), "cabin") << "neighbours swapped";
}

TEST(NearestName, TakesTheFirstOfEquals) { EXPECT_EQ(nearest_name("leg", kBodies), "leg_1"); }

TEST(NearestName, IsEmptyWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("thruster", kBodies), "");
  EXPECT_EQ(nearest_name("cabin", {}), "");
}

TEST(KnownNames, ListsAndGuesses) {
  EXPECT_EQ(known_names("bodies", "leg2", kBodies), " Known bodies: cabin, leg_1, leg_2. Did you mean \"leg_2\"?");
  EXPECT_EQ(known_names("bodies", "leg2", {}), " There are no known bodies.");
}

TEST(KnownNames, CutsALongList) {
  const std::vector<std::string> many(25, "thruster");
  const std::string text = known_names("bodies", "x", many);
  EXPECT_EQ(text.substr(text.size() - 5), ", ...");
}

}  // namespace
}  // namespace footfall
