// The one file that knows assimp.
#include "mbd_solver/scene/mesh_reader.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <filesystem>

#include "coupler/base/errors.h"

namespace footfall {

namespace {

// Vertices nearer than this share of the mesh's size are one: STL repeats each vertex, rounded to single precision.
constexpr double kWeldTolerance = 1e-6;

void check_format(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension != ".stl" && extension != ".obj" && extension != ".ply")
    throw InputError(file + ": a mesh file ends in .stl, .obj or .ply, not in \"" + extension + "\"");
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) throw InputError(file + ": there is no such mesh file");
}

}  // namespace

TriangleMesh read_mesh(const std::string& file, double scale) {
  check_format(file);
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  // Points and lines are dropped; degenerate triangles stay, so that the mesh check can name them.
  const aiScene* read =
      importer.ReadFile(file, aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_SortByPType);
  if (!read) throw InputError(file + ": cannot be read as a mesh: " + importer.GetErrorString());

  TriangleMesh mesh;
  Eigen::AlignedBox3d box;
  for (unsigned m = 0; m < read->mNumMeshes; ++m) {
    const aiMesh& part = *read->mMeshes[m];
    const int first = static_cast<int>(mesh.vertices.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D& v = part.mVertices[i];
      mesh.vertices.push_back(scale * Eigen::Vector3d(v.x, v.y, v.z));
      if (!mesh.vertices.back().allFinite())
        throw InputError(file + ": vertex " + std::to_string(i) + " has a coordinate that is no number");
      box.extend(mesh.vertices.back());
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices != 3) continue;
      const Eigen::Vector3i corners(static_cast<int>(face.mIndices[0]), static_cast<int>(face.mIndices[1]),
                                    static_cast<int>(face.mIndices[2]));
      mesh.triangles.push_back(corners + Eigen::Vector3i::Constant(first));
    }
  }
  if (mesh.triangles.empty()) throw InputError(file + ": holds no triangles");
  return welded(mesh, kWeldTolerance * box.diagonal().norm());
}

}  // namespace footfall
