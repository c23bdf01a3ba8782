// footfall_fmu_model: the simulation of an exported FMU, in a separate process (exported_model.h has the requests).
//   footfall_fmu_model RESOURCES        the folder with variables.txt, scene/ and bin/
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/helper_process.h"
#include "mbd_solver/fmi/codes.h"
#include "mbd_solver/fmi/model/exported_model.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/observe/spring_fit.h"
#include "mbd_solver/session/session.h"

namespace {

using namespace footfall;
namespace fs = std::filesystem;

// Ends this process with the importing program, also within a long step: its end of the pipe is closed, or its process is no
// longer our parent. A thread of it may end.
const pid_t kImporter = getppid();
void watch_importer() {
  std::thread([] {
    for (pollfd input = {STDIN_FILENO, 0, 0}; poll(&input, 1, 1000) <= 0;)
      if (getppid() != kImporter) break;
    _exit(1);
  }).detach();
}

// A force that the importing program sets and that depends on the motion of its body, as a spring there does. An explicit
// exchange acts on such a motion like a damping ratio of -omega H / 4, omega = sqrt(k/m): the master must be warned.
class StiffInput {
 public:
  StiffInput(std::string input, std::string body, const Eigen::Vector3d& direction, double mass)
      : input_(std::move(input)), body_(std::move(body)), direction_(direction), mass_(mass) {}

  const std::string& input() const { return input_; }
  // At the beginning of a step of H [s]; the warning, once, or nothing.
  std::string observe(const Session& s, double force, double step) {
    const auto along = [&](const char* const(&names)[3]) {
      double sum = 0.0;
      for (int i = 0; i < 3; ++i) sum += direction_[i] * s.value(body_ + names[i]);
      return sum;
    };
    const std::optional<SpringAndDamper> found =
        fit_.add(along({".x", ".y", ".z"}), along({".vx", ".vy", ".vz"}), force);
    if (told_ || !found) return "";
    const double k = found->k, omega_h = k > 0.0 ? step * std::sqrt(k / mass_) : 0.0;
    if (omega_h < kMostOmegaH) return "";
    told_ = true;
    return with_code(code::kFmuOmegaH, "t = " + number_text(s.time()) + " s: the input \"" + input_ +
                                           "\" answers the motion of body \"" + body_ + "\" like a spring of " +
                                           number_text(k, 3) + " N/m: omega H = " + number_text(omega_h, 2) +
                                           " with steps of H = " + number_text(step, 3) +
                                           " s. An explicit exchange feeds this motion like a "
                                           "damping ratio of " +
                                           number_text(-omega_h / 4.0, 2) + "; take steps below " +
                                           number_text(step * kMostOmegaH / omega_h, 2) + " s");
  }

 private:
  static constexpr double kMostOmegaH = 0.1;

  std::string input_, body_;
  Eigen::Vector3d direction_;
  double mass_;  // [kg]
  SpringFit fit_;
  bool told_ = false;
};

class Model {
 public:
  explicit Model(const std::string& resources) : resources_(resources) {
    for (ExportedVariable& v : variables_of_text(text_of("variables.txt"))) {
      if (v.kind == ExportedVariable::Kind::kInput) inputs_.push_back(v.name);
      if (v.kind == ExportedVariable::Kind::kOutput) outputs_.push_back(v.name);
    }
    exported_with_ = text_of("settings.txt");
    trusted_ = !text_of("trusted.txt").empty();
    scene_ = resources + "/scene/" + trimmed(text_of("scene.txt"));
  }

  std::string answer(const std::string& question) {
    const std::string content = question.substr(1);
    switch (question[0]) {
      case 'N':
        settings_ = content;
        make();
        return values(false);
      case 'S': return step(content);
      case 'G': return "B" + std::to_string(settings_.size()) + "\n" + settings_ + model().save();
      case 'R': {
        std::size_t used = 0;
        const std::size_t size = std::stoul(content, &used);
        const std::string before = settings_;
        settings_ = content.substr(used + 1, size);
        if (!model_ || settings_ != before) make();
        model().restore(content.substr(used + 1 + size));
        return values(false);
      }
      default: throw std::runtime_error("unknown question");
    }
  }

 private:
  std::string text_of(const std::string& name) const { return read_whole_file(resources_ + "/" + name).value_or(""); }
  Session& model() {
    if (!model_) throw std::runtime_error("the model is not initialized");
    return *model_;
  }

  void make() {
    std::vector<std::string> settings;
    for (const std::string& line : split(exported_with_ + settings_, '\n'))
      if (!line.empty()) settings.push_back(line);
    model_.reset();
    const Scene scene = read_scene(scene_, settings);
    model_ = std::make_unique<Session>(scene, SessionOptions{trusted_, false});
    told_ = 0;
    find_places();
    stiff_.clear();
    const std::vector<std::string>& columns = model_->names();
    for (const ForceSpec& force : scene.forces) {
      const BodySpec* const body = scene.body(force.body);
      if (!force.force || !body || !(body->mass > 0.0)) continue;
      if (std::find(inputs_.begin(), inputs_.end(), force.force->signal) == inputs_.end()) continue;
      if (std::find(columns.begin(), columns.end(), force.body + ".vz") == columns.end()) continue;
      stiff_.emplace_back(force.force->signal, force.body, force.direction, body->mass);
    }
  }

  void find_places() {
    places_.clear();
    const std::vector<std::string>& columns = model_->names();
    for (const std::string& name : outputs_) {
      const auto found = std::find(columns.begin(), columns.end(), name);
      const bool own = name == kBalanceColumn || name == kErrorColumn;
      if (!own && found == columns.end())
        throw std::runtime_error("the output \"" + name + "\" is no column with these parameters");
      places_.push_back(found - columns.begin());
    }
  }

  std::string step(const std::string& content) {
    std::vector<double> numbers(content.size() / sizeof(double));
    std::memcpy(numbers.data(), content.data(), numbers.size() * sizeof(double));
    if (numbers.size() != 2 + inputs_.size()) throw std::runtime_error("a step with too few numbers");
    Session& s = model();
    for (std::size_t i = 0; i < inputs_.size(); ++i)
      if (s.signal(inputs_[i]) != numbers[2 + i]) s.set(inputs_[i], numbers[2 + i]);
    const double begin = s.time(), until = numbers[0];
    for (StiffInput& input : stiff_)
      if (const std::string warning = input.observe(s, s.signal(input.input()), until - begin); !warning.empty())
        warnings_ += warning + "\n";
    return values(advance(until, numbers[1] != 0.0));
  }

  // To this time [s]. early: at most to the next event that changes the state; true: that ended the step. The event is found by
  // a step to the end, from whose beginning it is done again.
  bool advance(double until, bool early) {
    Session& s = model();
    const std::vector<std::string>& names = s.names();
    if (!early || std::find(names.begin(), names.end(), "state.since") == names.end()) {
      s.step_to(until);
      return false;
    }
    const auto last_event = [&] { return s.time() - s.value("state.since"); };
    const double begin = s.time(), before = last_event();
    const std::string saved = s.save();
    s.step_to(until);
    const double event = last_event();
    if (!(event > before + 1e-9 && event > begin && event < until * (1.0 - 1e-9))) return false;
    s.restore(saved);
    s.step_to(event);
    return true;
  }

  std::string values(bool early) {
    Session& s = model();
    const std::vector<double> row = s.row();
    std::vector<double> numbers = {s.time(), early ? 1.0 : 0.0, s.finished() ? 1.0 : 0.0};
    for (std::size_t i = 0; i < outputs_.size(); ++i)
      numbers.push_back(outputs_[i] == kBalanceColumn ? s.energy_balance()
                        : outputs_[i] == kErrorColumn ? s.summed_error()
                                                      : row[places_[i]]);
    for (std::size_t i = 0; i < outputs_.size(); ++i)
      if (!std::isfinite(numbers[3 + i])) throw std::runtime_error("the output \"" + outputs_[i] + "\" is not finite");
    const std::vector<std::string> all = s.warnings();
    for (; told_ < all.size(); ++told_) warnings_ += all[told_] + "\n";
    std::string warnings;
    warnings.swap(warnings_);
    return "V" + std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)) + warnings;
  }

  std::string resources_, scene_, exported_with_, settings_;
  bool trusted_ = false;
  std::vector<std::string> inputs_, outputs_;
  std::vector<std::size_t> places_;  // of the outputs in a row
  std::unique_ptr<Session> model_;
  std::vector<StiffInput> stiff_;
  std::string warnings_;  // for the next answer
  std::size_t told_ = 0;  // of the model's own
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr,
                 "footfall_fmu_model: the simulation of an exported FMU, which starts it; it is not for use by hand\n");
    return 2;
  }
  watch_importer();
  signal(SIGPIPE, SIG_IGN);
  const int out = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  std::unique_ptr<Model> model;
  for (std::string question; HelperProcess::read_frame(STDIN_FILENO, question);) {
    std::string answer;
    try {
      if (!model) model = std::make_unique<Model>(argv[1]);
      answer = model->answer(question.empty() ? "?" : question);
    } catch (const std::exception& error) {
      answer = std::string("E") + error.what();
    }
    if (!HelperProcess::write_frame(out, answer)) break;
  }
  return 0;
}
