#include "coupler/scheme.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

// Angular velocity of exp(theta(t)) in W: theta' + (1 - cos p)/p^2 theta x theta' + (p - sin p)/p^3 theta x
// (theta x theta'), p = |theta|.
Eigen::Vector3d angular_velocity(const Eigen::Vector3d& theta, const Eigen::Vector3d& theta_rate) {
  const double p2 = theta.squaredNorm();
  const double p = std::sqrt(p2);
  const bool small = p < 1e-4;  // series: the next terms are below p^4 / 24 = 4e-18
  const double c1 = small ? 0.5 - p2 / 24.0 : (1.0 - std::cos(p)) / p2;
  const double c2 = small ? 1.0 / 6.0 - p2 / 120.0 : (p - std::sin(p)) / (p2 * p);
  const Eigen::Vector3d cross = theta.cross(theta_rate);
  return theta_rate + c1 * cross + c2 * theta.cross(cross);
}

// The boundary rests in its pose at t_k during the whole window.
class Frozen : public Scheme {
 public:
  std::string_view name() const override { return "frozen"; }
  void predict(const BodyMotion& start, double, BodyMotion& out) const override {
    out.r = start.r;
    out.L = start.L;
    out.a = start.a;
    out.dr.setZero();
    out.w.setZero();
    out.da.setZero();
  }
  StepWeights weights() const override { return {0.5, 0.5}; }
  bool continuous_path() const override { return false; }
};

// r + dr tau, exp(w tau) L, a + da tau.
class Linear : public Scheme {
 public:
  void predict(const BodyMotion& start, double tau, BodyMotion& out) const override {
    out.r = start.r + tau * start.dr;
    out.L = turned(start.L, tau * start.w);
    out.a = start.a + tau * start.da;
    out.dr = start.dr;
    out.w = start.w;
    out.da = start.da;
  }
  bool continuous_path() const override { return true; }
};

class Css : public Linear {
 public:
  std::string_view name() const override { return "css"; }
  StepWeights weights() const override { return {0.0, 1.0}; }
};

class CssTrapezoid : public Linear {
 public:
  std::string_view name() const override { return "css-trapezoid"; }
  StepWeights weights() const override { return {0.5, 0.5}; }
};

// As css-trapezoid on the grains' side; the load that the body gets reacts within the window.
class Tangent : public Linear {
 public:
  std::string_view name() const override { return "tangent"; }
  StepWeights weights() const override { return {0.5, 0.5}; }
  bool wants_tangent() const override { return true; }
};

// As linear, and half the accelerations times tau^2.
class Quadratic : public Scheme {
 public:
  std::string_view name() const override { return "quadratic"; }
  void predict(const BodyMotion& start, double tau, BodyMotion& out) const override {
    const double half = 0.5 * tau;
    const Eigen::Vector3d theta = tau * (start.w + half * start.dw);
    out.r = start.r + tau * (start.dr + half * start.ddr);
    out.L = turned(start.L, theta);
    out.a = start.a + tau * (start.da + half * start.dda);
    out.dr = start.dr + tau * start.ddr;
    out.w = angular_velocity(theta, start.w + tau * start.dw);
    out.da = start.da + tau * start.dda;
  }
  StepWeights weights() const override { return {0.5, 0.5}; }
  bool continuous_path() const override { return true; }
};

}  // namespace

std::unique_ptr<Scheme> make_scheme(std::string_view name) {
  if (name == "css-trapezoid") return std::make_unique<CssTrapezoid>();
  if (name == "css") return std::make_unique<Css>();
  if (name == "quadratic") return std::make_unique<Quadratic>();
  if (name == "tangent") return std::make_unique<Tangent>();
  if (name == "frozen") return std::make_unique<Frozen>();
  throw InputError("unknown coupling scheme \"" + std::string(name) + "\". Known schemes: " + joined(scheme_names()) +
                   ".");
}

const std::vector<std::string>& scheme_names() {
  static const std::vector<std::string> names = {"css-trapezoid", "css", "quadratic", "tangent", "frozen"};
  return names;
}

}  // namespace footfall
