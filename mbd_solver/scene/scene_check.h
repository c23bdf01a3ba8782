#pragma once
// What a complete scene must fulfil beyond types, units and ranges: names that exist, joints that close, laws that make
// sense.

#include <algorithm>
#include <functional>
#include <unordered_map>

#include "coupler/base/text.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/kind_keys.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

void check_scene(const Scene& scene, Findings& findings);

// Its parts.
void check_struts(const Scene& scene, Findings& findings);
void check_cables(const Scene& scene, Findings& findings);
void check_springs(const Scene& scene, Findings& findings);
void check_forces(const Scene& scene, Findings& findings);
void check_controllers(const Scene& scene, Findings& findings);
void check_signals(const Scene& scene, Findings& findings);
// Of a signal that another program computes (foreign/check_foreign.cpp).
void check_foreign(const Scene& scene, const SignalSpec& signal, const EntryFindings& at);
void check_requirements(const Scene& scene, Findings& findings);
void check_groups(const Scene& scene, Findings& findings);
// Codes of [accepted], each with a reason.
void check_accepted(const Scene& scene, Findings& findings);
void check_landing(const Scene& scene, Findings& findings);
void check_contact(const Scene& scene, Findings& findings);
void check_soil(const Scene& scene, Findings& findings);
// Warnings about numbers that are possible, but mostly mistakes in a unit; of a scene without errors.
void check_plausible(const Scene& scene, Findings& findings);
// The LIGGGHTS script as text: its time step, and that it couples at all.
void check_script(const Scene& scene, Findings& findings);

// ---- shared by the parts ----

inline bool is_in(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class Entry>
std::vector<std::string> names_in(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}
std::vector<std::string> boundary_names(const Scene& scene);

// One of `entries` has this name, or none was given; what: "body", plural: "bodies".
template <class Entry>
void check_known(const EntryFindings& at, const MessageCode& code, const std::string& key, const std::string& what,
                 const std::string& plural, const std::string& name, const std::vector<Entry>& entries,
                 const NameIndex& index) {
  if (!name.empty() && !index.find(entries, name))
    at.error(code, key, "unknown " + what + " \"" + name + "\"." + known_names(plural, name, names_in(entries)));
}
void check_material_name(const Scene& scene, const BodySpec& body, const EntryFindings& at);
void check_body_name(const Scene& scene, const EntryFindings& at, const std::string& key, const std::string& name);
void check_signal_name(const Scene& scene, const EntryFindings& at, const std::string& key, const std::string& name);
// Both bodies exist, at most one is the ground, and they differ; skipped where the names were not given.
void check_pair(const Scene& scene, const EntryFindings& at, const std::array<std::string, 2>& bodies);
// min < max; `within`: the keys around them, "stops.". The message gives angles in degrees.
void check_min_below_max(const EntryFindings& at, const std::string& within, double min, double max, Unit unit);
// A function of time: an amplitude has a frequency, times of a table rise.
void check_function(const EntryFindings& at, const std::string& key, const std::optional<TimeFunctionSpec>& f);

// Every function of time that the scene gives, with the entry and the key that it belongs to.
void for_each_function(const Scene& scene,
                       const std::function<void(const Source&, const std::string&, const TimeFunctionSpec&)>& visit);

// Keys of other kinds are errors where both were written in the scene itself; what: "spring".
template <class Kind>
void check_kind_keys(const EntryFindings& at, Kind kind, const std::string& what) {
  for (const std::string& key : keys_of_other_kinds(kind))
    at.error_if(at.source().written_together("kind", key), code::kKeyWithoutEffect, key,
                "has no effect on this kind of " + what + "; remove it");
}

template <class Entry>
void check_unique_names(const std::vector<Entry>& entries, const std::string& what, Findings& findings) {
  std::unordered_map<std::string, int> lines;  // of the first entry with a name
  for (const Entry& entry : entries) {
    const auto [same, is_new] = lines.emplace(entry.name, entry.source.line);
    if (!is_new && !entry.name.empty())
      findings.error(
          code::kDuplicateName, entry.source, "name",
          "is already the name of another " + what + " (line " + std::to_string(same->second) + "); names must differ");
  }
}

}  // namespace footfall
