#pragma once
// The files that runs have made in a folder, as a list in it: what another run may remove there, and nothing else.

#include <set>
#include <string>
#include <vector>

namespace footfall {

inline constexpr const char* kMadeList = ".footfall.files";  // one path from the folder per line

// Paths from the folder, as they stand on its list; of a run that is under way or was killed also what came to the
// folder while it lived. Lines that lead out of the folder do not count.
std::vector<std::string> made_files(const std::string& folder);

// Removes the files on the list whose paths begin with `start`, and the folders that are empty then. Throws InputError
// when one stays.
void remove_made_files(const std::string& folder, const std::string& start = "");

// From here to its end, what comes to the folder is noted as made by us.
class MadeFiles {
 public:
  // Remembers what is there. Files of the list that are gone are left out of it.
  explicit MadeFiles(const std::string& folder);
  // Notes what has come since; a list that cannot be written is a warning on standard error.
  ~MadeFiles();
  MadeFiles(const MadeFiles&) = delete;
  MadeFiles& operator=(const MadeFiles&) = delete;

  // Is there, and no run has made it.
  bool is_foreign(const std::string& name) const { return before_.count(name) > 0; }
  const std::set<std::string>& foreign() const { return before_; }
  // A run begins that may be killed at any moment. Of what it leaves then is its own: these names; what last changed
  // before the last of them did; and what changed up to a minute later and has a name of one of the patterns (regular
  // expressions).
  void begin(const std::vector<std::string>& names, const std::vector<std::string>& patterns);

 private:
  void note() const;

  std::string folder_;
  std::set<std::string> before_;  // files that no run has made
  bool runs_ = false;
};

}  // namespace footfall
