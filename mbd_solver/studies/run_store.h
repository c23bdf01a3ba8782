#pragma once
// The runs of an experiment and what they left in their folders. A finished run is known by what it was made from, kept
// beside its folder (FOLDER.done.json) with what it cost: it is not done again until its scene, a setting or a file
// that the scene names has changed. So whatever ends the experiment, the same command goes on with what is left; and
// runs may be added while it goes. A run that was stopped goes on from its checkpoint, if it is made from the same as when
// it began (FOLDER.begun.json).

#include <array>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/scene/scene.h"
#include "mbd_solver/studies/plan.h"

namespace footfall {

// What a run is made from: the scene with all its values, and a fingerprint of each file it names: scripts (with what
// they include), meshes, controllers, tables; and the end time [s].
std::string recipe_of(const Scene& scene, double until);
// The same wherever the files stand, as long as the way from the scene to each of them is the same.
std::string portable_recipe_of(const Scene& scene, double until);

// Times of a run [s].
struct RunCost {
  double wall = 0.0, dem = 0.0, mbd = 0.0, exchange = 0.0;
  double cpu = 0.0;  // of all its programs, which other jobs of the machine hardly change
};
// Their names in summaries and tables.
inline constexpr std::array<std::pair<const char*, double RunCost::*>, 5> kTimes = {
    {{"wall_s", &RunCost::wall},
     {"dem_wall_s", &RunCost::dem},
     {"mbd_wall_s", &RunCost::mbd},
     {"exchange_wall_s", &RunCost::exchange},
     {"cpu_s", &RunCost::cpu}}};

// How a run ended.
struct RunEnd {
  static constexpr int kHung = 124;  // the exit code when the time limit struck
  std::string folder;                // of its results
  std::string status;                // of summary.json; "missing" without one
  int code = 0;                      // exit code
  std::string message;               // its last line of error, empty when it was done
  std::vector<std::string> warnings;
  nlohmann::ordered_json summary = nlohmann::ordered_json::object();  // empty when there is none
  RunCost cost;

  bool done() const { return code == 0; }
};

class RunStore {
 public:
  // Below `folder`; `keep`: runs that were done before are taken as they are.
  RunStore(std::string folder, bool keep) : folder_(std::move(folder)), keep_(keep) {}

  // Returns the number of the run, from 0 in their order. A run with the recipe of an earlier one is that one. Reads the
  // scene: throws InputError for a wrong one, unless the request says that it may be.
  std::size_t add(const RunRequest& request);

  const RunRequest& request(std::size_t run) const { return runs_[run].request; }
  // Of its results: that of the first run with its recipe.
  std::string folder(std::size_t run) const;
  // Fingerprint of its portable recipe; empty when its scene cannot be read.
  const std::string& portable_recipe(std::size_t run) const { return runs_[run].portable_recipe; }
  bool is_done(std::size_t run) const;
  int most_ranks() const;  // of LIGGGHTS in one run
  // One run for each bed that is not made yet and that at least so many of them share. A run makes its own bed where it
  // finds none; two that share one would wait for each other.
  std::vector<std::size_t> beds_to_make(const std::vector<std::size_t>& runs, int sharing = 1) const;
  void make_bed(std::size_t run, bool quiet) const;
  // The same, where a bed may turn out impossible: then every run of it has failed, and their logs say why.
  void try_bed(std::size_t run);
  bool has_failed(std::size_t run) const { return runs_[runs_[run].home].code > 0; }  // under our eyes

  // Those of `runs` that are to be done: their beds are there, and none is the same as another.
  std::vector<std::size_t> left(const std::vector<std::size_t>& runs) const;
  // Does `runs`, at most `jobs` at once, and calls `ended` after each. False when it was interrupted.
  bool carry_out(const std::vector<std::size_t>& runs, int jobs, const std::function<void(std::size_t)>& ended);
  RunEnd end_of(std::size_t run) const;

 private:
  struct Entry {
    RunRequest request;
    std::string recipe;  // its fingerprint; empty when the scene cannot be read: such a run is never taken as done
    std::string portable_recipe;  // likewise
    std::size_t home = 0;         // the first run with this recipe
    int ranks = 1;
    bool keeps = false;        // checkpoints, every output.checkpoint_interval
    std::vector<BedSpec> bed;  // none or one
    int code = -1;             // of a run that ended under our eyes
    RunCost cost;
  };
  std::string record_file(std::size_t run) const { return folder(run) + ".done.json"; }
  std::string begun_file(std::size_t run) const { return folder(run) + ".begun.json"; }
  std::string summary_file(std::size_t run) const { return folder(run) + "/summary.json"; }
  bool can_resume(std::size_t run) const;
  void note_end(Entry& entry, int code, double cpu, bool first);

  std::string folder_;
  bool keep_;
  std::vector<Entry> runs_;
  std::map<std::pair<std::string, int>, std::size_t> homes_;  // by recipe and repeats
};

}  // namespace footfall
