// Feeds files to a target, without libFuzzer: NAME [--damaged COUNT] FOLDER...
// Every file of the folders as it is; then so many damaged ones, at most kSeconds: bytes flipped, cut, doubled, and parts of other files put in. The same
// ones every time.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "coupler/base/whole_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr double kSeconds = 2.0;
constexpr std::size_t kLargest = 65536;  // larger files say nothing new [bytes]

void feed(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

class Damage {
 public:
  explicit Damage(std::vector<std::string> texts) : texts_(std::move(texts)) {}
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

  std::vector<std::string> texts_;
  std::mt19937 random_{7};  // seed
};

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> files;
  long damaged = 0;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--damaged" && i + 1 < argc) {
      damaged = std::atol(argv[++i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
      if (entry.is_regular_file()) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const std::string& file : files) {
    std::printf("%s\n", file.c_str());
    std::fflush(stdout);  // the last name is that of the finding
    texts.push_back(footfall::read_whole_file(file).value_or(""));
    feed(texts.back());
  }
  std::printf("%zu files\n", files.size());
  if (files.empty()) return 1;
  Damage damage(std::move(texts));
  const auto start = std::chrono::steady_clock::now();
  long n = 0;
  for (; n < damaged; ++n) {
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > kSeconds) break;
    std::printf("damaged %ld\n", n);
    std::fflush(stdout);
    feed(damage());
  }
  std::printf("%ld damaged files\n", n);
  return 0;
}
