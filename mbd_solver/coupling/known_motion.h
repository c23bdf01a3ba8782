#pragma once
// Bodies whose motion the joints alone decide: prescribed motions, and bodies fixed to them. Their path among the
// grains is known before the grains move.

#include <memory>
#include <vector>

#include "coupler/window.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/model/state.h"

namespace footfall {

class KnownMotion {
 public:
  // model and assembly must outlive this. start: of the run. bodies: indices in the model of the coupled ones.
  KnownMotion(const Model& model, const Assembly& assembly, const State& start, std::vector<int> bodies);

  // Known poses of each of the bodies after every DEM step of a window of n steps of dt [s] from `state`; without columns
  // for bodies that loads can move. No entries where the straight path is exact.
  const std::vector<KnownPath>& paths(const State& state, int n, double dt);
  bool is_known(std::size_t k) const { return known_[k]; }  // of the k-th of the bodies

 private:
  void find_bodies(const Assembly& assembly, const State& start);
  State at(const State& before, double time);
  bool goes_straight(const State& state, int n, double dt);

  const Model& model_;
  std::vector<int> bodies_;
  std::unique_ptr<Equations>
      equations_;            // separate, so that the equations of the run retain their factors; null: no known motion
  std::vector<bool> known_;  // per body
  std::vector<KnownPath> paths_, none_;
};

}  // namespace footfall
