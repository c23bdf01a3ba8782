#pragma once
// How functions of libraries are replaced: the launcher exports its symbols, so that the dynamic linker finds a function
// that it defines before the definition in LIGGGHTS, MPI or the C library. README.md lists all of them.

#include <dlfcn.h>

#include "coupler/base/errors.h"

namespace footfall {

// The library's own function of this (mangled) name, where this program replaces it.
template <class Function>
Function next_definition(const char* symbol) {
  const auto function = reinterpret_cast<Function>(dlsym(RTLD_NEXT, symbol));
  FOOTFALL_DEMAND(function != nullptr);
  return function;
}

}  // namespace footfall
