#pragma once
// Forces at the start of the next DEM step. The set-up of a run lets LIGGGHTS evaluate all forces; a
// checkpoint holds their sum over the ranks, and it is restored on one of them, since forces that
// LIGGGHTS evaluates anew would differ.

#include <memory>
#include <vector>

#include "liggghts_fix/link/dem_body.h"

namespace footfall {

class OpeningForces {
 public:
  using Bodies = std::vector<std::unique_ptr<DemBody>>;
  explicit OpeningForces(const Bodies& bodies) : bodies_(bodies) {}  // must outlive this

  void expect_set_up();                      // contacts that follow open the next DEM step
  void begin_substep();                      // which they open now
  std::vector<double> of_this_rank() const;  // all bodies in one row of numbers
  void store(std::vector<double> of_all_ranks) { stored_ = std::move(of_all_ranks); }
  const std::vector<double>& stored() const { return stored_; }
  std::vector<double>& stored() { return stored_; }
  void restore(bool on_this_rank);

 private:
  const Bodies& bodies_;
  bool set_up_ = false;         // a set-up has evaluated forces that open the next DEM step
  std::vector<double> stored_;  // of a checkpoint
};

}  // namespace footfall
