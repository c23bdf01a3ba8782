// FMI 2.0: inputs, a step, outputs. A step that the FMU has not done whole is an error, as its inputs are then unknown.

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "coupler/base/text.h"
#include "mbd_solver/fmi/fmi2_interface.h"
#include "mbd_solver/fmi/fmu_instance.h"

namespace footfall {
namespace {

void log_message_2(fmi2ComponentEnvironment log, fmi2String, fmi2Status status, fmi2String, fmi2String message, ...) {
  if (!log || !message || status == fmi2OK) return;
  char text[1000];
  va_list values;
  va_start(values, message);
  std::vsnprintf(text, sizeof text, message, values);
  va_end(values);
  static_cast<FmuLog*>(log)->add(text);
}

const char* name_of_status(fmi2Status status) {
  constexpr const char* kNames[] = {"fmi2OK", "fmi2Warning", "fmi2Discard", "fmi2Error", "fmi2Fatal", "fmi2Pending"};
  return status >= fmi2OK && status <= fmi2Pending ? kNames[status] : "an unknown status";
}

// A folder as a URI: RFC 3986.
std::string uri_of(const std::string& path) {
  std::string uri = "file://";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || std::strchr("/-_.~", c) != nullptr) {
      uri += c;
    } else {
      char code[4];
      std::snprintf(code, sizeof code, "%%%02X", byte);
      uri += code;
    }
  }
  return uri;
}

class Instance2 final : public FmuInstance {
 public:
  Instance2(const FmuDescription& description, const std::string& folder)
      : description_(description), resources_(uri_of(folder + "/resources")), library_(description, folder) {
    callbacks_ = {log_message_2, std::calloc, std::free, nullptr, &log_};
  }
  ~Instance2() override {
    if (instance_) library_.function<fmi2FreeInstanceTYPE>("fmi2FreeInstance")(instance_);
  }

  void begin(double time, const std::function<void()>&, const std::function<void()>& at_start,
             const std::function<void()>& inputs) override {
    if (instance_) library_.function<fmi2FreeInstanceTYPE>("fmi2FreeInstance")(instance_);
    instance_ = library_.function<fmi2InstantiateTYPE>("fmi2Instantiate")(
        "footfall", fmi2CoSimulation, description_.token.c_str(), resources_.c_str(), &callbacks_, 0, 0);
    if (!instance_) throw FmuError("fmi2Instantiate made no instance" + log_.last());
    check(library_.function<fmi2SetupExperimentTYPE>("fmi2SetupExperiment")(instance_, 0, 0.0, time, 0, 0.0),
          "fmi2SetupExperiment");
    at_start();
    mode("fmi2EnterInitializationMode");
    inputs();
    mode("fmi2ExitInitializationMode");
  }

  void step(double from, double to) override {
    const fmi2Status status = library_.function<fmi2DoStepTYPE>("fmi2DoStep")(instance_, from, to - from, 1);
    if (status == fmi2Discard) {
      fmi2Real last = from;
      fmi2Boolean terminated = 0;
      if (const auto ask = library_.find("fmi2GetRealStatus"))
        reinterpret_cast<fmi2GetRealStatusTYPE*>(ask)(instance_, fmi2LastSuccessfulTime, &last);
      if (const auto ask = library_.find("fmi2GetBooleanStatus"))
        reinterpret_cast<fmi2GetBooleanStatusTYPE*>(ask)(instance_, fmi2Terminated, &terminated);
      if (terminated != 0)
        throw FmuError("it asks for the end of the simulation at " + number_text(last, 9) + " s" + log_.last());
      throw FmuError("fmi2DoStep discarded the step from " + number_text(from, 9) + " s to " + number_text(to, 9) +
                     " s; it got to " + number_text(last, 9) + " s" + log_.last());
    }
    check(status, "fmi2DoStep");
  }

  void set(const FmuVariable& v, const std::vector<double>& values) override {
    const fmi2ValueReference reference = v.reference;
    if (v.type == "Real") {
      const fmi2Real value = values[0];
      check(library_.function<fmi2SetTYPE<fmi2Real>>("fmi2SetReal")(instance_, &reference, 1, &value), "fmi2SetReal");
    } else if (v.type == "Boolean") {
      const fmi2Boolean value = values[0] != 0.0 ? 1 : 0;
      check(library_.function<fmi2SetTYPE<fmi2Boolean>>("fmi2SetBoolean")(instance_, &reference, 1, &value),
            "fmi2SetBoolean");
    } else {
      const fmi2Integer value = value_as<fmi2Integer>(v, values[0]);
      check(library_.function<fmi2SetTYPE<fmi2Integer>>("fmi2SetInteger")(instance_, &reference, 1, &value),
            "fmi2SetInteger");
    }
  }

  std::vector<double> get(const FmuVariable& v, std::size_t) override {
    const fmi2ValueReference reference = v.reference;
    if (v.type == "Real") {
      fmi2Real value = 0.0;
      check(library_.function<fmi2GetTYPE<fmi2Real>>("fmi2GetReal")(instance_, &reference, 1, &value), "fmi2GetReal");
      return {value};
    }
    const bool flag = v.type == "Boolean";
    const char* const name = flag ? "fmi2GetBoolean" : "fmi2GetInteger";
    int value = 0;
    check(library_.function<fmi2GetTYPE<int>>(name)(instance_, &reference, 1, &value), name);
    return {flag ? (value != 0 ? 1.0 : 0.0) : static_cast<double>(value)};
  }

  void set_text(const FmuVariable& v, const std::string& value) override {
    const fmi2ValueReference reference = v.reference;
    const fmi2String text = value.c_str();
    check(library_.function<fmi2SetStringTYPE>("fmi2SetString")(instance_, &reference, 1, &text), "fmi2SetString");
  }

  std::string state() override {
    fmi2FMUstate state = nullptr;
    check(library_.function<fmi2GetFMUstateTYPE>("fmi2GetFMUstate")(instance_, &state), "fmi2GetFMUstate");
    std::size_t size = 0;
    check(library_.function<fmi2SerializedFMUstateSizeTYPE>("fmi2SerializedFMUstateSize")(instance_, state, &size),
          "fmi2SerializedFMUstateSize");
    std::string bytes(size, '\0');
    check(library_.function<fmi2SerializeFMUstateTYPE>("fmi2SerializeFMUstate")(instance_, state, bytes.data(), size),
          "fmi2SerializeFMUstate");
    check(library_.function<fmi2FreeFMUstateTYPE>("fmi2FreeFMUstate")(instance_, &state), "fmi2FreeFMUstate");
    return bytes;
  }

  void restore(const std::string& bytes) override {
    fmi2FMUstate state = nullptr;
    check(library_.function<fmi2DeSerializeFMUstateTYPE>("fmi2DeSerializeFMUstate")(instance_, bytes.data(),
                                                                                    bytes.size(), &state),
          "fmi2DeSerializeFMUstate");
    check(library_.function<fmi2SetFMUstateTYPE>("fmi2SetFMUstate")(instance_, state), "fmi2SetFMUstate");
    check(library_.function<fmi2FreeFMUstateTYPE>("fmi2FreeFMUstate")(instance_, &state), "fmi2FreeFMUstate");
  }

 private:
  void check(fmi2Status status, const char* function) {
    if (status == fmi2OK || status == fmi2Warning) return;
    throw FmuError(std::string(function) + " returned " + name_of_status(status) + log_.last());
  }
  void mode(const char* function) { check(library_.function<fmi2ModeTYPE>(function)(instance_), function); }

  const FmuDescription& description_;
  std::string resources_;
  FmuLibrary library_;
  FmuLog log_;
  fmi2CallbackFunctions callbacks_;
  fmi2Component instance_ = nullptr;
};

}  // namespace

std::unique_ptr<FmuInstance> make_instance_2(const FmuDescription& description, const std::string& folder) {
  return std::make_unique<Instance2>(description, folder);
}

}  // namespace footfall
