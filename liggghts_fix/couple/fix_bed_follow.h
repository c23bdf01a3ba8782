#pragma once
// fix ID all bed/follow body BODY directions x|y|xy distance D
// An endless bed: grains in a periodic box, whose sides follow a body of the scene. Grains do not move with the box; only the
// window of W that the box shows moves. It consists of kSlabs slabs along each direction. When the body comes closer
// than D to the last slab in front, the window advances by a slab: the rearmost slab is removed, and the corresponding
// slab of the bed at rest, as it was at the start, is inserted in its place, which by the period is the place in front. Grains
// in the rear that overlap the new grains are put on top of the bed, so that the mass inserted equals the mass removed.
//
// The body meets grains at their unwrapped places (x + L image). As a vector: number and mass [kg] of the grains
// added, then of the grains removed.

#include <Eigen/Dense>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "coupler/messages.h"
#include "fix.h"
#include "liggghts_fix/link/bed_exchange.h"

namespace footfall {
class DemLink;
}

namespace LAMMPS_NS {

class FixBedFollow : public Fix {
 public:
  FixBedFollow(LAMMPS* lmp, int narg, char** arg);  // throws footfall::InputError for a wrong command

  int setmask() override;
  void init() override;
  void setup_pre_exchange() override;
  void setup(int) override;
  void end_of_step() override;
  void pre_exchange() override;
  void post_force(int) override;
  double compute_vector(int i) override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

 private:
  // A grain of the bed at rest.
  struct RestingGrain {
    int tag = 0;
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    double radius = 0.0, mass = 0.0, density = 0.0;  // [m], [kg], [kg/m3]
    int type = 1, mask = 1;
    std::vector<int> partners;   // whose contacts have a history: places in the list
    std::vector<double> pairs;   // the histories, one after another
    std::vector<double> planes;  // those with primitive walls
  };
  struct Slab {
    int axis = 0, place = 0;  // in the box
  };
  static constexpr int kNoSlab = -1000000;

  void keep_bed();
  void find_next();
  void require_all_inside() const;
  footfall::SlabChange change_of(const Slab& slab, int way) const;
  double room_behind(int axis, int way) const;
  // Least and largest place of the nodes of a body along the axis in W; without nodes infinity and its negative [m].
  std::array<double, 2> extent_of(int body, int axis) const;
  void exchange(const footfall::BedExchange& exchange, footfall::GrainChanges& changes);
  void insert(const Slab& slab, int last_tag, footfall::GrainChanges& changes);
  void add_contacts(std::size_t k, const std::vector<int>& tags, std::vector<double>& pairs) const;
  bool is_held(int grain) const;
  bool is_in(const Slab& slab, const double* x) const;
  double slab_width(int axis) const;
  double energy_of(int grain) const;
  int place_of(double x, int axis) const;
  double limit(int axis, int slab) const;  // lower end of a slab of W [m]
  Fix* pair_history() const;
  std::vector<Fix*> plane_histories() const;
  std::vector<double> packed() const;
  void unpack(const double* numbers);

  footfall::DemLink& link_;
  std::string body_name_;
  int body_ = -1;
  std::array<bool, 2> follows_ = {true, true};
  double distance_ = 0.0;  // [m]

  std::vector<RestingGrain> bed_;                 // by their tags at the start
  std::vector<int> tags_;                         // of the last copy of each
  double allowed_overlap_ = 0.0;                  // of a remaining grain with a new grain, over the smaller radius [-]
  int pair_values_ = 0;                           // of a contact
  std::array<int, 2> first_ = {0, 0};             // slab of W at the lower end of the bed
  std::array<int, 2> held_ = {kNoSlab, kNoSlab};  // slab of W that is held at rest: the newest slab
  footfall::GrainChanges sum_;                    // counts only
  int next_axis_ = -1, next_way_ = 0;             // how the window moves in the next step; -1: it does not
};

}  // namespace LAMMPS_NS
