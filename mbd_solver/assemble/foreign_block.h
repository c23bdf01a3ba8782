#pragma once
// Signals that code of the user computes, in a separate process (base/helper_process.h), once per period.
//
// A request is a letter, then numbers (double, in the machine's order of bytes) or bytes:
//   T  texts...          the task: words that a zero byte separates          answer V, without outputs
//   I  t, u...           begins at the time t [s] with these inputs         answer V
//   S  t, t_next, u...   from t to t_next [s] with these inputs             answer V
//   G                    the data that the program needs to continue        answer B, or N if it has none to give
//   R  t, u..., bytes    continues at t from these bytes, in a new program  answer V
// and an answer likewise:
//   V  y...   the outputs, in the order of the scene
//   B  bytes
//   N  text   the reason why no state can be saved
//   E  text   an error: it ends the run

#include <memory>
#include <string>
#include <vector>

#include "mbd_solver/base/helper_process.h"
#include "mbd_solver/model/control/signal_blocks.h"

namespace footfall {

struct ForeignProgram {
  std::string label;                   // for messages: "signal \"engine\" (engine.fmu)"
  Command command{Rights::of_user()};  // the user trusts the scene that names it
  std::vector<std::string> task;       // the words of request T, the first request to a new program
  double limit = 0.0;                  // for one answer, by the wall clock [s]
  int inputs = 0, outputs = 0;
  std::vector<std::string> output_names;  // for messages
  double period = 0.0;                    // [s]
  double end = 0.0;                       // of the run: no step begins there [s]
};

// The conversation with one program, which is started with the first question.
class ForeignFunction {
 public:
  explicit ForeignFunction(ForeignProgram program) : program_(std::move(program)) {}

  const ForeignProgram& program() const { return program_; }
  const Eigen::VectorXd& outputs() const { return outputs_; }  // of the last answer

  // Each throws ForeignError, with time and label. u: the inputs at time t [s].
  void begin(double t, const BlockValues& u);  // from its start again, too
  // From the end of its last step to the next multiple of the period after t.
  void step(double t, const BlockValues& u);
  void visit(Archive& archive);

 private:
  void start();
  std::string ask(char letter, const std::vector<double>& numbers, const std::string& bytes);
  std::string answer_to(const std::string& question, double limit);  // [s]
  void ask_outputs(char letter, const std::vector<double>& numbers, const std::string& bytes = "");
  [[noreturn]] void fail(const std::string& what) const;
  double sample_time(double t, int later) const;  // the multiple of the period at t, or so many later [s]

  ForeignProgram program_;
  std::unique_ptr<HelperProcess> process_;
  Eigen::VectorXd outputs_, inputs_;
  double time_ = 0.0;  // the end of its last step [s]
};

// The first output. Its inputs are the program's inputs and last the time. `direct`: the outputs at a sample follow from
// its inputs; otherwise they are the end of the step from the sample before, and a loop of signals may contain the block.
class ForeignBlock final : public SignalBlock {
 public:
  ForeignBlock(std::shared_ptr<ForeignFunction> function, bool direct)
      : function_(std::move(function)), direct_(direct) {}

  int input_count() const override { return function_->program().inputs + 1; }
  int state_count() const override { return function_->program().outputs; }
  bool passes_through() const override { return direct_; }
  bool runs_apart() const override { return true; }
  void settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const override;
  double value(const BlockValues&, const BlockValues& z) const override { return z[0]; }
  void advance(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const override;
  double sample(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const override;
  void visit(Archive& archive) override { function_->visit(archive); }

 private:
  std::shared_ptr<ForeignFunction> function_;
  bool direct_;
};

// Another output of the same program. Its input is the signal of the first, so that it is evaluated later.
class ForeignOutput final : public SignalBlock {
 public:
  ForeignOutput(std::shared_ptr<const ForeignFunction> function, int output)
      : function_(std::move(function)), output_(output) {}
  bool runs_apart() const override { return true; }
  double value(const BlockValues&, const BlockValues&) const override {
    return output_ < function_->outputs().size() ? function_->outputs()[output_] : 0.0;
  }

 private:
  std::shared_ptr<const ForeignFunction> function_;
  int output_;
};

}  // namespace footfall
