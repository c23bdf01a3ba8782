#include "mbd_solver/cli/analysis/bed_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>

#include "mbd_solver/cli/grains/bed_frames.h"
#include "mbd_solver/cli/grains/bed_measures.h"

namespace footfall {
namespace {

constexpr double kFirstContact = 0.1;  // span over which impulses are compared [s]
constexpr int kRings = 30;             // of the crater's profile, each as wide as the smallest grain

std::string text(const char* format, ...) {
  char buffer[600];
  va_list words;
  va_start(words, format);
  std::vsnprintf(buffer, sizeof buffer, format, words);
  va_end(words);
  return buffer;
}

double first_contact(const ComparedBody& body) {
  for (std::size_t k = 0; k < body.time.size(); ++k)
    if (body.force[k].norm() > 0.0) return k > 0 ? body.time[k - 1] : body.time[0];
  return std::numeric_limits<double>::infinity();
}

Eigen::Vector3d impulse(const ComparedBody& body, double from, double to) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double before = 0.0;
  for (std::size_t k = 0; k < body.time.size(); ++k) {
    const double begin = std::max(before, from), end = std::min(body.time[k], to);
    if (end > begin) sum += (end - begin) * body.force[k];
    before = body.time[k];
  }
  return sum;
}

double peak(const ComparedBody& body) {
  double largest = 0.0;
  for (const Eigen::Vector3d& f : body.force) largest = std::max(largest, f.norm());
  return largest;
}

Eigen::Vector3d place_at(const SurfacePath& surface, double t) {
  const auto after = std::lower_bound(surface.time.begin(), surface.time.end(), t - 1e-12);
  const auto k = static_cast<std::size_t>(
      std::min<std::ptrdiff_t>(after - surface.time.begin(), static_cast<std::ptrdiff_t>(surface.time.size()) - 1));
  return surface.place[k];
}

double mean_packing(const BedFrame& bed, const std::vector<SurfacePath>& surfaces, double t) {
  double sum = 0.0;
  for (const SurfacePath& surface : surfaces)
    sum += packing_fraction(bed, place_at(surface, t), 0.8 * surface.radius, surface.radius) /
           static_cast<double>(surfaces.size());
  return sum;
}

void compare_forces(const ComparedRun& a, const ComparedRun& b, const std::vector<SurfacePath>& surfaces,
                    Comparison& result) {
  result.table += text("impulse of the grains, first %.2g s of contact\n  %-16s %14s %14s %11s   peak force\n",
                       kFirstContact, "body", a.label.c_str(), b.label.c_str(), "difference");
  Eigen::Vector3d all_a = Eigen::Vector3d::Zero(), all_b = all_a;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const double begin = std::min(first_contact(a.bodies[i]), first_contact(b.bodies[i]));
    const double common = std::min(a.bodies[i].time.back(), b.bodies[i].time.back());
    if (!(begin < common)) {
      result.table += text("  %-16s no contact\n", surfaces[i].body.c_str());
      continue;
    }
    const double end = std::min(begin + kFirstContact, common);
    const Eigen::Vector3d J_a = impulse(a.bodies[i], begin, end), J_b = impulse(b.bodies[i], begin, end);
    const double difference = (J_a - J_b).norm() / std::max(J_a.norm(), 1e-300);
    result.worst_impulse = std::max(result.worst_impulse, difference);
    all_a += J_a;
    all_b += J_b;
    result.table += text("  %-16s %10.4g N s %10.4g N s %9.2f %%   %.4g and %.4g N\n", surfaces[i].body.c_str(),
                         J_a.norm(), J_b.norm(), 100.0 * difference, peak(a.bodies[i]), peak(b.bodies[i]));
  }
  if (surfaces.size() > 1 && all_a.norm() > 0.0)
    result.table += text("  %-16s %10.4g N s %10.4g N s %9.2f %%\n", "all together", all_a.norm(), all_b.norm(),
                         100.0 * (all_a - all_b).norm() / all_a.norm());
  result.forces = "time";
  for (const SurfacePath& surface : surfaces)
    result.forces += "," + surface.body + " " + a.label + "," + surface.body + " " + b.label;
  result.forces += "\n";
  if (surfaces.empty()) return;
  // At the first run's windows; the other's impulse over each of them.
  double before = 0.0;
  for (std::size_t k = 0; k < a.bodies[0].time.size(); ++k) {
    const double t = a.bodies[0].time[k];
    if (t <= before || t > b.bodies[0].time.back() + 1e-12) continue;
    result.forces += text("%.9g", t);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      result.forces += text(",%.7g,%.7g", impulse(a.bodies[i], before, t).norm() / (t - before),
                            impulse(b.bodies[i], before, t).norm() / (t - before));
    result.forces += "\n";
    before = t;
  }
}

void compare_profiles(const BedFrame& bed_a, const BedFrame& bed_b, const ComparedRun& a, const ComparedRun& b,
                      const SurfacePath& surface, double t, Comparison& result) {
  const double width = 2.0 * *std::min_element(bed_a.radius.begin(), bed_a.radius.end());
  const Eigen::Vector2d centre = place_at(surface, t).head<2>();
  const std::vector<double> p_a = surface_profile(bed_a, centre, width, kRings),
                            p_b = surface_profile(bed_b, centre, width, kRings);
  result.profile = "distance," + a.label + "," + b.label + "\n";
  double sum = 0.0, deepest_a = std::numeric_limits<double>::infinity(), deepest_b = deepest_a;
  int count = 0;
  for (int k = 0; k < kRings; ++k) {
    const double z_a = p_a[static_cast<std::size_t>(k)], z_b = p_b[static_cast<std::size_t>(k)];
    if (std::isnan(z_a) || std::isnan(z_b)) continue;
    result.profile += text("%.6g,%.6g,%.6g\n", (k + 0.5) * width, z_a, z_b);
    sum += std::abs(z_a - z_b);
    deepest_a = std::min(deepest_a, z_a);
    deepest_b = std::min(deepest_b, z_b);
    ++count;
  }
  if (count > 0)
    result.table += text(
        "crater around %s at %.3g s: lowest ring at %.4g and %.4g m, rings differ by %.2g m in the mean (a grain is "
        "%.2g m)\n",
        surface.body.c_str(), t, deepest_a, deepest_b, sum / count, width);
}

}  // namespace

Comparison compare_beds(const ComparedRun& a, const ComparedRun& b, const std::vector<SurfacePath>& surfaces,
                        double dt) {
  Comparison result;
  compare_forces(a, b, surfaces, result);
  const std::map<long, std::string> frames_a = find_bed_frames(a.frames), frames_b = find_bed_frames(b.frames);
  result.beds = "time";
  for (const char* figure : {"kinetic energy", "coordination number", "packing", "displacement"})
    result.beds += std::string(",") + figure + " " + a.label + "," + figure + " " + b.label;
  result.beds += ",apart median,apart largest,share apart\n";
  BedFrame start_a, start_b, last_a, last_b;
  double last = 0.0, first_grain = -1.0, one_in_hundred = -1.0;
  std::string rows;
  for (const auto& [step, file_a] : frames_a) {
    const auto same = frames_b.find(step);
    if (same == frames_b.end()) continue;
    last_a = read_bed_frame(file_a);
    last_b = read_bed_frame(same->second);
    if (!result.has_beds) start_a = last_a, start_b = last_b;
    result.has_beds = true;
    const double t = static_cast<double>(step) * dt;
    const Separation apart = separation(last_a, last_b);
    const double numbers[11] = {kinetic_energy(last_a),
                                kinetic_energy(last_b),
                                coordination_number(last_a),
                                coordination_number(last_b),
                                mean_packing(last_a, surfaces, t),
                                mean_packing(last_b, surfaces, t),
                                separation(start_a, last_a).mean,
                                separation(start_b, last_b).mean,
                                apart.median,
                                apart.largest,
                                apart.share_apart};
    result.beds += text("%.9g", t);
    for (const double value : numbers) result.beds += text(",%.7g", value);
    result.beds += "\n";
    rows += text("  %-7.4g %10.4g %10.4g   %6.3f %6.3f   %6.4f %6.4f   %9.3g %9.3g   %9.2g %9.2g %8.3f\n", t,
                 numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5], numbers[6], numbers[7],
                 numbers[8], numbers[9], 100.0 * numbers[10]);
    if (first_grain < 0.0 && apart.share_apart > 0.0) first_grain = t;
    if (one_in_hundred < 0.0 && apart.share_apart > 0.01) one_in_hundred = t;
    last = t;
  }
  if (!result.has_beds) {
    result.table +=
        "the runs dumped their grains at no common step: nothing to say of the beds (dump id x y z vx vy vz radius)\n";
    return result;
  }
  result.table +=
      text("\nbeds: %s and %s\n  %-7s %21s   %13s   %13s   %19s   %s\n  %-7s %21s   %13s   %13s   %19s   %s\n",
           a.label.c_str(), b.label.c_str(), "time", "kinetic energy", "neighbours", "packing", "displacement",
           "same grains apart by", "[s]", "[J/kg]", "nearer than 1%", "under bodies", "mean [m]",
           "median, largest [m], % over r/10");
  result.table += rows;
  if (!surfaces.empty()) compare_profiles(last_a, last_b, a, b, surfaces.front(), last, result);
  if (first_grain < 0.0) {
    result.table += text("no grain is a tenth of its radius apart until %.3g s\n", last);
  } else {
    result.table +=
        text("chaos: the first grain is a tenth of its radius apart at %.3g s, one in a hundred ", first_grain);
    result.table += one_in_hundred < 0.0 ? text("not until %.3g s\n", last) : text("at %.3g s\n", one_in_hundred);
  }
  return result;
}

}  // namespace footfall
