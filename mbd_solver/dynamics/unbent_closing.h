#pragma once
// Flexible bodies are turned to where their joints close, and not bent: in the metric of masses a stiff body is bent as
// easily as it is turned, and the smallest motion alone would leave it with great forces.

#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/model/model.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// The bodies and joints of a model, and of its forces what counts turns alone.
Model without_forces(const Model& model);

// Closes the joints of a model without forces by moving its bodies as if none could bend.
class UnbentClosing {
 public:
  // layout: of the model. Both must outlive this.
  UnbentClosing(const Model& model, const Layout& layout);
  // Leaves the state as it is where that is not enough, and where no body can bend.
  void close(State& state);

 private:
  const Layout& layout_;
  Model model_;  // the same bodies and joints, and none of the bodies can bend
  Layout rigid_;
  ConstraintRows rows_;
  bool bends_ = false;
};

// The same for the places of a drawing that is open.
void close_unbent(const Model& model, State& state);

}  // namespace footfall
