#pragma once
// The C interface of FMI 2.0 as far as co-simulation needs it, written from the definitions of the standard
// (fmi-standard.org, version 2.0.4, sections 2.1 and 4.2). It uses the names of the standard.

#include <cstddef>

using fmi2Component = void*;
using fmi2ComponentEnvironment = void*;
using fmi2FMUstate = void*;
using fmi2ValueReference = unsigned int;
using fmi2Real = double;
using fmi2Integer = int;
using fmi2Boolean = int;
using fmi2Char = char;
using fmi2String = const fmi2Char*;
using fmi2Byte = char;

enum fmi2Status { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending };
enum fmi2Type { fmi2ModelExchange, fmi2CoSimulation };
enum fmi2StatusKind { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated };

extern "C" {
struct fmi2CallbackFunctions {
  void (*logger)(fmi2ComponentEnvironment, fmi2String instanceName, fmi2Status, fmi2String category, fmi2String message,
                 ...);
  void* (*allocateMemory)(std::size_t count, std::size_t size);
  void (*freeMemory)(void*);
  void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
  fmi2ComponentEnvironment componentEnvironment;
};

using fmi2InstantiateTYPE = fmi2Component(fmi2String instanceName, fmi2Type, fmi2String guid,
                                          fmi2String resourceLocation, const fmi2CallbackFunctions*,
                                          fmi2Boolean visible, fmi2Boolean loggingOn);
using fmi2FreeInstanceTYPE = void(fmi2Component);
using fmi2SetupExperimentTYPE = fmi2Status(fmi2Component, fmi2Boolean toleranceDefined, fmi2Real tolerance,
                                           fmi2Real startTime, fmi2Boolean stopTimeDefined, fmi2Real stopTime);
using fmi2ModeTYPE =
    fmi2Status(fmi2Component);  // fmi2EnterInitializationMode, fmi2ExitInitializationMode, fmi2Terminate
using fmi2DoStepTYPE = fmi2Status(fmi2Component, fmi2Real currentCommunicationPoint, fmi2Real communicationStepSize,
                                  fmi2Boolean noSetFMUStatePriorToCurrentPoint);
using fmi2GetRealStatusTYPE = fmi2Status(fmi2Component, fmi2StatusKind, fmi2Real*);
using fmi2GetBooleanStatusTYPE = fmi2Status(fmi2Component, fmi2StatusKind, fmi2Boolean*);
using fmi2SetStringTYPE = fmi2Status(fmi2Component, const fmi2ValueReference*, std::size_t, const fmi2String*);
using fmi2GetFMUstateTYPE = fmi2Status(fmi2Component, fmi2FMUstate*);
using fmi2SetFMUstateTYPE = fmi2Status(fmi2Component, fmi2FMUstate);
using fmi2FreeFMUstateTYPE = fmi2Status(fmi2Component, fmi2FMUstate*);
using fmi2SerializedFMUstateSizeTYPE = fmi2Status(fmi2Component, fmi2FMUstate, std::size_t*);
using fmi2SerializeFMUstateTYPE = fmi2Status(fmi2Component, fmi2FMUstate, fmi2Byte*, std::size_t);
using fmi2DeSerializeFMUstateTYPE = fmi2Status(fmi2Component, const fmi2Byte*, std::size_t, fmi2FMUstate*);
}

// fmi2GetReal ... fmi2SetBoolean: one pair per type.
template <class Value>
using fmi2GetTYPE = fmi2Status(fmi2Component, const fmi2ValueReference*, std::size_t, Value*);
template <class Value>
using fmi2SetTYPE = fmi2Status(fmi2Component, const fmi2ValueReference*, std::size_t, const Value*);
