// Small FMUs of the tests, one per value of MODEL, for FMI 3.0 and 2.0 (FMI_VERSION). All variables are numbers in one list; a value
// reference is the place of the first number of a variable.
//   1 Oscillator   m x'' = F - k x - d x', exact over a step with F held; ends steps early where x changes its sign (3.0)
//   2 Controller   u = kp e + ki I, I' = e, by Euler's rule once per step
//   3 Types        outputs are the inputs, in every type; its resource file
//   4 Broken       fails as its parameter says
#include <signal.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

#if FMI_VERSION == 3
#include "mbd_solver/fmi/fmi3_interface.h"
#else
#include "mbd_solver/fmi/fmi2_interface.h"
#endif

namespace {

constexpr int kNumbers = 32;

enum Fault { kNone, kError, kDiscard, kNotANumber, kCrash, kHang, kEnd, kNoInstance, kAbort, kExit };

struct Instance {
  double x[kNumbers];
  double time = 0.0;
  int early = 0;  // steps that ended early
  std::string resources;
  std::string text;
  std::string serialized;
};

enum class Result { kDone, kError, kDiscard, kEnd };

#if MODEL == 1  // 0 time, 1 F, 2 x, 3 v, 4 m, 5 k, 6 d, 7 x0, 8 v0
constexpr const char* kToken = "{oscillator}";
constexpr double kStart[] = {0, 0, 0, 0, 1, 1e4, 1, 0.01, 0};
void initialize(Instance& i) {
  i.x[2] = i.x[7];
  i.x[3] = i.x[8];
}
// x = F/k + exp(-D t) (a cos w t + b sin w t)
Result step(Instance& i, double h) {
  const double *p = i.x, rest = p[1] / p[5], decay = p[6] / (2 * p[4]), w = std::sqrt(p[5] / p[4] - decay * decay);
  const double a = p[2] - rest, b = (p[3] + decay * a) / w, c = std::cos(w * h), s = std::sin(w * h),
               e = std::exp(-decay * h);
  i.x[2] = rest + e * (a * c + b * s);
  i.x[3] = e * ((b * w - decay * a) * c - (a * w + decay * b) * s);
  return Result::kDone;
}
#elif MODEL == 2  // 0 time, 1 e, 2 u, 3 I, 4 kp, 5 ki
constexpr const char* kToken = "{controller}";
constexpr double kStart[] = {0, 0, 0, 0, 1, 0};
void initialize(Instance& i) { i.x[2] = i.x[4] * i.x[1] + i.x[5] * i.x[3]; }
Result step(Instance& i, double h) {
  i.x[3] += h * i.x[1];
  initialize(i);
  return Result::kDone;
}
#elif MODEL == \
    3  // 0 time, 1 ... 9 inputs, 11 ... 19 outputs (the last three are an array), 20 the resource, 21 length of the text, 22 ways
constexpr const char* kToken = "{types}";
constexpr double kStart[] = {0, 0, 0, 0, 0, 0, 0, 7, 8, 9};
void initialize(Instance& i) {
  for (int k = 1; k <= 9; ++k) i.x[10 + k] = i.x[k];
  if (std::FILE* const file = std::fopen((i.resources + "number.txt").c_str(), "r")) {
    if (std::fscanf(file, "%lf", &i.x[20]) != 1) i.x[20] = -1;
    std::fclose(file);
  }
  i.x[21] = static_cast<double>(i.text.size());
}
Result step(Instance& i, double) {
  initialize(i);
  return Result::kDone;
}
#else  // 0 time, 1 fault, 2 when [s], 3 y
constexpr const char* kToken = "{broken}";
constexpr double kStart[] = {0, 0, 0.01, 1};
void initialize(Instance&) {}
Result step(Instance& i, double h) {
  if (i.time + 0.5 * h < i.x[2]) return Result::kDone;
  switch (static_cast<int>(i.x[1])) {
    case kError: return Result::kError;
    case kDiscard: return Result::kDiscard;
    case kNotANumber: i.x[3] = std::numeric_limits<double>::quiet_NaN(); break;
    case kCrash: raise(SIGSEGV); break;
    case kHang:
      for (;;) usleep(100000);
    case kEnd: return Result::kEnd;
    case kAbort: std::abort();
    case kExit: std::exit(3);
    default: break;
  }
  return Result::kDone;
}
#endif

Instance* made(const char* token, const char* resources) {
  if (std::strcmp(token, kToken) != 0) return nullptr;
  auto* const i = new Instance;
  for (int k = 0; k < kNumbers; ++k) i->x[k] = k < static_cast<int>(std::size(kStart)) ? kStart[k] : 0.0;
  i->resources = resources;
  std::printf("an FMU may print\n");
  return i;
}

template <class Value>
void get(void* instance, unsigned reference, std::size_t count, Value* values) {
  for (std::size_t k = 0; k < count; ++k)
    values[k] = static_cast<Value>(static_cast<Instance*>(instance)->x[reference + k]);
}
template <class Value>
void set(void* instance, unsigned reference, std::size_t count, const Value* values) {
  for (std::size_t k = 0; k < count; ++k)
    static_cast<Instance*>(instance)->x[reference + k] = static_cast<double>(values[k]);
}

}  // namespace

#define EXPORT extern "C" __attribute__((visibility("default")))

#if FMI_VERSION == 3

#define GET_AND_SET(Type)                                                                                         \
  EXPORT fmi3Status fmi3Get##Type(fmi3Instance i, const fmi3ValueReference* r, std::size_t n, fmi3##Type* values, \
                                  std::size_t m) {                                                                \
    for (std::size_t k = 0; k < n; ++k, values += m / n) get(i, r[k], m / n, values);                             \
    return fmi3OK;                                                                                                \
  }                                                                                                               \
  EXPORT fmi3Status fmi3Set##Type(fmi3Instance i, const fmi3ValueReference* r, std::size_t n,                     \
                                  const fmi3##Type* values, std::size_t m) {                                      \
    for (std::size_t k = 0; k < n; ++k, values += m / n) set(i, r[k], m / n, values);                             \
    return fmi3OK;                                                                                                \
  }
GET_AND_SET(Float64)
GET_AND_SET(Float32)
GET_AND_SET(Int8)
GET_AND_SET(UInt8)
GET_AND_SET(Int16)
GET_AND_SET(UInt16)
GET_AND_SET(Int32)
GET_AND_SET(UInt32)
GET_AND_SET(Int64)
GET_AND_SET(UInt64)
GET_AND_SET(Boolean)

EXPORT fmi3Status fmi3SetString(fmi3Instance i, const fmi3ValueReference*, std::size_t, const fmi3String* texts,
                                std::size_t) {
  static_cast<Instance*>(i)->text = texts[0];
  return fmi3OK;
}

EXPORT fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String resources, fmi3Boolean,
                                                fmi3Boolean, fmi3Boolean, fmi3Boolean, const fmi3ValueReference*,
                                                std::size_t, fmi3InstanceEnvironment environment,
                                                fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback) {
  if (log) log(environment, fmi3Warning, "test", "a first word");
  return made(token, resources);
}
EXPORT void fmi3FreeInstance(fmi3Instance i) { delete static_cast<Instance*>(i); }
EXPORT fmi3Status fmi3EnterInitializationMode(fmi3Instance i, fmi3Boolean, fmi3Float64, fmi3Float64 time, fmi3Boolean,
                                              fmi3Float64) {
  static_cast<Instance*>(i)->time = time;
  return fmi3OK;
}
EXPORT fmi3Status fmi3ExitInitializationMode(fmi3Instance i) {
  initialize(*static_cast<Instance*>(i));
  return MODEL == 4 && static_cast<Instance*>(i)->x[1] == double{kNoInstance} ? fmi3Error : fmi3OK;
}
EXPORT fmi3Status fmi3EnterConfigurationMode(fmi3Instance) { return fmi3OK; }
EXPORT fmi3Status fmi3ExitConfigurationMode(fmi3Instance) { return fmi3OK; }
EXPORT fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 time, fmi3Float64 h, fmi3Boolean, fmi3Boolean* events,
                             fmi3Boolean* terminate, fmi3Boolean* early, fmi3Float64* last) {
  Instance& i = *static_cast<Instance*>(instance);
  if (std::fabs(time - i.time) > 1e-9 * (1.0 + time)) return fmi3Error;  // steps must follow each other
  *events = *terminate = *early = false;
  if (MODEL == 1 && i.early++ % 3 == 0) {  // every third call does half of the step
    h *= 0.5;
    *early = true;
  }
  const Result result = step(i, h);
  if (result == Result::kError) return fmi3Error;
  if (result == Result::kDiscard) return fmi3Discard;
  *terminate = result == Result::kEnd;
  i.time = i.x[0] = *last = time + h;
  return fmi3OK;
}
EXPORT fmi3Status fmi3GetFMUState(fmi3Instance i, fmi3FMUState* state) {
  *state = new Instance(*static_cast<Instance*>(i));
  return fmi3OK;
}
EXPORT fmi3Status fmi3SetFMUState(fmi3Instance i, fmi3FMUState state) {
  *static_cast<Instance*>(i) = *static_cast<Instance*>(state);
  return fmi3OK;
}
EXPORT fmi3Status fmi3FreeFMUState(fmi3Instance, fmi3FMUState* state) {
  delete static_cast<Instance*>(*state);
  *state = nullptr;
  return fmi3OK;
}
EXPORT fmi3Status fmi3SerializedFMUStateSize(fmi3Instance, fmi3FMUState, std::size_t* size) {
  *size = (kNumbers + 2) * sizeof(double);
  return fmi3OK;
}
EXPORT fmi3Status fmi3SerializeFMUState(fmi3Instance, fmi3FMUState state, fmi3Byte* bytes, std::size_t) {
  const Instance& i = *static_cast<Instance*>(state);
  const double more[] = {i.time, static_cast<double>(i.early)};
  std::memcpy(bytes, i.x, sizeof i.x);
  std::memcpy(bytes + sizeof i.x, more, sizeof more);
  return fmi3OK;
}
EXPORT fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte* bytes, std::size_t,
                                          fmi3FMUState* state) {
  auto* const i = new Instance(*static_cast<Instance*>(instance));
  double more[2];
  std::memcpy(i->x, bytes, sizeof i->x);
  std::memcpy(more, bytes + sizeof i->x, sizeof more);
  i->time = more[0];
  i->early = static_cast<int>(more[1]);
  *state = i;
  return fmi3OK;
}

#else

EXPORT fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference* r, std::size_t n, fmi2Real* values) {
  for (std::size_t k = 0; k < n; ++k) get(c, r[k], 1, values + k);
  return fmi2OK;
}
EXPORT fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference* r, std::size_t n, const fmi2Real* values) {
  for (std::size_t k = 0; k < n; ++k) set(c, r[k], 1, values + k);
  return fmi2OK;
}
EXPORT fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference* r, std::size_t n, fmi2Integer* values) {
  for (std::size_t k = 0; k < n; ++k) get(c, r[k], 1, values + k);
  return fmi2OK;
}
EXPORT fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference* r, std::size_t n,
                                 const fmi2Integer* values) {
  for (std::size_t k = 0; k < n; ++k) set(c, r[k], 1, values + k);
  return fmi2OK;
}
EXPORT fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference* r, std::size_t n, fmi2Boolean* values) {
  return fmi2GetInteger(c, r, n, values);
}
EXPORT fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference* r, std::size_t n,
                                 const fmi2Boolean* values) {
  return fmi2SetInteger(c, r, n, values);
}
EXPORT fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference*, std::size_t, const fmi2String* texts) {
  static_cast<Instance*>(c)->text = texts[0];
  return fmi2OK;
}
EXPORT fmi2Component fmi2Instantiate(fmi2String, fmi2Type, fmi2String guid, fmi2String resources,
                                     const fmi2CallbackFunctions* calls, fmi2Boolean, fmi2Boolean) {
  calls->logger(calls->componentEnvironment, "test", fmi2Warning, "test", "a first word of %d", 2);
  if (std::strncmp(resources, "file:///", 8) != 0) return nullptr;
  return made(guid, (std::string(resources + 7) + "/").c_str());
}
EXPORT void fmi2FreeInstance(fmi2Component c) { delete static_cast<Instance*>(c); }
EXPORT fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean, fmi2Real, fmi2Real time, fmi2Boolean, fmi2Real) {
  static_cast<Instance*>(c)->time = time;
  return fmi2OK;
}
EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component) { return fmi2OK; }
EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  initialize(*static_cast<Instance*>(c));
  return fmi2OK;
}
EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real h, fmi2Boolean) {
  Instance& i = *static_cast<Instance*>(c);
  const Result result = step(i, h);
  if (result == Result::kError) return fmi2Error;
  if (result == Result::kDiscard || result == Result::kEnd) return fmi2Discard;
  i.time = i.x[0] = time + h;
  return fmi2OK;
}
EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind, fmi2Boolean* value) {
  *value = MODEL == 4 && static_cast<Instance*>(c)->x[1] == double{kEnd};
  return fmi2OK;
}
EXPORT fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind, fmi2Real* value) {
  *value = static_cast<Instance*>(c)->time;
  return fmi2OK;
}
EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state) {
  *state = new Instance(*static_cast<Instance*>(c));
  return fmi2OK;
}
EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  *static_cast<Instance*>(c) = *static_cast<Instance*>(state);
  return fmi2OK;
}
EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component, fmi2FMUstate* state) {
  delete static_cast<Instance*>(*state);
  return fmi2OK;
}
EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component, fmi2FMUstate, std::size_t* size) {
  *size = (kNumbers + 1) * sizeof(double);
  return fmi2OK;
}
EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component, fmi2FMUstate state, fmi2Byte* bytes, std::size_t) {
  const Instance& i = *static_cast<Instance*>(state);
  std::memcpy(bytes, i.x, sizeof i.x);
  std::memcpy(bytes + sizeof i.x, &i.time, sizeof i.time);
  return fmi2OK;
}
EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte* bytes, std::size_t, fmi2FMUstate* state) {
  auto* const i = new Instance(*static_cast<Instance*>(c));
  std::memcpy(i->x, bytes, sizeof i->x);
  std::memcpy(&i->time, bytes + sizeof i->x, sizeof i->time);
  *state = i;
  return fmi2OK;
}

#endif
