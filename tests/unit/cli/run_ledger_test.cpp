// mbd_solver/cli/calibrate/run_ledger.h: what runs said comes back to the last bit, and only as an answer to the same question; damage is named.
#include "mbd_solver/cli/calibrate/run_ledger.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"

namespace footfall {
namespace {

class LedgerOfRuns : public ::testing::Test {
 protected:
  void SetUp() override {
    spec.scenes.resize(2);
    spec.scenes[0].name = "one", spec.scenes[1].name = "two";
    spec.figures.resize(2);
    spec.figures[0].name = "depth", spec.figures[0].key = "max_penetration_m";
    spec.figures[1].name = "angle", spec.figures[1].slope = {-0.2, -0.1};
    spec.targets.resize(2);
    spec.targets[0].figure = "depth", spec.targets[0].scene = "one", spec.targets[0].against = "two";
    spec.targets[1].figure = "angle", spec.targets[1].scene = "two";
  }
  void TearDown() override { std::filesystem::remove(file); }

  RunLedger::Entry entry(const std::string& run, double depth, double angle) const {
    RunLedger::Entry e;
    e.run = run, e.wall = 1.5, e.cpu = 0.1 + 0.2;
    e.numbers.figures = {depth, angle};
    e.numbers.curves.resize(2);
    return e;
  }
  void write_two() const {
    RunLedger ledger(spec, file);
    ledger.note("one", "recipe1", entry("one_1", 1.0 / 3.0, std::nan("")));
    ledger.note("two", "recipe2", entry("two_2", 2.0 / 3.0, M_PI));
    ledger.write();
  }

  CalibrationSpec spec;
  std::string file =
      (std::filesystem::temp_directory_path() / ("footfall_ledger_" + std::to_string(::getpid()))).string();
};

TEST_F(LedgerOfRuns, ComesBackToTheLastBit) {
  write_two();
  const RunLedger ledger(spec, file);
  const RunLedger::Entry* one = ledger.find("one", "recipe1");
  ASSERT_TRUE(one);
  EXPECT_EQ(one->run, "one_1");
  EXPECT_EQ(one->numbers.figures[0], 1.0 / 3.0);
  EXPECT_TRUE(std::isnan(one->numbers.figures[1])) << "not asked";
  EXPECT_EQ(one->cpu, 0.1 + 0.2);
  ASSERT_TRUE(ledger.find("two", "recipe2"));
  EXPECT_EQ(ledger.find("two", "recipe2")->numbers.figures[1], M_PI);
  EXPECT_FALSE(ledger.find("one", "recipe2")) << "of another scene";
  EXPECT_FALSE(ledger.find("one", "")) << "a scene that cannot be read";
}

TEST_F(LedgerOfRuns, AnswersTheSameQuestionOnlyAndKeepsTheOthers) {
  write_two();
  CalibrationSpec other = spec;
  other.figures[1].slope = {-0.3, -0.1};
  {
    RunLedger ledger(other, file);
    EXPECT_TRUE(ledger.find("one", "recipe1")) << "is not asked for the angle";
    EXPECT_FALSE(ledger.find("two", "recipe2"));
    ledger.note("two", "recipe2", entry("two_2", 0.5, 2.0));
    ledger.write();
  }
  EXPECT_EQ(RunLedger(other, file).find("two", "recipe2")->numbers.figures[1], 2.0);
  EXPECT_EQ(RunLedger(spec, file).find("two", "recipe2")->numbers.figures[1], M_PI);
}

TEST_F(LedgerOfRuns, CutAnywhereLosesTheLastLineAlone) {
  write_two();
  const std::string text = *read_whole_file(file);
  const std::size_t first = text.find('\n');
  for (std::size_t length = 0; length < text.size(); ++length) {
    std::ofstream(file) << text.substr(0, length);
    const RunLedger ledger(spec, file);
    EXPECT_EQ(ledger.find("one", "recipe1") != nullptr, length >= first) << length;
    EXPECT_EQ(ledger.find("two", "recipe2") != nullptr, length >= text.size() - 1) << length;
  }
}

TEST_F(LedgerOfRuns, DamageIsNamedByItsLine) {
  write_two();
  const std::string text = *read_whole_file(file);
  std::mt19937 random(7);
  int named = 0;
  for (int k = 0; k < 2000; ++k) {
    std::string damaged = text;
    for (int n = 0; n < 3; ++n) damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
    std::ofstream(file) << damaged;
    try {
      const RunLedger ledger(spec, file);
    } catch (const InputError& error) {
      ++named;
      EXPECT_NE(std::string(error.what()).find(file + ":"), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(named, 500);
}

}  // namespace
}  // namespace footfall
