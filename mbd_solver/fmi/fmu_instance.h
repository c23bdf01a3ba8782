#pragma once
// One instance of an FMU for co-simulation, of either version of FMI.

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "mbd_solver/base/fmu_description.h"

namespace footfall {

// The FMU reported an error, or did what the standard does not allow.
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
  std::string last() const { return last_.empty() ? "" : "; it says: " + last_; }

 private:
  std::string last_;
};

// A number as an integer or Boolean of the type. Throws FmuError where it is none.
template <class Value>
Value value_as(const FmuVariable& variable, double number);

}  // namespace footfall
