#pragma once
// An FMU led by its C interface, as an importing program does.

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include "mbd_solver/fmi/fmi3_interface.h"
#include "mbd_solver/fmi/fmu_file.h"
#include "mbd_solver/fmi/fmu_instance.h"
#include "tests/app/programs.h"

namespace footfall::test {

// The scene as NAME.fmu in the folder. words: more of the command line.
inline std::string exported(const app::Folder& folder, const std::string& name, const std::string& scene,
                            const std::string& words = "") {
  folder.write(name + ".toml", scene);
  folder.done("fmu " + name + ".toml --quiet --out " + name + ".fmu " + words);
  return folder.file(name + ".fmu");
}

struct Log {
  std::string text;
  static void add(fmi3InstanceEnvironment log, fmi3Status, fmi3String, fmi3String message) {
    static_cast<Log*>(log)->text += message;
  }
};

class Interface {
 public:
  Interface(const std::string& file, const std::string& folder, bool early_return) : description_(read_fmu(file)) {
    std::filesystem::create_directory(folder);
    unpack_fmu(file, folder);
    library_ = std::make_unique<FmuLibrary>(description_, folder);
    instance = library_->function<fmi3InstantiateCoSimulationTYPE>("fmi3InstantiateCoSimulation")(
        "test", description_.token.c_str(), (folder + "/resources/").c_str(), false, false, false, early_return,
        nullptr, 0, &log, Log::add, nullptr);
  }
  ~Interface() { library_->function<fmi3FreeInstanceTYPE>("fmi3FreeInstance")(instance); }
  fmi3Status begin() {
    const fmi3Status status = library_->function<fmi3EnterInitializationModeTYPE>("fmi3EnterInitializationMode")(
        instance, false, 0, 0, false, 0);
    return status == fmi3OK ? library_->function<fmi3ModeTYPE>("fmi3ExitInitializationMode")(instance) : status;
  }
  fmi3Status set(const std::string& name, double value) {
    const fmi3ValueReference reference = description_.find(name)->reference;
    return library_->function<fmi3SetTYPE<double>>("fmi3SetFloat64")(instance, &reference, 1, &value, 1);
  }
  double get(const std::string& name) {
    const fmi3ValueReference reference = description_.find(name)->reference;
    double value = std::nan("");
    library_->function<fmi3GetTYPE<double>>("fmi3GetFloat64")(instance, &reference, 1, &value, 1);
    return value;
  }
  fmi3Status step(double from, double h) {
    bool events = false;
    return library_->function<fmi3DoStepTYPE>("fmi3DoStep")(instance, from, h, true, &events, &ends, &early, &last);
  }
  fmi3Status mode(const char* name) { return library_->function<fmi3ModeTYPE>(name)(instance); }
  FmuLibrary& library() { return *library_; }

  fmi3Instance instance = nullptr;
  Log log;
  bool ends = false, early = false;
  double last = 0.0;

 private:
  FmuDescription description_;
  std::unique_ptr<FmuLibrary> library_;
};

}  // namespace footfall::test
