#pragma once
// Limits of readers of files. A file of a few kB can unpack to gigabytes, or name parts that name parts, 2^45 in all: a
// reader counts while it reads, throws at its limit, and trusts no size that a file announces. Everything that is counted
// has its limit here; levels of files within files are known to their readers, whole files are bounded before they are opened
// (coupler/base/input_file.h), and readers that may crash run in a process with limits of memory and time (scene/mesh_reader.h).
// docs/reference/exit_codes_and_limits.md has all of them for users.
//
//   ReadBudget instances(limit::kMeshInstances, file);
//   instances.take();    // for each

#include <cstdint>
#include <string>
#include <string_view>

namespace footfall {

struct ReadLimit {
  std::uint64_t most;
  const char* what;    // is counted, behind "has more than N"
  const char* remedy;  // advice to the user
  bool bytes = false;
};

namespace limit {

inline constexpr std::uint64_t kMegabyte = 1 << 20;

// --- Archives: FMUs.
inline constexpr ReadLimit kFmuDescription{64 * kMegabyte, "of modelDescription.xml, unpacked",
                                           "export the FMU with fewer variables", true};
inline constexpr ReadLimit kFmuEntries{100000, "files in the archive", "export the FMU again"};
// Sum of all entries; in addition at most kFmuRatio times the bytes of the archive, or kFmuSmall if that is more.
inline constexpr ReadLimit kFmuUnpacked{8192 * kMegabyte, "in the archive, unpacked",
                                        "export the FMU with fewer resources", true};
inline constexpr std::uint64_t kFmuRatio = 200, kFmuSmall = 256 * kMegabyte;
// Words of a start value: elements of an array.
inline constexpr ReadLimit kFmuStart{1 << 20, "values in one start attribute", "export the FMU with smaller arrays"};

// --- XML: counted before it is parsed, as "<" and "=" of the text, and of a robot with its included files.
inline constexpr ReadLimit kXmlParts{2000000, "elements and attributes", "export a smaller model"};
// Elements within elements: recursive readers remain within their stack.
inline constexpr ReadLimit kXmlDepth{200, "levels of elements within elements", "the file is damaged"};

// --- Files that include others: MJCF, SDF, scripts of LIGGGHTS, input files of finite-element codes.
inline constexpr ReadLimit kIncludedFiles{1000, "included files", "let no file include others many times"};
inline constexpr ReadLimit kIncludedText{64 * kMegabyte, "of text with its included files and variables",
                                         "let no file include others, and no variable name others, many times", true};
inline constexpr ReadLimit kIncludedMesh{1024 * kMegabyte, "of text with its included files",
                                         "let no file include others many times", true};
inline constexpr ReadLimit kScriptWords{2000000, "words in its commands", "read data from files instead"};

// --- COLLADA: nodes and geometries by reference.
inline constexpr ReadLimit kMeshInstances{100000, "instances of nodes and geometries",
                                          "export the mesh without instances"};
inline constexpr ReadLimit kMeshNumbers{20000000, "numbers and elements in its instances", "export a coarser mesh"};
inline constexpr ReadLimit kMeshTriangles{1000000, "triangles", "use a coarser mesh"};
// All meshes of one robot; a mesh that is used twice counts twice.
inline constexpr ReadLimit kRobotMeshes{4096 * kMegabyte, "of meshes", "use coarser ones", true};

// --- Meshes of finite-element codes: entries of sets, of sets that name sets, and numbers that a range passes over.
inline constexpr ReadLimit kSetEntries{100000000, "entries of sets", "let no set name others many times"};

// --- Scenes and other TOML: counted before it is parsed, as "=", "," and "[" of the text.
inline constexpr ReadLimit kTomlParts{4000000, "values", "write long tables to files, and name these"};

// --- Tables and text.
inline constexpr ReadLimit kLine{16 * kMegabyte, "in one line", "the file is damaged", true};
inline constexpr ReadLimit kTableCells{10000000, "cells", "thin the table"};
inline constexpr ReadLimit kFllLines{20000, "lines", "remove terms and rules"};

}  // namespace limit

class ReadBudget {
 public:
  // `place`: "file" or "file:line", for the message. `most`: lower than the limit, where the file allows less.
  ReadBudget(const ReadLimit& limit, std::string place) : ReadBudget(limit, std::move(place), limit.most) {}
  ReadBudget(const ReadLimit& limit, std::string place, std::uint64_t most)
      : limit_(limit), place_(std::move(place)), most_(most) {}

  // Throws InputError once more than the limit has been taken.
  void take(std::uint64_t amount = 1) {
    if (!takes(amount)) fail();
  }
  // The same for readers with errors of their own: false, and excess() describes the fault.
  bool takes(std::uint64_t amount = 1) {
    if (amount > most_ - taken_) return false;
    taken_ += amount;
    return true;
  }
  std::string excess() const;

 private:
  [[noreturn]] void fail() const;

  ReadLimit limit_;
  std::string place_;
  std::uint64_t most_, taken_ = 0;  // taken_ <= most_
};

// Elements and attributes that a text of XML has at most.
std::uint64_t xml_parts(std::string_view text);

}  // namespace footfall
