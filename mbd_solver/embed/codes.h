#pragma once
// Codes of the messages of embed/ and python/: E0720 to E0739, W0720 to W0739.

#include "coupler/base/errors.h"

namespace footfall::code {

// The scene touches grains, which this object does not move. Control the coupled pair, or give the scene another ground.
inline constexpr MessageCode kEmbeddedGrains{"E0720", "embedded-grains"};
// A step ends before the present time, or its end is not a number. Give a later time.
inline constexpr MessageCode kStepBackwards{"E0721", "step-backwards"};
// The simulation has ended or failed. Restore an earlier state, or make a new simulation.
inline constexpr MessageCode kCannotGoOn{"E0722", "cannot-go-on"};
// A name is no signal of kind "host" of this scene. Use one of those listed.
inline constexpr MessageCode kNoHostSignal{"E0723", "no-host-signal"};
// A value is not a finite number. Correct it.
inline constexpr MessageCode kGivenNotFinite{"E0724", "given-not-finite"};
// A simulation that does not record the peaks of its steps has no summary. Make it with the option to record.
inline constexpr MessageCode kNotRecorded{"E0725", "not-recorded"};
// A saved state belongs to another scene, or to other settings. Restore it into a simulation of its own scene.
inline constexpr MessageCode kStateOfAnother{"E0726", "state-of-another"};
// An argument of a call in Python has a wrong type, or is outside of its range. The message says what is expected.
inline constexpr MessageCode kWrongArgument{"E0728", "wrong-argument"};
// A call while another thread steps, saves or restores the same simulation. Wait for its end, or make a simulation for each thread.
inline constexpr MessageCode kInUse{"E0729", "in-use"};

}  // namespace footfall::code
