#pragma once
// What a complete scene must obey beyond types, units and ranges: names that exist, joints that close, laws that make
// sense.

#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

void check_scene(const Scene& scene, Findings& findings);

// Its parts.
void check_bodies(const Scene& scene, Findings& findings);
void check_joints(const Scene& scene, Findings& findings);
void check_initial_joints(const Scene& scene, Findings& findings);
void check_drives(const Scene& scene, Findings& findings);
void check_gears(const Scene& scene, Findings& findings);
void check_struts(const Scene& scene, Findings& findings);
void check_springs(const Scene& scene, Findings& findings);
void check_forces(const Scene& scene, Findings& findings);
void check_controllers(const Scene& scene, Findings& findings);
void check_signals(const Scene& scene, Findings& findings);
void check_contact(const Scene& scene, Findings& findings);
// Counts and sizes beyond reason.
void check_limits(const Scene& scene, Findings& findings);
// The LIGGGHTS script as text: its time step, and that it couples at all.
void check_script(const Scene& scene, Findings& findings);

// Shared by the parts.
std::vector<std::string> body_names(const Scene& scene);
// "a" and "b" exist, at most one is the ground, and they differ; skipped where the names were not given.
void check_pair(const Scene& scene, const Source& source, const std::array<std::string, 2>& bodies, Findings& findings);
void check_body_name(const Scene& scene, const Source& source, const std::string& key, const std::string& name,
                     Findings& findings);

// "signal" of an entry names one of the scene; empty: none is asked for.
void check_signal_name(const Scene& scene, const Source& source, const std::string& key, const std::string& name,
                       Findings& findings);

// The joint of this name; null, with a finding, where there is none.
const JointSpec* find_joint(const Scene& scene, const Source& source, const std::string& key, const std::string& name,
                            Findings& findings);

// min < max; `within`: what stands before these keys, "stops.". Unit::kAngle is told in degrees.
void check_min_below_max(const Source& source, const std::string& within, double min, double max, Unit unit,
                         Findings& findings);

// A function of time: an amplitude has a frequency, times of a table rise.
void check_function(const Source& source, const std::string& key, const std::optional<TimeFunctionSpec>& f,
                    Findings& findings);

template <class T>
void check_unique_names(const std::vector<T>& items, const std::string& what, Findings& findings) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (items[i].name.empty() || items[i].name != items[j].name) continue;
      findings.error(items[i].source, "name",
                     "there is already a " + what + " of this name (line " + std::to_string(items[j].source.line) +
                         "); names must differ");
      break;
    }
  }
}

}  // namespace footfall
