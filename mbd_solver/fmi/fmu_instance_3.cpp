// FMI 3.0: inputs, a step, outputs. Events are left to the FMU (eventModeUsed is false); a step that returns early is continued.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "coupler/base/text.h"
#include "mbd_solver/fmi/fmi3_interface.h"
#include "mbd_solver/fmi/fmu_instance.h"

namespace footfall {
namespace {

constexpr int kMostReturns = 100000;  // early ones in a step

void log_message_3(fmi3InstanceEnvironment log, fmi3Status status, fmi3String, fmi3String message) {
  if (log && message && status != fmi3OK) static_cast<FmuLog*>(log)->add(message);
}

const char* name_of_status(fmi3Status status) {
  constexpr const char* kNames[] = {"fmi3OK", "fmi3Warning", "fmi3Discard", "fmi3Error", "fmi3Fatal"};
  return status >= fmi3OK && status <= fmi3Fatal ? kNames[status] : "an unknown status";
}

class Instance3 final : public FmuInstance {
 public:
  Instance3(const FmuDescription& description, const std::string& folder, bool sets_structure)
      : description_(description),
        resources_(folder + "/resources/"),
        library_(description, folder),
        sets_structure_(sets_structure) {}
  ~Instance3() override {
    if (instance_) library_.function<fmi3FreeInstanceTYPE>("fmi3FreeInstance")(instance_);
  }

  void begin(double time, const std::function<void()>& structure, const std::function<void()>& at_start,
             const std::function<void()>& inputs) override {
    if (instance_) library_.function<fmi3FreeInstanceTYPE>("fmi3FreeInstance")(instance_);
    instance_ = library_.function<fmi3InstantiateCoSimulationTYPE>("fmi3InstantiateCoSimulation")(
        "footfall", description_.token.c_str(), resources_.c_str(), false, false, false, false, nullptr, 0, &log_,
        log_message_3, nullptr);
    if (!instance_) throw FmuError("fmi3InstantiateCoSimulation made no instance" + log_.last());
    if (sets_structure_) {
      mode("fmi3EnterConfigurationMode");
      structure();
      mode("fmi3ExitConfigurationMode");
    }
    at_start();
    check(library_.function<fmi3EnterInitializationModeTYPE>("fmi3EnterInitializationMode")(instance_, false, 0.0, time,
                                                                                            false, 0.0),
          "fmi3EnterInitializationMode");
    inputs();
    mode("fmi3ExitInitializationMode");
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
        throw FmuError("it asks for the end of the simulation at " + number_text(last, 9) + " s" + log_.last());
      if (!early) return;
      if (!(last > time) && returns > 0)
        throw FmuError("fmi3DoStep returned early at " + number_text(last, 9) + " s without having moved");
      if (returns > kMostReturns) throw FmuError("fmi3DoStep returned early without end in one step");
      time = std::max(time, last);
    }
  }

  void set(const FmuVariable& v, const std::vector<double>& values) override {
    const std::string& type = v.type;
    if (type == "Float64") return set_as<fmi3Float64>(v, values);
    if (type == "Float32") return set_as<fmi3Float32>(v, values);
    if (type == "Int8") return set_as<fmi3Int8>(v, values);
    if (type == "UInt8") return set_as<fmi3UInt8>(v, values);
    if (type == "Int16") return set_as<fmi3Int16>(v, values);
    if (type == "UInt16") return set_as<fmi3UInt16>(v, values);
    if (type == "Int32") return set_as<fmi3Int32>(v, values);
    if (type == "UInt32") return set_as<fmi3UInt32>(v, values);
    if (type == "Int64" || type == "Enumeration") return set_as<fmi3Int64>(v, values, "Int64");
    if (type == "UInt64") return set_as<fmi3UInt64>(v, values);
    if (type == "Boolean") return set_as<fmi3Boolean>(v, values);
    throw FmuError("its variable \"" + v.name + "\" is of the type " + type + ", which cannot be set");
  }

  std::vector<double> get(const FmuVariable& v, std::size_t count) override {
    const std::string& type = v.type;
    if (type == "Float64") return get_as<fmi3Float64>(v, count);
    if (type == "Float32") return get_as<fmi3Float32>(v, count);
    if (type == "Int8") return get_as<fmi3Int8>(v, count);
    if (type == "UInt8") return get_as<fmi3UInt8>(v, count);
    if (type == "Int16") return get_as<fmi3Int16>(v, count);
    if (type == "UInt16") return get_as<fmi3UInt16>(v, count);
    if (type == "Int32") return get_as<fmi3Int32>(v, count);
    if (type == "UInt32") return get_as<fmi3UInt32>(v, count);
    if (type == "Int64" || type == "Enumeration") return get_as<fmi3Int64>(v, count, "Int64");
    if (type == "UInt64") return get_as<fmi3UInt64>(v, count);
    if (type == "Boolean") return get_as<fmi3Boolean>(v, count);
    throw FmuError("its variable \"" + v.name + "\" is of the type " + type + ", which cannot be read");
  }

  void set_text(const FmuVariable& v, const std::string& value) override {
    const fmi3ValueReference reference = v.reference;
    const fmi3String text = value.c_str();
    check(library_.function<fmi3SetStringTYPE>("fmi3SetString")(instance_, &reference, 1, &text, 1), "fmi3SetString");
  }

  std::string state() override {
    fmi3FMUState state = nullptr;
    check(library_.function<fmi3GetFMUStateTYPE>("fmi3GetFMUState")(instance_, &state), "fmi3GetFMUState");
    std::size_t size = 0;
    check(library_.function<fmi3SerializedFMUStateSizeTYPE>("fmi3SerializedFMUStateSize")(instance_, state, &size),
          "fmi3SerializedFMUStateSize");
    std::string bytes(size, '\0');
    check(library_.function<fmi3SerializeFMUStateTYPE>("fmi3SerializeFMUState")(
              instance_, state, reinterpret_cast<fmi3Byte*>(bytes.data()), size),
          "fmi3SerializeFMUState");
    check(library_.function<fmi3FreeFMUStateTYPE>("fmi3FreeFMUState")(instance_, &state), "fmi3FreeFMUState");
    return bytes;
  }

  void restore(const std::string& bytes) override {
    fmi3FMUState state = nullptr;
    check(library_.function<fmi3DeserializeFMUStateTYPE>("fmi3DeserializeFMUState")(
              instance_, reinterpret_cast<const fmi3Byte*>(bytes.data()), bytes.size(), &state),
          "fmi3DeserializeFMUState");
    check(library_.function<fmi3SetFMUStateTYPE>("fmi3SetFMUState")(instance_, state), "fmi3SetFMUState");
    check(library_.function<fmi3FreeFMUStateTYPE>("fmi3FreeFMUState")(instance_, &state), "fmi3FreeFMUState");
  }

 private:
  void check(fmi3Status status, const char* function) {
    if (status == fmi3OK || status == fmi3Warning) return;
    throw FmuError(std::string(function) + " returned " + name_of_status(status) + log_.last());
  }
  void mode(const char* function) { check(library_.function<fmi3ModeTYPE>(function)(instance_), function); }

  template <class Value>
  void set_as(const FmuVariable& v, const std::vector<double>& values, const char* type = nullptr) {
    const std::unique_ptr<Value[]> list(new Value[values.size()]);
    for (std::size_t i = 0; i < values.size(); ++i) list[i] = value_as<Value>(v, values[i]);
    const fmi3ValueReference reference = v.reference;
    const std::string name = std::string("fmi3Set") + (type ? type : v.type);
    check(library_.function<fmi3SetTYPE<Value>>(name)(instance_, &reference, 1, list.get(), values.size()),
          name.c_str());
  }
  template <class Value>
  std::vector<double> get_as(const FmuVariable& v, std::size_t count, const char* type = nullptr) {
    const std::unique_ptr<Value[]> list(new Value[count]());
    const fmi3ValueReference reference = v.reference;
    const std::string name = std::string("fmi3Get") + (type ? type : v.type);
    check(library_.function<fmi3GetTYPE<Value>>(name)(instance_, &reference, 1, list.get(), count), name.c_str());
    return {list.get(), list.get() + count};
  }

  const FmuDescription& description_;
  std::string resources_;
  FmuLibrary library_;
  FmuLog log_;
  fmi3Instance instance_ = nullptr;
  bool sets_structure_;
};

}  // namespace

std::unique_ptr<FmuInstance> make_instance_3(const FmuDescription& description, const std::string& folder,
                                             bool sets_structure) {
  return std::make_unique<Instance3>(description, folder, sets_structure);
}

}  // namespace footfall
