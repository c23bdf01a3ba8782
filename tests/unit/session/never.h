#pragma once
// Runs of the tests that no signal ends.

#include <csignal>

namespace footfall::test {

inline const volatile std::sig_atomic_t kNever = 0;

}  // namespace footfall::test
