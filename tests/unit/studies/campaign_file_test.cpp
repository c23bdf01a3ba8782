// What a sweep file with drawn runs must hold.
#include <gtest/gtest.h>

#include "tests/unit/studies/text_file.h"

namespace footfall {
namespace {

constexpr const char* kGood = R"(scene = "scene.toml"
runs = 10
[[parameters]]
name = "v"
settings = ["x={value}"]
distribution = "normal"
mean = 1
deviation = 2
[[figures]]
name = "peak acceleration [g]"
key = "peak_acceleration_g"
[[outcomes]]
name = "hard"
when = "peak_acceleration > 5"
)";

std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), now);
}

TEST(ReadCampaign, AcceptsWhatIsRight) { EXPECT_EQ(test::sweep_complaint(kGood), ""); }

struct Fault {
  const char *old, *now, *code;
};

class ReadCampaignFault : public ::testing::TestWithParam<Fault> {};

TEST_P(ReadCampaignFault, IsNamed) {
  const Fault& f = GetParam();
  const std::string said = test::sweep_complaint(with(kGood, f.old, f.now));
  EXPECT_NE(said.find(f.code), std::string::npos) << f.now << "\n" << said;
}

INSTANTIATE_TEST_SUITE_P(
    Of, ReadCampaignFault,
    ::testing::Values(
        Fault{"runs = 10", "", "E0106"}, Fault{"runs = 10", "runs = -1", "E0105"},
        Fault{"runs = 10", "runs = 200000", "E0587"}, Fault{"runs = 10", "runs = 10\ndesign = \"grid\"", "E0115"},
        Fault{"runs = 10", "runs = 10\nuntil_width = 2", "E0105"}, Fault{"runs = 10", "runs = 10\nkeep = -1", "E0105"},
        Fault{"runs = 10", "runs = 10\nminimise = \"peak acceleration [g]\"", "E0140"},
        Fault{"distribution = \"normal\"", "distribution = \"gauss\"", "E0115"},
        Fault{"distribution = \"normal\"\nmean = 1\ndeviation = 2", "values = [1, 2]", "E0142"},
        Fault{"mean = 1", "", "E0106"}, Fault{"deviation = 2", "deviation = 0", "E0105"},
        Fault{"deviation = 2", "deviation = nan", "E010"}, Fault{"deviation = 2", "deviation = 2\nlikely = 1", "E0141"},
        Fault{"deviation = 2", "deviation = 2\nleast = 3\nmost = 2", "E0119"},
        Fault{"deviation = 2", "deviation = 2\nleast = 100", "E0105"},
        Fault{"deviation = 2", "deviation = 2\nvalues = [1, 2]", "E0141"},
        Fault{"deviation = 2", "deviation = 2\nensemble = true", "E0140"},
        Fault{"distribution = \"normal\"\nmean = 1\ndeviation = 2", "distribution = \"uniform\"\nleast = 2\nmost = 1",
              "E0119"},
        Fault{"distribution = \"normal\"\nmean = 1\ndeviation = 2",
              "distribution = \"triangular\"\nleast = 0\nmost = 1\nlikely = 2", "E0105"},
        Fault{"distribution = \"normal\"\nmean = 1\ndeviation = 2", "distribution = \"weibull\"\nscale = -1\nshape = 2",
              "E0105"},
        Fault{"distribution = \"normal\"\nmean = 1\ndeviation = 2",
              "distribution = \"discrete\"\nvalues = [1, 2]\nweights = [1]", "E0117"},
        Fault{"distribution = \"normal\"\nmean = 1\ndeviation = 2",
              "distribution = \"discrete\"\nvalues = [1, 2]\nweights = [0, 0]", "E0105"},
        Fault{"distribution = \"normal\"\nmean = 1\ndeviation = 2", "distribution = \"measured\"", "E0106"},
        Fault{"distribution = \"normal\"\nmean = 1\ndeviation = 2",
              "distribution = \"measured\"\nmeasured = \"none.csv\"", "E0250"},
        Fault{"name = \"v\"", "name = \"v x\"", "E0116"}, Fault{"name = \"v\"", "name = \"seed\"", "E0121"},
        Fault{"settings = [\"x={value}\"]", "", "E0106"},
        Fault{"settings = [\"x={value}\"]", "settings = [\"x={= w}\"]", "E0585"},
        Fault{"settings = [\"x={value}\"]", "settings = [\"x={= v\"]", "E0585"},
        Fault{"when = \"peak_acceleration > 5\"", "when = \"peak > 5\"", "E0581"},
        Fault{"when = \"peak_acceleration > 5\"", "when = \"peak_acceleration > (5\"", "E0"},
        Fault{"when = \"peak_acceleration > 5\"", "", "E0106"},
        Fault{"[[outcomes]]", "[[outcomes]]\nname = \"hard\"\nwhen = \"v > 1\"\n[[outcomes]]", "E0120"},
        Fault{"[[outcomes]]", "[[correlations]]\nbetween = [\"v\", \"w\"]\nrank = 0.5\n[[outcomes]]", "E0582"},
        Fault{"[[outcomes]]", "[[correlations]]\nbetween = [\"v\"]\nrank = 1\n[[outcomes]]", "E0117"},
        Fault{"[[outcomes]]", "[[envelopes]]\nname = \"e\"\nx = \"w\"\n[[outcomes]]", "E0582"},
        Fault{"[[outcomes]]", "[[envelopes]]\nname = \"e\"\nx = \"v\"\noutcome = \"soft\"\n[[outcomes]]", "E0581"},
        Fault{"[[outcomes]]", "[[envelopes]]\nname = \"e\"\nx = \"v\"\nlevel = 1\n[[outcomes]]", "E0105"},
        Fault{"[[outcomes]]", "[check]\nruns = 4\n[[outcomes]]", "E0106"},
        Fault{"[[outcomes]]", "[check]\nsettings = [\"a=1\"]\nruns = 1\n[[outcomes]]", "E0105"},
        Fault{"name = \"peak acceleration [g]\"", "name = \"[g]\"", "E0116"}));

TEST(ExactText, ReadsBackTheSameNumberInTheFewestDigits) {
  for (const double x : {0.1, 1.0 / 3.0, -2.0 / 3.0, 1e-300, 5e-324, 1.7976931348623157e308, 0.1 + 0.2})
    EXPECT_EQ(std::strtod(exact_text(x).c_str(), nullptr), x);
  EXPECT_EQ(exact_text(0.1), "0.1");
  EXPECT_EQ(exact_text(2147483647.0), "2147483647");
  EXPECT_EQ(exact_text(0.1 + 0.2), "0.30000000000000004");
}

}  // namespace
}  // namespace footfall
