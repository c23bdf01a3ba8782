#pragma once
// How often this program has asked for memory, for tests that claim that something needs none. It puts a malloc of its own
// into the program that includes it, so one source of a program may. Sanitizers have a malloc of their own, which must be
// the only one: next to them nothing is counted, and such a test is skipped.

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>

namespace footfall::test {
inline std::atomic<long> heap_requests{0};
}  // namespace footfall::test

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // g++
#define FOOTFALL_SANITIZED
#elif defined(__has_feature)  // clang++
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define FOOTFALL_SANITIZED
#endif
#endif

#ifdef FOOTFALL_SANITIZED
#define SKIP_WHERE_MEMORY_IS_NOT_COUNTED() GTEST_SKIP() << "a sanitizer owns malloc"
#else
#define SKIP_WHERE_MEMORY_IS_NOT_COUNTED() static_cast<void>(0)
extern "C" void* __libc_malloc(std::size_t);
extern "C" void* malloc(std::size_t size) {
  ++footfall::test::heap_requests;
  return __libc_malloc(size);
}
#endif
