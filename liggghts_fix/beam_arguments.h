#pragma once
// The words after `fix ID group wall/gran/beam`, taken apart without LIGGGHTS headers:
//   model ... [tangential ...] [cohesion ...] [rolling_friction ...] [surface ...]  type T  body NAME  [chain
//   C]  [stock keywords]

#include <string>
#include <vector>

#include "coupler/modal_boundary.h"

namespace footfall {

struct BeamArguments {
  // Throws InputError for a missing or doubled keyword, or one that means nothing for a beam.
  BeamArguments(int narg, const char* const* arg);

  std::string fix;   // "fix ID wall/gran/beam", for messages
  std::string type;  // material of the beam, a number for stock LIGGGHTS to check
  std::string body;
  int chain = -1;  // number of the beam within the body; -1: its only one
  // The same words for stock `fix wall/gran`, which brings contact models, history, heat and stored forces. A
  // wall needs a shape, and gets the primitive that claims to be near every grain (per-contact storage asks
  // it) and is never asked for a contact.
  std::vector<std::string> stock;
};

// Number of the chain meant: the body's only one, or the one asked for. Throws InputError naming those that
// there are.
int chosen_chain(const BeamArguments& arguments, const ModalBoundary& boundary);

}  // namespace footfall
