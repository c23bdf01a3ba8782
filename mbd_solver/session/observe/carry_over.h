#pragma once
// Between the state of a model and the file that holds the end of a run (build/end_state.h).

#include <string>
#include <vector>

#include "mbd_solver/assemble/end_state.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/state.h"

namespace footfall {

EndState end_state_of(const Mechanism& mechanism, const Layout& layout, const State& state);

// Sets what initial.from has of the bodies, elements and joints of this model. Throws InputError if it has none of the bodies,
// or one with other modes. notes: warnings about what is not carried over; null: none.
void carry_over(const Scene& scene, const Model& model, const Layout& layout, State& state,
                std::vector<std::string>* notes);

}  // namespace footfall
