// Files are read whole and parsed in a process of their own (read_apart), then scaled, welded and judged: how many digits
// their coordinates have.

#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>
#include <new>
#include <optional>

#include "coupler/base/concat.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/child_process.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/decimation.h"
#include "mbd_solver/fe/fe_mesh.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/mesh_reader.h"

namespace footfall {
using namespace code;

namespace {

// Vertices nearer than this share of the mesh's size are one: STL repeats each vertex, mostly rounded to seven digits.
constexpr double kWeldTolerance = 1e-6;
// Spacing of the numbers in a file over the mesh's size: a word, and no shape left.
constexpr double kCoarse = 1e-5, kLost = 1e-2;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;
constexpr std::size_t kMostTriangles = 100000;  // of a mesh that is used as it is
constexpr std::size_t kMostRead = 1000000;      // of a mesh that is decimated, or only gives a mass

void check_format(const std::string& file) {
  if (!is_mesh_name(file))
    throw InputError(kMeshFormat, file + ": ends in \"" + std::filesystem::path(file).extension().string() +
                                      "\", expected " + kMeshEnds);
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
    throw InputError(kMeshTooLarge, file, ": has ", bytes >> 20, " MB, expected a mesh of at most ", kMostBytes >> 20,
                     " MB");
  return bytes;
}

void demand_affordable(const std::string& file, std::size_t triangles, std::size_t most) {
  if (triangles <= most) return;
  const std::string remedy = most < kMostRead
                                 ? ": every node costs time in every step; use a coarser mesh, or let it be "
                                   "decimated by  surface = { triangles = 5000 }  of its boundary"
                                 : "; use a coarser mesh";
  throw InputError(kMeshTooLarge, file, ": has ", triangles, " triangles, expected at most ", most, remedy);
}

MeshFile parsed(const std::string& file, std::uintmax_t size, std::size_t most) {
  const std::optional<std::string> bytes = read_whole_file(file);
  if (!bytes || bytes->size() < size) throw InputError(kFileNotReadable, file + ": cannot be read");
  MeshFile result = parse_mesh(*bytes, file);
  demand_affordable(file, result.mesh.triangles.size(), most);
  return result;
}

// A mesh as bytes, for the pipe between two processes: two counts, the digits, the vertices, the triangles.
struct PackHead {
  std::size_t vertices, triangles, single;
  double spacing;
};

std::string packed(const MeshFile& file) {
  const TriangleMesh& mesh = file.mesh;
  const PackHead head{mesh.vertices.size(), mesh.triangles.size(), file.single, file.spacing};
  std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
  bytes.append(reinterpret_cast<const char*>(mesh.vertices.data()), head.vertices * sizeof(Eigen::Vector3d));
  bytes.append(reinterpret_cast<const char*>(mesh.triangles.data()), head.triangles * sizeof(Eigen::Vector3i));
  return bytes;
}

MeshFile unpacked(const std::string& bytes) {
  PackHead head;
  FOOTFALL_DEMAND(bytes.size() >= sizeof head);
  std::memcpy(&head, bytes.data(), sizeof head);
  const std::size_t size = head.vertices * sizeof(Eigen::Vector3d);
  FOOTFALL_DEMAND(bytes.size() == sizeof head + size + head.triangles * sizeof(Eigen::Vector3i));
  MeshFile file;
  file.single = head.single != 0;
  file.spacing = head.spacing;
  file.mesh.vertices.resize(head.vertices);
  file.mesh.triangles.resize(head.triangles);
  bytes.copy(reinterpret_cast<char*>(file.mesh.vertices.data()), size, sizeof head);
  bytes.copy(reinterpret_cast<char*>(file.mesh.triangles.data()), std::string::npos, sizeof head + size);
  return file;
}

TriangleMesh read_at_most(const std::string& file, double scale, std::size_t most) {
  check_format(file);
  const std::uintmax_t size = checked_size(file);
  MeshFile read = unpacked(read_apart(file, size, [&] { return packed(parsed(file, size, most)); }));
  TriangleMesh& mesh = read.mesh;
  if (mesh.triangles.empty()) throw InputError(kMeshEmpty, file + ": contains no triangles");
  Eigen::AlignedBox3d box;
  for (Eigen::Vector3d& x : mesh.vertices) x *= scale;
  for (const Eigen::Vector3i& triangle : mesh.triangles)
    for (const int corner : triangle) box.extend(mesh.vertices[corner]);
  const double across = box.diagonal().norm();
  if (!(kWeldTolerance * across > 0.0 && std::isfinite(across)))
    throw InputError(kMeshEmpty, file, ": has an extent of ", across, " m, expected a surface");
  TriangleMesh result = welded(mesh, kWeldTolerance * across);
  const double spacing = read.spacing * scale;
  if (spacing > kCoarse * across)
    result.notes.push_back(concat(
        file, ": its coordinates, up to ", box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff(),
        " m, have a last digit of ", number_text(spacing, 2), " m, and the mesh measures ", number_text(across, 3),
        " m; export it near the origin, or as text with more digits, and move it here with \"position\""));
  if (read.single && spacing > kLost * across) throw InputError(kMeshDigits, result.notes.front());
  return result;
}

// A fork with limits of time and memory; the result comes back through a file in memory.

constexpr rlim_t kSeconds = 5;                    // of processor time, and one more for each
constexpr std::size_t kBytesPerSecond = 1000000;  // of the file (a slow machine reads ten times as many)
constexpr rlim_t kMemory = rlim_t{1} << 30;       // [bytes], and
constexpr rlim_t kMemoryPerByte = 200;            // for each byte of the file
constexpr char kGood = '+', kWrong = '-';         // first character of an answer
constexpr int kCrashes[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};

// Address space in use [bytes].
[[maybe_unused]] rlim_t memory_now() {
  const std::string pages = read_whole_file("/proc/self/statm").value_or("");
  return std::strtoul(pages.c_str(), nullptr, 10) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

rlim_t seconds_for(std::size_t bytes) { return kSeconds + static_cast<rlim_t>(bytes / kBytesPerSecond); }

void limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(resource, &both);
}

int answer(int result, const std::string& file, std::size_t bytes, const std::function<std::string()>& read) {
  for (const int crash : kCrashes) signal(crash, SIG_DFL);  // no crash report
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, seconds_for(bytes));
#if !defined(__SANITIZE_ADDRESS__) && !defined(FOOTFALL_SANITIZED)  // sanitizers reserve terabytes
  limit(RLIMIT_AS, memory_now() + kMemory + kMemoryPerByte * static_cast<rlim_t>(bytes));
#endif
  std::string text;
  try {
    text = kGood + read();
  } catch (const std::bad_alloc&) {
    text = kWrong + with_code(kMeshDamaged, file + ": needs more memory than a file of its size can; export it again");
  } catch (const std::exception& error) {
    text = kWrong + std::string(error.what());
  }
  return ::write(result, text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1;
}

// Meshes of shapes, by the generators of mbd_solver/fe, and of files; tubes and spheres are made here.

constexpr double kDefaultElements = 10.0;  // elements along the largest size of a shape, when no element size is given

double largest_size(const ShapeSpec& s) {
  switch (s.kind) {
    case ShapeKind::kBox: return s.size.maxCoeff();
    case ShapeKind::kTube:
    case ShapeKind::kRod: return (s.to - s.from).norm();
    case ShapeKind::kDisc:
    case ShapeKind::kDish:
    case ShapeKind::kSphere:
    case ShapeKind::kMesh:
    case ShapeKind::kPoints: return 2.0 * s.radius;
    case ShapeKind::kCylinder: return std::max(2.0 * s.radius, s.length);
    case ShapeKind::kCapsule: return (s.to - s.from).norm() + s.diameter;
  }
  FOOTFALL_DEMAND(false);
}

// As few triangles as asked, with a note on what that changes.
TriangleMesh decimated_surface(const TriangleMesh& mesh, std::size_t most, const std::string& where) {
  Decimation result = decimated(mesh, most);
  const std::size_t left = result.mesh.triangles.size();
  if (left > kMostTriangles) demand_affordable(where, left, kMostTriangles);
  result.mesh.decimation =
      concat(where, ": decimated from ", mesh.triangles.size(), " to ", left,
             " triangles; the largest distance between both surfaces is ", number_text(result.distance, 3),
             " m, the enclosed volume differs by ", number_text(100.0 * result.volume_change, 2), " %");
  if (left > most)
    result.mesh.decimation += concat(
        "; fewer than ", left, " would turn triangles over, make needles or change how pieces and holes are connected");
  return result.mesh;
}

}  // namespace

TriangleMesh read_mesh(const std::string& file, double scale) { return read_at_most(file, scale, kMostTriangles); }

std::string read_apart(const std::string& file, std::size_t bytes, const std::function<std::string()>& read) {
  const auto failed = [&] {
    return InputError(code::kFileNotReadable, file + ": cannot be read: " + std::strerror(errno));
  };
  const int result = memfd_create("footfall", MFD_CLOEXEC);
  if (result < 0) throw failed();
  const pid_t child = start_copy([&] { return answer(result, file, bytes, read); }, Orphan::kIsKilled);
  const int code = wait_for_end(child), ended_by = code > 128 ? code - 128 : 0;
  std::string text(static_cast<std::size_t>(std::max<off_t>(0, lseek(result, 0, SEEK_END))), '\0');
  const bool whole = pread(result, &text[0], text.size(), 0) == static_cast<ssize_t>(text.size());
  close(result);
  if (child < 0 || !whole) throw failed();
  std::string problem;
  if (ended_by == SIGXCPU || ended_by == SIGKILL) {
    problem = concat("was not read within ", seconds_for(bytes), " s");
  } else if (ended_by != 0) {
    problem = concat("crashed its reader (", strsignal(ended_by), ")");
  } else if (text.empty()) {
    problem = "ended its reader without a result";
  }
  if (!problem.empty())
    throw InputError(kMeshDamaged,
                     file + ": " + problem + "; the file is damaged or too large: export it again, or a part of it");
  if (text.front() == kWrong) throw InputError(text.substr(1));
  return text.substr(1);
}

TriangleMesh mesh_of_shape(const ShapeSpec& shape) {
  return moved(read_at_most(shape.file, shape.scale, kMostRead), shape.orientation.toRotationMatrix(), shape.position);
}

TriangleMesh shape_surface(const BodySpec& body, const SurfaceSpec& surface) {
  const ShapeSpec& s = *body.shape;
  const double edge = surface.element_size > 0.0 ? surface.element_size : largest_size(s) / kDefaultElements;
  switch (s.kind) {
    case ShapeKind::kBox: return moved(box_mesh(s.size, edge), body.orientation.toRotationMatrix(), s.centre);
    case ShapeKind::kTube:
    case ShapeKind::kRod: return cylinder_mesh(s.from, s.to, s.diameter, edge);
    case ShapeKind::kDisc:
      return moved(surface.faces == SurfaceFaces::kMiddle ? disc_mesh(s.radius, edge)
                                                          : thick_disc_mesh(s.radius, s.thickness, edge),
                   axes_with_z(s.axis), s.centre);
    case ShapeKind::kDish: return moved(dish_mesh(s.radius, s.depth, edge), axes_with_z(s.axis), s.centre);
    case ShapeKind::kSphere: return moved(sphere_mesh(s.radius, edge), Eigen::Matrix3d::Identity(), s.centre);
    case ShapeKind::kCylinder: return moved(thick_disc_mesh(s.radius, s.length, edge), axes_with_z(s.axis), s.centre);
    case ShapeKind::kCapsule:
      return moved(capsule_mesh(0.5 * s.diameter, (s.to - s.from).norm(), edge), axes_with_z(s.to - s.from),
                   0.5 * (s.from + s.to));
    case ShapeKind::kMesh: return mesh_of_shape(s);
    case ShapeKind::kPoints: break;
  }
  return {};
}

TriangleMesh cylinder_mesh(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter, double edge) {
  const double length = (to - from).norm(), radius = 0.5 * diameter;
  const Eigen::Matrix3d R = axes_with_z(to - from);
  const int around = std::max(6, static_cast<int>(std::ceil(kPi * diameter / edge)));
  const int along = std::max(1, static_cast<int>(std::ceil(length / edge)));
  TriangleMesh mesh;
  for (int i = 0; i <= along; ++i) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * kPi * k / around;
      mesh.vertices.push_back(
          from + R * Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), length * i / along));
    }
  }
  const int bottom = static_cast<int>(mesh.vertices.size()), top = bottom + 1, last = along * around;
  mesh.vertices.push_back(from);
  mesh.vertices.push_back(to);
  for (int k = 0; k < around; ++k) {
    const int next = (k + 1) % around;
    for (int i = 0; i < along; ++i) {
      const int a = i * around + k, b = i * around + next, c = a + around, d = b + around;
      mesh.triangles.emplace_back(a, b, d);
      mesh.triangles.emplace_back(a, d, c);
    }
    mesh.triangles.emplace_back(bottom, next, k);
    mesh.triangles.emplace_back(top, last + k, last + next);
  }
  return mesh;
}

// An icosahedron whose triangles are halved until their edges are short enough, vertices pushed out to the sphere.
TriangleMesh sphere_mesh(double radius, double edge) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleMesh mesh;
  const double points[12][3] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (const auto& p : points) mesh.vertices.push_back(radius * Eigen::Vector3d(p[0], p[1], p[2]).normalized());
  const int faces[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                            {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                            {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (const auto& f : faces) mesh.triangles.emplace_back(f[0], f[1], f[2]);
  double longest = (mesh.vertices[0] - mesh.vertices[11]).norm();
  for (; longest > edge; longest *= 0.5) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [entry, fresh] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(mesh.vertices.size()));
      if (fresh) {
        const Eigen::Vector3d sum = mesh.vertices[a] + mesh.vertices[b];
        mesh.vertices.push_back(radius * sum.normalized());
      }
      return entry->second;
    };
    std::vector<Eigen::Vector3i> finer;
    for (const Eigen::Vector3i& t : mesh.triangles) {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

bool has_model_mesh(const BodySpec& body) {
  return body.flexible && !body.flexible->node_file.empty() && is_fe_mesh_name(body.flexible->node_file);
}

TriangleMesh boundary_surface(const Scene& scene, const BoundarySpec& boundary) {
  if (!boundary.surface) return {};
  const SurfaceSpec& surface = *boundary.surface;
  const BodySpec& body = scene.bodies[scene.body_index(boundary.body)];
  const bool from_file = !surface.file.empty();
  if (!from_file && !body.shape && !has_model_mesh(body))
    throw InputError(kNoSurface, "body \"" + body.name + "\": its model has no triangles; give surface.file");
  if (!from_file && !body.shape) return read_mesh(body.flexible->node_file, length_unit(body.flexible->units));
  const std::size_t most = surface.triangles > 0 ? static_cast<std::size_t>(surface.triangles) : 0;
  TriangleMesh mesh = from_file
                          ? moved(read_at_most(surface.file, surface.scale, most > 0 ? kMostRead : kMostTriangles),
                                  surface.orientation.toRotationMatrix(), surface.position)
                          : shape_surface(body, surface);
  const std::string where = from_file ? surface.file : "surface of body \"" + body.name + "\"";
  MeshDemands demands;
  demands.closed = surface.closed;
  check_mesh(mesh, demands, where);
  if (most > 0 && mesh.triangles.size() > most) return decimated_surface(mesh, most, where);
  if (!from_file && body.shape->kind == ShapeKind::kMesh)
    demand_affordable(body.shape->file, mesh.triangles.size(), kMostTriangles);
  return mesh;
}

}  // namespace footfall
