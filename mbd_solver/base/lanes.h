#pragma once
// Numbers side by side in the lanes of a vector register. Each lane computes what it would compute alone: results do not depend on how many
// there are. Files that use them are compiled without fused operations (CMakeLists.txt), so that all registers round alike.

#include <cmath>
#include <cstring>

#define FOOTFALL_IN_LINE inline __attribute__((always_inline))

namespace footfall {

inline constexpr int kMostLanes = 8;  // arrays that are read by lanes have room for a multiple of these

template <int N>
struct LaneTypes;
template <>
struct LaneTypes<4> {
  typedef double Real __attribute__((vector_size(32)));
  typedef long Mask __attribute__((vector_size(32)));
  typedef int Ints __attribute__((vector_size(16)));
};
template <>
struct LaneTypes<8> {
  typedef double Real __attribute__((vector_size(64)));
  typedef long Mask __attribute__((vector_size(64)));
  typedef int Ints __attribute__((vector_size(32)));
};

template <int N>
struct Lanes : LaneTypes<N> {
  static constexpr int kCount = N;
  using typename LaneTypes<N>::Real;
  using typename LaneTypes<N>::Mask;
  using typename LaneTypes<N>::Ints;
  struct Vector {
    Real x, y, z;
    FOOTFALL_IN_LINE Vector operator+(const Vector& b) const { return {x + b.x, y + b.y, z + b.z}; }
    FOOTFALL_IN_LINE Vector operator-(const Vector& b) const { return {x - b.x, y - b.y, z - b.z}; }
    FOOTFALL_IN_LINE Vector operator*(const Real& b) const { return {x * b, y * b, z * b}; }
    FOOTFALL_IN_LINE Real dot(const Vector& b) const { return x * b.x + y * b.y + z * b.z; }
  };

  static FOOTFALL_IN_LINE Real all(double value) { return Real{} + value; }
  static FOOTFALL_IN_LINE Real load(const double* from) {
    Real out;
    std::memcpy(&out, from, sizeof out);
    return out;
  }
  static FOOTFALL_IN_LINE void store(const Real& value, double* to) { std::memcpy(to, &value, sizeof value); }
  // Of three arrays, one behind the other.
  static FOOTFALL_IN_LINE Vector load(const double* from, std::ptrdiff_t apart) {
    return {load(from), load(from + apart), load(from + 2 * apart)};
  }
  static FOOTFALL_IN_LINE void store(const Vector& value, double* to, std::ptrdiff_t apart) {
    store(value.x, to);
    store(value.y, to + apart);
    store(value.z, to + 2 * apart);
  }
  static FOOTFALL_IN_LINE bool any(const Mask& mask) {
    long bits = 0;
    for (int k = 0; k < N; ++k) bits |= mask[k];
    return bits != 0;
  }
  static FOOTFALL_IN_LINE Real floor(const Real& a) {  // |a| < 2^31
    const Real towards_zero = __builtin_convertvector(__builtin_convertvector(a, Ints), Real);
    return towards_zero > a ? towards_zero - 1.0 : towards_zero;
  }
  static FOOTFALL_IN_LINE Real square_root(const Real& a) {
    Real out = a;
    for (int k = 0; k < N; ++k) out[k] = std::sqrt(a[k]);
    return out;
  }
};

// Function::run<L>(arguments...), always in line, for the registers that the machine has.
template <class Function, class... Arguments>
struct BestLanes {
  using Pointer = void (*)(Arguments...);
  static void narrow(Arguments... arguments) { Function::template run<Lanes<4>>(arguments...); }
#ifdef __x86_64__
  __attribute__((target("avx2"))) static void wide(Arguments... arguments) {
    Function::template run<Lanes<4>>(arguments...);
  }
  __attribute__((target("avx512f,avx512vl,avx512dq"))) static void widest(Arguments... arguments) {
    Function::template run<Lanes<8>>(arguments...);
  }
  static Pointer choose() {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
      return widest;
    return __builtin_cpu_supports("avx2") ? wide : narrow;
  }
#else
  static Pointer choose() { return narrow; }
#endif
};

}  // namespace footfall
