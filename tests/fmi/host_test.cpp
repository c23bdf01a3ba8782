// The host of FMUs, asked as a run asks it: closed forms of the FMUs of models.cpp, their types, states and failures.

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "mbd_solver/base/fmu_description.h"
#include "mbd_solver/fmi/fmu_file.h"
#include "tests/fmi/asked_fmu.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kFmus = TEST_FMUS "/";

struct Asked : test::AskedFmu {
  Asked(const std::string& fmu, const std::vector<std::string>& words, double limit = 60.0)
      : AskedFmu(kFmus + fmu + ".fmu", words, limit) {}
};

struct HostFolder : TemporaryFolder {
  using TemporaryFolder::folder_;
  using TemporaryFolder::write;
};

std::string failure(const std::string& fmu, const std::vector<std::string>& words, double limit = 60.0) {
  try {
    Asked asked(fmu, words, limit);
    asked.ask('I', {0.0});
    for (int k = 0; k < 5; ++k) asked.ask('S', {0.01 * k, 0.01 * (k + 1)});
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing";
}

// m = 1 kg, k = 1e4 N/m, d = 1 N s/m from 10 mm at rest: the FMU is exact, so the rest is round-off.
TEST(FmuHost, OscillatorMovesByItsClosedForm) {
  for (const char* fmu : {"oscillator_3", "oscillator_2"}) {
    Asked asked(fmu, {"input", "F", "output", "x", "output", "v"});
    EXPECT_THAT(asked.ask('I', {0.0, 0.0}), ElementsAre(0.01, 0.0));
    const double h = 1e-3, w = std::sqrt(1e4 - 0.25);
    for (int k = 0; k < 200; ++k) {
      const double t = h * (k + 1);
      const double x = 0.01 * std::exp(-0.5 * t) * (std::cos(w * t) + 0.5 / w * std::sin(w * t));
      EXPECT_NEAR(asked.ask('S', {h * k, t, 0.0})[0], x, 1e-14) << fmu;
    }
  }
}

TEST(FmuHost, StatesAreKeptBetweenProcesses) {
  for (const char* fmu : {"oscillator_3", "oscillator_2"}) {
    const std::vector<std::string> words = {"input", "F", "output", "x", "start", "k", "5000"};
    Asked first(fmu, words);
    first.ask('I', {0.0, 3.0});
    for (int k = 0; k < 7; ++k) first.ask('S', {0.01 * k, 0.01 * (k + 1), 3.0});
    const std::string state = first.raw('G', {});
    ASSERT_EQ(state[0], 'B');
    Asked second(fmu, words);
    second.ask('R', {0.07, 3.0}, state.substr(1));
    for (int k = 7; k < 14; ++k) {
      const std::vector<double> question = {0.01 * k, 0.01 * (k + 1), 2.0 + k};
      EXPECT_EQ(second.ask('S', question), first.ask('S', question)) << fmu;
    }
  }
}

TEST(FmuHost, EveryTypeOfNumberIsSetAndRead) {
  std::vector<std::string> words;
  const std::vector<std::string> types = {"Float64", "Float32", "Int8", "UInt16", "Int32", "Boolean"};
  for (const std::string& type : types) words.insert(words.end(), {"input", type + "_in", "output", type + "_out"});
  words.insert(words.end(), {"input", "array_in[2]", "output", "array_out[1]", "output", "array_out[2]", "output",
                             "array_out[3]", "output", "resource", "output", "length", "start", "text", "five!"});
  Asked asked("types_3", words);
  EXPECT_THAT(asked.ask('I', {0.0, 1.1, 0.25, -128, 65535, -7.4, 0.2, 80}),
              ElementsAre(1.1, 0.25, -128, 65535, -7, 1, 7, 80, 9, 42.5, 5));
  EXPECT_THAT(asked.raw('S', {0.0, 1.0, 0, 0, 128, 0, 0, 0, 0}), HasSubstr("Int8_in"));
  Asked two("types_2", {"input", "Int32_in", "input", "Boolean_in", "output", "Int32_out", "output", "Boolean_out",
                        "output", "resource"});
  EXPECT_THAT(two.ask('I', {0.0, 12.6, 3.0}), ElementsAre(13, 1, 42.5));
}

TEST(FmuHost, FailuresAreTold) {
  for (const std::string fmu : {"broken_3", "broken_2"}) {
    const auto fails = [&](int fault, double limit = 60.0) {
      return failure(fmu, {"output", "y", "start", "fault", std::to_string(fault)}, limit);
    };
    EXPECT_EQ(fails(0), "nothing");
    EXPECT_THAT(fails(1), HasSubstr("Error; its message: a first word"));
    EXPECT_THAT(fails(2), HasSubstr("discarded the step from 0.01 s to 0.02 s"));
    EXPECT_THAT(fails(4), HasSubstr("signal 11"));
    EXPECT_THAT(fails(5, 0.5), HasSubstr("time limit"));
    EXPECT_THAT(fails(6), HasSubstr("requests the end"));
    EXPECT_THAT(fails(8), HasSubstr("signal 6"));
    EXPECT_THAT(fails(9), HasSubstr("exit code 3"));
  }
  EXPECT_THAT(failure("broken_3", {"output", "y", "start", "fault", "7"}),
              HasSubstr("fmi3ExitInitializationMode returned fmi3Error"));
  EXPECT_THAT(failure("broken_3", {"output", "nothing"}), HasSubstr("no variable \"nothing\""));
}

// Not even after a crash or an FMU that hangs.
TEST(FmuHost, LeavesNoFolder) {
  const HostFolder folder;
  setenv("TMPDIR", folder.folder_.c_str(), 1);
  for (const char* fault : {"0", "4", "5"}) failure("broken_3", {"output", "y", "start", "fault", fault}, 0.5);
  unsetenv("TMPDIR");
  EXPECT_TRUE(std::filesystem::is_empty(folder.folder_));
}

std::string described(const std::string& xml) {
  try {
    return text_of(parse_model_description(xml));
  } catch (const FmuProblem& problem) {
    return problem.kind;
  }
}

TEST(ModelDescription, ProblemsHaveTheirKind) {
  EXPECT_EQ(described("<fmi"), "file");
  EXPECT_EQ(described("<other/>"), "file");
  EXPECT_EQ(described("<fmiModelDescription fmiVersion=\"1.0\"/>"), "version");
  EXPECT_THAT(
      described("<fmiModelDescription fmiVersion=\"3.0\"><ModelExchange modelIdentifier=\"m\"/></fmiModelDescription>"),
      HasSubstr("tool the FMU is not for co-simulation"));
  EXPECT_THAT(
      described(
          "<fmiModelDescription fmiVersion=\"2.0\"><CoSimulation modelIdentifier=\"m\" needsExecutionTool=\"true\"/>"
          "</fmiModelDescription>"),
      HasSubstr("tool the FMU needs"));
  EXPECT_EQ(
      described(
          "<fmiModelDescription fmiVersion=\"3.0\"><CoSimulation modelIdentifier=\"../m\"/></fmiModelDescription>"),
      "file");
}

TEST(ModelDescription, VariablesAreNamedOnceAndHaveNumbers) {
  const auto with = [](const std::string& variables) {
    return described("<fmiModelDescription fmiVersion='3.0'><CoSimulation modelIdentifier='m'/><ModelVariables>" +
                     variables + "</ModelVariables></fmiModelDescription>");
  };
  const std::string x = "<Float64 name='x' valueReference='1' start='1 true NaN'/>";
  EXPECT_THAT(with(x), HasSubstr("x"));
  EXPECT_EQ(with(x + x), "file");
  EXPECT_EQ(with("<Float64 valueReference='1'/>"), "file");
  for (const char* reference : {"", "one", "-1", "1.5", "4294967296", "40000000000"})
    EXPECT_EQ(with(std::string("<Float64 name='x' valueReference='") + reference + "'/>"), "file") << reference;
  EXPECT_EQ(with("<Float64 name='x' valueReference='1' start='soon'/>"), "file");
}

TEST(ModelDescription, IsReadBackFromItsLines) {
  for (const char* name : {"types_3", "types_2", "oscillator_3"}) {
    const FmuDescription fmu = read_fmu(kFmus + name + ".fmu");
    EXPECT_EQ(text_of(fmu_description_of(text_of(fmu))), text_of(fmu));
    EXPECT_GT(fmu.variables.size(), 5u);
  }
}

TEST(ModelDescription, OtherFilesAreNoFmu) {
  const HostFolder folder;
  const auto kind_of = [&](const std::string& bytes) {
    try {
      read_fmu(folder.write("file.fmu", bytes));
    } catch (const FmuProblem& problem) {
      return problem.kind;
    }
    return std::string("fmu");
  };
  EXPECT_EQ(kind_of("no archive"), "file");
  EXPECT_EQ(kind_of(std::string("PK\5\6") + std::string(18, '\0')), "file") << "an empty archive";
  std::ifstream whole(kFmus + "types_3.fmu", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
  EXPECT_EQ(kind_of(bytes), "fmu");
  EXPECT_EQ(kind_of(bytes.substr(0, bytes.size() / 2)), "file");
  // A library that is none, and an entry that would lie outside the folder: told before anything runs.
  const std::string text =
      "<fmiModelDescription fmiVersion='3.0'><CoSimulation modelIdentifier='m'/></fmiModelDescription>";
  const auto archive = [&](const std::string& library, const std::string& more) {
    const std::string file = (folder.folder_ / "made.fmu").string();
    write_fmu(file, {{"modelDescription.xml", "", text}, {"binaries/x86_64-linux/m.so", "", library}, {more, "", "x"}});
    try {
      return read_fmu(file).obstacle;
    } catch (const FmuProblem& problem) {
      return problem.kind;
    }
  };
#if defined(__x86_64__)
  EXPECT_EQ(archive("\177ELF and more", "resources/a.txt"), "");
  EXPECT_EQ(archive("text", "resources/a.txt"), "file");
#endif
  EXPECT_EQ(archive("\177ELF", "../a.txt"), "file");
}

// [1,1] [1,2] [2,1] [2,2] of an array of two by two whose size is a parameter.
// A bomb of 65 kB; before, 256 MB were unpacked, and parsed into 4 GB.
TEST(ModelDescription, IsUnpackedTo64MegabytesAtMost) {
  const HostFolder folder;
  const std::string file = (folder.folder_ / "bomb.fmu").string();
  write_fmu(file, {{"modelDescription.xml", "", std::string((64 << 20) + 1, ' ')}});
  EXPECT_LT(std::filesystem::file_size(file), 100000u);
  try {
    read_fmu(file);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const FmuProblem& problem) {
    EXPECT_EQ(problem.kind, "limit");
    EXPECT_THAT(problem.what(), HasSubstr("64 MB of modelDescription.xml"));
  }
}

// Parsed, an element of four bytes takes sixty.
TEST(ModelDescription, HasTwoMillionPartsAtMostAndArraysOfAMillion) {
  std::string parts = "<fmiModelDescription fmiVersion='3.0'>";
  for (int k = 0; k < 2000000; ++k) parts += "<a/>";
  EXPECT_EQ(described(parts + "</fmiModelDescription>"), "limit");
  std::string values;
  for (int k = 0; k <= 1 << 20; ++k) values += "0 ";
  EXPECT_EQ(described("<fmiModelDescription fmiVersion='3.0'><CoSimulation modelIdentifier='m'/><ModelVariables>"
                      "<Float64 name='x' valueReference='1' start='" +
                      values + "'/></ModelVariables></fmiModelDescription>"),
            "limit");
}

TEST(ModelDescription, ElementsAreCountedRowByRow) {
  FmuDescription fmu;
  fmu.variables.push_back({"n", "UInt64", "structuralParameter", "fixed", "", "3", 7, {}});
  FmuVariable A{"A", "Float64", "parameter", "fixed", "", "0", 8, {}};
  A.dimensions = {{0, 7, false}, {2, 0, true}};
  fmu.variables.push_back(A);
  EXPECT_EQ(find_element(fmu, "A[2,1]", {}).place, 2);
  EXPECT_EQ(find_element(fmu, "A[3,2]", {}).place, 5);
  EXPECT_NE(find_element(fmu, "A[3,2]", {{"n", "2"}}).problem, "");
  EXPECT_NE(find_element(fmu, "A", {}).problem, "");
  EXPECT_NE(find_element(fmu, "n[1]", {}).problem, "");
  EXPECT_EQ(find_element(fmu, "B", {}).variable, nullptr);
}

}  // namespace
}  // namespace footfall
