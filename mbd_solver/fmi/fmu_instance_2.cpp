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

struct Fmi2 {
  using Status = fmi2Status;
  using Byte = fmi2Byte;
  static constexpr const char *kPrefix = "fmi2", *kState = "FMUstate", *kDeserialize = "DeSerialize";
};

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

class Instance2 final : public FmuInstanceOf<Fmi2> {
 public:
  Instance2(const FmuDescription& description, const std::string& folder)
      : FmuInstanceOf(description, folder), resources_(uri_of(folder + "/resources")) {
    callbacks_ = {log_message_2, std::calloc, std::free, nullptr, &log_};
  }

  void begin(double time, const std::function<void()>&, const std::function<void()>& at_start,
             const std::function<void()>& inputs) override {
    free();
    take(library_.function<fmi2InstantiateTYPE>("fmi2Instantiate")(
             "footfall", fmi2CoSimulation, description_.token.c_str(), resources_.c_str(), &callbacks_, 0, 0),
         "Instantiate");
    call<fmi2SetupExperimentTYPE>("SetupExperiment", 0, 0.0, time, 0, 0.0);
    at_start();
    mode("EnterInitializationMode");
    inputs();
    mode("ExitInitializationMode");
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
        throw FmuError("it requests the end of the simulation at " + number_text(last, 9) + " s" + log_.last());
      throw FmuError("fmi2DoStep discarded the step from " + number_text(from, 9) + " s to " + number_text(to, 9) +
                     " s; it got to " + number_text(last, 9) + " s" + log_.last());
    }
    check(status, "fmi2DoStep");
  }

  void set(const FmuVariable& v, const std::vector<double>& values) override {
    const fmi2ValueReference reference = v.reference;
    if (v.type == "Real") {
      call<fmi2SetTYPE<fmi2Real>>("SetReal", &reference, 1, values.data());
    } else {
      const bool flag = v.type == "Boolean";
      const int value = flag ? (values[0] != 0.0 ? 1 : 0) : value_as<fmi2Integer>(v, values[0]);
      call<fmi2SetTYPE<int>>(flag ? "SetBoolean" : "SetInteger", &reference, 1, &value);
    }
  }

  std::vector<double> get(const FmuVariable& v, std::size_t) override {
    const fmi2ValueReference reference = v.reference;
    if (v.type == "Real") {
      fmi2Real value = 0.0;
      call<fmi2GetTYPE<fmi2Real>>("GetReal", &reference, 1, &value);
      return {value};
    }
    const bool flag = v.type == "Boolean";
    int value = 0;
    call<fmi2GetTYPE<int>>(flag ? "GetBoolean" : "GetInteger", &reference, 1, &value);
    return {flag ? (value != 0 ? 1.0 : 0.0) : static_cast<double>(value)};
  }

  void set_text(const FmuVariable& v, const std::string& value) override {
    const fmi2ValueReference reference = v.reference;
    const fmi2String text = value.c_str();
    call<fmi2SetStringTYPE>("SetString", &reference, 1, &text);
  }

 private:
  std::string resources_;
  fmi2CallbackFunctions callbacks_;
};

}  // namespace

std::unique_ptr<FmuInstance> make_instance_2(const FmuDescription& description, const std::string& folder) {
  return std::make_unique<Instance2>(description, folder);
}

}  // namespace footfall
