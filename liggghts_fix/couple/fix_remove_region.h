#pragma once
// fix ID all remove/region region REGION every N [from T] [until T]
// Every N steps, single grains whose centre is in the region are removed. Times count from step 0. As a vector: number and
// mass [kg] of the grains removed so far.

#include <cstdio>

#include "fix.h"

namespace LAMMPS_NS {

class FixRemoveRegion : public Fix {
 public:
  FixRemoveRegion(LAMMPS* lmp, int narg, char** arg);  // throws footfall::InputError for a wrong command

  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  void pre_exchange() override;
  double compute_vector(int i) override { return i == 0 ? count_ : mass_; }
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

 private:
  bool is_here(int grain) const;

  int region_ = -1;
  double from_ = 0.0, until_;        // [s]
  double count_ = 0.0, mass_ = 0.0;  // removed; [kg]
};

}  // namespace LAMMPS_NS
