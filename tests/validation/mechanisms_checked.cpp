// Prints docs/mechanisms_checked.md: mechanisms with known answers, and 300 random ones, over tolerances.
//   mechanisms_checked                 the whole page
//   mechanisms_checked --short         one tolerance, no long runs: what the tests run
//   mechanisms_checked --sections      how many sections there are
//   mechanisms_checked --section K     section 0, 1, ... alone; a last line "@..." is its row of the table at the end
//   mechanisms_checked --table         the head of that table
// Ends with 1 when an error is larger than what the tests hold it to.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>

#include "coupler/base/errors.h"
#include "tests/validation/checked_case.h"
#include "tests/physics/motion_of.h"
#include "tests/validation/random_mechanism.h"

namespace footfall::test {
namespace {

const char* const kIntegrators[] = {"one_step", "ida"};
constexpr double kJudged = 1e-6;  // the tolerance at which the goals are asked for: that of a scene

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Verdict {
  bool reached = false, held = false;
  std::string figure;  // error over tolerance, or what the run said
  double energy = 0.0;
  std::string told;
};

// One line of the table of a case.
Verdict print_run(const CheckedCase& mechanism, const std::string& integrator, double rtol) {
  const double start = processor_time();
  char text[64];
  Verdict verdict;
  try {
    const Outcome out = mechanism.run(integrator, rtol);
    const double seconds = processor_time() - start;
    std::snprintf(text, sizeof text, "%.2g", out.error / rtol);
    const bool energy = out.energy < mechanism.energy;
    const double given = integrator == "ida" ? mechanism.held_ida : mechanism.held_one_step;
    const double held = given > 0.0 ? given : mechanism.goal;
    verdict = {out.error < mechanism.goal * rtol && energy, std::isinf(held) || (out.error < held * rtol && energy),
               text, out.energy, out.told};
    std::printf("| %s | %g | %.1e | %s | %.1e | %ld | %.3f |\n", integrator.c_str(), rtol, out.error, text, out.energy,
                out.steps, seconds);
  } catch (const std::exception& error) {
    verdict.figure = "stops";
    verdict.held = std::isinf(integrator == "ida" ? mechanism.held_ida : mechanism.held_one_step);
    std::printf("| %s | %g | %s | | | | |\n", integrator.c_str(), rtol, error.what());
  }
  return verdict;
}

struct Summary {
  std::string rows;
  bool missed = false;  // what the tests hold
};

void print_case(const CheckedCase& mechanism, bool brief, Summary& summary) {
  std::printf("\n## %s\n\n%s\n\nCompared: %s\nReference: %s\n\n", mechanism.name.c_str(), mechanism.what.c_str(),
              mechanism.compared.c_str(), mechanism.source.c_str());
  std::printf(
      "| integrator | rtol | error | error / rtol | energy error [J] | steps | processor time [s] "
      "|\n|---|---|---|---|---|---|---|\n");
  try {
    mechanism.run("ida", 1e-3);      // a reference of its own is made here, outside the times
  } catch (const std::exception&) {  // is told by the runs below
  }
  Verdict judged[2];
  for (int k = 0; k < 2; ++k)
    for (const double rtol : mechanism.tolerances) {
      if (brief && rtol != kJudged) continue;
      const Verdict verdict = print_run(mechanism, kIntegrators[k], rtol);
      if (rtol == kJudged) judged[k] = verdict;
    }
  for (int k = 0; k < 2; ++k)
    if (!judged[k].told.empty()) std::printf("\n%s at %g: %s", kIntegrators[k], kJudged, judged[k].told.c_str());
  if (!judged[0].told.empty()) std::printf("\n");
  char line[256];
  std::snprintf(line, sizeof line, "| %s | %g | %s | %s | %g | %.1e | %.1e | %s, %s |\n", mechanism.name.c_str(),
                mechanism.goal, judged[0].figure.c_str(), judged[1].figure.c_str(), mechanism.energy, judged[0].energy,
                judged[1].energy, judged[0].reached ? "yes" : "**no**", judged[1].reached ? "yes" : "**no**");
  summary.rows += line;
  if (!mechanism.why.empty()) std::printf("\n%s\n", mechanism.why.c_str());
  summary.missed = summary.missed || !judged[0].held || !judged[1].held;
}

// Error over tolerance of the random mechanisms, in ascending order.
void print_random(bool brief, Summary& summary) {
  const unsigned seeds = brief ? 2 : 25;
  std::printf(
      "\n## %u random mechanisms\n\nTwelve families of %u, each from its seed: trees and loops with every kind of "
      "joint, springs, gas springs, MR dampers, stops, honeycombs, tables and bushings; four-bars and "
      "parallelograms; Bennett, Bricard and Sarrus; driven loops; loops with motors, with brakes, friction and limits, "
      "with "
      "gears, and on rolling wheels. They move for 0.5 s, or until they come near a "
      "position in which their conditions lose rank.\n\nCompared: all bodies at the end, relative to the size of the "
      "motion.\nReference: own run of the one-step method at rtol 1e-11.\n\n",
      12 * seeds, seeds);
  std::printf(
      "| integrator | rtol | error / rtol, median | nine of ten below | worst of the smooth ones | worst with kinks "
      "| ended with a message | steps | processor time [s] |\n|---|---|---|---|---|---|---|---|---|\n");
  struct Subject {
    Plan plan;
    Motion end;
    Size size;
  };
  std::vector<Subject> subjects;
  for (const Family family : kFamilies)
    for (unsigned seed = 1; seed <= seeds; ++seed) {
      Subject subject{random_mechanism(family, seed), {}, {}};
      const Model model = build(subject.plan);
      Run run(model, "one_step", as_a_scene(1e-11));
      const Motion start = motion_of(run);
      run.to(subject.plan.regular_until);
      subject.end = motion_of(run);
      subject.size = size_of(start, subject.end);
      subjects.push_back(subject);
    }
  for (const char* integrator : kIntegrators)
    for (const double rtol : {1e-4, 1e-6, 1e-8, 1e-10}) {
      if (brief && rtol != kJudged) continue;
      std::vector<double> ratio;
      double smooth = 0.0, rough = 0.0;
      long steps = 0, ended = 0;
      const double start = processor_time();
      for (const Subject& subject : subjects) {
        const Model model = build(subject.plan);
        Run run(model, integrator, as_a_scene(rtol));
        try {
          run.to(subject.plan.regular_until);
        } catch (const NumericalError&) {
          ++ended;
          continue;
        }
        steps += run.integrator->statistics().steps;
        ratio.push_back(difference(motion_of(run), subject.end, subject.size) / rtol);
        double& worst = subject.plan.rough ? rough : smooth;
        worst = std::max(worst, ratio.back());
      }
      const double seconds = processor_time() - start;
      std::sort(ratio.begin(), ratio.end());
      std::printf("| %s | %g | %.2g | %.2g | %.2g | %.2g | %ld | %ld | %.2f |\n", integrator, rtol,
                  ratio[ratio.size() / 2], ratio[ratio.size() * 9 / 10], smooth, rough, ended, steps, seconds);
      if (rtol == kJudged && std::string(integrator) == "one_step") {
        char line[256];
        std::snprintf(line, sizeof line, "| %u random mechanisms, worst smooth one | 100 | %.2g | | | | | %s |\n",
                      12 * seeds, smooth, smooth < 100.0 ? "yes" : "**no**");
        summary.rows += line;
        summary.missed = summary.missed || !(smooth < 100.0);
      }
    }
}

void print_head() {
  std::printf(
      "# Mechanisms with known answers\n\nMade by `docs/mechanisms_checked.sh`, which runs what stands here and "
      "takes some minutes; a short form runs in the tests. Tolerances are as in a scene: `rtol` as given, `atol` a "
      "hundredth of it; `max_step` does not limit. `one_step` is the default method without grains (`solver.method = "
      "\"auto\"`, fifth order). Times are processor times on one core of a shared machine: compare them within a "
      "table.\n\nWhat to take from it: the error at the end is a few times `rtol` on most mechanisms, and a tenth of "
      "`rtol` costs a third to a half more steps. Stops and dry friction have kinks, at which a step errs by more than "
      "it "
      "estimates: `one_step` may end some hundred tolerances off there, `ida` some ten, with more steps. Where the "
      "table at the end says **no**, look at "
      "`energy_balance_relative` in the summary of a run, and try the other integrator.\n");
}

void print_table() {
  std::printf(
      "\n## What is reached at rtol 1e-6\n\nGoals: error over tolerance, and error of the energy. Under `reached`: "
      "one_step, ida.\n\n| mechanism | goal | one_step | ida | goal [J] | one_step [J] | ida [J] | reached "
      "|\n|---|---|---|---|---|---|---|---|\n");
}

// The cases, and the random mechanisms behind them.
void print_section(std::size_t k, bool brief, Summary& summary) {
  const std::vector<CheckedCase> cases = checked_cases();
  if (k >= cases.size()) {
    print_random(brief, summary);
  } else if (!brief || cases[k].in_short) {
    print_case(cases[k], brief, summary);
  }
}

int print_page(bool brief) {
  print_head();
  Summary summary;
  for (std::size_t k = 0; k <= checked_cases().size(); ++k) print_section(k, brief, summary);
  print_table();
  std::printf("%s", summary.rows.c_str());
  return summary.missed ? 1 : 0;
}

int section(std::size_t k) {
  if (k == 0) print_head();
  Summary summary;
  print_section(k, false, summary);
  std::printf("@%s", summary.rows.c_str());
  return summary.missed ? 1 : 0;
}

}  // namespace
}  // namespace footfall::test

int main(int argc, char** argv) {
  using namespace footfall::test;
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "--section" && argc > 2) return section(std::stoul(argv[2]));
  if (what == "--sections") return std::printf("%zu\n", checked_cases().size() + 1) > 0 ? 0 : 1;
  if (what != "--table") return print_page(what == "--short");
  print_table();
  return 0;
}
