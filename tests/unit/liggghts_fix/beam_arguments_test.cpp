#include "liggghts_fix/beam_arguments.h"

#include <gtest/gtest.h>

#include <sstream>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

BeamArguments parsed(const std::string& after_style) {
  std::istringstream in("strut all wall/gran/beam " + after_style);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  return {static_cast<int>(pointers.size()), pointers.data()};
}

// The message must begin so, after the name of the fix that all share.
void expect_complaint(const std::string& after_style, const std::string& complaint) {
  try {
    parsed(after_style);
    ADD_FAILURE() << "nothing is wrong with: " << after_style;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("fix strut wall/gran/beam: " + complaint, 0), 0U) << error.what();
  }
}

TEST(BeamArguments, GiveTheStockWallItsWordsAndKeepTheirOwn) {
  const BeamArguments all =
      parsed("model hertz tangential history type 2 body leg_1 chain 3 body leg_2 store_force yes");
  EXPECT_EQ(all.type, "2");
  ASSERT_EQ(all.beams.size(), 2U);
  EXPECT_EQ(all.beams[0].body, "leg_1");
  EXPECT_EQ(all.beams[0].chain, 3);
  EXPECT_EQ(all.beams[1].body, "leg_2");
  EXPECT_EQ(all.beams[1].chain, -1);
  const std::vector<std::string> stock = {"strut",   "all",       "wall/gran/beam", "model", "hertz",     "tangential",
                                          "history", "primitive", "type",           "2",     "zcylinder", "0",
                                          "0",       "0",         "store_force",    "yes"};
  EXPECT_EQ(all.stock, stock);
}

TEST(BeamArguments, RefuseEveryWrongWordByName) {
  expect_complaint("model hertz mesh n_meshes 1 type 2 body leg", "keyword \"mesh\" belongs to fix wall/gran");
  expect_complaint("model hertz type 2 body", "nothing follows keyword \"body\"");
  expect_complaint("model hertz type 2 type 1 body leg", "keyword \"type\" stands twice");
  expect_complaint("model hertz type 2 chain 1 body leg", "\"chain 1\" does not follow a body");
  expect_complaint("model hertz type 2 body leg chain 1 chain 2", "\"chain 2\" does not follow a body");
  expect_complaint("model hertz type 2 body leg chain one", "\"chain one\" is not the number of a beam");
  expect_complaint("model hertz type 2 body leg chain -1", "\"chain -1\" is not the number of a beam");
  expect_complaint("model hertz body leg", "the material is missing");
  expect_complaint("model hertz type 2", "the body is missing");
  expect_complaint("model hertz type 2 body leg chain 1 body leg", "the same beam of body \"leg\"");
  expect_complaint("model hertz type 2 body leg chain 1 body leg chain 1", "the same beam of body \"leg\"");
}

ModalBoundary two_beams() {
  Eigen::Matrix3Xd rho0(3, 4);
  rho0 << 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0;
  return ModalBoundary("leg", rho0, {}, {{2, 3, 0.1, 7}, {0, 1, 0.1, 4}});
}

TEST(BeamArguments, ChooseAllBeamsOrTheOneWithTheNumber) {
  EXPECT_EQ(chosen_chains("fix f", {"leg", -1}, two_beams()), (std::vector<int>{4, 7}));
  EXPECT_EQ(chosen_chains("fix f", {"leg", 7}, two_beams()), std::vector<int>{7});
}

TEST(BeamArguments, NameTheBeamsThereAreWhenTheNumberIsWrong) {
  try {
    chosen_chains("fix f", {"leg", 5}, two_beams());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "fix f: body \"leg\" has no beam 5. It has 2 beams, numbers 4, 7");
  }
  const ModalBoundary bare("plate", Eigen::Matrix3Xd::Zero(3, 1), {});
  EXPECT_THROW(chosen_chains("fix f", {"plate", -1}, bare), InputError);
}

}  // namespace
}  // namespace footfall
