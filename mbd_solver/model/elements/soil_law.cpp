// Each law is written once for numbers and for numbers with derivatives (Dual), so that slopes are exact.

#include "mbd_solver/model/elements/soil_law.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/base/pi.h"

namespace footfall {
namespace {

// A number with derivatives by N others.
template <int N>
struct Dual {
  double value = 0.0;
  Eigen::Array<double, N, 1> by = Eigen::Array<double, N, 1>::Zero();

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT: a constant is a number
  Dual(double v, const Eigen::Array<double, N, 1>& d) : value(v), by(d) {}
  static Dual variable(double v, int k) {
    Dual out(v);
    out.by[k] = 1.0;
    return out;
  }

  Dual operator-() const { return {-value, -by}; }
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.by + b.by}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.by - b.by}; }
  friend Dual operator*(const Dual& a, const Dual& b) { return {a.value * b.value, a.by * b.value + b.by * a.value}; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double q = a.value / b.value;
    return {q, (a.by - q * b.by) / b.value};
  }
  friend Dual operator+(const Dual& a, double b) { return {a.value + b, a.by}; }
  friend Dual operator*(const Dual& a, double b) { return {a.value * b, a.by * b}; }
  friend Dual operator*(double a, const Dual& b) { return b * a; }
};

template <int N>
Dual<N> chained(const Dual<N>& x, double value, double slope) {
  return {value, slope * x.by};
}
double root(double x) { return std::sqrt(x); }
template <int N>
Dual<N> root(const Dual<N>& x) {
  const double r = std::sqrt(x.value);
  return chained(x, r, r > 0.0 ? 0.5 / r : 0.0);
}
double exponential(double x) { return std::exp(x); }
template <int N>
Dual<N> exponential(const Dual<N>& x) {
  const double e = std::exp(x.value);
  return chained(x, e, e);
}
double power(double x, double n) { return std::pow(x, n); }
template <int N>
Dual<N> power(const Dual<N>& x, double n) {
  const double p = std::pow(x.value, n);
  return chained(x, p, n * p / x.value);
}
double number(double x) { return x; }
template <int N>
double number(const Dual<N>& x) {
  return x.value;
}

template <class T>
struct Three {
  T x{0.0}, y{0.0}, z{0.0};
};
template <class T>
Three<T> operator+(const Three<T>& a, const Three<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Three<T> operator*(const T& s, const Three<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T dot(const Three<T>& a, const Three<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
struct Facet {
  Three<T> p, n, v;  // place, normal, velocity
};

template <class T>
struct Answer {
  Three<T> traction, inertia;  // [Pa]
};

Facet<double> plain_facet(const SoilPoint& at) {
  const auto three = [](const Eigen::Vector3d& a) { return Three<double>{a.x(), a.y(), a.z()}; };
  return {three(at.place), three(at.normal), three(at.velocity)};
}

Facet<Dual<9>> varied_facet(const SoilPoint& at) {
  const auto three = [](const Eigen::Vector3d& a, int k) {
    return Three<Dual<9>>{Dual<9>::variable(a.x(), k), Dual<9>::variable(a.y(), k + 1),
                          Dual<9>::variable(a.z(), k + 2)};
  };
  return {three(at.place, 0), three(at.normal, 3), three(at.velocity, 6)};
}

// The share of a thing that is complete at a: 3 y^2 - 2 y^3, y = x / a, without a corner at either end.
template <class T>
T grown(const T& x, double a) {
  if (number(x) >= a) return T(1.0);
  if (number(x) <= 0.0) return T(0.0);
  const T y = x * (1.0 / a);
  return y * y * (T(3.0) + -2.0 * y);
}

// Of `rebound`: the first part of it carries a facet that slides at constant depth.
constexpr double kSeat = 0.1;
// A facet that recedes by less than this from its direction of motion still counts in part, so that stress has no jump there.
constexpr double kRecede = 0.1;
// Of the shear length: a way within which shear depends on the place alone.
constexpr double kSwing = 0.05;

// The share of its strength that the ground bears where the displacement `share` bears at rest grows, with x = `closing`: never more
// than all.
template <class T>
T damped_share(const T& share, const T& closing) {
  if (!(number(closing) > 0.0)) return share * exponential(closing * (T(1.0) + -share));
  return share * (T(1.0) + closing) / (T(1.0) + closing * share);
}

template <class T>
T borne_share(const SoilLaw::Common& c, const T& share, const T& rate) {
  return damped_share(share, T(rate * c.damping));
}

// Of rft: losses do not vanish with speed.
constexpr double kLikeAt = 1.0;   // swings lose at least as much as the damping does at this speed [m/s],
constexpr double kSwings = 1e-2;  // above about this one [m/s]
template <class T>
T lossy_share(const SoilLaw::Common& c, const T& share, const T& rate) {
  const T speed = number(rate) > 0.0 ? rate : -rate;
  return damped_share(share, T((rate * c.damping) * (T(1.0) + T(kLikeAt) / (speed + kSwings))));
}

// A facet that swings sideways on elastic ground is damped, too, at the rate of its strength.
template <class T>
Three<T> sway(const SoilLaw::Common& c, const Facet<T>& at, const T& strength, const T& share) {
  const T drag = strength * share * (T(1.0) + -share) * -c.damping;
  return {drag * at.v.x, drag * at.v.y, T(0.0)};
}

constexpr int kRftTerms = 20;
// Of [1, x1, x2, x3, x1^2, x2^2, x3^2, x1 x2, x2 x3, x3 x1, x1^3, x2^3, x3^3, x1 x2^2, x2 x1^2, x2 x3^2, x3 x2^2, x3 x1^2,
// x1 x3^2, x1 x2 x3] [Agarwal 2023, table of c_k].
constexpr std::array<std::array<double, kRftTerms>, 3> kRft = {
    {{0.00212, -0.02320, -0.20890, -0.43083, -0.00259, 0.48872, -0.00415, 0.07204, -0.02750, -0.08772,
      0.01992, -0.45961, 0.40799,  -0.10107, -0.06576, 0.05664, -0.09269, 0.01892, 0.01033,  0.15120},
     {-0.06796, -0.10941, 0.04725, -0.06914, -0.05835, -0.65880, -0.11985, -0.25739, -0.26834, 0.02692,
      -0.00736, 0.63758,  0.08997, 0.21069,  0.04748,  0.20406,  0.18589,  0.04934,  0.13527,  -0.33207},
     {-0.02634, -0.03436, 0.45256,  0.00835,  0.02553, -1.31290, -0.05532, 0.06790,  -0.16404, 0.02287,
      0.02927,  0.95406,  -0.00131, -0.11028, 0.01487, -0.02730, 0.10911,  -0.04097, 0.07881,  -0.27519}}};

template <class T>
Three<T> generic_alpha(const Three<T>& n, const Three<T>& d) {
  const bool flipped = number(n.z) < 0.0;
  const Three<T> down = flipped ? T(-1.0) * n : n;
  const T x = d.z, y = down.z, z = dot(down, d);
  const T xx = x * x, yy = y * y, zz = z * z;
  const std::array<T, kRftTerms> terms = {T(1.0), x,      y,      z,      xx,     yy,       zz,
                                          x * y,  y * z,  z * x,  xx * x, yy * y, zz * z,   x * yy,
                                          y * xx, y * zz, z * yy, z * xx, x * zz, x * y * z};
  std::array<T, 3> f = {T(0.0), T(0.0), T(0.0)};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < kRftTerms; ++i) f[k] = f[k] + terms[i] * kRft[k][i];
  return f[0] * down + f[1] * d + Three<T>{T(0.0), T(0.0), f[2]};
}

// The sideways displacement of a facet since its memory; on its first touch as on a straight way to its depth below s.
template <class T>
std::array<T, 2> slid(const Facet<T>& at, const SoilMemory& m, const T& below) {
  if (m.touches) return {at.p.x + T(-m.place.x()), at.p.y + T(-m.place.y())};
  if (!(number(at.v.z) > 0.0)) return {T(0.0), T(0.0)};
  const T time = below / at.v.z;
  return {at.v.x * time, at.v.y * time};
}

// Speeds below this are slow flow, where the part that grows with speed has no corner at rest [m/s].
constexpr double kSlowFlow = 1e-3;

template <class T>
T saturated(const T& z, double z_s) {
  const T e = exponential(z * (-2.0 / z_s));  // z_s tanh(z / z_s)
  return z_s * (T(1.0) + -e) / (T(1.0) + e);
}

// What depends on speed, on the lower side of a facet; the upper one of a facet without sides is free where it is level.
template <class T>
Three<T> inertia_of(const SoilLaw::Common& c, const Facet<T>& at, const Three<T>& n, const T& seated, bool two_sided) {
  const T advance = dot(at.v, n);
  const bool advances = number(advance) > 0.0;
  if ((c.inertia == 0.0 && c.speed_resistance == 0.0) || (!advances && !two_sided)) return {};
  T size = (c.inertia * c.density) * (advance * advance) * seated;
  if (c.speed_resistance > 0.0) {
    const T speed = advances ? advance : -advance;
    const T fast = speed * speed / (speed + kSlowFlow);
    size = size + (c.speed_resistance * fast) * saturated(at.p.z, c.speed_depth) * seated;
  }
  if (advances) return -size * n;
  return (size * (T(1.0) + -n.z)) * n;
}

// Both uses of a law, from its one formula `evaluate(Facet<T>, memory, two_sided)`.
template <class Law>
SoilStress use(const Law& law, const SoilPoint& at, const SoilMemory& memory, bool two_sided, SoilLaw::With with) {
  SoilStress out;
  const auto vector = [](const auto& a) { return Eigen::Vector3d(number(a.x), number(a.y), number(a.z)); };
  if (with == SoilLaw::With::kSlope) {
    const auto answer = law.evaluate(varied_facet(at), memory, two_sided);
    out.traction = vector(answer.traction);
    out.inertia = vector(answer.inertia);
    const auto sum = answer.traction + answer.inertia;
    out.slope.row(0) = sum.x.by.matrix().transpose();
    out.slope.row(1) = sum.y.by.matrix().transpose();
    out.slope.row(2) = sum.z.by.matrix().transpose();
    return out;
  }
  const auto answer = law.evaluate(plain_facet(at), memory, two_sided);
  out.traction = vector(answer.traction);
  out.inertia = vector(answer.inertia);
  return out;
}

void check_common(const SoilLaw::Common& c, const std::string& where) {
  const auto demand = [&](bool good, const char* what) {
    if (!good) throw InputError(code::kParameterOutOfRange, where + what);
  };
  demand(c.density > 0.0, "the density must be positive.");
  demand(c.inertia >= 0.0, "the factor of inertia must not be negative.");
  demand(c.speed_resistance >= 0.0, "the resistance to speed must not be negative.");
  demand(c.speed_depth > 0.0, "the depth of the resistance to speed must be positive.");
  demand(c.cohesion >= 0.0, "the cohesion must not be negative.");
  demand(c.surface_friction >= 0.0, "the friction of the surface must not be negative.");
  demand(c.rebound > 0.0, "the rebound must be positive.");
  demand(c.damping >= 0.0, "the damping must not be negative.");
}

class RftLaw final : public SoilLaw {
 public:
  explicit RftLaw(const RftParameters& p) : p_(p) {
    const double phi = std::atan(p.friction);
    const double n_q = std::exp(kPi * p.friction) * std::pow(std::tan(0.25 * kPi + 0.5 * phi), 2);
    bearing_ = p.cohesion * (n_q - 1.0) / p.friction;
    upright_ = -rft_alpha(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()).z();
  }
  std::string_view kind() const override { return "rft"; }

  SoilStress stress(const SoilPoint& at, const SoilMemory& memory, bool two_sided, With with) const override {
    return use(*this, at, memory, two_sided, with);
  }

  template <class T>
  Answer<T> evaluate(const Facet<T>& at, const SoilMemory& m, bool two_sided) const {
    Answer<T> out;
    const double e = p_.rebound;
    const T below = at.p.z + T(-m.print);
    if (!(number(below) > 0.0) || !(number(at.p.z) > 0.0)) return out;
    const T seated = grown(below, kSeat * e);
    const std::array<T, 2> h = slid_from(at, m, below);
    const T q = number(below) > kSeat * e ? below + T(-kSeat * e) : T(0.0);
    const T square = h[0] * h[0] + h[1] * h[1] + q * q;
    // Without sides: of both, the lower one while the facet advances with it.
    const bool turned = two_sided && number(at.n.z) < 0.0;
    const Three<T> n = turned ? T(-1.0) * at.n : at.n;
    out.inertia = inertia_of(p_, at, n, seated, two_sided);
    if (!(number(square) > 0.0)) return out;
    const T size = root(square);
    const Three<T> d = (T(1.0) / size) * Three<T>{h[0], h[1], q};
    const T advance = dot(n, d), lower = grown(advance + kRecede, kRecede), rest = grown(size, e);
    const T share = seated * lossy_share(p_, rest, dot(d, at.v)), strength = p_.resistance * at.p.z * share;
    const Three<T> alpha = generic_alpha(n, d);
    out.traction = (strength * lower) * of_side(alpha, n);
    if (two_sided && number(lower) < 1.0) {
      out.traction = out.traction + (strength * (T(1.0) + -lower)) * of_side(alpha, T(-1.0) * n);
      out.traction = out.traction + (bearing_ * share * advance * (number(advance) < 0.0 ? advance : T(0.0))) * n;
    }
    if (number(advance) > 0.0) out.traction = out.traction + (-(bearing_ * share * advance * advance)) * n;
    out.traction = out.traction + sway(p_, at, seated * (upright_ * p_.resistance * at.p.z + bearing_), rest);
    return out;
  }

  void remember(const SoilPoint& at, SoilMemory& m) const override {
    const double e = p_.rebound, below = at.place.z() - m.print;
    if (!(below > 0.0) || !(at.place.z() > 0.0)) {
      m.touches = false;
      m.shear.setZero();
    } else {
      const std::array<double, 2> h = slid_from(plain_facet(at), m, below);
      const double q = std::max(0.0, below - kSeat * e);
      const double size = std::sqrt(h[0] * h[0] + h[1] * h[1] + q * q);
      const double kept = size > e ? e / size : 1.0;
      m.shear = Eigen::Vector2d(h[0], h[1]) * kept;
      if (q > 0.0) m.print = std::max(m.print, at.place.z() - kSeat * e - kept * q);
      m.touches = true;
    }
    m.place = at.place.head<2>();
  }

 private:
  // The side with the normal n pushes, and rubs as far as friction allows.
  template <class T>
  Three<T> of_side(const Three<T>& alpha, const Three<T>& n) const {
    const T along = dot(alpha, n);
    if (!(number(along) < 0.0)) return {};
    const Three<T> side = alpha + (-along) * n;
    const T square = dot(side, side);
    T held(1.0);
    if (number(square) > 0.0) {
      const T limit = p_.surface_friction * -along / root(square);
      if (number(limit) < 1.0) held = limit;
    }
    return along * n + held * side;
  }
  // The elastic displacement sideways.
  template <class T>
  std::array<T, 2> slid_from(const Facet<T>& at, const SoilMemory& m, const T& below) const {
    std::array<T, 2> h = slid(at, m, below);
    h[0] = h[0] + T(m.shear.x());
    h[1] = h[1] + T(m.shear.y());
    return h;
  }

  RftParameters p_;
  double bearing_;  // c N_c [Pa]
  double upright_;  // -alpha_z of a level facet that is pressed straight down
};

class SinkageLaw final : public SoilLaw {
 public:
  explicit SinkageLaw(const SinkageParameters& p) : p_(p), friction_(std::min(p.friction, p.surface_friction)) {}
  std::string_view kind() const override { return "pressure_sinkage"; }

  SoilStress stress(const SoilPoint& at, const SoilMemory& memory, bool two_sided, With with) const override {
    return use(*this, at, memory, two_sided, with);
  }

  template <class T>
  Answer<T> evaluate(const Facet<T>& at, const SoilMemory& m, bool two_sided) const {
    Answer<T> out;
    const double e = p_.rebound;
    const T below = at.p.z + T(-m.print);
    if (!(number(below) > 0.0) || !(number(at.p.z) > 0.0)) return out;
    Three<T> n = at.n;
    if (two_sided && number(n.z) < 0.0) n = T(-1.0) * n;
    const T seated = grown(below, kSeat * e);
    out.inertia = inertia_of(p_, at, n, seated, two_sided);
    if (!(number(n.z) > 0.0)) return out;
    const T rest = grown(below, e), borne = borne_share(p_, rest, at.v.z);
    const T strength = p_.stiffness * power(at.p.z, p_.exponent);
    const T p = strength * borne;
    const T limit = p_.cohesion * borne + friction_ * p;
    const std::array<T, 2> shear = sheared(at, m, below, limit);
    const Three<T> side = Three<T>{-(limit * shear[0]), -(limit * shear[1]), T(0.0)} + sway(p_, at, strength, rest);
    const T square = side.x * side.x + side.y * side.y;
    T held(1.0);
    if (number(square) > number(limit) * number(limit)) held = limit / root(square);
    out.traction = n.z * (held * side + Three<T>{T(0.0), T(0.0), -p});
    return out;
  }

  void remember(const SoilPoint& at, SoilMemory& m) const override {
    const double below = at.place.z() - m.print;
    if (!(below > 0.0) || !(at.place.z() > 0.0)) {
      m.touches = false;
      m.shear.setZero();
    } else {
      m.print = std::max(m.print, at.place.z() - p_.rebound);
      // A facet that swings about its place stays with its memory: the law of the way slid would wear off with every swing.
      if (m.touches && (at.place.head<2>() - m.place).norm() < kSwing * p_.shear_length) return;
      const double rest = grown(below, p_.rebound), borne = borne_share(p_, rest, at.velocity.z());
      const double limit = (p_.cohesion + friction_ * p_.stiffness * power(at.place.z(), p_.exponent)) * borne;
      const std::array<double, 2> shear = sheared(plain_facet(at), m, below, limit);
      m.shear = Eigen::Vector2d(shear[0], shear[1]);
      if (const double size = m.shear.norm(); size > 1.0) m.shear /= size;
      m.limit = limit;
      m.touches = true;
    }
    m.place = at.place.head<2>();
  }

 private:
  // dT/dj = (u - T) / K along a straight way: T = T_0 exp(-j/K) + u (1 - exp(-j/K)), with what is remembered under the present limit.
  template <class T>
  std::array<T, 2> sheared(const Facet<T>& at, const SoilMemory& m, const T& below, const T& limit) const {
    const std::array<T, 2> way = slid(at, m, below);
    const T kept = number(limit) > m.limit ? T(m.limit) / limit : T(1.0);
    const T x = m.shear.x() * kept, y = m.shear.y() * kept;
    const T square = way[0] * way[0] + way[1] * way[1];
    const double K = p_.shear_length;
    if (!(number(square) > 1e-24 * K * K))  // too short for a direction
      return {x + way[0] * (1.0 / K), y + way[1] * (1.0 / K)};
    const T j = root(square);
    const T left = exponential(j * (-1.0 / K));
    const T gained = (T(1.0) + (-left)) / j;
    return {x * left + gained * way[0], y * left + gained * way[1]};
  }

  SinkageParameters p_;
  double friction_;
};

}  // namespace

double rft_resistance(double density, double friction, double gravity) {
  return density * gravity * friction * (89.0 + friction * (-386.0 + friction * 894.0));
}

Eigen::Vector3d rft_alpha(const Eigen::Vector3d& normal, const Eigen::Vector3d& d) {
  const Three<double> alpha =
      generic_alpha(Three<double>{normal.x(), normal.y(), normal.z()}, Three<double>{d.x(), d.y(), d.z()});
  return {alpha.x, alpha.y, alpha.z};
}

std::unique_ptr<SoilLaw> make_rft(const RftParameters& p, const std::string& where) {
  check_common(p, where);
  if (!(p.friction > 0.0))
    throw InputError(code::kParameterOutOfRange, where + "the internal friction must be positive.");
  if (!(p.resistance > 0.0))
    throw InputError(code::kParameterOutOfRange,
                     where + "the resistance must be positive; there is no weight without gravity.");
  return std::make_unique<RftLaw>(p);
}

std::unique_ptr<SoilLaw> make_pressure_sinkage(const SinkageParameters& p, const std::string& where) {
  check_common(p, where);
  const auto demand = [&](bool good, const char* what) {
    if (!good) throw InputError(code::kParameterOutOfRange, where + what);
  };
  demand(p.stiffness > 0.0, "k_c / width + k_phi must be positive.");
  demand(p.exponent > 0.0, "the exponent must be positive.");
  demand(p.friction >= 0.0, "the internal friction must not be negative.");
  demand(p.shear_length > 0.0, "the shear length must be positive.");
  return std::make_unique<SinkageLaw>(p);
}

}  // namespace footfall
