#pragma once
// The DEM side's own file in a checkpoint: poses of all bodies and the state of the coupling. The grains are in LIGGGHTS'
// restart file next to it.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coupler/archive.h"
#include "coupler/messages.h"

namespace footfall {

class DemCheckpoint {
 public:
  using Visit = std::function<void(Archive&)>;  // saves or restores the state of the coupling

  static std::string file(const std::string& folder) { return folder + "/grains.txt"; }
  static std::string restart_file(const std::string& folder) { return folder + "/grains.restart"; }
  // Content of the file. poses: of all bodies of the scene, by name; step: LIGGGHTS' step number.
  using Poses = std::vector<std::pair<std::string, BodyMotion>>;
  static std::string text(Poses poses, std::int64_t step, const Visit& visit);

  // The run resumes from this folder. Replaces the initial poses of the bodies by the poses of the checkpoint: meshes are
  // compared with them, and beams start there. Throws InputError when the file cannot be read.
  void open(const std::string& folder, std::vector<CoupledBody>& bodies);
  bool is_open() const { return archive_.has_value(); }
  // Restores the state of the coupling. Throws InputError when LIGGGHTS is at another step.
  void restore(std::int64_t step, const Visit& visit);

  const std::string& folder() const { return folder_; }
  std::string grains_not_read() const;  // message when LIGGGHTS has not read the grains of the checkpoint

 private:
  std::string folder_;
  std::optional<Archive> archive_;
};

}  // namespace footfall
