#include "coupler/base/folder_lock.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds kForTheRest(30);  // programs of a run that was killed end within this
constexpr std::chrono::milliseconds kBetweenLooks(200);

}  // namespace

FileLock lock_folder(const std::string& folder) {
  make_folder(folder);
  const std::string file = (fs::path(folder) / kLockFile).string();
  const auto deadline = std::chrono::steady_clock::now() + kForTheRest;
  FileLock lock = FileLock::try_lock(file);
  while (!lock.held() && !is_alive(owner_of(file)) && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(kBetweenLooks);
    lock = FileLock::try_lock(file);
  }
  if (!lock.held()) {
    const int owner = owner_of(file);
    throw InputError(folder + ": another run writes here" +
                     (owner > 0 ? " (process " + std::to_string(owner) + ")" : std::string()) +
                     "; wait for its end, or choose another folder with --out");
  }
  return lock;
}

std::string locked_name(const std::string& folder) {
  std::error_code error;
  const fs::path full = fs::weakly_canonical(fs::absolute(folder, error), error);
  return error ? folder : (full / "").parent_path().string();
}

bool folder_is_held_for_us(const std::string& folder) {
  const char* held = std::getenv(kLockedFolder);
  return held && locked_name(folder) == held;
}

}  // namespace footfall
