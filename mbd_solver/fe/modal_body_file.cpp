// The file is read record by record; errors name file and line.

#include "mbd_solver/fe/modal_body_file.h"

#include <cmath>
#include <fstream>
#include <locale>

#include "coupler/base/errors.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

// Records of a plain text file: lines with content, split at blanks; # starts a comment.
class TextRecords : public TextReader {
 public:
  explicit TextRecords(const std::string& path)
      : TextReader(path, code::kModelFile, "a modal body. Check the name; it is relative to the scene file.") {}

  // Goes to the next record; false at the end of the file.
  bool next() {
    while (TextReader::next()) {
      split_fields(std::string_view(line()).substr(0, line().find('#')), Separators::kBlanks, words_);
      if (!words_.empty()) return true;
    }
    return false;
  }
  // The same; throws InputError at the end of the file.
  void require_next(const std::string& expected) {
    if (!next()) fail("the file ends here, expected " + expected + ".");
  }

  std::string word(std::size_t i) const { return std::string(words_[i]); }
  std::size_t size() const { return words_.size(); }
  // Words as numbers; throw InputError naming the word. integer: within [low, high], also as "3.0".
  double number(std::size_t i) const {
    if (i >= words_.size())
      fail("expected at least " + std::to_string(i + 1) + " numbers, found " + std::to_string(words_.size()) + ".");
    return TextReader::number(words_[i]);
  }
  int integer(std::size_t i, int low, int high) const {
    const double value = number(i);
    if (value != std::floor(value) || value < low || value > high) whole(words_[i], low, high);
    return static_cast<int>(value);
  }

 private:
  std::vector<std::string_view> words_;
};

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr const char* kFormat = "footfall-modal-body";
constexpr int kVersion = 1;
constexpr int kMaxCount = 1000000;  // larger numbers of nodes, modes or triangles indicate a damaged file

// Reads `keyword N`, returns N.
int read_count(TextRecords& file, const std::string& keyword, int low) {
  if (file.word(0) != keyword) file.fail("\"" + file.word(0) + "\", expected \"" + keyword + " COUNT\".");
  if (file.size() != 2) file.fail("expected \"" + keyword + "\" and one number.");
  return file.integer(1, low, kMaxCount);
}

void require_size(const TextRecords& file, std::size_t size, std::size_t or_size) {
  if (file.size() == size || file.size() == or_size) return;
  file.fail(std::to_string(file.size()) + " numbers, expected " + std::to_string(size) +
            (size == or_size ? "" : " or " + std::to_string(or_size)) + ".");
}

void read_nodes(TextRecords& file, ModalBody& body) {
  file.require_next("\"nodes COUNT\"");
  const int n = read_count(file, "nodes", 1);
  body.rho0.resize(3, n);
  body.node_mass.resize(n);
  body.node_inertia.assign(static_cast<std::size_t>(n), Matrix3d::Zero());
  for (int j = 0; j < n; ++j) {
    file.require_next("node " + std::to_string(j) + ": x y z mass");
    require_size(file, 4, 10);
    body.rho0.col(j) = Vector3d(file.number(0), file.number(1), file.number(2));
    body.node_mass(j) = file.number(3);
    if (body.node_mass(j) < 0.0)
      file.fail("mass matrix is not positive: node " + std::to_string(j) + " has a negative mass.");
    if (file.size() == 4) continue;
    const double xx = file.number(4), yy = file.number(5), zz = file.number(6);
    const double xy = file.number(7), yz = file.number(8), zx = file.number(9);
    Matrix3d& J = body.node_inertia[j];
    J << xx, xy, zx, xy, yy, yz, zx, yz, zz;
    const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(J, Eigen::EigenvaluesOnly).eigenvalues();
    if (moments.minCoeff() < -1e-12 * moments.cwiseAbs().maxCoeff())
      file.fail("mass matrix is not positive: the rotary inertia of node " + std::to_string(j) +
                " has a negative principal value.");
  }
  if (!(body.node_mass.sum() > 0.0)) file.fail("mass matrix is not positive: the nodes have no mass.");
}

void read_modes(TextRecords& file, ModalBody& body) {
  file.require_next("\"modes COUNT\"");
  const int s = read_count(file, "modes", 0);
  const int n = body.node_count();
  if (s > 6 * n - 6)
    file.fail(std::to_string(s) + " modes, but " + std::to_string(n) + " nodes have only " + std::to_string(6 * n - 6) +
              " elastic degrees of freedom.");
  std::vector<VectorXd> Phi, Psi;  // grown mode by mode, so that a wrong count does not allocate
  for (int k = 0; k < s; ++k) {
    file.require_next("\"mode " + std::to_string(k) + "\"");
    if (read_count(file, "mode", 0) != k) file.fail("expected \"mode " + std::to_string(k) + "\".");
    Phi.emplace_back(VectorXd::Zero(3 * n));
    Psi.emplace_back(VectorXd::Zero(3 * n));
    for (int j = 0; j < n; ++j) {
      file.require_next("mode " + std::to_string(k) + ", node " + std::to_string(j));
      require_size(file, 3, 6);
      for (int i = 0; i < 3; ++i) {
        Phi.back()(3 * j + i) = file.number(static_cast<std::size_t>(i));
        if (file.size() == 6) Psi.back()(3 * j + i) = file.number(static_cast<std::size_t>(3 + i));
      }
    }
  }
  body.Phi.resize(3 * n, s);
  body.Psi.resize(3 * n, s);
  for (int k = 0; k < s; ++k) {
    body.Phi.col(k) = Phi[k];
    body.Psi.col(k) = Psi[k];
  }
}

MatrixXd read_stiffness(TextRecords& file, int s) {
  file.require_next("\"stiffness\"");
  if (file.word(0) != "stiffness" || file.size() != 1) file.fail("\"" + file.word(0) + "\", expected \"stiffness\".");
  MatrixXd K = MatrixXd::Zero(s, s);
  std::size_t width = 0;
  for (int i = 0; i < s; ++i) {
    file.require_next("row " + std::to_string(i) + " of the stiffness");
    require_size(file, width == 0 ? 1 : width, width == 0 ? static_cast<std::size_t>(s) : width);
    width = file.size();
    if (width == 1) K(i, i) = file.number(0);
    for (std::size_t j = 0; width > 1 && j < width; ++j) K(i, static_cast<Index>(j)) = file.number(j);
  }
  if (!((K - K.transpose()).norm() <= 1e-6 * K.norm())) file.fail("the modal stiffness is not symmetric.");
  return K;
}

template <int Corners>
void read_cells(TextRecords& file, const std::string& keyword, int nodes,
                std::vector<Eigen::Matrix<int, Corners, 1>>& cells) {
  const int count = read_count(file, keyword, 0);
  for (int t = 0; t < count; ++t) {
    file.require_next(keyword + " " + std::to_string(t));
    require_size(file, Corners, Corners);
    Eigen::Matrix<int, Corners, 1> cell;
    for (int i = 0; i < Corners; ++i) cell(i) = file.integer(static_cast<std::size_t>(i), 0, nodes - 1);
    cells.push_back(cell);
  }
}

// The optional sections, each at most once, up to `end`.
void read_rest(TextRecords& file, ModalBody& body, BasisOptions& options) {
  const Index s = body.Phi.cols();
  for (file.require_next("\"end\""); file.word(0) != "end"; file.require_next("\"end\"")) {
    const std::string keyword = file.word(0);
    if (keyword == "damping" && file.size() == 1) {
      options.damping_ratio.clear();
      for (Index k = 0; k < s; ++k) {
        file.require_next("damping ratio of mode " + std::to_string(k));
        require_size(file, 1, 1);
        options.damping_ratio.push_back(file.number(0));
        if (options.damping_ratio.back() < 0.0) file.fail("a damping ratio is negative, expected 0 or more.");
      }
      if (s == 0) options.damping_ratio.push_back(0.0);
    } else if (keyword == "triangles" && body.triangles.empty()) {
      read_cells<3>(file, keyword, body.node_count(), body.triangles);
    } else if (keyword == "segments" && body.segments.empty()) {
      read_cells<2>(file, keyword, body.node_count(), body.segments);
    } else if (keyword == "stress" && body.stress_modes.rows() == 0) {
      const Index rows = 6 * static_cast<Index>(read_count(file, keyword, 0));
      std::vector<double> values;  // row by row, so that a wrong count does not allocate
      for (Index i = 0; s > 0 && i < rows; ++i) {
        file.require_next("row " + std::to_string(i) + " of the stress");
        require_size(file, static_cast<std::size_t>(s), static_cast<std::size_t>(s));
        for (Index k = 0; k < s; ++k) values.push_back(file.number(static_cast<std::size_t>(k)));
      }
      using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      body.stress_modes = Eigen::Map<const Rows>(values.data(), rows, s);
    } else {
      file.fail("\"" + keyword + "\", expected one of damping, triangles, segments, stress (each once) or end.");
    }
  }
  if (file.next()) file.fail("text after \"end\".");
}

}  // namespace

ReducedBody read_modal_body(const std::string& path, const BasisOptions& given, const std::string& name) {
  TextRecords file(path);
  const std::string first = std::string("\"") + kFormat + " " + std::to_string(kVersion) + "\"";
  file.require_next(first);
  if (file.word(0) != kFormat || file.size() != 2) file.fail("not a modal body file, expected " + first + ".");
  file.integer(1, kVersion, kVersion);
  BasisOptions options = given;
  ModalBody body;
  body.name = name;
  read_nodes(file, body);
  read_modes(file, body);
  const MatrixXd K = read_stiffness(file, static_cast<int>(body.Phi.cols()));
  read_rest(file, body, options);
  try {
    return orthonormalised(std::move(body), K, options);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

void write_modal_body(const std::string& path, const ModalBody& body, const Vector3d& p_DBo) {
  std::ofstream file(path);
  file.imbue(std::locale::classic());
  file.precision(17);
  file << kFormat << ' ' << kVersion << "\n# body: " << body.name << "\nnodes " << body.node_count() << '\n';
  for (Index j = 0; j < body.node_count(); ++j) {
    const Matrix3d& J = body.node_inertia[j];
    const Vector3d p = body.rho0.col(j) + p_DBo;
    file << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << body.node_mass(j);
    if (!J.isZero(0.0))
      file << ' ' << J(0, 0) << ' ' << J(1, 1) << ' ' << J(2, 2) << ' ' << J(0, 1) << ' ' << J(1, 2) << ' ' << J(2, 0);
    file << '\n';
  }
  file << "modes " << body.mode_count() << '\n';
  const bool rotations = !body.Psi.isZero(0.0);
  for (Index k = 0; k < body.mode_count(); ++k) {
    file << "mode " << k << '\n';
    for (Index j = 0; j < 3 * body.node_count(); j += 3) {
      file << body.Phi(j, k) << ' ' << body.Phi(j + 1, k) << ' ' << body.Phi(j + 2, k);
      if (rotations) file << ' ' << body.Psi(j, k) << ' ' << body.Psi(j + 1, k) << ' ' << body.Psi(j + 2, k);
      file << '\n';
    }
  }
  file << "stiffness\n";
  for (Index k = 0; k < body.mode_count(); ++k) file << body.stiffness(k) << '\n';
  file << "damping\n";
  for (Index k = 0; k < body.mode_count(); ++k) file << body.damping(k) / (2.0 * std::sqrt(body.stiffness(k))) << '\n';
  file << "triangles " << body.triangles.size() << '\n';
  for (const Eigen::Vector3i& t : body.triangles) file << t.transpose() << '\n';
  file << "segments " << body.segments.size() << '\n';
  for (const Eigen::Vector2i& e : body.segments) file << e.transpose() << '\n';
  if (body.stress_modes.size() > 0)
    file << "stress " << body.stress_modes.rows() / 6 << '\n'
         << body.stress_modes.format(Eigen::IOFormat(17, Eigen::DontAlignCols)) << '\n';
  file << "end\n";
  file.close();
  if (!file)
    throw InputError(code::kModelFileNotWritten,
                     path + ": the file cannot be written. Check the folder and the free space.");
}

}  // namespace footfall
