// Spans are functions of the centres and directions of their two guides, with first and second derivatives by forward
// differentiation (Jet); KinematicVector takes these to the coordinates of the bodies.

#include "mbd_solver/model/elements/cable.h"

#include <cmath>
#include <optional>

#include "coupler/base/errors.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/elements/joint_coordinate.h"

namespace footfall {
namespace {

constexpr double kToe = 1e-4;  // share of the length over which damping sets in

// Of a span: d = c_j - c_i, then a_i, b_i, a_j, b_j.
constexpr int kVariables = 15;
using Gradient = Eigen::Matrix<double, kVariables, 1>;
using Hessian = Eigen::Matrix<double, kVariables, kVariables>;

// A number with its first derivatives and, of order 2, its second ones.
template <int kOrder>
struct Jet {
  double v = 0.0;
  Gradient g = Gradient::Zero();
  Eigen::Matrix<double, kOrder == 2 ? kVariables : 1, kOrder == 2 ? kVariables : 1> h = decltype(h)::Zero();

  // f(this), with f' and f''
  Jet chain(double f, double f1, double f2) const {
    Jet out;
    out.v = f;
    out.g = f1 * g;
    if constexpr (kOrder == 2) out.h.noalias() = f1 * h + f2 * g * g.transpose();
    return out;
  }
};

template <int kOrder>
Jet<kOrder> operator+(Jet<kOrder> a, const Jet<kOrder>& b) {
  a.v += b.v;
  a.g += b.g;
  if constexpr (kOrder == 2) a.h += b.h;
  return a;
}
template <int kOrder>
Jet<kOrder> operator*(double s, Jet<kOrder> a) {
  a.v *= s;
  a.g *= s;
  if constexpr (kOrder == 2) a.h *= s;
  return a;
}
template <int kOrder>
Jet<kOrder> operator-(const Jet<kOrder>& a, const Jet<kOrder>& b) {
  return a + -1.0 * b;
}
template <int kOrder>
Jet<kOrder> operator*(const Jet<kOrder>& a, const Jet<kOrder>& b) {
  Jet<kOrder> out;
  out.v = a.v * b.v;
  out.g = a.v * b.g + b.v * a.g;
  if constexpr (kOrder == 2) out.h.noalias() = a.v * b.h + b.v * a.h + a.g * b.g.transpose() + b.g * a.g.transpose();
  return out;
}
template <int kOrder>
Jet<kOrder> square_root(const Jet<kOrder>& a) {
  const double s = std::sqrt(a.v);
  return a.chain(s, 0.5 / s, -0.25 / (s * a.v));
}
template <int kOrder>
Jet<kOrder> inverse(const Jet<kOrder>& a) {
  const double i = 1.0 / a.v;
  return a.chain(i, -i * i, 2.0 * i * i * i);
}
template <int kOrder>
Jet<kOrder> angle_of(const Jet<kOrder>& y, const Jet<kOrder>& x) {
  const double r2 = x.v * x.v + y.v * y.v, by_x = -y.v / r2, by_y = x.v / r2;
  Jet<kOrder> out;
  out.v = std::atan2(y.v, x.v);
  out.g = by_x * x.g + by_y * y.g;
  if constexpr (kOrder == 2) {
    const double xx = 2.0 * x.v * y.v / (r2 * r2), xy = (y.v * y.v - x.v * x.v) / (r2 * r2);
    out.h.noalias() = by_x * x.h + by_y * y.h + xx * (x.g * x.g.transpose() - y.g * y.g.transpose()) +
                      xy * (x.g * y.g.transpose() + y.g * x.g.transpose());
  }
  return out;
}

// The same functions of plain numbers.
double square_root(double a) { return std::sqrt(a); }
double inverse(double a) { return 1.0 / a; }
double angle_of(double y, double x) { return std::atan2(y, x); }
double value_of(double a) { return a; }
template <int kOrder>
double value_of(const Jet<kOrder>& a) {
  return a.v;
}
template <class S>
S jet_of(double value) {
  if constexpr (std::is_same_v<S, double>) {
    return value;
  } else {
    S out;
    out.v = value;
    return out;
  }
}

template <class S>
struct CableVector {
  S x, y, z;
};
template <class S>
CableVector<S> operator+(const CableVector<S>& a, const CableVector<S>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class S>
CableVector<S> operator-(const CableVector<S>& a, const CableVector<S>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S>
CableVector<S> operator*(const S& s, const CableVector<S>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class S>
CableVector<S> scaled(double s, const CableVector<S>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class S>
S dot_of(const CableVector<S>& a, const CableVector<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S>
CableVector<S> cross_of(const CableVector<S>& a, const CableVector<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class S>
struct SpanSide {  // of a span at one of its guides
  bool round = false;
  double radius = 0.0;
  CableVector<S> a, b;
};

template <class S>
struct Span {
  S length{}, theta_out{}, theta_in{};
  CableVector<S> n_out{}, n_in{};  // from the centres to the points of contact, unit vectors
};

// e in the plane normal to a, for the way along d; sin(beta) = offset / L.
template <class S>
bool tangent_way(const CableVector<S>& d, const CableVector<S>& a, const S& offset, CableVector<S>& e) {
  const CableVector<S> in_plane = d - dot_of(a, d) * a;
  const S square = dot_of(in_plane, in_plane);
  if (!(value_of(square) > value_of(offset) * value_of(offset))) return false;
  const S by_length = inverse(square_root(square));
  const CableVector<S> u = by_length * in_plane;
  const S sine = offset * by_length, cosine = square_root(jet_of<S>(1.0) - sine * sine);
  e = cosine * u + sine * cross_of(a, u);
  return true;
}

// False if one guide is inside of the other.
template <class S>
bool find_span(const CableVector<S>& d, const SpanSide<S>& i, const SpanSide<S>& j, Span<S>& out) {
  CableVector<S> way = d;
  const S both = i.round && j.round ? dot_of(i.a, j.a) : jet_of<S>(0.0);
  if (i.round) {
    CableVector<S> e;
    if (!tangent_way(d, i.a, jet_of<S>(i.radius) - j.radius * both, e)) return false;
    out.n_out = scaled(-1.0, cross_of(i.a, e));
    way = way - scaled(i.radius, out.n_out);
    out.theta_out = angle_of(dot_of(i.a, cross_of(i.b, out.n_out)), dot_of(i.b, out.n_out));
  }
  if (j.round) {
    CableVector<S> e;
    if (!tangent_way(d, j.a, i.radius * both - jet_of<S>(j.radius), e)) return false;
    out.n_in = scaled(-1.0, cross_of(j.a, e));
    way = way + scaled(j.radius, out.n_in);
    out.theta_in = angle_of(dot_of(j.a, cross_of(j.b, out.n_in)), dot_of(j.b, out.n_in));
  }
  const S square = dot_of(way, way);
  if (!(value_of(square) > 0.0)) return false;
  out.length = square_root(square);
  return true;
}

CableVector<double> in_parts(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d in_parts(const CableVector<double>& v) { return {v.x, v.y, v.z}; }

template <int kOrder>
CableVector<Jet<kOrder>> variables_of(const Eigen::Vector3d& v, int first) {
  CableVector<Jet<kOrder>> out;
  out.x.v = v.x();
  out.y.v = v.y();
  out.z.v = v.z();
  out.x.g[first] = out.y.g[first + 1] = out.z.g[first + 2] = 1.0;
  return out;
}

}  // namespace

// The cable at one instant.
struct Cable::Way {
  // The vectors of one guide: centre, axis, direction from which angles count.
  struct GuideVectors {
    KinematicVector c, a, b;
    int offset = 0, size = 0;  // of its body in the coordinates of the element
  };

  // A sum of functions of spans as a function of the coordinates: gradient, rate and derivative of the rate; and, if wanted,
  // the second derivatives.
  struct Quantity {
    explicit Quantity(int n, bool second)
        : by_x(Eigen::VectorXd::Zero(n)), rate_by_x(Eigen::VectorXd::Zero(second ? n : 0)) {
      if (second) by_xx = Eigen::MatrixXd::Zero(n, n);
    }
    double rate = 0.0;
    Eigen::VectorXd by_x, rate_by_x;
    Eigen::MatrixXd by_xx;
  };

  std::vector<GuideVectors> guides;
  std::vector<char> touched;    // per guide
  std::vector<double> counted;  // per inner state: its angle, with whole turns
  double length = 0.0, unstretched = 0.0;
  std::optional<Quantity> stretch, free;  // e, s
  std::vector<Quantity> angles;           // per inner state
};

struct Cable::Force {
  double e = 0.0, rate = 0.0, s = 0.0;
  double tension = 0.0, total = 0.0;                         // dV/de, F
  double total_by_e = 0.0, total_by_s = 0.0, by_rate = 0.0;  // of F
  double by_s = 0.0, by_s_e = 0.0, by_s_s = 0.0;             // dV/ds and its derivatives
  double energy = 0.0;
};

Cable::Cable(std::string name, std::vector<CableGuide> guides, const CableParameters& parameters)
    : ForceElement(std::move(name), kGround, kGround), guides_(std::move(guides)), parameters_(parameters) {
  FOOTFALL_DEMAND(guides_.size() >= 2);
  std::vector<int> found;
  for (const CableGuide& guide : guides_) {
    state_of_.push_back(guide.radius > 0.0 ? states_++ : -1);
    const int body = guide.marker.body;
    if (body != kGround && std::find(found.begin(), found.end(), body) == found.end()) found.push_back(body);
  }
  if (found.size() > kMostBodies)
    throw InputError(code::kCableBodies, "cable \"" + this->name() + "\" runs over " + std::to_string(found.size()) +
                                             " bodies between two ends, expected at most " +
                                             std::to_string(kMostBodies) +
                                             "; let it turn one of the pulleys (grip = true), which divides it");
  set_bodies(found);
}

Eigen::VectorXd Cable::initial_state() const {
  Eigen::VectorXd z(states_);
  for (std::size_t i = 0; i < guides_.size(); ++i)
    if (state_of_[i] >= 0) z[state_of_[i]] = guides_[i].angle;
  return z;
}

// One measurement of the way of a cable: places, touched guides and lengths, then their derivatives.
class Cable::Measurement {
 public:
  Measurement(const Cable& cable, const ElementInput& in, Way& way) : cable_(cable), in_(in), way_(way) {}
  void locate();
  void find_touched();
  void add_lengths();
  template <int kOrder>
  void add_spans();

 private:
  [[noreturn]] void refuse(std::size_t i, std::size_t j) const {
    throw NumericalError(code::kCableInside, "cable \"" + cable_.name() + "\": guides " + std::to_string(i + 1) +
                                                 " and " + std::to_string(j + 1) +
                                                 " of its path meet: one is inside of the other, so that no cable "
                                                 "runs between them.");
  }
  std::size_t next_touched(std::size_t i) const {
    do ++i;
    while (!way_.touched[i]);
    return i;
  }
  std::size_t last_touched(std::size_t i) const {
    do --i;
    while (!way_.touched[i]);
    return i;
  }
  Span<double> span_of(std::size_t i, std::size_t j) const;
  template <class AnyJet>
  void add(std::size_t i, std::size_t j, double factor, const AnyJet& jet, Way::Quantity& out) const;
  // Of the span from i to j: into the length; the angles of the guides in `for_i` and `for_j`.
  template <int kOrder>
  void add_span(std::size_t i, std::size_t j, bool length, bool for_i, bool for_j) const;

  const Cable& cable_;
  const ElementInput& in_;
  Way& way_;
  const std::vector<CableGuide>& guides_ = cable_.guides_;
  const std::vector<int>& state_of_ = cable_.state_of_;
};

void Cable::Measurement::locate() {
  const std::size_t count = guides_.size();
  way_.guides.resize(count);
  way_.touched.assign(count, 1);
  way_.counted.assign(static_cast<std::size_t>(cable_.states_), 0.0);
  static const BodyKinematics kAtRest;
  for (std::size_t i = 0; i < count; ++i) {
    const CableGuide& guide = guides_[i];
    Way::GuideVectors& at = way_.guides[i];
    const BodyKinematics* body = &kAtRest;
    for (std::size_t k = 0, offset = 0; guide.marker.body != kGround && k < kMostBodies; ++k) {
      const BodyKinematics* acted = k < 2 ? in_.pair.body[k] : in_.further[k - 2];
      if ((k < 2 ? cable_.bodies()[k] : cable_.further_bodies()[k - 2]) == guide.marker.body) {
        body = acted;
        at.offset = static_cast<int>(offset);
        break;
      }
      offset += static_cast<std::size_t>(acted->size());
    }
    at.size = body->size();
    const PairMotion pair{{body, &kAtRest}};
    at.c = KinematicVector::point(pair, 0, guide.marker);
    if (guide.radius > 0.0) {
      at.a = KinematicVector::axis(pair, 0, guide.marker, 2);
      at.b = KinematicVector::axis(pair, 0, guide.marker, 0);
    }
  }
}

Span<double> Cable::Measurement::span_of(std::size_t i, std::size_t j) const {
  Span<double> span;
  const auto side = [&](std::size_t k) {
    SpanSide<double> out{guides_[k].radius > 0.0, guides_[k].radius, {}, {}};
    if (out.round) {
      out.a = in_parts(way_.guides[k].a.value());
      out.b = in_parts(way_.guides[k].b.value());
    }
    return out;
  };
  if (!find_span(in_parts(Eigen::Vector3d(way_.guides[j].c.value() - way_.guides[i].c.value())), side(i), side(j),
                 span))
    refuse(i, j);
  return span;
}

void Cable::Measurement::find_touched() {
  const std::size_t count = guides_.size();
  // Wraps; the cable leaves the pulley with the most negative one, then the others are seen again.
  for (bool again = true; again;) {
    again = false;
    double least = 0.0;
    std::size_t leaves = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (state_of_[i] < 0) continue;
      const double before = i > 0 ? span_of(last_touched(i), i).theta_in : 0.0;
      const double after = i + 1 < count ? span_of(i, next_touched(i)).theta_out : 0.0;
      const double raw = i == 0 ? after : i + 1 == count ? before : after - before;
      double& angle = way_.counted[state_of_[i]];
      angle = nearest_turn(raw, in_.z[state_of_[i]]);
      if (cable_.is_end(i) || !way_.touched[i] || angle >= least) continue;
      least = angle;
      leaves = i;
    }
    if (least < 0.0) {
      way_.touched[leaves] = 0;
      again = true;
    }
  }
}

void Cable::Measurement::add_lengths() {
  const std::size_t count = guides_.size();
  way_.unstretched = cable_.parameters_.length;
  if (state_of_.front() >= 0) way_.unstretched -= guides_.front().radius * way_.counted[state_of_.front()];
  if (state_of_.back() >= 0) way_.unstretched += guides_.back().radius * way_.counted[state_of_.back()];
  if (cable_.parameters_.axial_stiffness > 0.0 && !(way_.unstretched > 0.0))
    throw NumericalError(code::kCableTakenUp, "cable \"" + cable_.name() +
                                                  "\": its drum has taken up the whole cable: nothing is left between "
                                                  "its ends.");
  way_.length = 0.0;
  for (std::size_t i = 0; i + 1 < count;) {
    const std::size_t j = next_touched(i);
    way_.length += span_of(i, j).length;
    if (j + 1 < count && state_of_[j] >= 0) way_.length += guides_[j].radius * way_.counted[state_of_[j]];
    i = j;
  }
}

template <class AnyJet>
void Cable::Measurement::add(std::size_t i, std::size_t j, double factor, const AnyJet& jet, Way::Quantity& out) const {
  const Way::GuideVectors &gi = way_.guides[i], &gj = way_.guides[j];
  // Each vector with its first variable and its sign: d = c_j - c_i.
  struct Part {
    const KinematicVector* vector;
    const Way::GuideVectors* guide;
    int first;
    double sign;
  };
  const Part parts[6] = {{&gi.c, &gi, 0, -1.0}, {&gj.c, &gj, 0, 1.0}, {&gi.a, &gi, 3, 1.0},
                         {&gi.b, &gi, 6, 1.0},  {&gj.a, &gj, 9, 1.0}, {&gj.b, &gj, 12, 1.0}};
  for (const Part& p : parts) {
    const Eigen::Vector3d g = factor * p.sign * jet.g.template segment<3>(p.first);
    out.rate += g.dot(p.vector->rate());
    if (p.guide->size == 0) continue;
    p.vector->add_transposed(g, out.by_x.segment(p.guide->offset, p.guide->size));
    if constexpr (std::decay_t<decltype(jet.h)>::RowsAtCompileTime == kVariables) {
      p.vector->add_rate_by_position(g, out.rate_by_x.segment(p.guide->offset, p.guide->size));
      p.vector->add_second(g, out.by_xx.block(p.guide->offset, p.guide->offset, p.guide->size, p.guide->size));
      Eigen::Vector3d turning = Eigen::Vector3d::Zero();
      for (const Part& o : parts) {
        const Eigen::Matrix3d C = factor * p.sign * o.sign * jet.h.template block<3, 3>(p.first, o.first);
        turning += C * o.vector->rate();
        if (o.guide->size == 0) continue;
        p.vector->add_product(C, *o.vector,
                              out.by_xx.block(p.guide->offset, o.guide->offset, p.guide->size, o.guide->size));
      }
      p.vector->add_transposed(turning, out.rate_by_x.segment(p.guide->offset, p.guide->size));
    }
  }
}

template <int kOrder>
void Cable::Measurement::add_span(std::size_t i, std::size_t j, bool length, bool for_i, bool for_j) const {
  const auto side = [&](std::size_t k, int first) {
    SpanSide<Jet<kOrder>> out;
    out.round = guides_[k].radius > 0.0;
    out.radius = guides_[k].radius;
    if (!out.round) return out;
    out.a = variables_of<kOrder>(way_.guides[k].a.value(), first);
    out.b = variables_of<kOrder>(way_.guides[k].b.value(), first + 3);
    return out;
  };
  const SpanSide<Jet<kOrder>> side_i = side(i, 3), side_j = side(j, 9);
  Span<Jet<kOrder>> span;
  if (!find_span(variables_of<kOrder>(way_.guides[j].c.value() - way_.guides[i].c.value(), 0), side_i, side_j, span))
    refuse(i, j);
  if (length) {
    Jet<kOrder> sum = span.length;
    if (side_i.round) sum = sum + side_i.radius * span.theta_out;
    if (side_j.round) sum = sum - side_j.radius * span.theta_in;
    add(i, j, 1.0, sum, *way_.stretch);
  }
  if (for_i && side_i.round) {
    add(i, j, 1.0, span.theta_out, way_.angles[state_of_[i]]);
    if (i == 0) add(i, j, -side_i.radius, span.theta_out, *way_.free);
  }
  if (for_j && side_j.round) {
    const double sign = j + 1 == guides_.size() ? 1.0 : -1.0;  // of a pulley: the wrap
    add(i, j, sign, span.theta_in, way_.angles[state_of_[j]]);
    if (j + 1 == guides_.size()) add(i, j, side_j.radius, span.theta_in, *way_.free);
  }
}

template <int kOrder>
void Cable::Measurement::add_spans() {
  for (std::size_t i = 0; i + 1 < guides_.size();) {
    const std::size_t j = next_touched(i);
    add_span<kOrder>(i, j, true, true, true);
    for (std::size_t k = i + 1; k < j; ++k) {  // pulleys that are not touched: their angles alone
      add_span<kOrder>(i, k, false, false, true);
      add_span<kOrder>(k, j, false, true, false);
    }
    i = j;
  }
}

void Cable::measure(const ElementInput& in, bool second, Way& way) const {
  Measurement measurement(*this, in, way);
  measurement.locate();
  measurement.find_touched();
  measurement.add_lengths();
  const int n = in.size();
  way.stretch.emplace(n, second);
  way.free.emplace(n, second);
  for (int k = 0; k < states_; ++k) way.angles.emplace_back(n, second);
  second ? measurement.add_spans<2>() : measurement.add_spans<1>();
}

Cable::Force Cable::force(const Way& way) const {
  Force out;
  out.s = way.unstretched;
  out.e = way.length - way.unstretched;
  out.rate = way.stretch->rate;
  if (!(out.e > 0.0)) return out;
  const double EA = parameters_.axial_stiffness, k = EA > 0.0 ? EA / out.s : parameters_.stiffness;
  const double by_s = EA > 0.0 ? -k / out.s : 0.0;  // dk/ds
  out.energy = 0.5 * k * out.e * out.e;
  out.tension = k * out.e;
  out.by_s = 0.5 * by_s * out.e * out.e;
  out.by_s_e = by_s * out.e;
  out.by_s_s = EA > 0.0 ? k / (out.s * out.s) * out.e * out.e : 0.0;
  const double toe = kToe * parameters_.length, ramp = std::min(1.0, out.e / toe);
  out.total = out.tension + parameters_.damping * out.rate * ramp;
  if (!(out.total > 0.0)) {
    out.total = 0.0;
    return out;
  }
  out.total_by_e = k + (ramp < 1.0 ? parameters_.damping * out.rate / toe : 0.0);
  out.total_by_s = by_s * out.e;
  out.by_rate = parameters_.damping * ramp;
  return out;
}

void Cable::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const {
  Way way;
  measure(in, false, way);
  const Force f = force(way);
  Q -= f.total * way.stretch->by_x + f.by_s * way.free->by_x;
  for (int k = 0; k < states_; ++k) {
    const std::size_t at = k;
    dz[k] = way.angles[at].rate + kTurnFollow * (way.counted[at] - in.z[k]);
  }
}

bool Cable::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  Way way;
  measure(in, true, way);
  const Force f = force(way);
  const Way::Quantity &e = *way.stretch, &s = *way.free;
  if (f.energy > 0.0) {
    const Eigen::VectorXd total_by_x = f.total_by_e * e.by_x + f.total_by_s * s.by_x + f.by_rate * e.rate_by_x;
    out.dQ_dx -= e.by_x * total_by_x.transpose() + f.total * e.by_xx;
    out.dQ_dv -= f.by_rate * e.by_x * e.by_x.transpose();
    if (parameters_.axial_stiffness > 0.0)
      out.dQ_dx -= s.by_x * (f.by_s_e * e.by_x + f.by_s_s * s.by_x).transpose() + f.by_s * s.by_xx;
  }
  for (int k = 0; k < states_; ++k) {
    const Way::Quantity& angle = way.angles[k];
    out.ddz_dx.row(k) += (angle.rate_by_x + kTurnFollow * angle.by_x).transpose();
    out.ddz_dv.row(k) += angle.by_x.transpose();
    out.ddz_dz(k, 0) -= kTurnFollow;
  }
  return true;
}

void Cable::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  Way way;
  measure(in, false, way);
  const Force f = force(way);
  stored[Stored::kStrain] += f.energy;
  power[Dissipation::kDamper] += (f.total - f.tension) * f.rate;
}

CableSample Cable::sample(const ElementInput& in) const {
  Way way;
  measure(in, false, way);
  const Force f = force(way);
  const auto angle = [&](int state) { return state < 0 ? 0.0 : way.counted[state]; };
  return {way.length, f.e, f.rate, f.total, f.s, angle(state_of_.front()), angle(state_of_.back())};
}

std::vector<CablePoint> Cable::points(const ElementInput& in) const {
  Way way;
  measure(in, false, way);
  std::vector<CablePlace> places;
  std::vector<int> guides;
  for (std::size_t i = 0; i < guides_.size(); ++i) {
    if (!way.touched[i]) continue;
    const Way::GuideVectors& at = way.guides[i];
    places.push_back({at.c.value(), at.a.value(), guides_[i].radius});
    guides.push_back(static_cast<int>(i));
  }
  double spans = 0.0;
  const std::vector<CableTouch> touches = touch(places, spans);
  std::vector<CablePoint> out;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const CablePlace &from = places[i], &to = places[i + 1];
    out.push_back({from.centre + from.radius * touches[i].out, guides[i], from.centre, from.axis});
    out.push_back({to.centre + to.radius * touches[i + 1].in, guides[i + 1], to.centre, to.axis});
  }
  return out;
}

std::vector<CableTouch> touch(const std::vector<CablePlace>& places, double& spans) {
  std::vector<CableTouch> out(places.size(), {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  spans = 0.0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const auto side = [&](const CablePlace& place) {
      return SpanSide<double>{place.radius > 0.0, place.radius, in_parts(place.axis),
                              in_parts(Eigen::Vector3d(place.axis.unitOrthogonal()))};
    };
    Span<double> span;
    if (!find_span(in_parts(Eigen::Vector3d(places[i + 1].centre - places[i].centre)), side(places[i]),
                   side(places[i + 1]), span))
      throw NumericalError(code::kCableInside, "guides " + std::to_string(i + 1) + " and " + std::to_string(i + 2) +
                                                   " of its path meet: one is inside of the other.");
    spans += span.length;
    if (places[i].radius > 0.0) out[i].out = in_parts(span.n_out);
    if (places[i + 1].radius > 0.0) out[i + 1].in = in_parts(span.n_in);
  }
  return out;
}

}  // namespace footfall
