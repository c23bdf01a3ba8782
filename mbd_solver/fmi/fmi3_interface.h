#pragma once
// The C interface of FMI 3.0 as far as co-simulation needs it, written from the definitions of the standard
// (fmi-standard.org, version 3.0, sections 2.2 and 4.2). It uses the names of the standard.

#include <cstddef>
#include <cstdint>

using fmi3Float32 = float;
using fmi3Float64 = double;
using fmi3Int8 = std::int8_t;
using fmi3UInt8 = std::uint8_t;
using fmi3Int16 = std::int16_t;
using fmi3UInt16 = std::uint16_t;
using fmi3Int32 = std::int32_t;
using fmi3UInt32 = std::uint32_t;
using fmi3Int64 = std::int64_t;
using fmi3UInt64 = std::uint64_t;
using fmi3Boolean = bool;
using fmi3Char = char;
using fmi3Byte = std::uint8_t;
using fmi3String = const fmi3Char*;
using fmi3Binary = const fmi3Byte*;
using fmi3Clock = bool;
using fmi3ValueReference = std::uint32_t;
using fmi3Instance = void*;
using fmi3InstanceEnvironment = void*;
using fmi3FMUState = void*;

enum fmi3Status { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal };
enum fmi3IntervalQualifier { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged };
enum fmi3DependencyKind { fmi3Independent, fmi3Constant, fmi3Fixed, fmi3Tunable, fmi3Discrete, fmi3Dependent };

using fmi3LogMessageCallback = void (*)(fmi3InstanceEnvironment, fmi3Status, fmi3String category, fmi3String message);
using fmi3IntermediateUpdateCallback = void (*)(fmi3InstanceEnvironment, fmi3Float64 time, fmi3Boolean setRequested,
                                                fmi3Boolean getAllowed, fmi3Boolean stepFinished,
                                                fmi3Boolean canReturnEarly, fmi3Boolean* earlyReturnRequested,
                                                fmi3Float64* earlyReturnTime);

// Types of the functions; the name of a function is the name of its type without "TYPE".
extern "C" {
using fmi3GetVersionTYPE = const char*();
using fmi3SetDebugLoggingTYPE = fmi3Status(fmi3Instance, fmi3Boolean, std::size_t, const fmi3String*);
using fmi3InstantiateCoSimulationTYPE =
    fmi3Instance(fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath, fmi3Boolean visible,
                 fmi3Boolean loggingOn, fmi3Boolean eventModeUsed, fmi3Boolean earlyReturnAllowed,
                 const fmi3ValueReference* requiredIntermediateVariables, std::size_t nRequiredIntermediateVariables,
                 fmi3InstanceEnvironment, fmi3LogMessageCallback, fmi3IntermediateUpdateCallback);
using fmi3FreeInstanceTYPE = void(fmi3Instance);
using fmi3EnterInitializationModeTYPE = fmi3Status(fmi3Instance, fmi3Boolean toleranceDefined, fmi3Float64 tolerance,
                                                   fmi3Float64 startTime, fmi3Boolean stopTimeDefined,
                                                   fmi3Float64 stopTime);
using fmi3ModeTYPE = fmi3Status(fmi3Instance);  // of all functions that change the mode and have no other argument
using fmi3DoStepTYPE = fmi3Status(fmi3Instance, fmi3Float64 currentCommunicationPoint,
                                  fmi3Float64 communicationStepSize, fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                                  fmi3Boolean* eventHandlingNeeded, fmi3Boolean* terminateSimulation,
                                  fmi3Boolean* earlyReturn, fmi3Float64* lastSuccessfulTime);
using fmi3SetStringTYPE = fmi3Status(fmi3Instance, const fmi3ValueReference*, std::size_t, const fmi3String*,
                                     std::size_t);
using fmi3GetFMUStateTYPE = fmi3Status(fmi3Instance, fmi3FMUState*);
using fmi3SetFMUStateTYPE = fmi3Status(fmi3Instance, fmi3FMUState);
using fmi3FreeFMUStateTYPE = fmi3Status(fmi3Instance, fmi3FMUState*);
using fmi3SerializedFMUStateSizeTYPE = fmi3Status(fmi3Instance, fmi3FMUState, std::size_t*);
using fmi3SerializeFMUStateTYPE = fmi3Status(fmi3Instance, fmi3FMUState, fmi3Byte*, std::size_t);
using fmi3DeserializeFMUStateTYPE = fmi3Status(fmi3Instance, const fmi3Byte*, std::size_t, fmi3FMUState*);
}

// fmi3GetFloat64 ... fmi3SetBoolean: one pair per type.
template <class Value>
using fmi3GetTYPE = fmi3Status(fmi3Instance, const fmi3ValueReference*, std::size_t, Value*, std::size_t);
template <class Value>
using fmi3SetTYPE = fmi3Status(fmi3Instance, const fmi3ValueReference*, std::size_t, const Value*, std::size_t);
