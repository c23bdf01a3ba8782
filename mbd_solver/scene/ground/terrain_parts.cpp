// The surface of the ground from its numbers: waves of a random spectrum and rocks of random places come from their seeds, the
// same on every machine.

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <utility>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/resolve.h"

namespace footfall {
namespace {

constexpr double kPeriods = 6.0;  // longest waves in a period of a random surface
constexpr int kRoughWaves = 64;   // of a random surface
constexpr int kRockSizes = 400;   // of the table of diameters
constexpr int kRockTries = 60;    // places at which a rock looks for room

// splitmix64 [Steele, Lea and Flood, OOPSLA 2014].
class Draws {
 public:
  explicit Draws(int seed) : state_(static_cast<std::uint64_t>(seed)) {}
  double number() {  // from 0 to below 1
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
  }

 private:
  std::uint64_t state_;
};

// Bands of equal ratio; the mean square of each is in proportion to the integral of k^-2(H + 1) k over it; the sum
// of all over a period is height^2.
void add_roughness(const RoughnessSpec& r, std::vector<GroundWave>& waves) {
  if (r.height == 0.0) return;
  Draws draws(r.seed);
  const double low = 2.0 * kPi / r.longest, ratio = r.longest / r.shortest, H = r.hurst;
  const auto edge = [&](int i) { return low * std::pow(ratio, static_cast<double>(i) / kRoughWaves); };
  std::vector<double> square(kRoughWaves);
  double sum = 0.0;
  for (int i = 0; i < kRoughWaves; ++i) {
    const double a = edge(i), b = edge(i + 1);
    square[i] = H < 1e-9 ? std::log(b / a) : std::pow(a / low, -2.0 * H) - std::pow(b / low, -2.0 * H);
    sum += square[i];
  }
  // All waves fit into a square of this side, which is periodic: a wave of amplitude 0 gives it to Terrain.
  const double quantum = low / kPeriods;
  waves.push_back({{quantum, 0.0}, 0.0, 0.0});
  for (int i = 0; i < kRoughWaves; ++i) {
    const double k = edge(i) * std::pow(ratio, draws.number() / kRoughWaves), angle = 2.0 * kPi * draws.number();
    GroundWave wave;
    wave.k = {quantum * std::round(k * std::cos(angle) / quantum), quantum * std::round(k * std::sin(angle) / quantum)};
    wave.amplitude = r.height * std::sqrt(2.0 * square[i] / sum);
    wave.phase = 2.0 * kPi * draws.number();
    waves.push_back(wave);
  }
  // Rounding gives some waves the same vector, or the opposite one; they add up to one wave: a sin(k x + p).
  std::map<std::pair<long, long>, std::complex<double>> distinct;
  for (auto wave = waves.end() - kRoughWaves; wave != waves.end(); ++wave) {
    const std::pair<long, long> at = {std::lround(wave->k.x() / quantum), std::lround(wave->k.y() / quantum)};
    const bool opposite = at < std::pair<long, long>(0, 0);
    distinct[opposite ? std::pair{-at.first, -at.second} : at] +=
        std::polar(wave->amplitude, opposite ? kPi - wave->phase : wave->phase);
  }
  double mean_square = 0.0;
  for (const auto& [at, amplitude] : distinct) mean_square += 0.5 * std::norm(amplitude);
  for (auto wave = waves.end() - kRoughWaves; wave != waves.end(); ++wave)
    wave->amplitude *= r.height / std::sqrt(mean_square);
}

// Rocks of the law in RockFieldSpec: a Poisson process; the largest take their places first, apart from others where there is
// room. Those in the keep-out are left out.
void add_rock_field(const RockFieldSpec& f, std::vector<Rock>& rocks) {
  if (!(f.abundance > 0.0)) return;
  Draws draws(f.seed);
  const double mean = expected_rocks(f), q = 1.79 + 0.152 / f.abundance;
  int count = -1;
  for (double sum = 0.0; sum < mean; ++count) sum -= std::log(1.0 - draws.number());
  std::vector<double> D(kRockSizes + 1), above(kRockSizes + 1, 0.0);  // rocks larger than D, up to a factor
  for (int i = 0; i <= kRockSizes; ++i)
    D[i] = f.smallest * std::pow(f.largest / f.smallest, static_cast<double>(i) / kRockSizes);
  for (std::size_t i = kRockSizes; i-- > 0;) {
    const auto density = [&](double d) { return std::exp(-q * d) / (d * d); };
    const double middle = 0.5 * (D[i] + D[i + 1]);
    above[i] = above[i + 1] + (D[i + 1] - D[i]) / 6.0 * (density(D[i]) + 4.0 * density(middle) + density(D[i + 1]));
  }
  std::vector<double> sizes;
  for (int k = 0; k < count; ++k) {
    const double target = above[0] * draws.number();
    std::size_t i = 0;
    while (i + 1 < kRockSizes && above[i + 1] > target) ++i;
    sizes.push_back(D[i] + (D[i + 1] - D[i]) * (above[i] - target) / (above[i] - above[i + 1]));
  }
  std::sort(sizes.rbegin(), sizes.rend());
  const std::size_t first = rocks.size();
  for (const double size : sizes) {
    Rock rock{{0.0, 0.0}, 0.5 * size, f.buried};
    for (int t = 0; t < kRockTries; ++t) {
      const double u = draws.number(), v = draws.number();
      rock.place = {f.x + (u - 0.5) * f.size[0], f.y + (v - 0.5) * f.size[1]};
      const bool room = std::none_of(rocks.begin() + first, rocks.end(), [&](const Rock& other) {
        return (other.place - rock.place).norm() < other.radius + rock.radius;
      });
      if (room) break;
    }
    if ((rock.place - Eigen::Vector2d(f.keep_out_x, f.keep_out_y)).norm() < f.keep_out + rock.radius &&
        f.keep_out > 0.0)
      continue;
    rocks.push_back(rock);
  }
}

}  // namespace

std::shared_ptr<Terrain> terrain_of(const TerrainSpec& spec) {
  TerrainParts parts;
  parts.origin = spec.position;
  parts.slope = -std::tan(spec.slope) * Eigen::Vector2d(std::cos(spec.azimuth), std::sin(spec.azimuth));
  if (spec.map) parts.map = spec.map->grid;
  for (const CraterSpec& c : spec.craters)
    parts.craters.push_back({{c.x, c.y}, 0.5 * c.diameter, c.depth, c.rim_height});
  for (const WaveSpec& w : spec.waves) {
    if (w.height == 0.0) continue;
    const double k = 2.0 * kPi / w.length;
    parts.waves.push_back({k * Eigen::Vector2d(std::cos(w.azimuth), std::sin(w.azimuth)), 0.5 * w.height, w.phase});
  }
  if (spec.roughness) add_roughness(*spec.roughness, parts.waves);
  for (const RockSpec& r : spec.rocks) parts.rocks.push_back({{r.x, r.y}, 0.5 * r.diameter, r.buried});
  if (spec.rock_field) add_rock_field(*spec.rock_field, parts.rocks);
  return std::make_shared<Terrain>(std::move(parts));
}

}  // namespace footfall
