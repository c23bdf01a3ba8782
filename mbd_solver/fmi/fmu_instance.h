#pragma once
// One instance of an FMU for co-simulation, of either version of FMI.

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "mbd_solver/base/fmu_description.h"

namespace footfall {

// The FMU reported an error, or violated the standard.
struct FmuError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class FmuInstance {
 public:
  virtual ~FmuInstance() = default;

  // Frees an earlier instance, makes a new one, and initializes it at this time [s]. structure sets structural parameters,
  // at_start parameters and start values, inputs the inputs.
  virtual void begin(double time, const std::function<void()>& structure, const std::function<void()>& at_start,
                     const std::function<void()>& inputs) = 0;
  virtual void step(double from, double to) = 0;  // [s]
  virtual void set(const FmuVariable& variable, const std::vector<double>& values) = 0;
  virtual void set_text(const FmuVariable& variable, const std::string& value) = 0;
  virtual std::vector<double> get(const FmuVariable& variable, std::size_t count) = 0;
  virtual std::string state() = 0;
  virtual void restore(const std::string& state) = 0;
};

// folder: where the FMU is unpacked. sets_structure: structural parameters differ from their start values. The description
// must outlive the instance.
std::unique_ptr<FmuInstance> make_instance_2(const FmuDescription& description, const std::string& folder);
std::unique_ptr<FmuInstance> make_instance_3(const FmuDescription& description, const std::string& folder,
                                             bool sets_structure);

// ---- shared by both ----

// The library of an FMU and its functions.
class FmuLibrary {
 public:
  FmuLibrary(const FmuDescription& description, const std::string& folder);
  void* find(const std::string& name) const;  // null: not there
  template <class Type>
  Type* function(const std::string& name) const {
    void* const found = find(name);
    if (!found) throw FmuError("its library has no function " + name + ": the FMU is incomplete");
    return reinterpret_cast<Type*>(found);
  }

 private:
  void* handle_;
};

// The last messages of an FMU, for errors.
class FmuLog {
 public:
  void add(const std::string& text);
  std::string last() const { return last_.empty() ? "" : "; its message: " + last_; }

 private:
  std::string last_;
};

// A number as an integer or Boolean of the type. Throws FmuError where it is none.
template <class Value>
Value value_as(const FmuVariable& variable, double number);

// The part that differs in both versions only by names. Api has Status, Byte, kPrefix ("fmi3"), kState ("FMUState"),
// kDeserialize; values of both Status are OK, Warning, Discard, Error, Fatal, Pending.
template <class Api>
class FmuInstanceOf : public FmuInstance {
 public:
  FmuInstanceOf(const FmuDescription& description, const std::string& folder)
      : description_(description), library_(description, folder) {}
  ~FmuInstanceOf() override { free(); }

  std::string state() override {
    void* state = nullptr;
    call<Status(void*, void**)>("Get" + kState, &state);
    std::size_t size = 0;
    call<Status(void*, void*, std::size_t*)>("Serialized" + kState + "Size", state, &size);
    std::string bytes(size, '\0');
    call<Status(void*, void*, Byte*, std::size_t)>("Serialize" + kState, state, reinterpret_cast<Byte*>(bytes.data()),
                                                   size);
    call<Status(void*, void**)>("Free" + kState, &state);
    return bytes;
  }
  void restore(const std::string& bytes) override {
    void* state = nullptr;
    call<Status(void*, const Byte*, std::size_t, void**)>(
        Api::kDeserialize + kState, reinterpret_cast<const Byte*>(bytes.data()), bytes.size(), &state);
    call<Status(void*, void*)>("Set" + kState, state);
    call<Status(void*, void**)>("Free" + kState, &state);
  }

 protected:
  using Status = typename Api::Status;
  using Byte = typename Api::Byte;

  // Calls the function, whose name ends like this, for the instance. Throws FmuError unless the status is OK or Warning.
  template <class Function, class... Values>
  void call(const std::string& name, Values... values) {
    check(library_.template function<Function>(Api::kPrefix + name)(instance_, values...), Api::kPrefix + name);
  }
  void mode(const std::string& name) { call<Status(void*)>(name); }
  void check(Status status, const std::string& function) const {
    constexpr const char* kNames[] = {"OK", "Warning", "Discard", "Error", "Fatal", "Pending"};
    const int number = static_cast<int>(status);
    if (number == 0 || number == 1) return;
    throw FmuError(function + " returned " +
                   (number > 1 && number < 6 ? std::string(Api::kPrefix) + kNames[number] : "an unknown status") +
                   log_.last());
  }
  // Takes a new instance in the place of an earlier one.
  void take(void* instance, const std::string& function) {
    instance_ = instance;
    if (!instance_) throw FmuError(Api::kPrefix + function + " made no instance" + log_.last());
  }
  void free() {
    if (instance_) library_.template function<void(void*)>(std::string(Api::kPrefix) + "FreeInstance")(instance_);
    instance_ = nullptr;
  }

  const std::string kState = Api::kState;
  const FmuDescription& description_;
  FmuLibrary library_;
  FmuLog log_;
  void* instance_ = nullptr;
};

}  // namespace footfall
