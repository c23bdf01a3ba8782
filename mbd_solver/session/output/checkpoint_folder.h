#pragma once
// Checkpoints of a run as folders RUN/checkpoint/N/. A checkpoint is written to N.part, synced to the disk with a list of
// its files and their checksums, and then renamed: a folder without ".part" is complete. The last two are kept.

#include <string>
#include <vector>

namespace footfall {

// Wall-clock checkpoint interval of runs without output.checkpoint_interval [s].
inline constexpr double kCheckpointEvery = 60.0;

// Content of the file or folder is safe from a power cut afterwards. Throws InputError when the disk reports an error.
void sync_to_disk(const std::string& path);

class CheckpointFolder {
 public:
  explicit CheckpointFolder(const std::string& run) : folder_(run + "/checkpoint") {}
  ~CheckpointFolder() { cancel(); }
  CheckpointFolder(const CheckpointFolder&) = delete;
  CheckpointFolder& operator=(const CheckpointFolder&) = delete;

  // Creates the empty folder of checkpoint n, into which files are then written; returns its absolute path. Throws
  // InputError.
  std::string begin(long n);
  // All files are written. Throws InputError when the disk reports an error; older checkpoints then still exist.
  void finish();
  void cancel();  // removes a checkpoint that is not finished
  void clear();   // removes the checkpoints written by this object, and the folder when it is empty

 private:
  std::string folder_;
  std::string part_;  // folder of the unfinished checkpoint
  long n_ = 0;
  std::vector<long> written_;
};

// Removes unfinished checkpoints of programs that were killed. No program may be writing there.
void remove_unfinished_checkpoints(const std::string& run);

// The folder of the newest checkpoint whose files agree with their checksums. Throws InputError, with the damage found,
// when there is none.
std::string newest_checkpoint(const std::string& run);

}  // namespace footfall
