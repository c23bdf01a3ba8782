#include "mbd_solver/cli/launch/bed_seal.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>

#include "coupler/base/fingerprint.h"
#include "coupler/base/whole_file.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSeal = "bed.seal";
constexpr const char* kSealHead = "footfall-seal 1";

// The number at this place; nothing behind the end.
template <class T>
std::optional<T> number_at(const std::string& bytes, std::size_t place) {
  if (place > bytes.size() || bytes.size() - place < sizeof(T)) return {};
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

// LIGGGHTS' write_restart.cpp: a flag (int) before each value, in this order. Those before the number of grains are
// texts behind their length, integers of 64 bits, or int.
struct Header {
  std::int32_t processes = 0;
  std::int64_t grains = 0;
  std::string version, style;
};
std::optional<Header> read_header(const std::string& bytes) {
  enum Flag { kVersion = 0, kUnits = 4, kStep = 5, kProcesses = 7, kStyle = 22, kGrains = 23 };
  Header header;
  std::size_t place = 0;
  for (std::int32_t flag = kVersion; flag <= kGrains; ++flag) {
    if (number_at<std::int32_t>(bytes, place) != flag) return {};
    place += sizeof flag;
    if (flag == kVersion || flag == kUnits || flag == kStyle) {
      const std::int32_t length = number_at<std::int32_t>(bytes, place).value_or(-1);
      constexpr std::int32_t kLongest = 1000;
      if (length < 1 || length > kLongest) return {};
      place += sizeof length;
      if (bytes.size() < place + static_cast<std::size_t>(length)) return {};
      const std::string text = bytes.substr(place, static_cast<std::size_t>(length) - 1);
      if (flag == kVersion) header.version = text;
      if (flag == kStyle) header.style = text;
      if (text == "hybrid") return header;  // its parts follow
      place += static_cast<std::size_t>(length);
    } else if (flag == kStep || flag == kGrains) {
      const std::optional<std::int64_t> value = number_at<std::int64_t>(bytes, place);
      if (!value) return {};
      if (flag == kGrains) header.grains = *value;
      place += sizeof *value;
    } else {
      const std::optional<std::int32_t> value = number_at<std::int32_t>(bytes, place);
      if (!value) return {};
      if (flag == kProcesses) header.processes = *value;
      place += sizeof *value;
    }
  }
  return header;
}

// The grains of one process: `count` numbers from `place` on, of each grain first how many it has, then x y z. How many
// grains they are; nothing when the numbers are no such chain.
std::optional<std::int64_t> grains_in(const std::string& bytes, std::size_t place, std::int64_t count) {
  std::int64_t grains = 0;
  for (std::int64_t k = 0; k < count; ++grains) {
    const auto at = [&](std::int64_t i) {
      return number_at<double>(bytes, place + sizeof(double) * static_cast<std::size_t>(i)).value_or(std::nan(""));
    };
    const double length = at(k);
    constexpr double kShortest = 4.0;
    if (!(length >= kShortest && length <= static_cast<double>(count - k) && length == std::floor(length))) return {};
    for (int axis = 1; axis <= 3; ++axis)
      if (!std::isfinite(at(k + axis))) return {};
    k += static_cast<std::int64_t>(length);
  }
  return grains;
}

// The file ends with one block for each process: a count (int) and so many numbers. Walks them from the end, as what
// stands before them has no known length: a place whose count reaches exactly to the end of the block is its start.
bool ends_with_blocks(const std::string& bytes, std::size_t end, std::int32_t blocks, std::int64_t grains) {
  if (blocks == 0) return grains == 0;
  for (std::int64_t count = 1; sizeof(std::int32_t) + sizeof(double) * static_cast<std::size_t>(count) <= end;
       ++count) {
    const std::size_t start = end - sizeof(std::int32_t) - sizeof(double) * static_cast<std::size_t>(count);
    if (number_at<std::int32_t>(bytes, start) != count) continue;
    const std::optional<std::int64_t> found = grains_in(bytes, start + sizeof(std::int32_t), count);
    if (found && *found <= grains && ends_with_blocks(bytes, start, blocks - 1, grains - *found)) return true;
  }
  // A process without grains comes last: any zero looks like its count.
  return end >= sizeof(std::int32_t) && number_at<std::int32_t>(bytes, end - sizeof(std::int32_t)) == 0 &&
         ends_with_blocks(bytes, end - sizeof(std::int32_t), blocks - 1, grains);
}

std::string seal_of(const fs::path& folder) {
  std::string text = std::string(kSealHead) + "\n";
  for (const char* name : {kBedRestart, kBedGrains})
    if (const auto bytes = read_whole_file((folder / name).string()))
      text += std::string(name) + " " + std::to_string(bytes->size()) + " " + fingerprint(*bytes) + "\n";
  return text;
}

std::string against_seal(const fs::path& folder, const std::string& seal) {
  std::istringstream lines(seal);
  std::string line;
  if (!std::getline(lines, line) || line != kSealHead) return std::string(kSeal) + " cannot be read";
  bool restart = false;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string name, sum;
    std::size_t size = 0;
    if (!(words >> name >> size >> sum)) return std::string(kSeal) + " cannot be read";
    const auto bytes = read_whole_file((folder / name).string());
    if (!bytes) return name + " is missing";
    if (bytes->size() != size)
      return name + " has " + std::to_string(bytes->size()) + " bytes, it was made with " + std::to_string(size);
    if (fingerprint(*bytes) != sum) return name + " has changed since it was made (checksum)";
    restart = restart || name == kBedRestart;
  }
  return restart ? "" : std::string(kSeal) + " does not name " + kBedRestart;
}

}  // namespace

void seal_bed(const std::string& folder) {
  write_whole_file((fs::path(folder) / kSeal).string(), seal_of(folder),
                   "set FOOTFALL_CACHE to a folder that can be written");
}

std::string damage_of_bed(const std::string& folder) {
  const fs::path at(folder);
  if (!fs::exists(at / kBedRestart)) return std::string(kBedRestart) + " is missing";
  if (const auto seal = read_whole_file((at / kSeal).string())) return against_seal(at, *seal);
  const std::string damage = damage_of_restart((at / kBedRestart).string());
  return damage.empty() && fs::exists(at / kBedGrains) ? damage_of_dump((at / kBedGrains).string()) : damage;
}

std::string damage_of_restart(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  const auto bytes = read_whole_file(path);
  if (!bytes) return name + " cannot be read";
  if (bytes->empty()) return name + " is empty";
  const std::optional<Header> header = read_header(*bytes);
  if (!header || header->version.find("LIGGGHTS") == std::string::npos)
    return name + " does not begin as a restart file of LIGGGHTS does";
  if (header->style != "granular" && header->style != "sphere") return "";
  if (header->processes < 1 || header->grains < 0 ||
      !ends_with_blocks(*bytes, bytes->size(), header->processes, header->grains))
    return name + " does not hold the " + std::to_string(header->grains) + " grains that it begins with";
  return "";
}

std::string damage_of_dump(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  const auto text = read_whole_file(path);
  if (!text) return name + " cannot be read";
  std::istringstream lines(*text);
  std::string line;
  long expected = 0, found = 0, number = 0;
  enum { kElsewhere, kCount, kAtoms } part = kElsewhere;
  while (std::getline(lines, line)) {
    ++number;
    if (line.rfind("ITEM:", 0) == 0) {
      part = line == "ITEM: NUMBER OF ATOMS" ? kCount : line.rfind("ITEM: ATOMS", 0) == 0 ? kAtoms : kElsewhere;
      if (part == kAtoms) found = 0;
    } else if (part == kCount) {
      expected = std::strtol(line.c_str(), nullptr, 10);
    } else if (part == kAtoms) {
      ++found;
      const char* at = line.c_str();
      for (char* end = nullptr;; at = end) {
        const double value = std::strtod(at, &end);
        if (end == at) break;
        if (!std::isfinite(value)) return name + ":" + std::to_string(number) + ": \"" + line + "\" is not finite";
      }
    }
  }
  if (found != expected)
    return name + " holds " + std::to_string(found) + " grains, it begins with " + std::to_string(expected);
  return "";
}

}  // namespace footfall
