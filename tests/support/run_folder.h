#pragma once
// Runs programs in a folder of their own below the build tree, always with a time limit.

#include <filesystem>
#include <string>
#include <utility>

namespace footfall::test {

struct Outcome {
  int exit_code = -1;  // 124: the time limit struck
  double seconds = 0.0;
  std::string text;  // standard output and error of all programs
};

// A clean folder for one test: of this process alone, because ctest runs several tests of one program at once. It goes away
// with its owner where the test has not failed.
class RunFolder {
 public:
  explicit RunFolder(const std::string& name);
  RunFolder(RunFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  ~RunFolder();

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& file, const std::string& text) const;
  // Throws std::runtime_error when there is no such file.
  std::string read(const std::string& file) const;
  bool has(const std::string& file) const { return std::filesystem::exists(path_ / file); }

  // A line for the shell, in the folder.
  Outcome command(const std::string& line, int limit_seconds) const;
  // The programs of one job: what follows `mpirun`, more ranks than cores allowed.
  Outcome mpirun(const std::string& programs, int limit_seconds = 60) const;
  // A program of this build.
  static std::string program(const std::string& name);

  // Stock LIGGGHTS, or ours without a partner.
  Outcome alone(const std::string& liggghts, int ranks, const std::string& arguments, int limit_seconds = 60) const;
  // liggghts_mbd and the scripted partner.
  Outcome coupled(int ranks, const std::string& arguments, const std::string& partner, int limit_seconds = 60) const;

 private:
  std::filesystem::path path_;
};

}  // namespace footfall::test
