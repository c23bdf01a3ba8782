#include "mbd_solver/cli/experiments/accuracy_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"
#include "mbd_solver/cli/experiments/stability_map.h"
#include "mbd_solver/cli/experiments/study.h"
#include "mbd_solver/cli/experiments/study_error.h"
#include "mbd_solver/cli/experiments/study_page.h"
#include "mbd_solver/cli/experiments/study_plot.h"
#include "mbd_solver/cli/experiments/study_run.h"
#include "mbd_solver/cli/experiments/window_growth.h"
#include "mbd_solver/cli/launch/programs.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr double kGrowthMiss = 1e-2;  // of the growth per window: a motion of a few windows does not tell it better
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// All runs of one study, in order.
class StudyRunner {
 public:
  StudyRunner(const StudySpec& study, const std::string& out, const AccuracyArguments& arguments)
      : study_(study), out_(out), short_(arguments.short_form), resume_(arguments.resume) {
    members_ = short_ && !study.ensemble_short.empty() ? study.ensemble_short : study.ensemble_values;
    if (members_.empty()) members_ = {""};
  }

  StudyTable run() {
    StudyTable table;
    table.title = study_.title;
    table.x_name = study_.x_name;
    table.members = static_cast<int>(members_.size());
    for (const MeasureSpec& measure : study_.measures) table.measures.push_back(measure.name);
    std::vector<StudyRun> references;
    if (study_.has_reference) references = reference_runs({}, "reference", table);
    for (const CurveSpec& curve : study_.curves) {
      table.curves.push_back(curve.name);
      table.defaults.push_back(curve.default_value);
      const std::vector<StudyRun> own =
          curve.reference.empty() ? references : reference_runs(curve.reference, curve.name, table);
      for (const std::string& value : short_ ? curve.short_values : curve.values) {
        const std::vector<StudyRun> runs =
            all(curve.scene, settings_of(curve, value), curve.name + "_" + value, study_.repeats);
        table.points.push_back(point(curve.name, value, curve.scale, runs, own));
        table.grains = table.grains || table.points.back().dem > 0.0;
        say(table.points.back());
      }
    }
    return table;
  }

 private:
  // `more`: what the reference of one curve has of its own.
  std::vector<StudyRun> reference_runs(const std::vector<std::string>& more, const std::string& name,
                                       StudyTable& table) {
    std::vector<std::string> settings = study_.reference;
    settings.insert(settings.end(), more.begin(), more.end());
    const std::vector<StudyRun> runs =
        all(study_.reference_scene, settings, more.empty() ? name : name + "_reference", 1);
    for (const StudyRun& run : runs)
      if (run.code != 0)
        throw NumericalError("the reference run ended with code " + std::to_string(run.code) + ": " + run.message);
    table.references.push_back(point(name, "reference", 0.0, runs, runs));
    say(table.references.back());
    return runs;
  }

  // One run per member of the ensemble. Curves share runs with the same settings.
  std::vector<StudyRun> all(const std::string& scene, const std::vector<std::string>& settings, const std::string& name,
                            int repeats) {
    std::vector<StudyRun> runs;
    for (const std::string& member : members_) {
      StudyRunRequest request;
      request.scene = (fs::path(study_.folder) / (scene.empty() ? study_.scene : scene)).lexically_normal().string();
      std::string folder = name + (member.empty() ? "" : "_" + member);
      std::replace(folder.begin(), folder.end(), ' ', '_');  // LIGGGHTS splits paths at blanks
      request.out = (fs::path(out_) / folder).string();
      request.settings = study_.settings;
      if (short_)
        request.settings.insert(request.settings.end(), study_.short_settings.begin(), study_.short_settings.end());
      request.settings.insert(request.settings.end(), settings.begin(), settings.end());
      if (!member.empty())
        for (const std::string& setting : filled(study_.ensemble_settings, member)) request.settings.push_back(setting);
      request.until = short_ && study_.short_until > 0.0 ? study_.short_until : study_.until;
      request.time_limit = study_.time_limit;
      request.repeats = repeats;
      request.resume = resume_;
      const std::string recipe = recipe_of(request);
      const auto found = recipe.empty() ? done_.end() : done_.find({recipe, repeats});
      runs.push_back(found == done_.end() ? run_once(request) : found->second);
      done_[{recipe, repeats}] = runs.back();
    }
    return runs;
  }

  StudyPoint point(const std::string& curve, const std::string& value, double scale, const std::vector<StudyRun>& runs,
                   const std::vector<StudyRun>& references) const {
    StudyPoint p;
    p.curve = curve;
    p.value = value;
    char* end = nullptr;
    const double x = std::strtod(value.c_str(), &end);
    p.x = *end == '\0' ? scale * x : 0.0;
    p.errors.assign(study_.measures.size(), kNone);
    if (members_.size() > 1) p.sampled.assign(study_.measures.size(), SampledFigure{kNone, kNone, kNone, kNone});
    for (const StudyRun& run : runs) {
      p.code = std::max(p.code, run.code);
      if (run.code != 0) {
        p.message = run.message;
        std::printf("%s %s: ended with code %d: %s\n", curve.c_str(), value.c_str(), run.code, run.message.c_str());
        return p;
      }
      const double share = 1.0 / static_cast<double>(runs.size());
      p.wall += share * run.wall;
      p.dem += share * run.dem;
      p.mbd += share * run.mbd;
      p.exchange += share * run.exchange;
      p.cpu += share * run.cpu;
      p.steps += share * run.summary.value("steps", 0.0);
      p.windows += share * run.summary.value("windows", 0.0);
    }
    const StudyRun none;
    for (std::size_t m = 0; m < study_.measures.size(); ++m) {
      const MeasureSpec& measure = study_.measures[m];
      if (members_.size() > 1 && measure.kind == MeasureKind::kFigure) {
        std::vector<double> mine, theirs;
        for (const StudyRun& run : runs) mine.push_back(figure_of(measure, run));
        for (const StudyRun& run : references) theirs.push_back(figure_of(measure, run));
        p.sampled[m] = sampled_figure(mine, theirs);
        p.errors[m] = p.sampled[m].error;
        continue;
      }
      double sum = 0.0;
      for (std::size_t k = 0; k < runs.size(); ++k)
        sum += error_of(measure, runs[k], references.empty() ? none : references[k]);
      p.errors[m] = sum / static_cast<double>(runs.size());
    }
    return p;
  }

  void say(const StudyPoint& p) const {
    std::printf("%-16s %-8s wall %8.3f s, CPU %8.3f s (grains %.3f, mechanism %.3f, exchange %.3f)", p.curve.c_str(),
                p.value.c_str(), p.wall, p.cpu, p.dem, p.mbd, p.exchange);
    for (std::size_t m = 0; m < p.errors.size(); ++m)
      std::printf("  %s %.3g", study_.measures[m].name.c_str(), p.errors[m]);
    std::printf("\n");
    std::fflush(stdout);
  }

  const StudySpec& study_;
  std::string out_;
  bool short_, resume_;
  std::vector<std::string> members_;
  std::map<std::pair<std::string, int>, StudyRun> done_;  // by recipe and repeats
};

// Says which expectations hold; true when all do.
bool meets(const StudySpec& study, const StudyTable& table) {
  bool all = true;
  for (const ExpectSpec& expect : study.expect) {
    const std::size_t m = static_cast<std::size_t>(
        std::find(table.measures.begin(), table.measures.end(), expect.measure) - table.measures.begin());
    const auto line = table.line(expect.curve, m, false);
    const auto report = [&](bool good, const char* what, double found, double least, double most) {
      all = all && good;
      std::printf("%-9s %s, %s: %s %.4g, expected %.4g to %.4g\n", good ? "ok" : "NOT SO", expect.curve.c_str(),
                  expect.measure.c_str(), what, found, least, most);
    };
    if (expect.least_order != 0.0 || expect.most_order != 0.0) {
      const double order = observed_order(line);
      report(order >= expect.least_order && order <= expect.most_order, "order", order, expect.least_order,
             expect.most_order);
    }
    if (expect.most_error > 0.0) {
      // Of the last value run: files name values from coarse to fine. An error of zero is no point of a logarithmic
      // line, but a good one.
      double error = kNone;
      for (const StudyPoint& point : table.points)
        if (point.curve == expect.curve) error = point.errors[m];
      report(error <= expect.most_error, "error", error, 0.0, expect.most_error);
    }
  }
  return all;
}

}  // namespace

int accuracy_command(const AccuracyArguments& arguments) {
  const StudySpec study = read_study(arguments.file);
  const std::string name = fs::path(arguments.file).stem().string();
  const std::string out =
      short_path(arguments.out.empty() ? (fs::path("runs") / "accuracy" / name).string() : arguments.out);
  make_folder(out);

  if (!study.omega_h.empty()) {
    const std::vector<GrowthPoint> points = growth_of_schemes(
        study.omega_h, study.substeps, study.scene.empty() ? "" : (fs::path(study.folder) / study.scene).string(), out);
    const std::string table = (fs::path(out) / (name + ".md")).string();
    write_growth(table, study.title, points, study.substeps);
    if (!arguments.table.empty()) write_growth(arguments.table, study.title, points, study.substeps);
    bool all = true;
    for (const GrowthPoint& p : points) {
      const auto near = [&](double found) { return std::abs(found - p.theory) <= kGrowthMiss * p.theory; };
      const bool good = near(p.measured) && (study.scene.empty() || near(p.in_liggghts));
      all = all && good;
      std::printf("%-9s %-14s omega H %-6g growth in LIGGGHTS %.6g, code alone %.6g, theory %.6g\n",
                  good ? "ok" : "NOT SO", p.scheme.c_str(), p.omega_h, p.in_liggghts, p.measured, p.theory);
    }
    std::printf("Files: %s\n", table.c_str());
    return all ? kExitDone : kExitFailed;
  }
  if (!study.cases.empty()) {
    const std::vector<Verdict> verdicts = run_map(study, arguments.only, out);
    const std::string table = (fs::path(out) / (name + ".md")).string();
    write_map(table, study, verdicts);
    if (!arguments.table.empty()) write_map(arguments.table, study, verdicts);
    const auto bad = std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return !v.as_expected; });
    std::printf("%zu cases, %td not as expected: %s\n", verdicts.size(), bad, table.c_str());
    return bad == 0 ? kExitDone : kExitFailed;
  }
  const StudyTable table = StudyRunner(study, out, arguments).run();
  const std::string csv = (fs::path(out) / (name + ".csv")).string();
  write_study_csv(csv, table);
  if (!arguments.table.empty()) write_study_page(arguments.table, table, "./footfall accuracy " + arguments.file);
  std::printf("Files: %s\n", csv.c_str());
  try {
    std::printf("       %s\n", draw_study(out, name, table).c_str());
  } catch (const InputError& e) {
    std::fprintf(stderr, "footfall: warning: no picture: %s\n", e.what());
  }
  return meets(study, table) ? kExitDone : kExitFailed;
}

}  // namespace footfall
