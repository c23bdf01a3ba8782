// The readers that are fed with random bytes, and the entry of libFuzzer, which feeds the reader that FOOTFALL_FUZZ_TARGET names.
#include "tests/fuzz/targets.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "coupler/archive.h"
#include "coupler/base/errors.h"
#include "coupler/message_fields.h"
#include "coupler/messages.h"
#include "mbd_solver/assemble/grain_dump.h"
#include "mbd_solver/assemble/law_files.h"
#include "mbd_solver/fe/fe_mesh.h"
#include "mbd_solver/fe/matrix_model.h"
#include "mbd_solver/fe/modal_body_file.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/summary.h"
#include "mbd_solver/studies/calibration.h"
#include "mbd_solver/studies/sweep_file.h"
#include "tests/support/temporary_folder.h"

namespace footfall::fuzz {
namespace {

template <class Read>
void allowed(const Read& read) {
  try {
    read();
  } catch (const InputError&) {
  } catch (const ProtocolError&) {
  } catch (const NumericalError&) {
  }
}

// A file of this process that holds the bytes.
std::string file_of(const char* name, const std::string& bytes) {
  static const TemporaryFolder folder;
  return folder.write(name, bytes);
}

template <class Read>
void as_file(const char* name, const std::string& bytes, const Read& read) {
  const std::string path = file_of(name, bytes);
  allowed([&] { read(path); });
}

void scene(const std::string& bytes) {
  as_file("scene.toml", bytes, [](const std::string& path) { read_scene(path, {}); });
}
void experiment(const std::string& bytes) {
  as_file("experiment.toml", bytes, [](const std::string& path) { read_sweep_file(path); });
}
void calibration(const std::string& bytes) {
  as_file("calibration.toml", bytes, [](const std::string& path) { read_calibration(path); });
}
void fll(const std::string& bytes) {
  as_file("controller.fll", bytes, [](const std::string& path) { const FuzzySystem system(read_fll(path)); });
}
void mesh_stl(const std::string& bytes) {
  as_file("mesh.stl", bytes, [](const std::string& path) { read_mesh(path, 1.0); });
}
void mesh_obj(const std::string& bytes) {
  as_file("mesh.obj", bytes, [](const std::string& path) { read_mesh(path, 1.0); });
}
void mesh_ply(const std::string& bytes) {
  as_file("mesh.ply", bytes, [](const std::string& path) { read_mesh(path, 1.0); });
}
// The same bytes as stiffness, mass and, from the first line "nodes" on, as the list of nodes. The content tells the format.
void mtx(const std::string& bytes) {
  as_file("matrix.mtx", bytes, [&](const std::string& path) {
    const std::size_t at = bytes.find("\nnodes");
    const std::string nodes = file_of("nodes", at == std::string::npos ? "0 0 0\n" : bytes.substr(at + 6));
    read_matrix_model({path, path, nodes});
  });
}
// Rows of the matrices of a bar of two nodes, as CalculiX lists them.
void dof(const std::string& bytes) {
  as_file("matrix.dof", bytes, [](const std::string& path) {
    MatrixFiles files;
    files.stiffness = files.mass = file_of("matrix.sti", "1 1 1.0\n1 4 -1.0\n4 4 1.0\n2 2 1.0\n6 6 1.0\n");
    files.nodes = file_of("nodes", "1 0 0 0\n2 1 0 0\n");
    files.rows = path;
    read_matrix_model(files);
  });
}
// Meshes of finite-element codes, with the modes of the results.
void fe_mesh(const std::string& bytes, const char* name) {
  allowed([&] {
    const FeMesh mesh = parse_fe_mesh(bytes, name);
    skin_of(mesh);
    if (std::string(name) == "mesh.frd") parse_frd_modes(bytes, name, mesh);
  });
}
void fe_inp(const std::string& bytes) { fe_mesh(bytes, "mesh.inp"); }
void fe_msh(const std::string& bytes) { fe_mesh(bytes, "mesh.msh"); }
void fe_bdf(const std::string& bytes) { fe_mesh(bytes, "mesh.bdf"); }
void fe_frd(const std::string& bytes) { fe_mesh(bytes, "mesh.frd"); }
void mesh_off(const std::string& bytes) {
  as_file("mesh.off", bytes, [](const std::string& path) { read_mesh(path, 1.0); });
}
void modal(const std::string& bytes) {
  as_file("body.modal", bytes, [](const std::string& path) { read_modal_body(path, BasisOptions(), "body"); });
}
void two_columns(const std::string& bytes) {
  as_file("table.csv", bytes, [](const std::string& path) { read_two_columns(path); });
}
void history(const std::string& bytes) {
  as_file("history.csv", bytes, [](const std::string& path) { read_history(path); });
}
void summary(const std::string& bytes) {
  as_file("summary.json", bytes, [](const std::string& path) {
    const auto summary = read_summary(path);
    with_summary_of(path, [&] { return summary.value("status", ""); });
  });
}
void start(const std::string& bytes) {
  as_file("start.json", bytes,
          [](const std::string& path) { read_run_start(std::filesystem::path(path).parent_path().string()); });
}
// The dump of the grains of a bed.
void bed(const std::string& bytes) {
  as_file("bed.restart.grains", bytes, [](const std::string& path) { read_grains(path); });
}

// What a program saves in a checkpoint, with every type of value.
struct Saved {
  long window = 0;
  double time = 0.0;
  bool chosen = false;
  std::string scheme;
  std::vector<bool> flags;
  std::optional<double> peak;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(3);
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  std::array<double, 2> energy{};
  Load load;

  void visit(Archive& archive) {
    archive("window", window);
    archive("time", time);
    archive("chosen", chosen);
    archive("scheme", scheme);
    archive("flags", flags);
    archive("peak", peak);
    archive("q", q);
    archive("A", A);
    archive("energy", energy);
    archive("load", load);
  }
};
void checkpoint(const std::string& bytes) {
  allowed([&] {
    Archive archive("run.txt", bytes);
    Saved().visit(archive);
    archive.finish();
  });
}

template <class Message>
void unpack_as(const std::string& bytes) {
  allowed([&] {
    Message message;
    unpack(Bytes(bytes.begin(), bytes.end()), message);
  });
}
void messages(const std::string& bytes) {
  unpack_as<Hello>(bytes);
  unpack_as<Geometry>(bytes);
  unpack_as<Start>(bytes);
  unpack_as<Accept>(bytes);
  unpack_as<Motion>(bytes);
  unpack_as<Load>(bytes);
  unpack_as<Close>(bytes);
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {{"scene", scene},
                                          {"experiment", experiment},
                                          {"calibration", calibration},
                                          {"fll", fll},
                                          {"mesh_stl", mesh_stl},
                                          {"mesh_obj", mesh_obj},
                                          {"mesh_ply", mesh_ply},
                                          {"mesh_off", mesh_off},
                                          {"fe_inp", fe_inp},
                                          {"fe_msh", fe_msh},
                                          {"fe_bdf", fe_bdf},
                                          {"fe_frd", fe_frd},
                                          {"mtx", mtx},
                                          {"dof", dof},
                                          {"modal", modal},
                                          {"two_columns", two_columns},
                                          {"history", history},
                                          {"summary", summary},
                                          {"start", start},
                                          {"bed", bed},
                                          {"checkpoint", checkpoint},
                                          {"messages", messages}};
  return all;
}

}  // namespace footfall::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const footfall::fuzz::Target* const chosen = [] {
    const char* name = std::getenv("FOOTFALL_FUZZ_TARGET");
    for (const footfall::fuzz::Target& target : footfall::fuzz::targets())
      if (name && target.name == std::string(name)) return &target;
    std::abort();
  }();
  chosen->read(std::string(data, data + size));
  return 0;
}
