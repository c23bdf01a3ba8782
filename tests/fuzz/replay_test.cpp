// Every reader reads the files of its corpus, and damaged files made of them: bytes changed, cut, doubled, parts of other files put in. Damage
// is the same every time. FOOTFALL_DAMAGED: how many for each reader (default 100).
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <random>

#include "coupler/base/files.h"
#include "tests/fuzz/targets.h"

namespace footfall::fuzz {
namespace {

constexpr std::size_t kLargest = 65536;  // [bytes] of a damaged file

class Damage {
 public:
  explicit Damage(const std::vector<std::string>& texts) : texts_(texts) {}
  std::string operator()() {
    std::string text = texts_[below(texts_.size())];
    for (std::size_t times = 1 + below(4); times > 0; --times) once(text);
    return text.substr(0, kLargest);
  }

 private:
  std::size_t below(std::size_t n) { return n > 0 ? random_() % n : 0; }
  void once(std::string& text) {
    const std::size_t place = below(text.size() + 1),
                      length = below(std::min<std::size_t>(text.size() - place, 64) + 1);
    static constexpr const char* kStrange[] = {"nan", "-1", "1e999", "99999999999", "0", "[", "\"", "\n", ",", "\xff"};
    switch (below(6)) {
      case 0:
        if (place < text.size()) text[place] = static_cast<char>(random_());
        break;
      case 1: text.erase(place, length); break;
      case 2: text.resize(place); break;
      case 3: text.insert(place, text.substr(place, length)); break;
      case 4: text.replace(place, length, kStrange[below(std::size(kStrange))]); break;
      default: {
        const std::string& other = texts_[below(texts_.size())];
        text.insert(place, other.substr(below(other.size() + 1), 64));
      }
    }
  }

  const std::vector<std::string>& texts_;
  std::mt19937 random_{7};  // seed
};

char now[512];  // what is being read, for a crash

void report_crash(int signal_number) {
  if (write(STDERR_FILENO, now, std::strlen(now)) < 0) std::abort();
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

class Fuzz : public ::testing::TestWithParam<Target> {};

TEST_P(Fuzz, ReadsOrRefusesWhatever) {
  for (const int number : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE}) std::signal(number, report_crash);
  std::vector<std::string> files, texts;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(FOOTFALL_CORPUS) + "/" + GetParam().name))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  ASSERT_FALSE(files.empty());
  const auto read = [](const std::string& what, const std::string& text) {
    std::snprintf(now, sizeof now, "crashed at %s\n", what.c_str());
    EXPECT_NO_THROW(GetParam().read(text)) << what;
  };
  for (const std::string& file : files) {
    texts.push_back(read_whole_file(file).value_or(""));
    read(file, texts.back());
  }
  Damage damage(texts);
  const char* number = std::getenv("FOOTFALL_DAMAGED");
  for (long k = number ? std::atol(number) : 100; k > 0; --k)
    read("damaged, " + std::to_string(k) + " to go", damage());
}

INSTANTIATE_TEST_SUITE_P(Readers, Fuzz, ::testing::ValuesIn(targets()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace footfall::fuzz
