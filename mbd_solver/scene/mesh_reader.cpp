// STL, OBJ and PLY by the library assimp, which only this file uses. Size and head of a file are checked first, because the
// library reserves what a damaged head promises; it reads in a process of its own (read_apart.h).
#include "mbd_solver/scene/mesh_reader.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/read_apart.h"

namespace footfall {

using namespace code;

namespace {

// Vertices nearer than this share of the mesh's size are one: STL repeats each vertex, rounded to single precision.
constexpr double kWeldTolerance = 1e-6;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;
constexpr std::size_t kMostTriangles = 100000;
constexpr int kMostHeadLines = 1000;  // of a PLY file

// With its dot, in lower case.
std::string extension_of(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void check_format(const std::string& file) {
  const std::string extension = extension_of(file);
  if (extension != ".stl" && extension != ".obj" && extension != ".ply")
    throw InputError(kMeshFormat, file + ": ends in \"" + extension + "\", expected .stl, .obj or .ply");
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored))
    throw InputError(kNoFile, file + ": this mesh file does not exist");
}

// Size of the file [bytes].
std::uintmax_t checked_size(const std::string& file) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (error) throw InputError(kFileNotReadable, file + ": cannot be read: " + error.message());
  if (bytes == 0) throw InputError(kMeshEmpty, file + ": is empty, expected a mesh");
  if (bytes > kMostBytes)
    throw InputError(kMeshTooLarge, file + ": has " + std::to_string(bytes >> 20) + " MB, expected a mesh of at most " +
                                        std::to_string(kMostBytes >> 20) + " MB");
  return bytes;
}

void demand_affordable(const std::string& file, std::size_t triangles) {
  if (triangles > kMostTriangles)
    throw InputError(kMeshTooLarge, file + ": has " + std::to_string(triangles) + " triangles, expected at most " +
                                        std::to_string(kMostTriangles) +
                                        ": every node costs time in every step; use a coarser mesh");
}

// A line of a head, which may end in CR, LF or both.
bool head_line(std::istream& in, std::string& line) {
  line.clear();
  for (int c = in.get(); c != std::char_traits<char>::eof(); c = in.get()) {
    if (c == '\r' && in.peek() == '\n') in.get();
    if (c == '\r' || c == '\n') return true;
    line += static_cast<char>(c);
  }
  return !line.empty();
}

// The head of a PLY file says how many elements follow. The library reserves them all before it reads; each takes at
// least a byte. It also takes counts from damaged lines, so any number of the head may be one. In a head without an end it
// searches for seconds.
void demand_elements_fit(const std::string& file, std::uintmax_t bytes) {
  if (extension_of(file) != ".ply") return;
  std::ifstream in(file);
  std::string line, word;
  for (int number = 1; number <= kMostHeadLines && head_line(in, line); ++number) {
    if (line.rfind("end_header", 0) == 0) return;
    if (line.rfind("comment", 0) == 0 || line.rfind("obj_info", 0) == 0) continue;
    std::istringstream words(line);
    while (words >> word)  // a name may begin as "inf" does
      if (word.front() >= '0' && word.front() <= '9' && std::strtod(word.c_str(), nullptr) > static_cast<double>(bytes))
        throw InputError(kMeshDamaged, file + ":" + std::to_string(number) + ": announces " + word +
                                           " elements in a file of " + std::to_string(bytes) +
                                           " bytes; export it again");
  }
  throw InputError(kMeshDamaged,
                   file + ": cannot be read as a mesh: none of its first " + std::to_string(kMostHeadLines) +
                       " lines is \"end_header\", with which the head of a PLY file ends; export it again");
}

// As the library reads it, each triangle with corners of its own or not.
TriangleMesh read_raw(const std::string& file) {
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  // Points and lines are dropped; degenerate triangles stay, so that the mesh check can name them.
  const aiScene* read =
      importer.ReadFile(file, aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_SortByPType);
  if (!read) throw InputError(kMeshFormat, file + ": cannot be read as a mesh: " + importer.GetErrorString());
  TriangleMesh mesh;
  for (unsigned m = 0; m < read->mNumMeshes; ++m) {
    const aiMesh& part = *read->mMeshes[m];
    demand_affordable(file, mesh.triangles.size() + part.mNumFaces);
    const int first = static_cast<int>(mesh.vertices.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D& v = part.mVertices[i];
      mesh.vertices.emplace_back(v.x, v.y, v.z);
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices != 3) continue;
      const Eigen::Vector3i corners(static_cast<int>(face.mIndices[0]), static_cast<int>(face.mIndices[1]),
                                    static_cast<int>(face.mIndices[2]));
      mesh.triangles.push_back(corners + Eigen::Vector3i::Constant(first));
    }
  }
  return mesh;
}

// A mesh as bytes, for the pipe between two processes: two counts, the vertices, the triangles.
std::string packed(const TriangleMesh& mesh) {
  const std::size_t counts[] = {mesh.vertices.size(), mesh.triangles.size()};
  std::string bytes(reinterpret_cast<const char*>(counts), sizeof counts);
  bytes.append(reinterpret_cast<const char*>(mesh.vertices.data()), counts[0] * sizeof(Eigen::Vector3d));
  bytes.append(reinterpret_cast<const char*>(mesh.triangles.data()), counts[1] * sizeof(Eigen::Vector3i));
  return bytes;
}

TriangleMesh unpacked(const std::string& bytes) {
  std::size_t counts[2];
  FOOTFALL_DEMAND(bytes.size() >= sizeof counts);
  std::memcpy(counts, bytes.data(), sizeof counts);
  const std::size_t size = counts[0] * sizeof(Eigen::Vector3d);
  FOOTFALL_DEMAND(bytes.size() == sizeof counts + size + counts[1] * sizeof(Eigen::Vector3i));
  TriangleMesh mesh;
  mesh.vertices.resize(counts[0]);
  mesh.triangles.resize(counts[1]);
  bytes.copy(reinterpret_cast<char*>(mesh.vertices.data()), size, sizeof counts);
  bytes.copy(reinterpret_cast<char*>(mesh.triangles.data()), std::string::npos, sizeof counts + size);
  return mesh;
}

}  // namespace

TriangleMesh read_mesh(const std::string& file, double scale) {
  check_format(file);
  const std::uintmax_t size = checked_size(file);
  demand_elements_fit(file, size);
  TriangleMesh mesh = unpacked(read_apart(file, size, [&] { return packed(read_raw(file)); }));
  if (mesh.triangles.empty()) throw InputError(kMeshEmpty, file + ": contains no triangles");
  const int count = static_cast<int>(mesh.vertices.size());
  for (const Eigen::Vector3i& triangle : mesh.triangles)
    if (triangle.minCoeff() < 0 || triangle.maxCoeff() >= count)
      throw InputError(kMeshDamaged, file + ": a triangle has vertex " + std::to_string(triangle.maxCoeff()) + " of " +
                                         std::to_string(count) + "; export it again");
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    mesh.vertices[i] *= scale;
    if (!mesh.vertices[i].allFinite())
      throw InputError(kMeshDamaged,
                       file + ": vertex " + std::to_string(i) + " has a coordinate that is no number; export it again");
    box.extend(mesh.vertices[i]);
  }
  const double across = box.diagonal().norm();
  if (!(kWeldTolerance * across > 0.0 && std::isfinite(across)))
    throw InputError(kMeshEmpty, file + ": has an extent of " + std::to_string(across) + " m, expected a surface");
  return welded(mesh, kWeldTolerance * across);
}

}  // namespace footfall
