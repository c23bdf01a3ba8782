/* The FMU of inputs/reference: thrust' = (largest * throttle - thrust) / response, by the exact solution of a step.
   make_engine.sh compiles it. FMI 3.0, co-simulation; the state is three numbers. */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { kTime, kThrottle, kThrust, kLargest, kResponse, kCount };
enum { kOk = 0, kErrorStatus = 3 };
typedef struct {
  double x[kCount];
} Engine;
typedef uint32_t Reference;

void* fmi3InstantiateCoSimulation(const char* name, const char* token, const char* resources, bool visible, bool logs, bool events,
                                  bool early, const Reference* intermediate, size_t count, void* environment, void* log, void* update) {
  const Engine start = {{0.0, 0.0, 0.0, 3000.0, 0.05}};
  (void)name, (void)resources, (void)visible, (void)logs, (void)events, (void)early, (void)intermediate, (void)count;
  (void)environment, (void)log, (void)update;
  Engine* const e = strcmp(token, "{footfall-engine}") == 0 ? malloc(sizeof *e) : NULL;
  if (e) *e = start;
  return e;
}
void fmi3FreeInstance(Engine* e) { free(e); }
int fmi3EnterInitializationMode(Engine* e, bool defined, double tolerance, double time, bool stops, double stop) {
  (void)defined, (void)tolerance, (void)stops, (void)stop;
  e->x[kTime] = time;
  return kOk;
}
int fmi3ExitInitializationMode(Engine* e) { return e->x[kResponse] > 0.0 ? kOk : kErrorStatus; }
int fmi3SetFloat64(Engine* e, const Reference* r, size_t n, const double* values, size_t m) {
  for (size_t i = 0; i < n && i < m; ++i) e->x[r[i]] = values[i];
  return kOk;
}
int fmi3GetFloat64(Engine* e, const Reference* r, size_t n, double* values, size_t m) {
  for (size_t i = 0; i < n && i < m; ++i) values[i] = e->x[r[i]];
  return kOk;
}
int fmi3DoStep(Engine* e, double time, double h, bool no_return, bool* events, bool* end, bool* early, double* last) {
  const double aim = e->x[kLargest] * e->x[kThrottle];
  (void)no_return;
  e->x[kThrust] = aim + (e->x[kThrust] - aim) * exp(-h / e->x[kResponse]);
  *last = e->x[kTime] = time + h;
  *events = *end = *early = false;
  return kOk;
}
int fmi3GetFMUState(Engine* e, void** state) {
  if (!*state) *state = malloc(sizeof *e);
  memcpy(*state, e, sizeof *e);
  return kOk;
}
int fmi3SetFMUState(Engine* e, const void* state) { return memcpy(e, state, sizeof *e), kOk; }
int fmi3FreeFMUState(Engine* e, void** state) {
  (void)e;
  free(*state);
  *state = NULL;
  return kOk;
}
int fmi3SerializedFMUStateSize(Engine* e, const void* state, size_t* size) {
  (void)state;
  *size = sizeof *e;
  return kOk;
}
int fmi3SerializeFMUState(Engine* e, const void* state, uint8_t* bytes, size_t size) {
  (void)e;
  return memcpy(bytes, state, size), kOk;
}
int fmi3DeserializeFMUState(Engine* e, const uint8_t* bytes, size_t size, void** state) {
  *state = NULL;
  fmi3GetFMUState(e, state);
  return memcpy(*state, bytes, size), kOk;
}
