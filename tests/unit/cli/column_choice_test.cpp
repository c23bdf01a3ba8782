#include "mbd_solver/cli/analysis/column_choice.h"

#include <gtest/gtest.h>

#include <set>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

using Names = std::vector<std::string>;

History history_of(const std::vector<std::pair<std::string, std::string>>& columns, double value = 1.0) {
  History history{{"time"}, {"s"}, {{0.0, 1.0}}};
  for (const auto& [name, unit] : columns) {
    history.names.push_back(name);
    history.units.push_back(unit);
    history.columns.push_back({0.0, value});
  }
  return history;
}

// Four legs of three struts each, as the lander has.
History lander() {
  std::vector<std::pair<std::string, std::string>> columns = {
      {"cabin.vx", "m/s"}, {"cabin.vy", "m/s"}, {"cabin.vz", "m/s"}, {"cabin.az", "m/s2"}};
  for (const char* leg : {"1", "2", "3", "4"})
    for (const char* strut : {"primary", "left", "right"})
      for (const char* what : {"stroke", "force"})
        columns.emplace_back(std::string("leg_") + leg + "_" + strut + "." + what,
                             std::string(what) == "force" ? "N" : "m");
  columns.emplace_back("motor_1.force", "N");
  return history_of(columns, 5e3);
}

nlohmann::ordered_json scene() {
  nlohmann::ordered_json json;
  for (const char* leg : {"1", "2", "3", "4"})
    for (const char* strut : {"primary", "left", "right"})
      json["struts"].push_back({{"name", std::string("leg_") + leg + "_" + strut}});
  return json;
}

TEST(ColumnChoice, WordsAreColumnsPatternsKindsAndVectors) {
  const History history = lander();
  EXPECT_EQ(chosen_columns(history, {}, {"cabin.az"}), Names{"cabin.az"});
  EXPECT_EQ(chosen_columns(history, {}, {"leg_1_*.stroke"}).size(), 3u);
  EXPECT_EQ(chosen_columns(history, {}, {"cabin.v"}), (Names{"cabin.vx", "cabin.vy", "cabin.vz"}));
  // The motor's force is no strut's.
  EXPECT_EQ(chosen_columns(history, scene(), {"struts.*.force"}).size(), 12u);
  EXPECT_EQ(chosen_columns(history, scene(), {"*.force"}).size(), 13u);
  EXPECT_EQ(chosen_columns(history, {}, {"cabin.az", "cabin.a*"}), Names{"cabin.az"});  // every column once
}

TEST(ColumnChoice, AWordThatMeansNothingIsToldWithWhatMayHaveBeenMeant) {
  try {
    chosen_columns(lander(), scene(), {"cabin.ay"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("Did you mean \"cabin."), std::string::npos) << error.what();
  }
}

TEST(ColumnChoice, UnitsFollowTheData) {
  EXPECT_EQ(drawn_unit("N", 5e3).name, "kN");
  EXPECT_EQ(drawn_unit("N", 999.0).name, "N");
  EXPECT_EQ(drawn_unit("Pa", 2e8).name, "MPa");
  EXPECT_EQ(drawn_unit("m", 0.02).name, "mm");
  EXPECT_DOUBLE_EQ(drawn_unit("m", 0.02).factor, 1e3);
  EXPECT_EQ(drawn_unit("m", 3.0).name, "m");
  EXPECT_EQ(drawn_unit("rad", 1e-4).name, "rad");
  EXPECT_EQ(drawn_unit("-", 1e6).name, "-");
}

TEST(ColumnChoice, MoreThanEightSeriesBecomeLegsOfOneScaleWithAColourPerRole) {
  const History history = lander();
  const Panels panels = panels_of(history, chosen_columns(history, scene(), {"struts.*.force"}));
  ASSERT_EQ(panels.figures.size(), 4u);
  EXPECT_TRUE(panels.multiples);
  for (const Figure& figure : panels.figures) {
    ASSERT_EQ(figure.curves.size(), 3u);
    EXPECT_EQ(figure.axis, "force [kN]");
    EXPECT_EQ(figure.curves[0].title, "primary");
    EXPECT_EQ(figure.curves[0].colour, panels.figures[0].curves[0].colour);
    EXPECT_EQ(figure.high, panels.figures[0].high);
    EXPECT_GE(figure.high, 5.0);  // kN, as the curves
  }
  EXPECT_EQ(panels.figures[2].title, "leg_3");
}

TEST(ColumnChoice, NoPanelHasTwoSeriesOfOneColourOrTwoUnits) {
  std::vector<std::pair<std::string, std::string>> columns;
  for (int i = 0; i < 21; ++i) columns.emplace_back("body" + std::string(1, static_cast<char>('a' + i)) + ".x", "m");
  columns.emplace_back("body.vx", "m/s");
  const History history = history_of(columns);
  const Panels panels = panels_of(history, Names(history.names.begin() + 1, history.names.end()));
  std::size_t curves = 0;
  for (const Figure& figure : panels.figures) {
    std::set<std::string> colours;
    for (const Curve& curve : figure.curves) colours.insert(curve.colour);
    EXPECT_EQ(colours.size(), figure.curves.size());
    EXPECT_LE(figure.curves.size(), 8u);
    curves += figure.curves.size();
  }
  EXPECT_EQ(curves, 22u);
  EXPECT_EQ(panels.figures.size(), 4u);  // 8 + 8 + 5 of one unit, one of the other
}

}  // namespace
}  // namespace footfall
