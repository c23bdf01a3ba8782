#pragma once
// What [landing] of a scene asks for: how far a lander is from tipping over, how far it slid, what came near the ground.
//
// Pads p_i are bodies with a boundary, or named points; neighbours are adjacent on their convex hull in the reference
// configuration, seen along the axis of the base. Vertical is gravity's direction, c the mass centre of all bodies that
// joints, struts and springs connect to the base, m their mass.
//   stability distance   d = min_i n_i . (c - p_i), n_i = up x e_i / |up x e_i|, e_i = p_i+1 - p_i: of the mass centre from
//                        the nearest vertical plane through two neighbouring pads, negative beyond it
//   energy margin        E = min_i m g (R_i |up - u_i u_i . up| - rho_i . up) - L_i^2 / (2 I_i): the energy that lifts the mass
//                        centre over the edge i [Messuri and Klein, IEEE J. Robot. Autom. 1 (1985) 132], minus the kinetic
//                        energy that a turn about this edge would keep; u_i = e_i / |e_i|, rho_i the arm of c from the edge,
//                        R_i its length, L_i and I_i angular momentum and inertia about the edge; L_i counts where it turns
//                        outwards. Beyond the edge the first part is negative, and a turn back adds.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/session/observe/sampler.h"

namespace footfall {

// The ground of heights: the plane, uneven ground, the surface to which a bed is cut ([ground.terrain]), or the highest grain under
// the boundaries at the start, along the coordinate axis nearest to up: a bed lies level in its box, however gravity is tilted.
struct GroundLevel {
  Eigen::Vector3d normal;                      // out of the ground, in W
  double height;                               // along it [m]
  std::shared_ptr<Terrain> terrain = nullptr;  // then normal and height do not count

  double above(const Eigen::Vector3d& p) const { return terrain ? terrain->distance(p) : normal.dot(p) - height; }
  Eigen::Vector3d normal_at(const Eigen::Vector3d& p) const { return terrain ? terrain->foot(p).normal : normal; }
};
GroundLevel ground_level(const Subject& subject);

struct LandingValues {
  double stability_distance = 0.0;  // d [m]
  double tip_energy_margin = 0.0;   // E [J]
  double tilt = 0.0;                // of the base's axis from the vertical [rad]
  double slid = 0.0;                // largest way of a pad along the ground from where it first touched [m]
  int pads_touching = 0;
  bool fallen = false;      // beyond an edge, where the first part of E is negative, and E of this edge is, too
  int struts_at_stops = 0;  // beyond an end stop on which they did not rest at the start, or with a crushed honeycomb
  std::vector<double> clearance;  // of each point above the ground [m]
};

// An extreme value so far, and its time [s].
struct Peak {
  double value = 0.0, time = 0.0;
  void see(double now, double at) {
    if (!(now > value)) return;
    value = now;
    time = at;
  }
};

template <>
inline constexpr auto kFields<Peak> = kFieldsOf<&Peak::value, &Peak::time>;

class LandingWatch {
 public:
  // The scene has [landing]. Throws InputError for pads that span no area. What the subject views must outlive this.
  explicit LandingWatch(const Subject& subject);

  void update(const Sample& sample);
  void visit(Archive& archive);

  const LandingValues& now() const { return now_; }
  const std::string& base() const;
  int base_body() const { return lander_.base; }
  const std::vector<int>& bodies() const { return lander_.bodies; }  // of the model
  const std::vector<std::string>& pads() const { return pad_names_; }

  // Since the first contact of a pad; before any, since the start.
  const Peak& least_distance() const { return least_distance_; }
  const Peak& least_margin() const { return least_margin_; }
  const Peak& largest_tilt() const { return largest_tilt_; }
  // Since the start.
  const Peak& least_clearance(std::size_t point) const { return least_clearance_[point]; }
  // The mass centre is beyond the plane of two neighbouring pads, also of a lander that lies on its back.
  bool tipped() const { return now_.stability_distance < 0.0; }

  struct First {
    std::string name;
    double time = 0.0;  // [s]
  };
  std::vector<First> first_contacts() const;   // of pads, in their order
  std::vector<First> struts_at_stops() const;  // that ever were, in the order of their times

 private:
  struct LandingPoint {
    int body = 0;                            // of the model
    Eigen::Vector3d p_B = {0.0, 0.0, 0.0};   // from Bo in B [m]
    const BodyBoundary* boundary = nullptr;  // of a pad: its lowest place along the vertical is the height
  };
  LandingPoint place_of_point(const LandingPointSpec& point) const;
  void choose_base();
  void choose_bodies();
  void choose_pads();
  void choose_edges();
  Eigen::Vector3d place_of(const LandingPoint& place, const Sample& sample) const;
  bool touches(const LandingPoint& pad, const Eigen::Vector3d& p_W, const Sample& sample) const;
  bool at_stop(std::size_t strut, const Sample& sample) const;
  void measure_edges(const Sample& sample);
  void see_pads(const Sample& sample);

  Subject subject_;
  Eigen::Vector3d up_;
  GroundLevel ground_;
  struct Lander {
    int base = 0;
    Eigen::Vector3d axis_B;  // upwards, in the axes of the base
    std::vector<int> bodies;
    double mass = 0.0;  // [kg]
  } lander_;
  std::vector<std::string> pad_names_;
  std::vector<LandingPoint> pads_, points_;
  std::vector<std::size_t> edges_;  // pads in their order around the axis

  LandingValues now_;
  std::vector<Eigen::Vector3d> pad_places_;               // of the sample, in W [m]
  std::vector<std::optional<double>> touched_, stopped_;  // first times of pads and struts [s]
  std::vector<Eigen::Vector3d> touched_at_;
  std::vector<bool> rests_;  // per strut: at the start on the stop of its extended end, as gas holds it there
  bool any_contact_ = false, started_ = false;
  Peak least_distance_, least_margin_, largest_tilt_;
  std::vector<Peak> least_clearance_;
};

// When a landing is over, as [landing] has it: at rest, or tipped over.
//   at rest      for rest_time no body of the lander moves faster than rest_speed, its base does not turn faster than
//                rest_speed / L, and it stands on three pads or lies, touching the ground, beyond the plane of two of them;
//                L = max_i |r_i - r_base| + sqrt(J / m), J the largest principal inertia of the base. Two pads are no rest:
//                a lander that rocks over them stops at the top, too
//   tipped over  for rest_time the mass centre is beyond the plane of two pads, without the energy to come back:
//                LandingValues::fallen
// Samples between steps count; the run ends at the next output row, with grains at the end of the next coupling interval.
class LandingEnd {
 public:
  // The scene has [landing]. What the subject views must outlive this.
  LandingEnd(const Subject& subject, const LandingWatch& landing);

  // Behind landing.update(sample).
  void update(const Sample& sample, const LandingWatch& landing);
  bool is_over() const { return rests_ || tipped_; }
  const char* name() const { return rests_ ? "rest" : tipped_ ? "tipped" : "end_time"; }
  std::string reason() const;  // a sentence; empty: it is not over

  void visit(Archive& archive);

 private:
  bool moves(const Sample& sample, const LandingWatch& landing) const;

  const LandingSpec& spec_;
  int base_;
  std::vector<int> bodies_;
  double length_ = 0.0;                 // L [m]
  double moved_ = 0.0, upright_ = 0.0;  // the last times at which it was not at rest, and not fallen [s]
  bool rests_ = false, tipped_ = false;
};

}  // namespace footfall
