// FMI 3.0: inputs, a step, outputs. Events are left to the FMU (eventModeUsed is false); a step that returns early is continued.

#include <algorithm>
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/fmi/fmi3_interface.h"
#include "mbd_solver/fmi/fmu_instance.h"

namespace footfall {
namespace {

constexpr int kMostReturns = 100000;  // early ones in a step

void log_message_3(fmi3InstanceEnvironment log, fmi3Status status, fmi3String, fmi3String message) {
  if (log && message && status != fmi3OK) static_cast<FmuLog*>(log)->add(message);
}

struct Fmi3 {
  using Status = fmi3Status;
  using Byte = fmi3Byte;
  static constexpr const char *kPrefix = "fmi3", *kState = "FMUState", *kDeserialize = "Deserialize";
};

class Instance3 final : public FmuInstanceOf<Fmi3> {
 public:
  Instance3(const FmuDescription& description, const std::string& folder, bool sets_structure)
      : FmuInstanceOf(description, folder), resources_(folder + "/resources/"), sets_structure_(sets_structure) {}

  void begin(double time, const std::function<void()>& structure, const std::function<void()>& at_start,
             const std::function<void()>& inputs) override {
    free();
    take(library_.function<fmi3InstantiateCoSimulationTYPE>("fmi3InstantiateCoSimulation")(
             "footfall", description_.token.c_str(), resources_.c_str(), false, false, false, false, nullptr, 0, &log_,
             log_message_3, nullptr),
         "InstantiateCoSimulation");
    if (sets_structure_) {
      mode("EnterConfigurationMode");
      structure();
      mode("ExitConfigurationMode");
    }
    at_start();
    call<fmi3EnterInitializationModeTYPE>("EnterInitializationMode", false, 0.0, time, false, 0.0);
    inputs();
    mode("ExitInitializationMode");
  }

  void step(double from, double to) override {
    const auto do_step = library_.function<fmi3DoStepTYPE>("fmi3DoStep");
    const double end = to - 1e-12 * std::max(std::abs(to), to - from);
    double time = from;
    for (int returns = 0; time < end; ++returns) {
      fmi3Boolean events = false, terminate = false, early = false;
      fmi3Float64 last = to;
      const fmi3Status status = do_step(instance_, time, to - time, true, &events, &terminate, &early, &last);
      if (status == fmi3Discard)
        throw FmuError("fmi3DoStep discarded the step from " + number_text(time, 9) + " s to " + number_text(to, 9) +
                       " s" + log_.last());
      check(status, "fmi3DoStep");
      if (terminate)
        throw FmuError("it requests the end of the simulation at " + number_text(last, 9) + " s" + log_.last());
      if (!early) return;
      if (!(last > time) && returns > 0)
        throw FmuError("fmi3DoStep returned early at " + number_text(last, 9) + " s without having moved");
      if (returns > kMostReturns) throw FmuError("fmi3DoStep returned early without end in one step");
      time = std::max(time, last);
    }
  }

  void set(const FmuVariable& v, const std::vector<double>& values) override {
    by_type(v, "set", [&](auto value, const std::string& type) { set_as<decltype(value)>(v, values, type); });
  }

  std::vector<double> get(const FmuVariable& v, std::size_t count) override {
    std::vector<double> values;
    by_type(v, "read", [&](auto value, const std::string& type) { values = get_as<decltype(value)>(v, count, type); });
    return values;
  }

  void set_text(const FmuVariable& v, const std::string& value) override {
    const fmi3ValueReference reference = v.reference;
    const fmi3String text = value.c_str();
    call<fmi3SetStringTYPE>("SetString", &reference, 1, &text, 1);
  }

 private:
  // use(value of its type, name of the type in functions)
  template <class Use>
  static void by_type(const FmuVariable& v, const char* what, const Use& use) {
    const std::string& type = v.type;
    if (type == "Float64") return use(fmi3Float64(), type);
    if (type == "Float32") return use(fmi3Float32(), type);
    if (type == "Int8") return use(fmi3Int8(), type);
    if (type == "UInt8") return use(fmi3UInt8(), type);
    if (type == "Int16") return use(fmi3Int16(), type);
    if (type == "UInt16") return use(fmi3UInt16(), type);
    if (type == "Int32") return use(fmi3Int32(), type);
    if (type == "UInt32") return use(fmi3UInt32(), type);
    if (type == "Int64" || type == "Enumeration") return use(fmi3Int64(), "Int64");
    if (type == "UInt64") return use(fmi3UInt64(), type);
    if (type == "Boolean") return use(fmi3Boolean(), type);
    throw FmuError("its variable \"" + v.name + "\" is of the type " + type + ", which cannot be " + what);
  }
  template <class Value>
  void set_as(const FmuVariable& v, const std::vector<double>& values, const std::string& type) {
    const std::unique_ptr<Value[]> list(new Value[values.size()]);
    for (std::size_t i = 0; i < values.size(); ++i) list[i] = value_as<Value>(v, values[i]);
    const fmi3ValueReference reference = v.reference;
    call<fmi3SetTYPE<Value>>("Set" + type, &reference, 1, list.get(), values.size());
  }
  template <class Value>
  std::vector<double> get_as(const FmuVariable& v, std::size_t count, const std::string& type) {
    const std::unique_ptr<Value[]> list(new Value[count]());
    const fmi3ValueReference reference = v.reference;
    call<fmi3GetTYPE<Value>>("Get" + type, &reference, 1, list.get(), count);
    return {list.get(), list.get() + count};
  }

  std::string resources_;
  bool sets_structure_;
};

}  // namespace

std::unique_ptr<FmuInstance> make_instance_3(const FmuDescription& description, const std::string& folder,
                                             bool sets_structure) {
  return std::make_unique<Instance3>(description, folder, sets_structure);
}

}  // namespace footfall
