// The checks of how a run starts in groups, and of what is told of it: landing, requirements, accepted warnings.

#include <algorithm>
#include <unordered_set>

#include "coupler/base/text.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;

void check_groups(const Scene& scene, Findings& findings) {
  if (!scene.initial.groups) return;
  const InitialGroupsSpec& groups = *scene.initial.groups;
  const EntryFindings at(findings, scene.initial.source);
  at.error_if(groups.moving.empty() && groups.still.empty(), kMissingKey, "groups",
              "names no body; name those that stand still, or those that move");
  for (const std::string& body : groups.still)
    at.error_if(is_in(groups.moving, body), kListedTwice, "groups", "\"", body,
                "\" is both moving and still; keep one");
  for (const std::string& body : groups.moving) check_body_name(scene, at, "groups.moving", body);
  for (const std::string& body : groups.still) check_body_name(scene, at, "groups.still", body);
  at.error_if(std::all_of(scene.bodies.begin(), scene.bodies.end(),
                          [&](const BodySpec& body) { return stands_still(scene, body.name); }),
              kConflictingKeys, "groups", "leaves no body that moves; name fewer bodies that stand still");
  const auto check = [&](const auto& entries, const char* what) {
    for (const auto& entry : entries) {
      const std::string &a = entry.bodies[0], &b = entry.bodies[1];
      if (a == "ground" || b == "ground" || stands_still(scene, a) == stands_still(scene, b)) continue;
      findings.error(kConflictingKeys, entry.source, "bodies", "a ", what,
                     " joins a body of each group of initial.groups, \"", a, "\" and \"", b,
                     "\", which [initial] moves apart; put both into one group");
    }
  };
  check(scene.joints, "joint");
  check(scene.struts, "strut");
  check(scene.springs, "spring");
  for (const CableSpec& cable : scene.cables) {
    std::vector<std::string> bodies;
    for (const CableGuideSpec& guide : cable.path)
      if (guide.body != "ground") bodies.push_back(guide.body);
    for (const std::string& body : bodies)
      if (stands_still(scene, body) != stands_still(scene, bodies.front()))
        findings.error(kConflictingKeys, cable.source, "path", "runs over bodies of both groups of initial.groups, \"",
                       bodies.front(), "\" and \"", body, "\", which [initial] moves apart; put them into one group");
  }
}

void check_landing(const Scene& scene, Findings& findings) {
  if (!scene.landing) return;
  const LandingSpec& landing = *scene.landing;
  const EntryFindings at(findings, landing.source);
  check_unique_names(landing.points, "point", findings);
  for (const LandingPointSpec& point : landing.points)
    check_body_name(scene, {findings, point.source}, "body", point.body);
  check_body_name(scene, at, "base", landing.base);
  at.error_if(at.given("rest_speed") && !landing.end_at_rest, kKeyWithoutEffect, "rest_speed",
              "has no effect without end_at_rest = true; add that, or remove it");
  at.error_if(at.given("rest_time") && !landing.end_at_rest && !landing.end_when_tipped, kKeyWithoutEffect, "rest_time",
              "has no effect without end_at_rest = true or end_when_tipped = true; add one of them, or remove it");
  const std::vector<std::string> points = names_in(landing.points), bodies = boundary_names(scene);
  std::vector<std::string> known = points;
  known.insert(known.end(), bodies.begin(), bodies.end());
  std::unordered_set<std::string> seen;
  for (const std::string& pad : landing.pads) {
    at.error_if(!is_in(known, pad), kUnknownBody, "pads", "\"", pad,
                "\" is neither a body with a boundary nor a point of [[landing.points]].",
                known_names("pads", pad, known));
    at.error_if(!seen.insert(pad).second, kListedTwice, "pads", "names \"", pad, "\" twice; name each pad once");
  }
  at.error_if(scene.ground.kind == GroundKind::kNone, kNeedsOtherKey, "",
              "needs a ground, above which heights are measured; add [ground], or remove [landing]");
  at.error_if(scene.gravity.isZero(0.0), kNeedsOtherKey, "",
              "needs gravity, against which a lander tips over; give gravity, or remove [landing]");
}

void check_requirements(const Scene& scene, Findings& findings) {
  check_unique_names(scene.requirements, "requirement", findings);
  for (const RequirementSpec& r : scene.requirements) {
    const EntryFindings at(findings, r.source);
    at.missing_if(!r.least && !r.most, "most", "a requirement needs least, most, or both");
    at.error_if(r.least && r.most && *r.least > *r.most, kOutOfRange, "least", "is ", *r.least,
                ", more than most = ", *r.most, "; no value is between");
    try {
      Expression::names_in(r.value);
    } catch (const InputError& error) {
      findings.coded_error(r.source, "value", error.what());
    }
  }
}

void check_accepted(const Scene& scene, Findings& findings) {
  const EntryFindings at(findings, scene.source);
  for (const auto& [code, reason] : scene.accepted) {
    const bool is_warning =
        code.size() == 5 && code[0] == 'W' && code.find_first_not_of("0123456789", 1) == std::string::npos;
    at.error_if(!is_warning, kNoWarningCode, "accepted." + code,
                "is not the code of a warning, such as W0655; errors cannot be accepted");
    at.error_if(reason.find_first_not_of(" \t") == std::string::npos, kNoWarningCode, "accepted." + code,
                "gives no reason; write in a few words why this warning does not matter here");
  }
}

}  // namespace footfall
