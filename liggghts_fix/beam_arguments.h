#pragma once
// The words after `fix ID group wall/gran/beam`, taken apart without LIGGGHTS headers:
//   model ... [tangential ...] [cohesion ...] [rolling_friction ...] [surface ...]
//   type T  body NAME [chain C] [body NAME [chain C]] ...  [curvature yes|no]  [stock keywords]

#include <string>
#include <vector>

#include "coupler/modal_boundary.h"

namespace footfall {

// Beams that one `body NAME [chain C]` means.
struct BeamChoice {
  std::string body;
  int chain = -1;  // number of the beam within the body; -1: all that it has
};

struct BeamArguments {
  // Throws InputError for a missing or doubled keyword, or one that means nothing for beams.
  BeamArguments(int narg, const char* const* arg);

  std::string fix;                // "fix ID wall/gran/beam", for messages
  std::string type;               // material of the beams, a number for stock LIGGGHTS to check
  std::vector<BeamChoice> beams;  // at least one, none twice
  bool curvature = false;         // contacts know that the beams are round; otherwise they are as stiff as a plane's
  // The same words for stock `fix wall/gran`, which brings contact models, history, heat and stored forces. A wall
  // needs a shape, and gets the primitive that claims to be near every grain (per-contact storage asks it) and is never
  // asked for a contact.
  std::vector<std::string> stock;
};

// Numbers of the chains meant, in rising order. `fix` begins the message of the InputError that is thrown when there is
// none.
std::vector<int> chosen_chains(const std::string& fix, const BeamChoice& choice, const ModalBoundary& boundary);

}  // namespace footfall
