#pragma once
// How a window of the staggered coupling is done: which motion the grains see while the bodies wait, and how
// the forces of the substeps become the one load that the bodies get. [Lin25 section 4.2, 34], theory:
// coupling (order and stability table).

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "coupler/body_motion.h"

namespace footfall {

// Share of a substep's mean force that comes from the force standing at its start and at its end; the two sum
// to 1. {1/2, 1/2} is the impulse that velocity Verlet really applies; {0, 1} is the mean over steps 1..n as
// printed.
struct StepWeights {
  double opening = 0.5;
  double closing = 0.5;
};

// A scheme has no state: it may be shared by all bodies and both programs.
class Scheme {
 public:
  virtual ~Scheme() = default;
  virtual std::string_view name() const = 0;
  // Predicted position and velocity (r, L, a, dr, w, da) a time tau [s] after the state `start`;
  // accelerations are left alone. `out` is sized like `start`. No allocation.
  virtual void predict(const BodyMotion& start, double tau, BodyMotion& out) const = 0;
  virtual StepWeights weights() const = 0;
  // True: the boundary starts each window where the last one ended and reaches the new prediction at the
  // window's end. False: it jumps to the prediction at the window's start, and the work of the jump is
  // counted and reported.
  virtual bool continuous_path() const = 0;
  // True: the grains' side also returns the tangent stiffness and damping of each body's contacts, and the
  // body reacts on them within the window (TangentLoad).
  virtual bool wants_tangent() const { return false; }
};

// "css-trapezoid" (default), "css" (as printed), "quadratic", "tangent", "frozen" (teaching and tests only: it pumps
// energy). Throws InputError for any other name, listing these.
std::unique_ptr<Scheme> make_scheme(std::string_view name);
const std::vector<std::string>& scheme_names();
inline constexpr std::string_view kDefaultScheme = "css-trapezoid";

}  // namespace footfall
