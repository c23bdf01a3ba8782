#pragma once
// Checkpoints as sets of files: RUN/checkpoint/N/, one folder for each. A set grows in N.part, is brought to the disk with
// a list of its files and their checksums, and is then renamed: a set without ".part" is whole. The last two are kept.

#include <string>
#include <vector>

namespace footfall {

// A run whose scene sets no checkpoint_interval is kept so often on the clock on the wall [s].
inline constexpr double kKeepEvery = 60.0;

// What was written to the file, or into the folder, outlives a power cut. Throws InputError when the disk refuses.
void sync_to_disk(const std::string& path);

class CheckpointFolder {
 public:
  explicit CheckpointFolder(const std::string& run) : folder_(run + "/checkpoint") {}
  ~CheckpointFolder() { drop(); }
  CheckpointFolder(const CheckpointFolder&) = delete;
  CheckpointFolder& operator=(const CheckpointFolder&) = delete;

  // Makes the empty folder of set n, which then takes the files, and returns its absolute path. Throws InputError.
  std::string begin(long n);
  // All files of the set are written. Throws InputError when the disk refuses; older sets are then still there.
  void finish();
  void drop();   // instead, or at the end: a set that is not finished is none
  void clear();  // removes the sets that were written here, and the folder when nothing else is in it

 private:
  std::string folder_;
  std::string part_;  // of the set that grows
  long n_ = 0;
  std::vector<long> written_;
};

// What programs that were killed have left of sets that were growing. Nobody may be writing there any more.
void remove_unfinished_sets(const std::string& run);

// The folder of the newest set of a run whose files are what their checksums say. Throws InputError when there is none,
// and says what is wrong with those that there are.
std::string newest_checkpoint(const std::string& run);

}  // namespace footfall
