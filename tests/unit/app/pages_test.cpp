// Pages and pictures of a run.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <random>
#include <set>

#include "coupler/base/errors.h"
#include "mbd_solver/app/packed_series.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/app/plots.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/app/results.h"
#include "mbd_solver/base/packed_bytes.h"
#include "mbd_solver/session/output/history.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

// Names of cases hold what tables separate cells by.
TEST(SweepReport, KeepsCellsThatHoldCommas) {
  struct Folder : TemporaryFolder {
    using TemporaryFolder::text;
    using TemporaryFolder::write;
  } const folder;
  const std::string rows =
      "run,gravity,status,peak\n0,\"[0,0,-3.71] # \"\"Mars\"\"\",done,2.5\n1,\"[0,0,-9.81]\",failed,\n";
  write_report(std::filesystem::path(folder.write("runs.csv", rows)).parent_path().string());
  const std::string page = folder.text("report.html");
  EXPECT_NE(page.find("<td>[0,0,-3.71] # &quot;Mars&quot;</td><td>done</td>"), std::string::npos) << page;
  EXPECT_NE(page.find("<td>[0,0,-9.81]</td><td>failed</td>"), std::string::npos) << page;
}

// A page that needs nothing but itself.

// Per cent of the limit that is nearest.
TEST(RequirementLines, TellTheMarginOfTheNearestLimit) {
  const auto line = [](const char* limits) {
    const auto summary = nlohmann::ordered_json::parse(
        R"({"requirements": [{"name": "peak", "unit": "g", "value": 3.2, "verdict": "met", )" + std::string(limits) +
        "}]}");
    return requirement_lines(summary).at(0);
  };
  const auto ends = [](const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
  };
  EXPECT_TRUE(ends(line(R"("most": 5, "margin": 1.8)"), "1.8 g (36 %)"));
  EXPECT_TRUE(ends(line(R"("least": 2, "margin": 1.2)"), "1.2 g (60 %)"));
  EXPECT_TRUE(ends(line(R"("least": 2, "most": 4, "margin": 0.8)"), "0.8 g (20 %)"));
  EXPECT_TRUE(ends(line(R"("least": 2, "most": 40, "margin": 1.2)"), "1.2 g (60 %)"));
}

TEST(HtmlPage, Base64FollowsTheStandard) {
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

TEST(HtmlPage, LinksFilesBelowItsFolderAlone) {
  HtmlPage page("t");
  page.table({{"to play it"}, {"[play](kept/row_1/view.html)"}, {"[a](javascript:b)"}, {"[a](//b/c)"}, {"[a](/b)"}});
  const std::string text = page.text();
  EXPECT_NE(text.find("<td><a href=\"kept/row_1/view.html\">play</a></td>"), std::string::npos) << text;
  for (const char* const cell : {"[a](javascript:b)", "[a](//b/c)", "[a](/b)"})
    EXPECT_NE(text.find("<td>" + std::string(cell) + "</td>"), std::string::npos) << cell;
}

// As warnings name options: `--set a=1`.
TEST(HtmlPage, ShowsWhatIsBetweenBackticksAsCode) {
  HtmlPage page("t");
  page.warning("use `--set a=<1>` or `b`");
  page.warning("a ` alone");
  EXPECT_NE(page.text().find("use <code>--set a=&lt;1&gt;</code> or <code>b</code></p>"), std::string::npos);
  EXPECT_NE(page.text().find("a ` alone</p>"), std::string::npos);
}

TEST(HtmlPage, PicturesStandInThePage) {
  const TemporaryFolder folder;
  const std::string file = folder.write("dot.png", "PNG!");
  HtmlPage page("t");
  page.picture(file);
  EXPECT_NE(page.text().find("src=\"data:image/png;base64,UE5HIQ==\""), std::string::npos);
  EXPECT_THROW(page.picture("/no/such/picture.png"), InputError);
}

// What web/src/figures.js reads: groups of figures with common times, values curve by curve.
TEST(HtmlPage, HoldsItsFiguresAsNumbers) {
  const History history{{"time", "a", "b"}, {"s", "m", "m"}, {{0.0, 0.5}, {1.0, 2.0}, {4.0, 8.0}}};
  const Formula a{{{1.0, "a"}}, 0.0, 1e3}, b{{{1.0, "b"}}};
  Figure both{"both", "Both", "length [mm]", {{"a", a}, {"total", b}}};
  both.peaks = {{0.5, 2000.0, "2000 at 0.5 s"}};
  HtmlPage page("t");
  EXPECT_EQ(page.text().find("<script"), std::string::npos) << "a page without data needs none";
  page.figures({both, {"one", "One", "length [m]", {{"b", b, "#c7e9c0"}}}}, history);
  page.figures({both}, history);
  const nlohmann::ordered_json& groups = page.data().run.at("figures");
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].at("times"), nlohmann::ordered_json({0.0, 0.5}));
  const nlohmann::ordered_json& first = groups[0].at("figures")[0];
  EXPECT_EQ(first.at("peaks")[0].at("text"), "2000 at 0.5 s");
  EXPECT_EQ(first.at("curves")[0].at("series"), 0);
  EXPECT_EQ(first.at("curves")[1].at("series"), 6) << "a total is black";
  EXPECT_EQ(groups[0].at("figures")[1].at("curves")[0].at("colour"), "#c7e9c0");
  const PageParts& data = page.data();
  ASSERT_EQ(data.chunks.size(), 2u);
  EXPECT_EQ(data.chunks[1].first, "figures-1");
  EXPECT_EQ(data.chunks[0].second, packed_numbers(std::vector<float>{1000, 2000, 4, 8, 4, 8}));
  const std::string text = page.text();
  EXPECT_LT(text.find("data-group=\"0\""), text.find("data-group=\"1\""));
  EXPECT_LT(text.find("data-group=\"1\""), text.find("id=\"footfall-figures-0\""));
}

// What the scripts of a page read.

void add_column(History& history, const std::string& name, const std::string& unit, const std::vector<double>& values) {
  history.names.push_back(name);
  history.units.push_back(unit);
  history.columns.push_back(values);
}

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

// What a page holds is what the run wrote, to half a step. The way back here follows web/src/decode.js.

std::string unpacked(const std::string& text, std::size_t size) {
  return inflated(bytes_of_base64(text).value(), size).value();
}

std::uint32_t byte(const std::string& bytes, std::size_t i) { return static_cast<unsigned char>(bytes[i]); }

void next_frame(const std::string& text, std::vector<std::uint16_t>& last) {
  const std::size_t n = last.size();
  const std::string bytes = unpacked(text, 2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t z = byte(bytes, i) | (byte(bytes, n + i) << 8);
    last[i] = static_cast<std::uint16_t>(last[i] + ((z >> 1) ^ (0u - (z & 1u))));
  }
}

TEST(PackedSeries, EveryFrameComesBackAsItWas) {
  constexpr std::size_t kCount = 1000;
  std::mt19937 random(17);
  std::uniform_int_distribution<int> any(0, 65535);
  PackedSeries series(kCount);
  std::vector<std::uint16_t> frame(kCount), read(kCount, 0);
  for (int k = 0; k < 5; ++k) {
    for (std::uint16_t& value : frame) value = static_cast<std::uint16_t>(any(random));
    // the ends of the range, there and back
    frame[0] = k % 2 == 0 ? 0 : 65535;
    frame[1] = k % 2 == 0 ? 32768 : 0;
    frame[2] = k % 2 == 0 ? 65535 : 32767;
    next_frame(series.add(frame), read);
    EXPECT_EQ(read, frame) << "frame " << k;
  }
}

TEST(PackedSeries, WhatRestsTakesNoRoom) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> any(0, 65534);
  std::vector<std::uint16_t> frame(30000);
  for (std::uint16_t& value : frame) value = static_cast<std::uint16_t>(any(random));
  PackedSeries series(frame.size());
  const std::size_t first = series.add(frame).size();
  EXPECT_GT(first, frame.size() * 2);                // noise does not pack
  EXPECT_LT(series.add(frame).size(), first / 100);  // its standing still does
}

TEST(PackedNumbers, FloatsAndWholeNumbersComeBackBitForBit) {
  const std::vector<float> numbers = {0.0f, -1.5f, 3.14159e-12f, 6.0e23f, -0.0f};
  const std::string bytes = unpacked(packed_numbers(numbers), 4 * numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::uint32_t bits = 0, expected = 0;
    for (std::size_t k = 0; k < 4; ++k) bits |= byte(bytes, k * numbers.size() + i) << (8 * k);
    std::memcpy(&expected, &numbers[i], 4);
    EXPECT_EQ(bits, expected);
  }
  const std::string whole = unpacked(packed_numbers(std::vector<std::uint32_t>{0x01020304u}), 4);
  EXPECT_EQ(whole, std::string("\x04\x03\x02\x01"));
}

TEST(Box, PlacesAreHalfAStepOffAtMost) {
  Box box;
  EXPECT_TRUE(box.is_empty());
  box.include({-1.0, 2.0, 0.0});
  box.include({1.5, 2.0, 0.8});  // without width along y
  EXPECT_FALSE(box.is_empty());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.0, 1.5);
  for (int i = 0; i < 1000; ++i) {
    const double x = place(random), read = box.low.x() + box.step(0) * box.number_of(0, x);
    EXPECT_NEAR(read, x, 0.5 * box.step(0) * (1.0 + 1e-9));
  }
  EXPECT_EQ(box.number_of(0, -1.0), 0);
  EXPECT_EQ(box.number_of(0, 1.5), kSteps);  // and never kAbsent
  EXPECT_EQ(box.number_of(1, 2.0), 0);
}

TEST(RootNumber, TellsSmallOnesApart) {
  EXPECT_EQ(root_number(0.0, 4.0), 0);
  EXPECT_EQ(root_number(4.0, 4.0), 255);
  EXPECT_EQ(root_number(1.0, 4.0), 128);
  EXPECT_GT(root_number(4e-4, 4.0), 1);  // a ten thousandth
  EXPECT_EQ(root_number(1.0, 0.0), 0);
}

TEST(ReducedRows, FewRowsStayAsTheyAre) {
  const std::vector<double> time = {0.0, 1.0, 2.0, 3.0}, values = {4.0, -1.0, 7.0, 2.0};
  const std::vector<std::size_t> rows = rows_to_draw(time, 2);
  EXPECT_EQ(rows, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(drawn_values(values, rows), values);
}

TEST(ReducedRows, NoPeakIsLost) {
  std::vector<double> time, values;
  for (int k = 0; k < 100000; ++k) {
    time.push_back(1e-3 * k);
    values.push_back(std::sin(0.01 * k));
  }
  values[31234] = 50.0;
  values[77777] = -60.0;
  const std::vector<std::size_t> rows = rows_to_draw(time, 500);
  EXPECT_LE(rows.size(), 1000u);
  EXPECT_EQ(rows.front(), 0u);
  EXPECT_EQ(rows.back(), time.size() - 1);
  const std::vector<double> drawn = drawn_values(values, rows);
  ASSERT_EQ(drawn.size(), rows.size());
  // Each pair is the lowest and the highest of its span, where its rows say.
  for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(rows[i]);
    const auto [low, high] = std::minmax_element(from, values.begin() + static_cast<std::ptrdiff_t>(rows[i + 1] + 1));
    EXPECT_EQ(std::min(drawn[i], drawn[i + 1]), *low);
    EXPECT_EQ(std::max(drawn[i], drawn[i + 1]), *high);
  }
  EXPECT_EQ(*std::max_element(drawn.begin(), drawn.end()), 50.0);
  EXPECT_EQ(*std::min_element(drawn.begin(), drawn.end()), -60.0);
}

// Rows come closer together where samples and windows end: spans of one row stand for themselves.
TEST(ReducedRows, SpansMayHoldOneRowOrMany) {
  const std::vector<double> time = {0.0, 0.1, 0.11, 0.12, 0.5, 0.9, 0.91, 1.0}, values = {1, 2, 9, 3, 4, 5, -6, 7};
  const std::vector<std::size_t> rows = rows_to_draw(time, 3);
  const std::vector<double> drawn = drawn_values(values, rows);
  ASSERT_EQ(drawn.size(), rows.size());
  EXPECT_EQ(*std::max_element(drawn.begin(), drawn.end()), 9.0);
  EXPECT_EQ(*std::min_element(drawn.begin(), drawn.end()), -6.0);
}

using Names = std::vector<std::string>;

History history_of(const std::vector<std::pair<std::string, std::string>>& columns, double value = 1.0) {
  History history{{"time"}, {"s"}, {{0.0, 1.0}}};
  for (const auto& [name, unit] : columns) add_column(history, name, unit, {0.0, value});
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

TEST(ColumnChoice, GuessesWhichColumnIsMeant) {
  EXPECT_TRUE(test::names(test::error_of([] { chosen_columns(lander(), scene(), {"cabin.ay"}); }), {"\"cabin."}));
}

TEST(ColumnChoice, UnitsFollowTheData) {
  EXPECT_EQ(drawn_unit("N", 5e3).name, "kN");
  EXPECT_EQ(drawn_unit("N", 999.0).name, "N");
  EXPECT_EQ(drawn_unit("Pa", 2e8).name, "MPa");
  EXPECT_EQ(drawn_unit("m", 0.02).name, "mm");
  EXPECT_DOUBLE_EQ(drawn_unit("m", 0.02).factor, 1e3);
  EXPECT_EQ(drawn_unit("m", 3.0).name, "m");
  EXPECT_EQ(drawn_unit("m", 2e-5).name, "µm");
  EXPECT_EQ(drawn_unit("J", 2e-5).name, "µJ");
  EXPECT_EQ(drawn_unit("N", 0.02).name, "mN");
  EXPECT_EQ(drawn_unit("N", 0.0).name, "N");
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
    EXPECT_EQ(figure.curves[0].series, panels.figures[0].curves[0].series);
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
    for (const Curve& curve : figure.curves) colours.insert(series_colour(curve.series));
    EXPECT_EQ(colours.size(), figure.curves.size());
    EXPECT_LE(figure.curves.size(), 14u);
    curves += figure.curves.size();
  }
  EXPECT_EQ(curves, 22u);
  EXPECT_EQ(panels.figures.size(), 3u);  // 14 + 7 of one unit, one of the other
}

// The ledger: what the grains dissipated is the rest of the work they received.

// A mechanism of 100 J loses 10 J/s in a damper and 20 J/s to grains; 1 J/s of that is lost in the interface.
History run(bool grains) {
  History h;
  const auto add = [&](const char* name, const std::vector<double>& values) { add_column(h, name, "J", values); };
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
  if (grains) add("coupling.energy_error", {0, 1, 2});
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

// 6 J come with grains in the middle, and 1 J leaves with others: neither is dissipated.
TEST(EnergyLedger, EnergyThatGrainsBringIsALineOfItsOwn) {
  History h = run(true);
  for (const auto& [name, values] : std::map<std::string, std::vector<double>>{{"coupling.grains_inserted", {0, 6, 6}},
                                                                               {"coupling.grains_left", {0, 0, -1}},
                                                                               {"coupling.grains_changed", {0, 0, 0}}})
    add_column(h, name, "J", values);
  const History ledger = energy_ledger(h, {{0, 1, 2}, {3, 13, 16}, {50, 48, 46}});
  EXPECT_DOUBLE_EQ(ledger.column("grains.inserted")[2], 6.0);
  EXPECT_DOUBLE_EQ(ledger.column("grains.left")[2], -1.0);
  EXPECT_DOUBLE_EQ(ledger.column("grains.dissipated")[1], 20.0 - 1.0 - 10.0 + 2.0 + 6.0);
  EXPECT_DOUBLE_EQ(ledger.column("grains.dissipated")[2], 40.0 - 2.0 - 13.0 + 4.0 + 5.0);
}

TEST(EnergyLedger, AMechanismThatDoesNotCloseIsSeen) {
  History h = run(true);
  for (const char* name : {"energy.kinetic", "energy.total"}) h.columns[h.find(name)][2] += 0.9;
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
  std::string write(const std::string& text) const { return TemporaryFolder::write("grains_energy.txt", text); }
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
  EXPECT_TRUE(test::names(test::error_of([&] { read_grain_energies(path); }), {"grains_energy.txt:2:"}));
}

const History kHistory{{"a", "b", "c"}, {"m", "m", "m"}, {{3.0, 0.0}, {4.0, -1.0}, {12.0, 0.0}}};

TEST(Formula, SumsAndNorms) {
  const Formula sum{{{1.0, "a"}, {-2.0, "b"}}, 5.0, 0.5};
  EXPECT_EQ(sum.values(kHistory), (std::vector<double>{0.0, 3.5}));
  EXPECT_EQ(sum.gnuplot(), "(0.5*(5+column('a')-2*column('b')))");
  const Formula norm{{{1.0, "a"}, {1.0, "b"}, {1.0, "c"}}, 0.0, 2.0, true};
  EXPECT_EQ(norm.values(kHistory), (std::vector<double>{26.0, 2.0}));
  EXPECT_EQ(norm.gnuplot(), "(2*sqrt(column('a')**2+column('b')**2+column('c')**2))");
}

// Figures of a history and the scripts that draw them.

History plotted_history() {
  History h;
  h.names = {"time",           "cabin.z",        "cabin.vz",   "cabin.az",       "pad.contact.fx",
             "pad.contact.fy", "pad.contact.fz", "leg.stroke", "energy.kinetic", "energy.strain"};
  h.units.assign(h.names.size(), "-");
  for (std::size_t i = 0; i < h.names.size(); ++i) h.columns.push_back({i == 9 ? 0.0 : 1.0, i == 9 ? 0.0 : 2.0});
  return h;
}

TEST(Figures, ShowWhatTheHistoryHoldsAndLeaveOutTheRest) {
  std::vector<std::string> names;
  for (const Figure& figure : standard_figures(plotted_history(), "")) {
    names.push_back(figure.name);
    if (figure.name == "energy") {
      EXPECT_EQ(figure.curves.size(), 1u) << "the strain energy is always zero";
    }
    if (figure.name == "descent") {
      EXPECT_EQ(figure.curves[0].formula.values(plotted_history()),
                (std::vector<double>{0.0, -1.0}));  // z is 1, then 2
    }
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"acceleration", "velocity", "descent", "energy", "strokes", "contact_forces"}));
}

// The work of contacts on the mechanism is negative where it loses energy to grains.
TEST(Figures, ShowTheEnergyThatGoesToTheGrains) {
  History h = plotted_history();
  for (const auto& [name, end] : {std::pair("work.contact", -3000.0), std::pair("coupling.energy_error", 0.0)})
    add_column(h, name, "J", {0.0, end});
  std::vector<double> to_grains;  // [kJ]
  for (const Figure& figure : standard_figures(h, ""))
    for (const auto& curve : figure.curves)
      if (curve.title == "to the grains") to_grains = curve.formula.values(h);
  EXPECT_EQ(to_grains, (std::vector<double>{0.0, 3.0}));
}

// Small numbers are told in small units: no "0.00 kN".
TEST(Figures, ChooseUnitsBySize) {
  History h = plotted_history();
  for (std::vector<double>& column : h.columns)
    for (double& value : column) value *= 0.01;
  for (const Figure& figure : standard_figures(h, "")) {
    double largest = 0.0;
    for (const double value : figure.curves[0].formula.values(h)) largest = std::max(largest, std::abs(value));
    EXPECT_TRUE(largest == 0.0 || largest >= 0.001) << figure.name;
    if (figure.name == "contact_forces") {
      EXPECT_NE(figure.axis.find("[mN]"), std::string::npos) << figure.axis;
    }
    if (figure.name == "energy") {
      EXPECT_NE(figure.axis.find("[mJ]"), std::string::npos) << figure.axis;
    }
  }
}

TEST(Figures, MarkTouchdownPeaksAndLimits) {
  History h{{"time", "cabin.z", "cabin.vz", "cabin.az", "leg.stroke"}, {"s", "m", "m/s", "m/s2", "m"}, {}};
  h.columns = {{0.0, 0.1, 0.2, 0.3}, {1, 1, 1, 1}, {0, 0, 0, 0}, {-1.6, -1.6, 19.6133, 5}, {0, 0, 0.2, 0.1}};
  for (const std::string axis : {"x", "y", "z"})
    add_column(h, "pad.contact.f" + axis, "N",
               axis == "z" ? std::vector<double>{0, 0, 90, 50} : std::vector<double>(4, 0.0));
  const nlohmann::ordered_json summary = {
      {"scene",
       {{"requirements",
         {{{"name", "payload"}, {"value", "cabin.az.largest / g0"}, {"most", 3.0}},
          {{"name", "sum"}, {"value", "cabin.az.max + cabin.az.min"}, {"most", 1.0}}}},
        {"struts", {{{"name", "leg"}, {"stops", {{"min", nullptr}, {"max", 0.25}}}}}}}}};
  std::vector<Figure> figures = standard_figures(h, "cabin");
  mark_figures(h, summary, figures);
  for (const Figure& figure : figures) {
    ASSERT_EQ(figure.times.size(), 1u);
    EXPECT_EQ(figure.times[0].time, 0.2);  // the first row with a force
    if (figure.name == "acceleration") {
      ASSERT_EQ(figure.peaks.size(), 1u);
      EXPECT_NEAR(figure.peaks[0].value, 2.0, 1e-12);
      EXPECT_EQ(figure.peaks[0].time, 0.2);
      ASSERT_EQ(figure.limits.size(), 1u);  // 3 g; -3 g is far from the curve
      EXPECT_NEAR(figure.limits[0].value, 3.0, 1e-12);
      EXPECT_EQ(figure.limits[0].text, "payload");
    }
    if (figure.name == "strokes") {
      ASSERT_EQ(figure.limits.size(), 1u);
      EXPECT_NEAR(figure.limits[0].value, 0.25, 1e-12);
    }
  }
}

// The text of a peak does not cover the curves, by all samples of each curve and points between them: an early and a late peak, curves that
// end flat near it as struts do, a ripple, and a curve that fills the graph and leaves no place.
TEST(Figures, TextsOfPeaksMeetNoCurve) {
  constexpr int kRows = 1000;
  const auto falling = [](double t) {
    return -0.1 * std::min(1.0, t / 0.15) - 0.005 * std::exp(-std::pow((t - 0.18) / 0.02, 2));
  };
  const auto early = [](double t) { return 9.0 * std::exp(-t / 0.05) + 0.3 * std::sin(40.0 * t); };
  const auto late = [](double t) { return t * t * t; };
  const auto ripple = [](double t) { return std::exp(-3.0 * t) * std::cos(50.0 * t); };
  const auto full = [](double t) { return std::sin(900.0 * t); };
  using Shape = double (*)(double);
  for (const Shape shape : {Shape{falling}, Shape{early}, Shape{late}, Shape{ripple}, Shape{full}}) {
    History h{{"time", "a.force", "b.force"}, {"s", "N", "N"}, {{}, {}, {}}};
    for (int k = 0; k < kRows; ++k) {
      const double t = k / (kRows - 1.0);
      h.columns[0].push_back(t);
      h.columns[1].push_back(shape(t));
      h.columns[2].push_back(0.95 * shape(t));
    }
    std::vector<Figure> figures = standard_figures(h, "");
    ASSERT_EQ(figures.size(), 1u);
    mark_figures(h, nlohmann::ordered_json::object(), figures);
    const Mark& peak = figures[0].peaks.at(0);
    if (shape == Shape{full}) {
      EXPECT_FALSE(peak.text_at);
      continue;
    }
    ASSERT_TRUE(peak.text_at);
    double low = 0.0, high = 0.0;
    std::vector<std::vector<double>> curves;
    for (const Curve& curve : figures[0].curves) {
      curves.push_back(curve.formula.values(h));
      low = std::min(low, *std::min_element(curves.back().begin(), curves.back().end()));
      high = std::max(high, *std::max_element(curves.back().begin(), curves.back().end()));
    }
    const double across = 0.5 * text_width(peak.text.size()), up = 0.5 * kTextHeight * (high - low);
    EXPECT_GE(peak.text_at->first - across, -1e-9);
    EXPECT_LE(peak.text_at->first + across, 1.0 + 1e-9);
    for (const std::vector<double>& values : curves)
      for (std::size_t k = 0; k + 1 < values.size(); ++k)
        for (const double over : {0.0, 0.25, 0.5, 0.75}) {
          const double t = h.columns[0][k] + over / (kRows - 1.0), y = values[k] + over * (values[k + 1] - values[k]);
          EXPECT_FALSE(std::abs(t - peak.text_at->first) < across && std::abs(y - peak.text_at->second) < up) << t;
        }
  }
}

TEST(Figures, FourteenSeriesHaveColoursOfTheirOwnInEveryStyle) {
  for (const PlotStyle style : every<PlotStyle>()) {
    std::set<std::string> colours;
    for (int k = 0; k < kSeriesColours; ++k) colours.insert(series_colour(k, style));
    EXPECT_EQ(colours.size(), 14u);
  }
}

TEST(Figures, HaveNoMoreSeriesThanColours) {
  History h = plotted_history();
  for (const std::string strut : {"primary", "left", "right"})
    for (int leg = 1; leg <= 4; ++leg) h.names.push_back("leg_" + std::to_string(leg) + "_" + strut + ".force");
  h.units.assign(h.names.size(), "N");
  h.columns.resize(h.names.size(), {1.0, 2.0});
  std::vector<std::string> titles;
  for (const Figure& figure : standard_figures(h, "")) {
    EXPECT_LE(figure.curves.size(), static_cast<std::size_t>(kSeriesColours)) << figure.name;
    if (figure.name.rfind("strut_forces", 0) == 0) titles.push_back(figure.name + " " + figure.title.substr(34));
  }
  EXPECT_EQ(titles, (std::vector<std::string>{"strut_forces : leg_*_primary", "strut_forces_2 : leg_*_left",
                                              "strut_forces_3 : leg_*_right"}));
}

class PlotScripts : public ::testing::Test, protected TemporaryFolder {};

TEST_F(PlotScripts, DrawWithGnuplotAsPngAndSvg) {
  const History history = plotted_history();
  HistoryWriter writer(file("history.csv"), history.names, history.units);
  for (std::size_t row : {0u, 1u}) {
    std::vector<double> values;
    for (const auto& column : history.columns) values.push_back(column[row]);
    writer.write(values);
  }
  writer.flush();
  const std::vector<std::string> scripts =
      write_plot_scripts(file("plots"), standard_figures(history, "cabin"), "A \"lander\"");
  std::string command = "cd '" + file("plots") + "' && gnuplot";
  for (const std::string& script : scripts) command += " " + script;
  ASSERT_EQ(std::system((command + " 2>gnuplot.log").c_str()), 0) << text("plots/gnuplot.log");
  for (std::string script : scripts) {
    for (const char* ending : {".png", ".svg"}) {
      const auto picture = folder_ / "plots" / std::filesystem::path(script).replace_extension(ending);
      EXPECT_GT(std::filesystem::file_size(picture), 1000u) << picture;
    }
  }
}

}  // namespace
}  // namespace footfall
