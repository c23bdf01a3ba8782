// footfall_fmu_host: reads and runs one FMU for another program, which sends requests through standard input and output
// (base/helper_process.h, assemble/foreign_block.h). The code of the FMU runs in a process that this process watches: in
// every case the folder with the unpacked FMU is removed.
//   footfall_fmu_host describe      request D with the path of an FMU: its description
//   footfall_fmu_host run           the requests of foreign_block.h; the task is FILE, then input NAME, output NAME, start NAME VALUE

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/helper_process.h"
#include "mbd_solver/fmi/fmu_file.h"
#include "mbd_solver/fmi/fmu_instance.h"

namespace {

using namespace footfall;
namespace fs = std::filesystem;

constexpr int kBadUse = 2;  // exit code

struct HostTask {
  std::string file;
  std::vector<std::string> inputs, outputs;
  FmuStarts starts;
};

// The values of a variable as a description or a scene writes them, so many.
std::vector<double> values_of(const FmuVariable& variable, const std::string& text, std::size_t count) {
  std::vector<double> values;
  for (const std::string& word : split(text, ' ')) {
    if (word.empty()) continue;
    values.push_back(word == "true" ? 1.0 : word == "false" ? 0.0 : read_number(word.c_str(), nullptr));
  }
  if (values.empty()) values.push_back(0.0);
  if (values.size() == 1) values.resize(count, values[0]);
  if (values.size() != count)
    throw FmuError("its variable \"" + variable.name + "\" has " + std::to_string(count) +
                   " elements, but the start value has " + std::to_string(values.size()));
  return values;
}

// A variable that is set or read as a whole, of which a scene uses some elements.
struct UsedVariable {
  const FmuVariable* variable;
  std::vector<double> values;
};

class FmuRun {
 public:
  FmuRun(const HostTask& task, const std::string& folder) : task_(task), description_(read_fmu(task.file)) {
    if (!description_.obstacle.empty())
      throw FmuError(description_.obstacle.substr(description_.obstacle.find(' ') + 1));
    unpack_fmu(task.file, folder);
    for (const std::string& name : task.inputs) inputs_.push_back(place_of_name(name, to_set_));
    for (const std::string& name : task.outputs) outputs_.push_back(place_of_name(name, to_get_));
    bool structure = false;
    for (const auto& [name, value] : task.starts) {
      const FmuVariable* const v = description_.find(name);
      structure = structure || (v && v->causality == "structuralParameter");
    }
    instance_ = description_.version[0] == '2' ? make_instance_2(description_, folder)
                                               : make_instance_3(description_, folder, structure);
  }

  std::string answer(const std::string& question) {
    const char letter = question[0];
    std::vector<double> numbers;
    const auto take = [&](std::size_t count) {
      if (question.size() < 1 + count * sizeof(double)) throw FmuError("a request to its host has too few numbers");
      numbers.resize(count);
      std::memcpy(numbers.data(), question.data() + 1, count * sizeof(double));
    };
    switch (letter) {
      case 'I':
        take(1 + inputs_.size());
        begin(numbers[0], numbers.data() + 1);
        return outputs();
      case 'S':
        take(2 + inputs_.size());
        set_inputs(numbers.data() + 2);
        instance_->step(numbers[0], numbers[1]);
        return outputs();
      case 'G': {
        if (!description_.keeps_state) return "Nthe FMU cannot save its state (canSerializeFMUState)";
        std::string start(reinterpret_cast<const char*>(&start_), sizeof start_);
        return "B" + start + instance_->state();
      }
      case 'R': {
        take(1 + inputs_.size());
        const std::string bytes = question.substr(1 + numbers.size() * sizeof(double));
        if (bytes.size() < sizeof start_) throw FmuError("its state in the checkpoint is damaged");
        std::memcpy(&start_, bytes.data(), sizeof start_);
        begin(start_, numbers.data() + 1);
        instance_->restore(bytes.substr(sizeof start_));
        return outputs();
      }
      default: throw FmuError("its host received an unknown request");
    }
  }

 private:
  struct VariableElement {
    std::size_t variable;  // in a list of used ones
    std::size_t element;
  };

  std::size_t count_of(const FmuVariable& v) const {
    return static_cast<std::size_t>(FmuDescription::count(description_.sizes(v, task_.starts)));
  }

  VariableElement place_of_name(const std::string& name, std::vector<UsedVariable>& used) {
    const FmuElement found = find_element(description_, name, task_.starts);
    if (!found.variable) throw FmuError("it has no variable \"" + name + "\"");
    if (!found.problem.empty()) throw FmuError("its variable \"" + name + "\" " + found.problem);
    for (std::size_t i = 0; i < used.size(); ++i)
      if (used[i].variable == found.variable) return {i, static_cast<std::size_t>(found.place)};
    const FmuVariable& v = *found.variable;
    const auto given = task_.starts.find(v.name);
    used.push_back({&v, values_of(v, given == task_.starts.end() ? v.start : given->second, count_of(v))});
    return {used.size() - 1, static_cast<std::size_t>(found.place)};
  }

  void set_starts(bool structural) {
    for (const auto& [name, value] : task_.starts) {
      const FmuVariable* const v = description_.find(name);
      if (!v) throw FmuError("it has no variable \"" + name + "\"");
      if ((v->causality == "structuralParameter") != structural) continue;
      v->is_number() ? instance_->set(*v, values_of(*v, value, count_of(*v))) : instance_->set_text(*v, value);
    }
  }
  void set_inputs(const double* u) {
    for (std::size_t i = 0; i < inputs_.size(); ++i) to_set_[inputs_[i].variable].values[inputs_[i].element] = u[i];
    for (const UsedVariable& used : to_set_) instance_->set(*used.variable, used.values);
  }
  void begin(double time, const double* u) {
    start_ = time;
    instance_->begin(
        time, [&] { set_starts(true); }, [&] { set_starts(false); }, [&] { set_inputs(u); });
  }
  std::string outputs() {
    for (UsedVariable& used : to_get_) used.values = instance_->get(*used.variable, used.values.size());
    std::string answer = "V";
    for (const VariableElement& place : outputs_) {
      const double value = to_get_[place.variable].values[place.element];
      answer.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return answer;
  }

  const HostTask& task_;
  FmuDescription description_;
  std::vector<UsedVariable> to_set_, to_get_;
  std::vector<VariableElement> inputs_, outputs_;
  std::unique_ptr<FmuInstance> instance_;
  double start_ = 0.0;  // of the instance [s]
};

// Answers until the input ends. An FMU that prints writes to standard error.
int serve(const std::function<std::string(const std::string&)>& answer) {
  const int out = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  std::string question;
  while (HelperProcess::read_frame(STDIN_FILENO, question)) {
    std::string text;
    try {
      if (question.empty()) throw FmuError("its host received an empty request");
      text = answer(question);
    } catch (const std::exception& error) {
      text = std::string("E") + error.what();
    }
    if (!HelperProcess::write_frame(out, text)) return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

int describe() {
  return serve([](const std::string& question) -> std::string {
    try {
      return "V" + text_of(read_fmu(question.substr(1)));
    } catch (const FmuProblem& problem) {
      return "E" + problem.kind + "\t" + problem.what();
    }
  });
}

HostTask task_of(const std::string& question) {
  const std::vector<std::string> words = split(question.substr(1), '\0');
  HostTask task;
  task.file = words.empty() ? "" : words[0];
  for (std::size_t i = 1; i + 1 < words.size(); i += 2) {
    if (words[i] == "input") {
      task.inputs.push_back(words[i + 1]);
    } else if (words[i] == "output") {
      task.outputs.push_back(words[i + 1]);
    } else if (words[i] == "start") {
      task.starts[words[i + 1]] = i + 2 < words.size() ? words[i + 2] : "";
      ++i;
    } else {
      throw FmuError("its host was given an unknown task");
    }
  }
  return task;
}

pid_t worker = -1;

void end_worker(int) {
  if (worker > 0) kill(worker, SIGKILL);
}

int run() {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  std::string folder = (place / "footfall_fmu_XXXXXX").string();
  if (error || !mkdtemp(folder.data())) {
    std::fprintf(stderr,
                 "footfall_fmu_host: no folder can be made in %s: %s; set TMPDIR to a folder that you may write to\n",
                 error ? "the temporary folder (TMPDIR)" : place.c_str(),
                 error ? error.message().c_str() : std::strerror(errno));
    return EXIT_FAILURE;
  }
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  for (const int number : {SIGTERM, SIGINT, SIGHUP}) signal(number, end_worker);
  const auto answer_all = [&] {
    for (const int number : {SIGTERM, SIGINT, SIGHUP}) signal(number, SIG_DFL);
    HostTask task;
    std::unique_ptr<FmuRun> of_fmu;
    const int code = serve([&](const std::string& question) -> std::string {
      if (question[0] == 'T') {
        task = task_of(question);
        return "V";
      }
      if (!of_fmu) of_fmu = std::make_unique<FmuRun>(task, folder);
      return of_fmu->answer(question);
    });
    of_fmu.reset();
    std::fflush(nullptr);
    return code;
  };
  worker = start_copy(answer_all, Orphan::kIsKilled);
  for (const int file : {STDIN_FILENO, STDOUT_FILENO}) close(file);
  int status = 0;
  while (worker > 0 && waitpid(worker, &status, 0) < 0 && errno == EINTR) {
  }
  fs::remove_all(folder, error);
  if (!WIFSIGNALED(status)) return WEXITSTATUS(status);
  signal(WTERMSIG(status), SIG_DFL);
  raise(WTERMSIG(status));
  return EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 1 && words[0] == "--version") {
    std::printf("footfall_fmu_host %s\n", FOOTFALL_VERSION);
    return EXIT_SUCCESS;
  }
  if (words.size() != 1 || (words[0] != "describe" && words[0] != "run")) {
    std::fprintf(stderr,
                 "footfall_fmu_host: reads and runs FMUs for mbd_solver, which starts it; it is not for use by hand\n");
    return kBadUse;
  }
  signal(SIGPIPE, SIG_IGN);
  return words[0] == "describe" ? describe() : run();
}
