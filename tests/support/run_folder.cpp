#include "tests/support/run_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace footfall::test {

RunFolder::RunFolder(const std::string& name)
    : path_(std::filesystem::path(FOOTFALL_BINARY_DIR) / "test_runs" / (name + "_" + std::to_string(getpid()))) {
  std::filesystem::remove_all(path_);
  std::filesystem::create_directories(path_);
  // Open MPI refuses root unless it is told that this is meant.
  setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
}

RunFolder::~RunFolder() {
  std::error_code ignored;
  if (!path_.empty() && !::testing::Test::HasFailure()) std::filesystem::remove_all(path_, ignored);
}

void RunFolder::write(const std::string& file, const std::string& text) const {
  std::ofstream out(path_ / file);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + (path_ / file).string());
}

std::string RunFolder::read(const std::string& file) const {
  std::ifstream in(path_ / file, std::ios::binary);
  if (!in) throw std::runtime_error("no file " + (path_ / file).string());
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

Outcome RunFolder::command(const std::string& line, int limit_seconds) const {
  const auto start = std::chrono::steady_clock::now();
  const std::string whole = "cd '" + path_.string() + "' && timeout -k 2 " + std::to_string(limit_seconds) + " " +
                            line + " > output.txt 2>&1 < /dev/null";
  const int status = std::system(whole.c_str());
  Outcome outcome;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.text = read("output.txt");
  return outcome;
}

Outcome RunFolder::mpirun(const std::string& programs, int limit_seconds) const {
  return command("mpirun --oversubscribe " + programs, limit_seconds);
}

std::string RunFolder::program(const std::string& name) { return std::string(FOOTFALL_BINARY_DIR) + "/bin/" + name; }

Outcome RunFolder::alone(const std::string& liggghts, int ranks, const std::string& arguments,
                         int limit_seconds) const {
  return mpirun("-np " + std::to_string(ranks) + " " + liggghts + " " + arguments, limit_seconds);
}

Outcome RunFolder::coupled(int ranks, const std::string& arguments, const std::string& partner,
                           int limit_seconds) const {
  return mpirun("-np " + std::to_string(ranks) + " " + program("liggghts_mbd") + " " + arguments + " : -np 1 " +
                    program("scripted_partner") + " " + partner,
                limit_seconds);
}

}  // namespace footfall::test
