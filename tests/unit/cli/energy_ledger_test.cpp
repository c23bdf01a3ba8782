// The ledger: what the grains dissipated is the rest of the work they received.
#include "mbd_solver/cli/analysis/energy_ledger.h"

#include <gtest/gtest.h>

#include <stdlib.h>
#include <algorithm>

#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/analysis/plots.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

// A mechanism of 100 J loses 10 J/s in a damper and 20 J/s to grains; 1 J/s of that is lost in the interface.
History run(bool grains) {
  History h;
  const auto add = [&](const char* name, std::vector<double> values) {
    h.names.emplace_back(name);
    h.units.emplace_back("J");
    h.columns.push_back(std::move(values));
  };
  const double out = grains ? 20.0 : 0.0;
  add("time", {0, 1, 2});
  add("energy.kinetic", {90, 80 - out, 70 - 2 * out});
  add("energy.gravity", {10, 10, 10});
  add("energy.strain", {0, 0, 0});
  add("energy.gas", {0, 0, 0});
  add("energy.contact", {0, 0, 0});
  add("energy.total", {100, 90 - out, 80 - 2 * out});
  add("dissipated.damper", {0, 10, 20});
  add("work.contact", {0, -out, -2 * out});
  add("work.motion", {0, 0, 0});
  if (grains) add("coupling.energy_residual", {0, 1, 2});
  return h;
}

TEST(EnergyLedger, TheRestOfTheWorkIsDissipatedInTheGrains) {
  GrainEnergies grains{{0, 0.5, 1, 1.5}, {3, 5, 7, 9}, {50, 49, 48, 47}};  // +4 J/s, -2 J/s
  const History ledger = energy_ledger(run(true), grains);
  ASSERT_EQ(ledger.column("time"), grains.time);
  EXPECT_DOUBLE_EQ(ledger.column("work.to_grains")[3], 30.0);
  EXPECT_DOUBLE_EQ(ledger.column("grains.kinetic")[3], 6.0);
  EXPECT_DOUBLE_EQ(ledger.column("grains.gravity")[3], -3.0);
  EXPECT_DOUBLE_EQ(ledger.column("grains.dissipated")[3], 30.0 - 1.5 - 6.0 + 3.0);
  for (const double sum : ledger.column("sum")) EXPECT_DOUBLE_EQ(sum, 100.0);
}

TEST(EnergyLedger, AMechanismThatDoesNotCloseIsSeen) {
  History h = run(true);
  for (const char* name : {"energy.kinetic", "energy.total"})
    h.columns[static_cast<std::size_t>(h.find(name))][2] += 0.9;
  EXPECT_NEAR(energy_ledger(h, {}).column("closing_error").back(), 0.01, 1e-12);  // of 90 J
}

TEST(EnergyLedger, WithoutGrainsThereAreNoColumnsOfThem) {
  const History ledger = energy_ledger(run(false), {});
  for (const char* name : {"work.to_grains", "interface", "grains.kinetic", "grains.dissipated"})
    EXPECT_LT(ledger.find(name), 0) << name;
  EXPECT_EQ(ledger.column("time").size(), 3u);
}

TEST(EnergyLedger, BandsOfItsPictureAreNeverNegative) {
  const History ledger = energy_ledger(run(true), {{0, 1, 2}, {0, 4, 8}, {0, -2, -4}});
  const Figure figure = ledger_figure(ledger);
  const auto gravity = std::find_if(figure.curves.begin(), figure.curves.end(),
                                    [](const Curve& curve) { return curve.title == "grains, gravity"; });
  ASSERT_TRUE(gravity != figure.curves.begin() && gravity != figure.curves.end());
  const std::vector<double> edge = gravity->formula.values(ledger), below = (gravity - 1)->formula.values(ledger);
  for (std::size_t k = 0; k < 3; ++k)  // on top of the band below, from its own lowest value, in kJ
    EXPECT_NEAR(edge[k] - below[k], (4.0 - 2.0 * static_cast<double>(k)) / 1000.0, 1e-12) << k;
  EXPECT_TRUE(figure.stacked);
}

class GrainFile : public ::testing::Test, protected TemporaryFolder {
 protected:
  std::string write(const std::string& text) const {
    const std::string path = (folder_ / "grains_energy.txt").string();
    std::ofstream(path) << text;
    return path;
  }
};

TEST_F(GrainFile, KineticIsOfTranslationAndRotation) {
  const GrainEnergies grains = read_grain_energies(write("# title\n# step time\n0 0 1 0.5 7\n50 0.005 2 0.25 6\n"));
  EXPECT_EQ(grains.kinetic, (std::vector<double>{1.5, 2.25}));
  EXPECT_EQ(grains.gravity, (std::vector<double>{7, 6}));
}

TEST_F(GrainFile, ARowThatAKilledRunCutOffIsLeftOut) {
  EXPECT_EQ(read_grain_energies(write("0 0 1 0 7\n50 0.005 2")).time.size(), 1u);
}

TEST_F(GrainFile, ABrokenRowIsNamedWithItsLine) {
  const std::string path = write("0 0 1 0 7\n50 0.005 2\n100 0.01 1 0 7\n");
  try {
    read_grain_energies(path);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("grains_energy.txt:2: \"50 0.005 2\": expected five numbers"),
              std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace footfall
