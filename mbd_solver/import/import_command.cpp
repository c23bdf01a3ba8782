// Reads the file in a separate process first, since its libraries may crash on a damaged one; then writes all files
// of the scene, or none.
#include "mbd_solver/import/import_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "coupler/base/concat.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/bed/bed_forecast.h"
#include "mbd_solver/import/codes.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/observe/start_check.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

fs::path folder_for(const ImportArguments& arguments) {
  std::string name = arguments.out;
  while (name.size() > 1 && name.back() == '/') name.pop_back();
  if (name.empty()) {
    for (const char c : fs::path(arguments.file).stem().string())
      name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' ? c : '_';
  }
  const fs::path folder(name);
  if (!is_plain_name(folder.filename().string()))
    throw InputError(code::kRobotFolder, name,
                     ": the name of the folder has characters other than letters, digits and _ - . (or too many); "
                     "choose another one with --out");
  std::error_code error;
  if (fs::exists(fs::symlink_status(folder, error)))
    throw InputError(code::kRobotFolder, name, ": exists already; choose another folder with --out");
  return folder;
}

void write_files(const fs::path& folder, const std::vector<SceneFile>& files) {
  make_folder(folder.string());
  try {
    for (const SceneFile& file : files) {
      const fs::path path = folder / file.name;
      make_folder(path.parent_path().string());
      write_whole_file(path.string(), file.content);
    }
    read_scene(folder.string());  // a scene that this program made is one
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    throw;
  }
}

// The bed that `check` proposes for the scene; nothing if there is none, or it cannot be built: `check` reports why.
std::optional<RobotBed> bed_of(const std::string& folder) {
  constexpr int kRounds = 5;  // grains become smaller with the bed, and narrow bodies need a bed of some grains
  Scene scene = read_scene(folder);
  if (!scene.touches_particles() || !scene.particles->box) return std::nullopt;
  std::optional<RobotBed> bed;
  try {
    check_by_building(
        scene, false, [](const std::string&) {},
        [&](const Scene& placed, const Mechanism& mechanism) {
          scene = placed;
          BoxSpec& box = *scene.particles->box;
          for (int round = 0; round < kRounds; ++round) {
            const BedProposal proposal = proposed_bed(scene, mechanism);
            if (!(proposal.width > 0.0)) return;
            bed = RobotBed{proposal.size, proposal.centre, proposal.depth};
            box.radius = {bed->radius()};
          }
        });
  } catch (const InputError&) {
    return std::nullopt;
  }
  return bed;
}

// The size by which read_apart bounds the work of a reader: MuJoCo and sdformat need a few seconds for small files, too, and
// sdformat takes 10 ms and 1.5 MB for a link of 200 characters.
std::size_t work_of(const std::string& file, std::uintmax_t bytes) {
  constexpr std::uintmax_t kAnyFile = 10000000, kOfSdf = 20, kSmall = 1000000;
  const bool sdf = fs::path(file).extension() == ".sdf" || fs::path(file).extension() == ".world";
  return static_cast<std::size_t>(kAnyFile + (sdf ? kOfSdf * std::min(bytes, kSmall) : 0) + bytes);
}

}  // namespace

int import_command(const ImportArguments& arguments) {
  const fs::path folder = folder_for(arguments);
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(arguments.file, error);
  const auto read = [&] {
    Robot robot = read_robot(arguments.file, arguments.options);
    tidy_robot(robot, arguments.options);
    return robot;
  };
  if (!error && fs::is_regular_file(arguments.file, error))
    read_apart(arguments.file, work_of(arguments.file, bytes), [&] {
      read();
      return std::string("read");
    });
  Robot robot = read();
  if (robot.links.empty())
    throw InputError(code::kRobotStill, arguments.file, ":1: no part of \"", robot.name,
                     "\" can move: it is static, or without mass; a scene needs a body. Export the robot itself, not "
                     "its surroundings");
  const Robot as_read = robot;
  std::vector<SceneFile> files = write_robot_scene(robot, arguments.options);
  std::string list;
  for (const std::string& line : not_taken_lines(robot, false, false)) list += line + "\n";
  std::size_t looks = 0, others = 0;
  for (const NotTaken& one : robot.not_taken) ++(one.looks ? looks : others);
  if (arguments.strict && others > 0)
    throw InputError(code::kRobotStrict, list, arguments.file, ": --strict: ", others,
                     " parts cannot be said in a scene as they are; remove them, or import without --strict");
  write_files(folder, files);
  if (const std::optional<RobotBed> bed = bed_of(folder.string())) {
    Robot again = as_read;
    write_whole_file((folder / files.front().name).string(),
                     write_robot_scene(again, arguments.options, bed)[0].content);
  }
  if (!arguments.quiet) std::fprintf(stderr, "%s", list.c_str());
  const auto count = [](std::size_t n, const std::string& what) { return concat(n, " ", what, n == 1 ? "" : "s"); };
  const std::size_t bodies = robot.links.size();
  std::printf("%s: %s with %s, %s, %s and %s, of the %s file %s\n", folder.string().c_str(), "a scene",
              (std::to_string(bodies) + (bodies == 1 ? " body" : " bodies")).c_str(),
              count(robot.joints.size(), "joint").c_str(), count(robot.gears.size(), "gear").c_str(),
              count(robot.drives.size(), "motor").c_str(), robot.format.c_str(), arguments.file.c_str());
  if (others + looks > 0)
    std::printf("%s\n", with_code(code::kRobotNotTaken, others, " parts are not taken as they are, and ", looks,
                                  " of pictures alone; the end of scene.toml lists all with their lines")
                            .c_str());
  const std::string self = called_as(), place = shell_word(folder.string());
  std::printf("Next: %s check %s; %s run %s\n", self.c_str(), place.c_str(), self.c_str(), place.c_str());
  return kExitDone;
}

}  // namespace footfall
