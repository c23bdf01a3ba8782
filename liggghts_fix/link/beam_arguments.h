#pragma once
// The arguments of  fix ID group wall/gran/beam :
//   model ... [tangential ...] [cohesion ...] [rolling_friction ...] [surface ...]
//   type T  body NAME [chain C] [body NAME [chain C]] ...  [curvature yes|no]  [stock keywords]

#include <string>
#include <vector>

#include "coupler/modal_boundary.h"

namespace footfall {

// The beams of one `body NAME [chain C]`.
struct BeamChoice {
  std::string body;
  int chain = -1;  // number of the beam within the body; -1: all
};

struct BeamArguments {
  // Throws InputError for a keyword that is missing, repeated or without meaning for beams.
  BeamArguments(int narg, const char* const* arg);

  std::string fix;                // "fix ID wall/gran/beam", for messages
  std::string type;               // material of the beams; the fix checks the number
  std::vector<BeamChoice> beams;  // at least one, none twice
  bool curvature = false;         // contacts are those on a round beam; otherwise as stiff as on a plane
  // The arguments of a stock `fix wall/gran`, which has the contact models, history, heat and stored forces. A wall needs
  // a shape: it gets a primitive that reports to be near every grain (per-contact storage requires that) and never
  // computes a contact.
  std::vector<std::string> stock;
};

// Numbers of the chosen chains in rising order. Throws InputError, whose message begins with `fix`, when there is none.
std::vector<int> chosen_chains(const std::string& fix, const BeamChoice& choice, const ModalBoundary& boundary);

}  // namespace footfall
