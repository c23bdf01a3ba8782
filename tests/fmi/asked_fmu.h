#pragma once
// An FMU in its host, asked as a run asks it.

#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "mbd_solver/base/helper_process.h"

namespace footfall::test {

class AskedFmu {
 public:
  // words: the rest of the task; limit: of an answer [s].
  AskedFmu(const std::string& file, const std::vector<std::string>& words, double limit)
      : process_({Rights::of_user(), {FMU_HOST, "run"}}, limit) {
    std::string task = "T" + file;
    for (const std::string& word : words) task += '\0' + word;
    process_.ask(task);
  }
  // The numbers of an answer; throws another answer as its text.
  std::vector<double> ask(char letter, const std::vector<double>& numbers, const std::string& bytes = "") {
    const std::string answer = raw(letter, numbers, bytes);
    if (answer[0] != 'V') throw std::runtime_error(answer);
    std::vector<double> values((answer.size() - 1) / sizeof(double));
    std::memcpy(values.data(), answer.data() + 1, values.size() * sizeof(double));
    return values;
  }
  std::string raw(char letter, const std::vector<double>& numbers, const std::string& bytes = "") {
    std::string question(1, letter);
    question.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
    return process_.ask(question + bytes);
  }

 private:
  HelperProcess process_;
};

}  // namespace footfall::test
