// Bodies, force elements and joints by their names.

#include "mbd_solver/session/observe/carry_over.h"

#include "coupler/base/errors.h"
#include "mbd_solver/assemble/codes.h"

namespace footfall {

EndState end_state_of(const Mechanism& mechanism, const Layout& layout, const State& state) {
  const Model& model = mechanism.model;
  EndState end;
  end.time = state.time;
  end.placement = mechanism.placement;
  for (int i = 0; i < model.body_count(); ++i) {
    const std::size_t at = i;
    const int s = model.body(i).mode_count();
    end.bodies[model.body(i).name()] = {state.q.segment(layout.body_q[at], 7 + s),
                                        state.v.segment(layout.body_v[at], 6 + s)};
  }
  for (int i = 0; i < model.force_count(); ++i)
    if (const int n = model.force(i).state_count(); n > 0)
      end.elements[model.force(i).name()] = state.z.segment(layout.force_z[i], n);
  for (int j = 0; j < model.joint_count(); ++j)
    if (const int angle = layout.joint_angle[j]; angle >= 0 && angle < state.angles.size())
      end.angles[model.joint(j).name] = state.angles(angle);
  return end;
}

void carry_over(const Scene& scene, const Model& model, const Layout& layout, State& state,
                std::vector<std::string>* notes) {
  const EndState end = read_end_state(scene);
  std::string left;
  std::size_t found = 0;
  for (const auto& [name, body] : end.bodies) {
    const std::optional<int> index = model.find_body(name);
    if (!index) {
      left += (left.empty() ? "\"" : ", \"") + name + "\"";
      continue;
    }
    const std::size_t at = *index;
    const int s = model.body(*index).mode_count();
    if (body.q.size() != 7 + s || body.v.size() != 6 + s)
      refuse_end_state(scene, "body \"" + name + "\" had " + std::to_string(body.q.size() - 7) +
                                  " modes at the end of \"" + scene.initial.from + "\", but has " + std::to_string(s) +
                                  " in this scene; define it as it was there");
    state.q.segment(layout.body_q[at], 7 + s) = body.q;
    state.v.segment(layout.body_v[at], 6 + s) = body.v;
    ++found;
  }
  if (found == 0)
    refuse_end_state(scene, "no body of this scene was in \"" + scene.initial.from + "\", which has " + left +
                                "; give at least one of them the same name");
  for (int i = 0; i < model.force_count(); ++i) {
    const auto element = end.elements.find(model.force(i).name());
    const int n = model.force(i).state_count();
    if (element == end.elements.end() || element->second.size() != n) continue;
    state.z.segment(layout.force_z[i], n) = element->second;
  }
  for (int j = 0; j < model.joint_count(); ++j) {
    const int angle = layout.joint_angle[j];
    const auto given = end.angles.find(model.joint(j).name);
    if (angle >= 0 && angle < state.angles.size() && given != end.angles.end()) state.angles(angle) = given->second;
  }
  if (notes == nullptr) return;
  if (!left.empty())
    notes->push_back(with_code(code::kNotCarried, "initial.from: not carried over from \"" + scene.initial.from +
                                                      "\", because this scene has no such body: " + left));
  if (scene.ground.kind == GroundKind::kSoil)
    notes->push_back(with_code(code::kNotCarried,
                               "initial.from: prints in a soil without grains are not carried over; "
                               "the ground is as at its start"));
}

}  // namespace footfall
