// import_damaged SECONDS SEED FILE...: imports damaged copies of robots, each in a process of its own that is forked from this one, whose
// libraries are loaded. Each ends with exit code 0 and a scene, or with 2, a message with a code, and nothing written; never with a crash,
// a hang or another exception. Keeps the damaged file that does not. Pieces come from all files: give files of one format.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include "coupler/base/errors.h"
#include "mbd_solver/import/import_command.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kLongest = 60;  // of one import [s]
const char* const kWords[] = {
    "nan",        "1e400", "-1",    "0",    "1e-320", "",     "world", "0 0",   "1 2 3 4 5 6 7 8",
    "<",          ">",     "&amp;", "\x01", "\xff",   "${x}", "true",  "-inf",  "package://x/y.stl",
    "2147483648", "1e300", "-0",    "1e-9", "999999", ".",    "../",   "0 0 0", "0 0 1"};

std::string whole(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Damage {
 public:
  Damage(unsigned seed, std::vector<std::string> texts) : dice_(seed), texts_(std::move(texts)) {}

  std::size_t below(std::size_t n) { return n == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, n - 1)(dice_); }

  std::string of(std::string text) {
    static constexpr int kTimes[] = {1, 1, 1, 2, 5};
    for (int left = kTimes[below(5)]; left > 0; --left) text = once(text);
    return text;
  }

 private:
  std::string word() {
    const std::size_t k = below(std::size(kWords) + 2);
    if (k < std::size(kWords)) return kWords[k];
    return k == std::size(kWords) ? std::string(5000, 'a') : token(texts_[below(texts_.size())]);
  }

  // A piece in quotes, of any of the files.
  std::string token(const std::string& text) {
    const std::size_t at = text.find('"', below(text.size())),
                      end = at == std::string::npos ? at : text.find('"', at + 1);
    return end == std::string::npos ? "x" : text.substr(at + 1, std::min<std::size_t>(end - at - 1, 200));
  }

  // A whole line; elements of most files stand on lines of their own.
  static std::pair<std::size_t, std::size_t> line_at(const std::string& text, std::size_t at) {
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1), after = text.find('\n', at);
    const std::size_t from = before == std::string::npos ? 0 : before + 1;
    return {from, (after == std::string::npos ? text.size() : after + 1) - from};
  }

  std::string once(std::string text) {
    if (text.empty()) return word();
    const std::size_t at = below(text.size());
    const auto [from, length] = line_at(text, at);
    switch (below(9)) {
      case 0: text[at] = static_cast<char>(below(256)); return text;
      case 1: return text.substr(0, at);
      case 2: return text.erase(from, length);
      case 3: {
        const std::string& other = texts_[below(texts_.size())];
        const auto [start, count] = line_at(other, below(other.size()));
        return text.insert(from, other.substr(start, count));
      }
      case 4: return text.erase(at, below(60));
      case 5:
      case 6: {  // the value of an attribute or element
        const char open = below(3) > 0 ? '"' : '>', close = open == '"' ? '"' : '<';
        const std::size_t begin = text.find(open, at),
                          end = begin == std::string::npos ? begin : text.find(close, begin + 1);
        return end == std::string::npos ? text : text.replace(begin + 1, end - begin - 1, word());
      }
      case 7: {  // two lines
        const std::string line = text.substr(from, length);
        text.erase(from, length);
        return text.insert(text.empty() ? 0 : line_at(text, below(text.size())).first, line);
      }
      default: {
        const std::size_t blank = text.find(' ', at);
        return blank == std::string::npos ? text + word() : text.insert(blank, " " + word());
      }
    }
  }

  std::mt19937 dice_;
  std::vector<std::string> texts_;
};

// Exit code, or -signal.
int imported(const ImportArguments& arguments, const std::string& said) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(kLongest);
    const int out = ::open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(out, STDERR_FILENO);
    int code = 1;
    try {
      code = import_command(arguments);
    } catch (const InputError& e) {
      std::fprintf(stderr, "%s\n", e.what());
      code = 2;
    } catch (const std::exception& e) {
      std::fprintf(stderr, "exception: %s\n", e.what());
    }
    std::fflush(nullptr);
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

int damage(double seconds, unsigned seed, const std::vector<std::string>& files) {
  std::vector<std::string> texts;
  for (const std::string& file : files) texts.push_back(whole(file));
  Damage dice(seed, texts);
  const TemporaryFolder place;
  const std::string folder = place.folder_.string();
  const std::string said = folder + "/said", out = folder + "/out";
  std::map<int, int> codes;
  int count = 0, failed = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end) {
    const std::size_t k = dice.below(files.size());
    ImportArguments a;
    a.file = folder + "/robot" + fs::path(files[k]).extension().string();
    a.out = out;
    a.quiet = true;
    const std::size_t how = dice.below(4);
    a.options.hold = how == 1;
    if (how == 2) a.options.ground = "grains";
    a.options.merge_fixed = a.options.fix_base = how == 3;
    std::ofstream(a.file, std::ios::binary) << dice.of(texts[k]);
    const int code = imported(a, said);
    ++count;
    ++codes[code];
    const std::string message = whole(said);
    const bool good = (code == 0 && fs::exists(out + "/scene.toml")) ||
                      (code == 2 && !fs::exists(out) && message.find(" [E") != std::string::npos);
    if (!good) {
      const std::string kept =
          "damaged_" + std::to_string(seed) + "_" + std::to_string(++failed) + fs::path(a.file).extension().string();
      fs::copy_file(a.file, kept, fs::copy_options::overwrite_existing);
      std::printf("%s: exit code or -signal %d, options %zu: %s\n", kept.c_str(), code, how,
                  message.substr(message.size() > 300 ? message.size() - 300 : 0).c_str());
      std::fflush(stdout);
    }
    fs::remove_all(out);
  }
  std::printf("%d damaged files:", count);
  for (const auto& [code, times] : codes) std::printf(" %d of exit code %d,", times, code);
  std::printf(" %d failed\n", failed);
  return failed > 0 ? 1 : 0;
}

}  // namespace
}  // namespace footfall

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "import_damaged SECONDS SEED FILE...\n");
    return 2;
  }
  return footfall::damage(std::atof(argv[1]), static_cast<unsigned>(std::atoi(argv[2])), {argv + 3, argv + argc});
}
