#pragma once
// What a soil without grains does to one facet of a boundary. Two laws behind one interface; theory 6.7.
// Axes of the ground: x, y in its undisturbed plane, z down. A facet at x, y and the depth z has the normal n out of its body.
//   print     s: the depth of the ground under the facet after all that has pressed on it; contact while z > s
//   elastic   within `rebound` e of its print the ground is elastic: stiff while it unloads, and it never pulls. u is the elastic
//             displacement, w_0 = 3 y^2 - 2 y^3, y = min(1, |u|/e), x = d |u|'. The share of its strength that it bears is
//             w_0 (1 + x) / (1 + x w_0) closing, w_0 exp(x (1 - w_0)) opening: without a corner at its ends and where |u| turns round
//             Of rft x = d |u|' (1 + v_1 / (abs(|u|') + v_2)), v_1 = 1 m/s, v_2 = 10 mm/s: sand gives back little at any speed. Its push
//             along n grows with the way slid meanwhile, so that elastic ground would make a plate that is drawn slowly hop for ever
//   sway      -d w_0 (1 - w_0) times its strength, times the velocity sideways
//   inertia   -lambda rho (v.n)^2 n where the facet advances, v.n > 0
//   speed     -c v.n z_s tanh(z / z_s) n likewise: grains that jam under a fast facet carry a share of the soil next to them, and
//             more of it the deeper it is, down to some radii of the grains, z_s. Coarse grains at impact speed need it; in the limit of
//             slow flow it vanishes
// Stress is a function of place and speed and of a memory that changes only between integration steps, so the ground has no
// inner states: within a step every facet has an elastic displacement from its memory, cut at the strength of the ground.
//
// Resistive force theory in three dimensions [Agarwal, Goldman and Kamrin, PNAS 120, e2214017120 (2023)]: for a displacement
// along d, |d| = 1, with g down and n' = n or -n, whichever points down,
//   alpha = f_1 n' + f_2 d + f_3 g,  f_k = sum c_k T,  T the 20 monomials up to x_1^a x_2^b x_3^c, a + b + c <= 3
//   x_1 = d.g,  x_2 = n'.g,  x_3 = n'.d;   t = xi z (alpha_n + min(1, mu_s |alpha_n| / |alpha_t|) alpha_t) - c N_c max(0, n.d)^2 n
//   xi = rho g (894 mu^3 - 386 mu^2 + 89 mu);  N_c = (N_q - 1) / mu,  N_q = exp(pi mu) tan^2(pi/4 + phi/2) [Reissner 1924]
// Range: slow flow of dry grains around facets deep against a grain; mu of 0.1 to 0.9; facets that go down or sideways.
//
// Pressure and sinkage [Bekker 1969; Reece 1965] with shear [Janosi and Hanamoto 1961], on the area seen from above:
//   p = (k_c / b + k_phi) z^n,   tau = (c + p tan(phi)) (1 - exp(-j / K)) along the way j that the facet has slid
// A share s of a limit L that the ground remembers bears s min(L, L') where the limit is L' now: pressed harder it carries the same
// stress, relieved the same displacement, so that no closed way gives energy. tau and sway together never exceed c + p tan(phi).
// Range: flat plates of about the width b of the test, pressed normal to the ground; no force on facets that stand upright.

#include <Eigen/Dense>
#include <memory>
#include <string>
#include <string_view>

namespace footfall {

// Of one facet, in the axes of the ground.
struct SoilPoint {
  Eigen::Vector3d place;     // x, y, depth z [m]
  Eigen::Vector3d normal;    // out of the body
  Eigen::Vector3d velocity;  // [m/s]
};

// What the ground remembers of one facet.
struct SoilMemory {
  double print = 0.0;                               // s [m]
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  // x, y when it was remembered last [m]
  Eigen::Vector2d shear = Eigen::Vector2d::Zero();  // rft: elastic displacement [m]; pressure_sinkage: share of tau [-]
  double limit = 0.0;                               // pressure_sinkage: c + p tan(phi) at that share [Pa]
  Eigen::Vector2d printed = Eigen::Vector2d::Zero();  // x, y of its print [m]
  bool touches = false;
};

struct SoilStress {
  Eigen::Vector3d traction = Eigen::Vector3d::Zero();  // on the facet, without what depends on speed [Pa]
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();   // with the part that grows with speed [Pa]
  Eigen::Matrix<double, 3, 9> slope;  // d(traction + inertia) / d(place, normal, velocity), where it is asked for
};

class SoilLaw {
 public:
  enum class With { kTraction, kSlope };

  // Of both laws.
  struct Common {
    double density = 1500.0;         // rho, of the bulk [kg/m3] > 0
    double inertia = 1.0;            // lambda >= 0
    double speed_resistance = 0.0;   // c >= 0 [Pa s/m2]
    double speed_depth = 1.0;        // z_s > 0 [m]
    double cohesion = 0.0;           // c >= 0 [Pa]
    double surface_friction = 10.0;  // mu_s between facet and ground >= 0; large: as rough as the soil
    double rebound = 1e-3;           // e > 0 [m]
    double damping = 3.0;            // d of the elastic ground >= 0 [s/m]
  };

  virtual ~SoilLaw() = default;
  virtual std::string_view kind() const = 0;
  // Where z > memory.print. two_sided: the facet has no inside; the side that advances counts.
  virtual SoilStress stress(const SoilPoint& at, const SoilMemory& memory, bool two_sided, With with) const = 0;
  // The memory after a step that ends here; print, place, shear and touches.
  virtual void remember(const SoilPoint& at, SoilMemory& memory) const = 0;
};

struct RftParameters : SoilLaw::Common {
  double friction = 0.4;    // mu = tan(phi) of the soil > 0
  double resistance = 0.0;  // xi [Pa/m] > 0
};
// xi of a soil of this density, internal friction and weight [Pa/m].
double rft_resistance(double density, double friction, double gravity);
// alpha of a facet with this normal that moves along d, in the axes of the ground.
Eigen::Vector3d rft_alpha(const Eigen::Vector3d& normal, const Eigen::Vector3d& d);

struct SinkageParameters : SoilLaw::Common {
  double stiffness = 0.0;     // k_c / b + k_phi [Pa/m^n] > 0
  double exponent = 1.0;      // n > 0
  double friction = 0.6;      // tan(phi) >= 0
  double shear_length = 0.0;  // K > 0 [m]
};

// Throw InputError on values outside their range, with `where` in front.
std::unique_ptr<SoilLaw> make_rft(const RftParameters& parameters, const std::string& where);
std::unique_ptr<SoilLaw> make_pressure_sinkage(const SinkageParameters& parameters, const std::string& where);

}  // namespace footfall
