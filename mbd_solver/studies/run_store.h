#pragma once
// The runs of a study and their results. FOLDER.done.json, next to the folder of a finished run, holds a fingerprint
// of its inputs (its recipe) and its cost: the run is not repeated until its scene, a setting or a file that the
// scene names has changed. The same command therefore resumes a study that was ended, and runs may be added
// meanwhile. An interrupted run resumes from its checkpoint if its recipe equals FOLDER.begun.json.

#include <array>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/scene/scene.h"
#include "mbd_solver/studies/plan.h"

namespace footfall {

// The inputs of a run: the scene with all its values, a fingerprint of each file that it names (scripts with the files they
// include, meshes, controllers, tables), and the end time [s].
std::string recipe_of(const Scene& scene, double until);
// The same on other machines: names of files are relative to the scene.
std::string portable_recipe_of(const Scene& scene, double until);

// Times of a run [s].
struct RunCost {
  double wall = 0.0, dem = 0.0, mbd = 0.0, exchange = 0.0;
  double cpu = 0.0;  // processor time of all its programs; hardly depends on other jobs of the machine
};
// Their keys in summaries and tables.
inline constexpr std::array<std::pair<const char*, double RunCost::*>, 5> kTimes = {
    {{"wall_s", &RunCost::wall},
     {"dem_wall_s", &RunCost::dem},
     {"mbd_wall_s", &RunCost::mbd},
     {"exchange_wall_s", &RunCost::exchange},
     {"cpu_s", &RunCost::cpu}}};

// How a run ended.
struct RunEnd {
  static constexpr int kHung = 124;  // exit code at the time limit
  std::string folder;                // of its results
  std::string status;                // of summary.json; "missing" without one
  int code = 0;                      // exit code
  std::string message;               // its last line of error; empty when it is done
  std::vector<std::string> warnings;
  nlohmann::ordered_json summary = nlohmann::ordered_json::object();  // empty: none
  RunCost cost;

  bool done() const { return code == 0; }
};

class RunStore {
 public:
  // In folders below `folder`; `reuse`: finished runs are not repeated.
  RunStore(std::string folder, bool reuse) : folder_(std::move(folder)), reuse_(reuse) {}

  // Returns the number of the run, counted from 0. A run with the recipe of an earlier one shares its results. Reads the
  // scene; throws InputError for a wrong one, unless the request allows it.
  std::size_t add(const RunRequest& request);

  const RunRequest& request(std::size_t run) const { return runs_[run].request; }
  // The folder of its results: of the first run with its recipe.
  std::string folder(std::size_t run) const;
  // Fingerprint of its portable recipe; empty when its scene cannot be read.
  const std::string& portable_recipe(std::size_t run) const { return runs_[run].portable_recipe; }
  bool is_done(std::size_t run) const;
  int most_ranks() const;       // of LIGGGHTS in one run
  int at_once(int jobs) const;  // `jobs`; 0: as many runs as the cores allow
  // One run for each bed that is not made yet and that at least `sharing` of the runs share. A run makes its bed itself if
  // there is none; two that share one would wait for each other.
  std::vector<std::size_t> beds_to_make(const std::vector<std::size_t>& runs, int sharing = 1) const;
  void make_bed(std::size_t run, bool quiet) const;
  // The same where a bed may fail: then every run with it has failed, with the reason in its log.
  void try_bed(std::size_t run);
  bool has_failed(std::size_t run) const { return runs_[runs_[run].home].code > 0; }  // during this process

  // The remaining runs among `runs`, each recipe once. Their beds exist.
  std::vector<std::size_t> left(const std::vector<std::size_t>& runs) const;
  // Carries out `runs`, at most `jobs` at once, and calls `ended` after each. False when interrupted.
  bool carry_out(const std::vector<std::size_t>& runs, int jobs, const std::function<void(std::size_t)>& ended);
  RunEnd end_of(std::size_t run) const;

 private:
  struct Entry {
    RunRequest request;
    std::string recipe;           // its fingerprint; empty when the scene cannot be read: never counts as done
    std::string portable_recipe;  // likewise
    std::size_t home = 0;         // the first run with this recipe
    int ranks = 1;
    bool has_checkpoints = false;  // its scene sets output.checkpoint_interval
    std::vector<BedSpec> bed;      // none or one
    int code = -1;                 // exit code, if the run ended during this process
    RunCost cost;
  };
  std::string record_file(std::size_t run) const { return folder(run) + ".done.json"; }
  std::string begun_file(std::size_t run) const { return folder(run) + ".begun.json"; }
  std::string summary_file(std::size_t run) const { return folder(run) + "/summary.json"; }
  bool can_resume(std::size_t run) const;
  void record_end(Entry& entry, int code, double cpu, bool first);

  std::string folder_;
  bool reuse_;
  std::vector<Entry> runs_;
  std::map<std::pair<std::string, int>, std::size_t> homes_;  // by recipe and repeats
};

}  // namespace footfall
