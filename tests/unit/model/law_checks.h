#pragma once
// What every strut law must satisfy, whatever its formula: derivatives that agree with its force and rates,
// and the identity force * rate = d(stored)/dt + dissipated. Used by the tests of all laws.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "mbd_solver/model/laws/strut_law.h"
#include "tests/support/refused.h"

namespace footfall::law_checks {

inline const Eigen::VectorXd kNoState;

inline double force(const StrutLaw& law, double stroke, double rate, double voltage, const Eigen::VectorXd& z) {
  StrutOutput out(law.state_count());
  law.evaluate({stroke, rate, voltage, z}, out);
  return out.force;
}
inline double force(const StrutLaw& law, double stroke, double rate = 0.0, double voltage = 0.0) {
  return force(law, stroke, rate, voltage, law.initial_state());
}

// Of the law of `make` with one parameter changed: every change must be refused, and its key named.
template <class Law, class Parameters>
void expect_refused(const Parameters& good,
                    std::initializer_list<std::pair<const char*, std::function<void(Parameters&)>>> changes) {
  EXPECT_NO_THROW(Law{good});
  for (const auto& [key, change] : changes) {
    Parameters p = good;
    change(p);
    EXPECT_TRUE(test::names(test::error_of([&] { Law{p}; }), {key}));
  }
}

inline double dissipated(const StrutLaw& law, const StrutInput& in) {
  std::vector<StrutPower> powers;
  law.dissipated_power(in, powers);
  double sum = 0.0;
  for (const StrutPower& p : powers) {
    EXPECT_GE(p.power, 0.0) << law.kind() << " " << name_of(p.kind) << " at stroke " << in.stroke << ", rate "
                            << in.rate;
    sum += p.power;
  }
  return sum;
}

// Derivatives against central differences. Steps h = 1e-6 of the scale: truncation ~ h^2 f''' and round-off ~
// 1e-16 / h are both below 1e-5 of the derivative for smooth laws; kTolerance leaves a factor of ten. The
// point must not lie within h of a kink.
inline void expect_derivatives(const StrutLaw& law, double stroke, double rate, double voltage,
                               const Eigen::VectorXd& z, double stroke_scale, double rate_scale) {
  constexpr double kTolerance = 1e-4;
  const int n = law.state_count();
  StrutOutput at(n), plus(n), minus(n);
  law.evaluate({stroke, rate, voltage, z}, at);
  const auto compare = [&](double analytic, double difference, double scale, const char* what) {
    EXPECT_NEAR(analytic, difference, kTolerance * (std::abs(difference) + scale))
        << law.kind() << " " << what << " at stroke " << stroke << ", rate " << rate << ", voltage " << voltage
        << ", z " << z.transpose();
  };
  const double hx = 1e-6 * stroke_scale, hv = 1e-6 * rate_scale;
  // Round-off of the differences of a force of this size.
  const double force_noise = 1e-10 * (1.0 + std::abs(at.force));
  law.evaluate({stroke + hx, rate, voltage, z}, plus);
  law.evaluate({stroke - hx, rate, voltage, z}, minus);
  compare(at.dforce_dstroke, (plus.force - minus.force) / (2 * hx), force_noise / hx, "dforce_dstroke");
  for (int i = 0; i < n; ++i)
    compare(at.ddz_dstroke[i], (plus.dz[i] - minus.dz[i]) / (2 * hx), 1e-8 / hx, "ddz_dstroke");
  law.evaluate({stroke, rate + hv, voltage, z}, plus);
  law.evaluate({stroke, rate - hv, voltage, z}, minus);
  compare(at.dforce_drate, (plus.force - minus.force) / (2 * hv), force_noise / hv, "dforce_drate");
  for (int i = 0; i < n; ++i) compare(at.ddz_drate[i], (plus.dz[i] - minus.dz[i]) / (2 * hv), 1e-8 / hv, "ddz_drate");
  for (int k = 0; k < n; ++k) {
    const double hz = 1e-6 * stroke_scale;
    Eigen::VectorXd zp = z, zm = z;
    zp[k] += hz;
    zm[k] -= hz;
    law.evaluate({stroke, rate, voltage, zp}, plus);
    law.evaluate({stroke, rate, voltage, zm}, minus);
    compare(at.dforce_dz[k], (plus.force - minus.force) / (2 * hz), force_noise / hz, "dforce_dz");
    for (int i = 0; i < n; ++i) compare(at.ddz_dz(i, k), (plus.dz[i] - minus.dz[i]) / (2 * hz), 1e-8 / hz, "ddz_dz");
  }
}

// force * rate = d(stored)/dt + dissipated at one point, the stored part by a central difference along the
// motion.
inline void expect_power_identity(const StrutLaw& law, double stroke, double rate, double voltage,
                                  const Eigen::VectorXd& z) {
  StrutOutput out(law.state_count());
  const StrutInput in{stroke, rate, voltage, z};
  law.evaluate(in, out);
  // [s]; the stiffest toe has d3E/dx3 = k / toe = 5e10 N/m2, so that the difference is exact to 5e10 (rate
  // h)^2 rate / 6 ~ 1e-4 W.
  const double h = 1e-8;
  const Eigen::VectorXd zp = z + h * out.dz, zm = z - h * out.dz;
  const double ep = law.stored_energy({stroke + h * rate, rate, voltage, zp});
  const double em = law.stored_energy({stroke - h * rate, rate, voltage, zm});
  const double stored_rate = (ep - em) / (2 * h);
  const double difference_noise =
      1e-15 * (1.0 + std::abs(ep)) / h;  // round-off of the difference, ten units in the last place
  EXPECT_NEAR(out.force * rate, stored_rate + dissipated(law, in),
              1e-6 * (1.0 + std::abs(out.force * rate)) + 10 * difference_noise)
      << law.kind() << " at stroke " << stroke << ", rate " << rate << ", voltage " << voltage << ", z "
      << z.transpose();
}

// A motion x(t) with its rate, and what a law does along it: inner states and energies by the classical
// Runge-Kutta rule.
struct Motion {
  std::function<double(double)> stroke, rate;
};
struct Along {
  Eigen::VectorXd z;                        // at the end
  double work = 0.0;                        // integral of force * rate [J]
  double dissipated = 0.0;                  // integral of the dissipated power [J]
  double stored_start = 0.0, stored = 0.0;  // [J]
};
// visit(t, z, work) after every step; may be empty.
inline Along drive(const StrutLaw& law, const Motion& motion, double t0, double t1, int steps, double voltage,
                   Eigen::VectorXd z, const std::function<void(double, const Eigen::VectorXd&, double)>& visit = {}) {
  const int n = law.state_count();
  StrutOutput out(n);
  Eigen::VectorXd y(n + 2);
  y << z, 0.0, 0.0;
  const auto rates = [&](double t, const Eigen::VectorXd& at) {
    const Eigen::VectorXd zt = at.head(n);
    const StrutInput in{motion.stroke(t), motion.rate(t), voltage, zt};
    law.evaluate(in, out);
    Eigen::VectorXd dy(n + 2);
    dy << out.dz, out.force * in.rate, dissipated(law, in);
    return dy;
  };
  Along result;
  result.stored_start = law.stored_energy({motion.stroke(t0), motion.rate(t0), voltage, z});
  const double h = (t1 - t0) / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = t0 + i * h;
    const Eigen::VectorXd k1 = rates(t, y), k2 = rates(t + h / 2, y + h / 2 * k1),
                          k3 = rates(t + h / 2, y + h / 2 * k2), k4 = rates(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (visit) visit(t + h, y.head(n), y[n]);
  }
  result.z = y.head(n);
  result.work = y[n];
  result.dissipated = y[n + 1];
  result.stored = law.stored_energy({motion.stroke(t1), motion.rate(t1), voltage, result.z});
  return result;
}

// A seeded smooth random motion: a sum of five sines within +- amplitude about a centre.
inline Motion random_motion(unsigned seed, double centre, double amplitude) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> phase(0.0, 6.283185307179586), frequency(2.0, 30.0);
  std::vector<std::array<double, 2>> waves;
  for (int i = 0; i < 5; ++i) waves.push_back({frequency(generator), phase(generator)});
  const double a = amplitude / 5.0;
  return {[=](double t) {
            double x = centre;
            for (const auto& w : waves) x += a * std::sin(w[0] * t + w[1]);
            return x;
          },
          [=](double t) {
            double v = 0.0;
            for (const auto& w : waves) v += a * w[0] * std::cos(w[0] * t + w[1]);
            return v;
          }};
}

}  // namespace footfall::law_checks
