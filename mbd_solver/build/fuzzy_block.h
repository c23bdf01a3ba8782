#pragma once
// A fuzzy system as a signal.

#include "mbd_solver/model/control/fuzzy.h"
#include "mbd_solver/model/control/signal_blocks.h"

namespace footfall {

class FuzzyBlock final : public SignalBlock {
 public:
  FuzzyBlock(const std::string& file, std::size_t inputs, const std::string& output)
      : function_(file, inputs, output), inputs_(static_cast<int>(inputs)) {}
  int input_count() const override { return inputs_; }
  double value(const BlockValues& u, const BlockValues&) const override { return function_.value(u); }

 private:
  FuzzyFunction function_;
  int inputs_;
};

}  // namespace footfall
