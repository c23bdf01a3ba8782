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
  // words: options of the host; limit: of an answer [s].
  AskedFmu(const std::string& file, const std::vector<std::string>& words, double limit)
      : process_(line(file, words), limit) {}
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
  static std::vector<std::string> line(const std::string& file, const std::vector<std::string>& words) {
    std::vector<std::string> all = {FMU_HOST, "run", file};
    all.insert(all.end(), words.begin(), words.end());
    return all;
  }
  HelperProcess process_;
};

}  // namespace footfall::test
