// The table of units and suffixes.
#include "mbd_solver/scene/units.h"

#include <map>

#include "mbd_solver/base/pi.h"

namespace footfall {

namespace {
constexpr double kStandardGravity = 9.80665;  // [m/s2]

struct UnitEntry {
  const char* name;
  std::vector<UnitSuffix> suffixes;
};

const UnitEntry& entry(Unit unit) {
  static const std::map<Unit, UnitEntry> table = {
      {Unit::kNone, {"", {}}},
      {Unit::kLength, {"m", {{"_mm", 1e-3}, {"_cm", 1e-2}}}},
      {Unit::kArea, {"m2", {{"_mm2", 1e-6}, {"_cm2", 1e-4}}}},
      {Unit::kArea2, {"m4", {{"_mm4", 1e-12}, {"_cm4", 1e-8}}}},
      {Unit::kVolume, {"m3", {{"_cm3", 1e-6}, {"_l", 1e-3}}}},
      {Unit::kAngle, {"rad", {{"_deg", kPi / 180.0}}}},
      {Unit::kTime, {"s", {{"_ms", 1e-3}, {"_us", 1e-6}}}},
      {Unit::kMass, {"kg", {{"_g", 1e-3}, {"_t", 1e3}}}},
      {Unit::kDensity, {"kg/m3", {{"_g_cm3", 1e3}}}},
      {Unit::kInertia, {"kg m2", {}}},
      {Unit::kVelocity, {"m/s", {{"_mm_s", 1e-3}, {"_km_h", 1.0 / 3.6}}}},
      {Unit::kAngularVelocity, {"rad/s", {{"_deg", kPi / 180.0}, {"_rpm", kPi / 30.0}}}},
      {Unit::kAcceleration, {"m/s2", {{"_g", kStandardGravity}}}},
      {Unit::kForce, {"N", {{"_kN", 1e3}}}},
      {Unit::kPressure, {"Pa", {{"_kPa", 1e3}, {"_MPa", 1e6}, {"_GPa", 1e9}}}},
      {Unit::kFrequency, {"Hz", {{"_kHz", 1e3}}}},
      {Unit::kStiffness, {"N/m", {{"_N_mm", 1e3}}}},
      {Unit::kDamping, {"N s/m", {}}},
      {Unit::kTurningStiffness, {"N m/rad", {{"_Nm_deg", 180.0 / kPi}}}},
      {Unit::kTurningDamping, {"N m s/rad", {}}},
      {Unit::kTorque, {"N m", {{"_Nmm", 1e-3}, {"_kNm", 1e3}}}},
  };
  return table.at(unit);
}
}  // namespace

const char* unit_name(Unit unit) { return entry(unit).name; }
const std::vector<UnitSuffix>& unit_suffixes(Unit unit) { return entry(unit).suffixes; }

}  // namespace footfall
