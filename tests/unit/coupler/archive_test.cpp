#include "coupler/archive.h"

#include <gtest/gtest.h>

#include <limits>

#include "coupler/base/errors.h"
#include "coupler/message_fields.h"

namespace footfall {
namespace {

struct Part {
  double x = 0.0;
  std::vector<bool> marks;
  void visit(Archive& archive) {
    archive("x", x);
    archive("marks", marks);
  }
};

struct Memory {
  bool yes = false;
  int n = 0;
  long steps = 0;
  double tiny = 0.0, endless = 0.0;
  std::string text;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::VectorXd rates;
  Eigen::MatrixXd table;
  std::array<double, 2> pair{};
  std::vector<Part> parts;
  std::optional<Part> there, absent;
  BodyLoad load;  // has a list of fields

  void visit(Archive& archive) {
    archive("yes", yes);
    archive("n", n);
    archive("steps", steps);
    archive("tiny", tiny);
    archive("endless", endless);
    archive("text", text);
    archive("place", place);
    archive("rates", rates);
    archive("table", table);
    archive("pair", pair);
    archive("parts", parts);
    archive("there", there);
    archive("absent", absent);
    archive("load", load);
  }
};

Memory example() {
  Memory m;
  m.yes = true;
  m.n = -7;
  m.steps = 1L << 40;
  m.tiny = std::numeric_limits<double>::denorm_min();
  m.endless = std::numeric_limits<double>::infinity();
  m.text = "two lines:\na \\ and an end ";
  m.place = {0.1, -1.0 / 3.0, 1e300};
  m.rates = Eigen::VectorXd::LinSpaced(5, 0.0, 0.3);
  m.table = Eigen::MatrixXd::Random(2, 3);
  m.pair = {1.0, 2.0};
  m.parts = {{0.7, {true, false, true}}, {0.2, {}}};
  m.there = Part{0.3, {false}};
  m.load.mean.F_W = {1.0, 2.0, 3.0};
  m.load.contacts = 4;
  m.load.tangent.resize(1);
  return m;
}

std::string text_of(Memory memory) {
  Archive archive;
  archive("memory", memory);
  return archive.text();
}

std::string complaint_about(const std::string& text) {
  Archive archive("run.txt", text);
  Memory memory;
  try {
    archive("memory", memory);
    archive.finish();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Archive, RestoresEveryBit) {
  const std::string text = text_of(example());
  Archive archive("run.txt", text);
  Memory restored;
  archive("memory", restored);
  archive.finish();
  EXPECT_EQ(text_of(restored), text);
  const Memory e = example();
  EXPECT_EQ(restored.tiny, e.tiny);
  EXPECT_EQ(restored.endless, e.endless);
  EXPECT_EQ(restored.text, e.text);
  EXPECT_EQ(restored.place, e.place);
  EXPECT_EQ(restored.rates, e.rates);
  EXPECT_EQ(restored.parts[0].marks, e.parts[0].marks);
  EXPECT_FALSE(restored.absent.has_value());
  EXPECT_EQ(restored.load.mean.F_W, e.load.mean.F_W);
}

TEST(Archive, OfAnotherMemoryIsRefusedWithItsLine) {
  const std::string text = text_of(example());
  std::string other = text;
  other.replace(other.find("memory/n "), 9, "memory/m ");
  const std::string said = complaint_about(other);
  EXPECT_NE(said.find("run.txt:2: expected \"memory/n\", found \"memory/m\""), std::string::npos) << said;
  EXPECT_NE(complaint_about(text + "more 1\n").find("expected the end"), std::string::npos);
  EXPECT_NE(complaint_about(text.substr(0, text.size() - 3)), "");
}

TEST(Archive, VectorsOfAnotherLengthAreRefused) {
  Eigen::VectorXd five = Eigen::VectorXd::Ones(5), four = Eigen::VectorXd::Ones(4), none;
  Archive save;
  save("q", five);
  Archive fits("run.txt", save.text()), too_long("run.txt", save.text());
  fits("q", none);
  EXPECT_EQ(none, five);
  EXPECT_THROW(too_long("q", four), InputError);
}

// Rows without columns were taken for rows of one number each, which nobody had made room for.
TEST(Archive, ShapesThatATypeCannotHaveAreRefused) {
  for (const char* text : {"q 3 0\n", "q 0 3\n", "q 1 3 1 2 3\n", "q -1 1\n"}) {
    Eigen::VectorXd q;
    Archive archive("run.txt", text);
    EXPECT_THROW(archive("q", q), InputError) << text;
  }
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Archive lying("run.txt", "r 1 3 0x1p+0 0x1p+0 0x1p+0\n");
  EXPECT_THROW(lying("r", place), InputError);
}

}  // namespace
}  // namespace footfall
