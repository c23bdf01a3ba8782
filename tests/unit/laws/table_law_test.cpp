#include "mbd_solver/model/laws/table_law.h"

#include <fstream>

#include "coupler/base/errors.h"
#include "tests/unit/laws/law_checks.h"

namespace footfall {
namespace {

using namespace law_checks;

TableLawParameters example() {
  TableLawParameters p;
  p.stroke = {0.0, 0.1, 0.3};
  p.rate = {-1.0, -0.1, 0.0, 0.1, 2.0};
  p.force.resize(3, 5);
  p.force << -900, -400, 0, 600, 2000,  //
      -500, 0, 400, 1000, 2400,         //
      600, 1100, 1500, 2100, 3000;
  return p;
}

// A file that disappears with the test.
struct TemporaryFile {
  explicit TemporaryFile(const std::string& text)
      : path(std::filesystem::temp_directory_path() /
             ("footfall_table_" + std::to_string(std::random_device{}()) + ".csv")) {
    std::ofstream(path) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path); }
  std::filesystem::path path;
};

TEST(TableLaw, IsExactAtItsEntriesAndLinearBetween) {
  const TableLaw law(example());
  const TableLawParameters p = example();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 5; ++j)
      EXPECT_NEAR(force(law, p.stroke[static_cast<std::size_t>(i)], p.rate[static_cast<std::size_t>(j)]), p.force(i, j),
                  1e-9);
  EXPECT_NEAR(force(law, 0.05, 0.05), 0.25 * (0 + 600 + 400 + 1000), 1e-9);
}

TEST(TableLaw, ContinuesItsElasticPartLinearlyAndHoldsTheRest) {
  const TableLaw law(example());
  EXPECT_NEAR(force(law, 0.4, 0.0), 1500.0 + 0.1 * 5500.0, 1e-9);
  EXPECT_NEAR(force(law, 0.4, 0.1), 1500.0 + 0.1 * 5500.0 + 600.0, 1e-9);
  EXPECT_NEAR(force(law, 0.1, 9.0), 2400.0, 1e-9);
  EXPECT_NEAR(force(law, -0.1, -5.0), -400.0 - 900.0, 1e-9);
}

// A linear spring and damper written as a table is that spring and damper, inside the table.
TEST(TableLaw, ReproducesABilinearLaw) {
  TableLawParameters p;
  p.stroke = {-0.2, 0.0, 0.07, 0.2};
  p.rate = {-3.0, -0.5, 0.0, 1.0, 3.0};
  p.force.resize(4, 5);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 5; ++j)
      p.force(i, j) = 5000.0 * p.stroke[static_cast<std::size_t>(i)] + 300.0 * p.rate[static_cast<std::size_t>(j)];
  const TableLaw law(p);
  for (double x : {-0.19, -0.01, 0.05, 0.15})
    for (double v : {-2.9, -0.3, 0.4, 2.0}) {
      EXPECT_NEAR(force(law, x, v), 5000.0 * x + 300.0 * v, 1e-9);
      // trapezoids of the nodes
      EXPECT_NEAR(law.stored_energy({x, v, 0.0, law_checks::kNoState}), 2500.0 * x * x, 0.25 * 2500.0 * 0.2 * 0.2);
    }
}

TEST(TableLaw, DissipatesWhatItTakesAlsoOutsideTheTable) {
  const TableLaw law(example());
  for (unsigned seed : {1u, 2u, 3u}) {
    const Motion motion = random_motion(seed, 0.15, 0.4);
    const Along run = drive(law, motion, 0.0, 1.0, 50000, 0.0, law_checks::kNoState);
    // Kinks of the force at the table's lines: second-order jumps in each of the few hundred crossings.
    EXPECT_NEAR(run.work, run.dissipated + run.stored - run.stored_start, 1e-8 * run.dissipated);
  }
}

TEST(TableLaw, DerivativesAreThoseOfTheForce) {
  const TableLaw law(example());
  for (double x : {-0.2, 0.03, 0.22, 0.5})
    for (double v : {-4.0, -0.4, -0.03, 0.06, 1.0, 5.0}) {
      expect_derivatives(law, x, v, 0.0, law_checks::kNoState, 0.01, 0.01);
      expect_power_identity(law, x, v, 0.0, law_checks::kNoState);
    }
}

TEST(TableLaw, ReadsItsFile) {
  const TemporaryFile file(
      "# a passive strut\n"
      "stroke, -1.0, -0.1, 0, +0.1, 2.0\n"
      "0.00, -900, -400, 0, 600, 2000\n"
      "\n"
      "0.10, -500, 0, 400, 1000, 24e2  # a comment\n"
      "0.30, 600, 1100, 1500, 2100, 3000\r\n");
  const TableLawParameters p = read_table_law(file.path), expected = example();
  EXPECT_EQ(p.stroke, expected.stroke);
  EXPECT_EQ(p.rate, expected.rate);
  EXPECT_EQ(p.force, expected.force);
  EXPECT_EQ(p.lines, (std::vector<int>{3, 5, 6}));
}

TEST(TableLaw, NamesFileAndLineOfABadTable) {
  const auto message = [](const std::string& text) {
    const TemporaryFile file(text);
    const std::string found = message_of<InputError>([&] { TableLaw{read_table_law(file.path)}; });
    expect_contains(found, file.path.filename().string());
    return found;
  };
  const std::string head = "stroke, -1, 0, 1\n";
  expect_contains(message(head + "0, -1, 0, x\n"), ":2: \"x\" is not a number");
  expect_contains(message(head + "0, -1, 0\n"), ":2: 3 cells; expected 4");
  expect_contains(message(head + "0, -1, 0, nan\n"), ":2: \"nan\" is not a number");
  expect_contains(message(head + "0, -1, 0, 1\n0, -1, 0, 1\n"), ":3: stroke 0 m does not lie above");
  expect_contains(message(head + "0, -1, 0, 1\n# end\n0.1, -1, 0, -5\n"),
                  ":4: force -5 N at stroke 0.1 m, rate 1 m/s is below the force at rest");
  expect_contains(message(head + "0, 7, 0, 1\n0.1, -1, 0, 5\n"),
                  ":2: force 7 N at stroke 0 m, rate -1 m/s is above the force at rest");
  expect_contains(message(head + "0, -1, 0, 1\n"), "1 lines of forces");
  expect_contains(message("stroke, 1, 2\n0, 1, 2\n1, 1, 2\n"), "0 m/s is not among the rates");
  expect_contains(message("stroke, 0, 2, 1\n0, 1, 2, 3\n1, 1, 2, 3\n"), "rate 1 m/s follows 2 m/s");
  expect_contains(message("stroke, 1\n"), ":1: 2 cells in the first line");
  expect_contains(message_of<InputError>([] { read_table_law("no_such_file.csv"); }),
                  "no_such_file.csv: cannot be read");
}

}  // namespace
}  // namespace footfall
