// Requests to the program of a signal, and the meaning of its answers. Its state in a checkpoint is text: base64.

#include "mbd_solver/assemble/foreign_block.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "coupler/archive.h"
#include "coupler/base/text.h"
#include "mbd_solver/assemble/codes.h"
#include "mbd_solver/base/packed_bytes.h"

namespace footfall {
namespace {

constexpr double kSampleRounding = 1e-6;  // of a period
constexpr double kTimeToBegin = 60.0;     // of a new program [s]

std::vector<double> numbers_of(std::initializer_list<double> times, const BlockValues& u) {
  std::vector<double> numbers(times);
  numbers.insert(numbers.end(), u.data(), u.data() + u.size());
  return numbers;
}

}  // namespace

void ForeignFunction::fail(const std::string& what) const {
  throw ForeignError(code::kForeignFailed, "t = ", number_text(time_, 9), " s: ", program_.label, ": ", what);
}

double ForeignFunction::sample_time(double t, int later) const {
  return (std::floor(t / program_.period + kSampleRounding) + later) * program_.period;
}

// An interpreter and the files that it imports take longer to begin than to answer.
void ForeignFunction::start() {
  process_ = std::make_unique<HelperProcess>(program_.command, program_.limit);
  answer_to("T" + joined(program_.task, std::string(1, '\0')), std::max(program_.limit, kTimeToBegin));
}

std::string ForeignFunction::ask(char letter, const std::vector<double>& numbers, const std::string& bytes) {
  std::string question(1, letter);
  question.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  question += bytes;
  try {
    if (!process_) start();
    return answer_to(question, program_.limit);
  } catch (const NoAnswer& error) {
    process_.reset();
    fail(std::string("its program ") + error.what());
  }
}

std::string ForeignFunction::answer_to(const std::string& question, double limit) {
  std::string answer = process_->ask(question, limit);
  if (answer.empty()) fail("its program sent an empty answer");
  if (answer[0] == 'E') fail(answer.substr(1));
  return answer;
}

void ForeignFunction::ask_outputs(char letter, const std::vector<double>& numbers, const std::string& bytes) {
  const std::string answer = ask(letter, numbers, bytes);
  const std::size_t size = static_cast<std::size_t>(program_.outputs) * sizeof(double);
  if (answer[0] != 'V' || answer.size() != 1 + size)
    fail(concat("its program sent an answer of ", answer.size(), " bytes, expected ", program_.outputs, " outputs"));
  outputs_.resize(program_.outputs);
  std::memcpy(outputs_.data(), answer.data() + 1, size);
  for (int i = 0; i < program_.outputs; ++i)
    if (!std::isfinite(outputs_[i]))
      fail(concat("its output \"", program_.output_names[i], "\" is ", outputs_[i],
                  ", expected a finite number; check the inputs and parameters that it is given"));
}

void ForeignFunction::begin(double t, const BlockValues& u) {
  time_ = sample_time(t, 0);
  inputs_ = u;
  ask_outputs('I', numbers_of({time_}, u));
}

void ForeignFunction::step(double t, const BlockValues& u) {
  const double next = sample_time(t, 1);
  if (t > program_.end - kSampleRounding * program_.period) return;
  inputs_ = u;
  ask_outputs('S', numbers_of({time_, next}, u));
  time_ = next;
}

void ForeignFunction::visit(Archive& archive) {
  archive("time", time_);
  archive("inputs", inputs_);
  archive("outputs", outputs_);
  std::string state;
  if (!archive.restores() && process_) {
    const std::string answer = ask('G', {}, "");
    if (answer[0] == 'N')
      throw ForeignError(code::kForeignStateless, program_.label,
                         ": a checkpoint cannot be written: ", answer.substr(1));
    if (answer[0] != 'B') fail("its program sent another answer than its state");
    state = base64(answer.substr(1));
  }
  bool begun = process_ != nullptr;
  archive("begun", begun);
  archive("state", state);
  if (!archive.restores() || !begun) return;
  const std::optional<std::string> bytes = bytes_of_base64(state);
  if (!bytes || inputs_.size() != program_.inputs)
    throw InputError(code::kForeignState, program_.label,
                     ": its state in the checkpoint is damaged; resume from another one");
  process_.reset();
  const Eigen::VectorXd known = outputs_;
  ask_outputs('R', numbers_of({time_}, inputs_), *bytes);
  outputs_ = known;
}

void ForeignBlock::settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const {
  const Eigen::Index n = u.size() - 1;
  function_->begin(u[n], u.head(n));
  z = function_->outputs();
}

void ForeignBlock::advance(const BlockValues& u, double, Eigen::Ref<Eigen::VectorXd> z) const {
  const Eigen::Index n = u.size() - 1;
  function_->step(u[n], u.head(n));
  z = function_->outputs();
}

double ForeignBlock::sample(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const {
  advance(u, period, z);
  return z[0];
}

}  // namespace footfall
