// Controllers of the scene and the struts they drive.

#include "mbd_solver/build/codes.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/model/control/controllers.h"
#include "mbd_solver/model/control/fuzzy_controller.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {
namespace {

std::unique_ptr<Controller> build(const ControllerSpec& spec, int outputs, std::vector<std::string>& warnings) {
  switch (spec.kind) {
    case ControllerKind::kConstant: {
      ConstantControllerParameters p;
      p.period = spec.period;
      p.voltages.resize(outputs);
      for (int k = 0; k < outputs; ++k)
        p.voltages(k) = spec.voltages[spec.voltages.size() == 1 ? 0 : static_cast<std::size_t>(k)];
      return std::make_unique<ConstantController>(p);
    }
    case ControllerKind::kFuzzy: {
      FuzzyControllerParameters p;
      p.file = spec.file;
      p.period = spec.period;
      p.filter_frequency = spec.filter_frequency;
      p.tabulated = spec.tabulated;
      for (std::size_t i = 0; i < p.grid.size(); ++i) p.grid[i] = spec.grid[i];
      auto controller = std::make_unique<FuzzyController>(p);
      if (controller->table_difference())
        warnings.push_back(
            with_code(code::kTableDifference, "controller \"" + spec.name +
                                                  "\": the table differs from the exact controller by up to " +
                                                  std::to_string(*controller->table_difference())));
      return controller;
    }
    case ControllerKind::kSkyhook: {
      SkyhookControllerParameters p = spec.skyhook;
      p.outputs = outputs;
      p.period = spec.period;
      return std::make_unique<SkyhookController>(p);
    }
    case ControllerKind::kPid: {
      PidControllerParameters p = spec.pid;
      p.outputs = outputs;
      p.period = spec.period;
      p.filter_frequency = spec.filter_frequency;
      return std::make_unique<PidController>(p);
    }
  }
  FOOTFALL_DEMAND(false);
}

}  // namespace

void add_controllers(const Scene& scene, Mechanism& mechanism) {
  for (const ControllerSpec& spec : scene.controllers) {
    const int outputs = static_cast<int>(spec.outputs.size());
    ControllerEntry entry;
    entry.name = spec.name;
    entry.controller = build(spec, outputs, mechanism.warnings);
    if (entry.controller->output_count() != outputs)
      throw InputError(code::kOutputCount, place_of(scene.file, spec.source, "outputs") + "contains " +
                                               std::to_string(outputs) + " names, expected " +
                                               std::to_string(entry.controller->output_count()) +
                                               ", the outputs of the controller");
    entry.body = scene.body_index(spec.body);
    entry.touchdown_acceleration = spec.touchdown_acceleration;
    entry.touchdown_delay = spec.touchdown_delay;
    if (spec.touchdown_acceleration == 0.0 || spec.kind == ControllerKind::kConstant)
      entry.wakes_at = -std::numeric_limits<double>::infinity();
    entry.outputs = spec.outputs;
    for (int k = 0; k < outputs; ++k) {
      const int place = add_input(mechanism, 0.0);
      if (k == 0) entry.first_input = place;
    }
    entry.struts.assign(static_cast<std::size_t>(outputs), -1);
    for (std::size_t i = 0; i < scene.struts.size(); ++i)
      for (std::size_t k = 0; k < spec.outputs.size(); ++k)
        if (scene.struts[i].mr && scene.struts[i].mr->controller == spec.name + "." + spec.outputs[k])
          entry.struts[k] = static_cast<int>(i);
    mechanism.controllers.push_back(std::move(entry));
  }
}

}  // namespace footfall
