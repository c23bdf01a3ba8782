#pragma once
// How sources named liggghts_access*.cpp reach what LIGGGHTS 3.8.0 keeps to itself, and what they put in its place.
//
// An explicit template instantiation may name a private member (access is not checked there), which hands out a pointer
// to member; a derived class may name a protected one as &Derived::member.
//
// The launcher exports its symbols, so that LIGGGHTS finds a member that is defined here before the library's own.

#include <dlfcn.h>

#include "coupler/base/errors.h"

namespace footfall {

template <class Tag>
struct Revealed {
  static typename Tag::type member;
};
template <class Tag>
typename Tag::type Revealed<Tag>::member;

// Instantiated in this namespace, outside of unnamed ones:  template struct Reveal<Tag, &Class::member>;
template <class Tag, typename Tag::type member>
struct Reveal {
  Reveal() { Revealed<Tag>::member = member; }
  static Reveal instance;
};
template <class Tag, typename Tag::type member>
Reveal<Tag, member> Reveal<Tag, member>::instance;

// The library's own member of this symbol, where one of ours stands in its place.
template <class Member>
Member original(const char* symbol) {
  const auto member = reinterpret_cast<Member>(dlsym(RTLD_NEXT, symbol));
  FOOTFALL_DEMAND(member != nullptr);
  return member;
}

}  // namespace footfall
