// Matrices become entries between labelled rows; labels and the nodes' file give each row its place in the model.

#include "mbd_solver/fe/matrix_model.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/fe/fe_mesh.h"
#include "mbd_solver/fe/model_text.h"
#include "mbd_solver/fe/spider.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

constexpr int kMostRows = 100000000;
constexpr long kMostNumber = 2000000000;  // of a node
constexpr double kOneMass = 1e-4;         // relative: files print six digits or more
constexpr double kSameAlong = 1e-9;       // of a node along x, y and z, relative

// Node and degree of freedom from 1, as files count them.
struct RowLabel {
  long node = 0;
  int dof = 0;
  bool operator<(const RowLabel& other) const { return node != other.node ? node < other.node : dof < other.dof; }
};

std::string text_of(const RowLabel& row) { return std::to_string(row.node) + "." + std::to_string(row.dof); }

struct FileMatrix {
  std::string path;
  int size = 0;
  std::vector<RowLabel> rows;  // empty: in the order of the nodes
  std::vector<Triplet> entries;
};

// Numbers the labels in the order in which they appear.
class RowNumbers {
 public:
  explicit RowNumbers(FileMatrix& matrix) : matrix_(matrix) {}
  int of(const RowLabel& label) {
    const auto [entry, fresh] = numbers_.try_emplace(label, static_cast<int>(matrix_.rows.size()));
    if (fresh) matrix_.rows.push_back(label);
    return entry->second;
  }

 private:
  FileMatrix& matrix_;
  std::map<RowLabel, int> numbers_;
};

// --- Formats.

void read_market(ModelText& text, FileMatrix& matrix) {
  const std::string expected = "\"%%MatrixMarket matrix coordinate real symmetric\" (or general, or integer)";
  std::vector<std::string> w = text.words();
  for (std::string& word : w) word = upper_case(word);
  if (w.size() != 5 || w[1] != "MATRIX" || w[2] != "COORDINATE" || (w[3] != "REAL" && w[3] != "INTEGER") ||
      (w[4] != "SYMMETRIC" && w[4] != "GENERAL"))
    text.fail("unsupported matrix, expected " + expected + ".");
  const bool symmetric = w[4] == "SYMMETRIC";
  const auto next = [&](const std::string& what) {
    for (;;) {
      if (!text.next()) text.fail("the file ends here, expected " + what + ".");
      const std::size_t from = text.line().find_first_not_of(" \t");
      if (from != std::string::npos && text.line()[from] != '%') return text.words();
    }
  };
  std::vector<std::string> words = next("rows, columns and entries");
  if (words.size() != 3) text.fail("expected three numbers: rows, columns and entries.");
  matrix.size = static_cast<int>(text.whole(words[0], 1, kMostRows));
  if (text.whole(words[1], 1, kMostRows) != matrix.size) text.fail("expected a square matrix.");
  const long entries = text.whole(words[2], 1, kMostNumber);
  bool below = false, above = false;  // of the diagonal
  for (long e = 0; e < entries; ++e) {
    words = next("entry " + std::to_string(e + 1) + " of " + std::to_string(entries));
    if (words.size() != 3) text.fail("expected three numbers: row, column and value.");
    const int i = static_cast<int>(text.whole(words[0], 1, matrix.size)) - 1,
              j = static_cast<int>(text.whole(words[1], 1, matrix.size)) - 1;
    const double value = text.number(words[2]);
    matrix.entries.emplace_back(i, j, value);
    below = below || i > j;
    above = above || i < j;
    if (symmetric && below && above)
      text.fail(
          "an entry on the other side of the diagonal, expected one triangle of a symmetric matrix. Leave the other "
          "out, or call the matrix general.");
    if (symmetric && i != j) matrix.entries.emplace_back(j, i, value);
  }
  while (text.next())
    if (!text.blank() && trimmed(text.line())[0] != '%')
      text.fail("more entries than the " + std::to_string(entries) + " announced.");
}

// `row column value` without a head (CalculiX, Abaqus), or `node, dof, node, dof, value` (Abaqus). The current line is the
// first that counts.
void read_entries(ModelText& text, FileMatrix& matrix) {
  RowNumbers numbers(matrix);
  std::size_t columns = 0;
  do {
    if (text.blank() || text.line().compare(0, 2, "**") == 0 || text.line()[0] == '*') continue;
    const std::vector<std::string> cells = text.cells();
    if (columns == 0) columns = cells.size();
    if ((cells.size() != 3 && cells.size() != 5) || cells.size() != columns)
      text.fail(
          std::to_string(cells.size()) +
          " numbers, expected \"row column value\" or \"node, dof, node, dof, value\" in all lines. Known formats "
          "are MatrixMarket, CalculiX .sti and .mas, Abaqus .mtx and Nastran DMIG.");
    int i = 0, j = 0;
    if (columns == 3) {
      i = static_cast<int>(text.whole(cells[0], 1, kMostRows)) - 1;
      j = static_cast<int>(text.whole(cells[1], 1, kMostRows)) - 1;
      matrix.size = std::max({matrix.size, i + 1, j + 1});
    } else {
      const auto label = [&](std::size_t k) {
        return RowLabel{text.whole(cells[k], -kMostNumber, kMostNumber),
                        static_cast<int>(text.whole(cells[k + 1], 0, 1000))};
      };
      i = numbers.of(label(0));
      j = numbers.of(label(2));
    }
    matrix.entries.emplace_back(i, j, text.number(cells.back()));
  } while (text.next());
  if (columns == 5) matrix.size = static_cast<int>(matrix.rows.size());
}

// `*USER ELEMENT, NODES=n`, the nodes in comments, degrees of freedom, then `*MATRIX, TYPE=...` with the lower triangle by
// rows. A line of degrees of freedom holds from its position on.
void read_substructure(ModelText& text, const std::string& type, FileMatrix& matrix) {
  std::vector<long> nodes;
  std::map<long, std::vector<int>> dofs;  // by the position of the node, from 1
  bool listing = false, in_element = false, found = false;
  std::string others;
  do {
    const std::string& line = text.line();
    if (line.compare(0, 2, "**") == 0) {
      const std::string comment = upper_case(trimmed(line.substr(2)));
      if (comment.rfind("ELEMENT NODES", 0) == 0) {
        listing = true;
        nodes.clear();
        continue;
      }
      const bool is_list = !comment.empty() && comment.find_first_not_of("0123456789, \t-") == std::string::npos;
      if (listing && is_list)
        for (const std::string& cell : split(comment, ','))
          if (!trimmed(cell).empty()) nodes.push_back(text.whole(trimmed(cell), -kMostNumber, kMostNumber));
      listing = listing && is_list;
      continue;
    }
    listing = false;
    if (!line.empty() && line[0] == '*') {
      const std::string keyword = upper_case(line);
      in_element = keyword.rfind("*USER ELEMENT", 0) == 0;
      if (in_element) dofs.clear();
      if (keyword.rfind("*MATRIX", 0) != 0) continue;
      std::string wide = keyword;
      wide.erase(std::remove(wide.begin(), wide.end(), ' '), wide.end());
      const std::size_t at = wide.find("TYPE=");
      const std::string is = at == std::string::npos ? "" : wide.substr(at + 5, wide.find(',', at) - at - 5);
      if (is != type) {
        others += (others.empty() ? "" : ", ") + is;
        continue;
      }
      if (nodes.empty() || dofs.empty())
        text.fail(
            "a matrix without the list of its nodes and their degrees of freedom, expected \"** ELEMENT NODES\" and "
            "\"*USER ELEMENT\" before it.");
      for (std::size_t p = 0; p < nodes.size(); ++p) {
        auto of = dofs.upper_bound(static_cast<long>(p) + 1);
        if (of == dofs.begin()) text.fail("node " + std::to_string(nodes[p]) + " has no degrees of freedom.");
        for (const int dof : (--of)->second) matrix.rows.push_back({nodes[p], dof});
        if (matrix.rows.size() > text.bytes()) text.fail("more rows than the file can hold.");
      }
      matrix.size = static_cast<int>(matrix.rows.size());
      std::vector<double> values;
      const std::size_t size = matrix.rows.size(), expected = size * (size + 1) / 2;
      while (values.size() < expected) {
        if (!text.next() || (!text.line().empty() && text.line()[0] == '*'))
          text.fail("the matrix ends after " + std::to_string(values.size()) + " values, expected " +
                    std::to_string(expected) + ", the lower triangle of " + std::to_string(size) + " rows.");
        for (const std::string& cell : text.cells())
          if (!cell.empty()) values.push_back(text.number(cell));
      }
      if (values.size() > expected)
        text.fail("more than the " + std::to_string(expected) + " values of the lower triangle.");
      std::size_t k = 0;
      for (int i = 0; i < matrix.size; ++i)
        for (int j = 0; j <= i; ++j) matrix.entries.emplace_back(i, j, values[k++]);
      found = true;
      continue;
    }
    if (!in_element || text.blank()) continue;
    std::vector<long> numbers;
    for (const std::string& cell : text.cells()) numbers.push_back(text.whole(cell, 0, kMostNumber));
    if (numbers.empty()) continue;  // commas alone
    const bool first = dofs.empty();
    std::vector<int>& of = dofs[first ? 1 : numbers[0]];
    of.clear();
    for (std::size_t k = first ? 0 : 1; k < numbers.size(); ++k)
      of.push_back(static_cast<int>(std::min(numbers[k], 1000L)));
  } while (text.next());
  if (!found)
    throw InputError(code::kModelFile, matrix.path + ": has no *MATRIX, TYPE=" + type +
                                           (others.empty() ? "" : ", but " + others) +
                                           ". Request it, or name another file.");
}

// DMIG cards: `DMIG NAME 0 IFO TIN ...`, then columns `DMIG NAME GJ CJ - G1 C1 A1 B1 - G2 ...`.
void read_dmig(const std::string& bytes, char letter, FileMatrix& matrix) {
  const auto each = [&](const std::function<void(const NastranCards&)>& use) {
    ModelText text(bytes, matrix.path);
    NastranCards cards(text);
    while (cards.next())
      if (cards.fields()[0] == "DMIG") use(cards);
  };
  std::vector<std::string> names;
  each([&](const NastranCards& card) {
    if (!card.given(1)) card.fail("DMIG without a name.");
    const std::string name = upper_case(card.fields()[1]);
    if (!card.given(2) || card.fields()[2] != "0") return;
    if (name[0] == letter && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    if (name[0] == letter && card.whole(4, 1, 4) > 2) card.fail("a complex matrix, expected a real one.");
  });
  const std::string what = letter == 'K' ? "stiffness (KAAX, K2GG, ...)" : "mass (MAAX, M2GG, ...)";
  if (names.empty())
    throw InputError(code::kModelFile, matrix.path + ": has no DMIG matrix whose name begins with " +
                                           std::string(1, letter) + ", expected the " + what + ".");
  std::string taken = names[0];
  if (names.size() > 1) {
    const std::string usual = std::string(1, letter) + "AAX";
    if (std::find(names.begin(), names.end(), usual) == names.end())
      throw InputError(code::kModelFile, matrix.path + ": has the DMIG matrices " + joined(names) + ", expected one " +
                                             what + ". Leave one in the file.");
    taken = usual;
  }
  RowNumbers numbers(matrix);
  each([&](const NastranCards& card) {
    if (upper_case(card.fields()[1]) != taken || (card.given(2) && card.fields()[2] == "0")) return;
    const auto label = [&](std::size_t k) {
      return RowLabel{card.whole(k, 1, kMostNumber), card.given(k + 1) ? static_cast<int>(card.whole(k + 1, 0, 6)) : 0};
    };
    const int j = numbers.of(label(2));
    for (std::size_t k = 5; card.given(k); k += 4) {
      if (!card.given(k + 2)) card.fail("a row without a value.");
      matrix.entries.emplace_back(numbers.of(label(k)), j, card.number(k + 2, 0.0));
    }
  });
  matrix.size = static_cast<int>(matrix.rows.size());
}

// Where a triangle is stored only, adds the other. Zeros are left out.
void complete(FileMatrix& matrix) {
  std::vector<Triplet>& entries = matrix.entries;
  entries.erase(std::remove_if(entries.begin(), entries.end(), [](const Triplet& e) { return e.value() == 0.0; }),
                entries.end());
  std::vector<std::pair<int, int>> off;
  for (const Triplet& e : entries)
    if (e.row() != e.col()) off.emplace_back(e.row(), e.col());
  std::sort(off.begin(), off.end());
  const std::size_t before = entries.size();
  std::size_t with_partner = 0;
  for (std::size_t k = 0; k < before; ++k) {
    const Triplet e = entries[k];
    if (e.row() == e.col()) continue;
    if (std::binary_search(off.begin(), off.end(), std::pair(e.col(), e.row()))) {
      ++with_partner;
    } else {
      entries.emplace_back(e.col(), e.row(), e.value());
    }
  }
  if (with_partner > 0 && with_partner < off.size())
    throw InputError(code::kModelFile,
                     matrix.path +
                         ": some entries are given on both sides of the diagonal and others on one only, "
                         "expected one triangle, or all of a symmetric matrix.");
}

FileMatrix read_file_matrix(const std::string& path, bool stiffness) {
  const std::string bytes = bytes_of_model(path);
  FileMatrix matrix;
  matrix.path = path;
  ModelText text(bytes, path);
  bool market = false, substructure = false, dmig = false;
  while (text.next()) {
    if (text.blank()) continue;
    const std::string line = upper_case(text.line());
    market = line.compare(0, 14, "%%MATRIXMARKET") == 0;
    substructure = line.rfind("*USER ELEMENT", 0) == 0 || line.rfind("*MATRIX", 0) == 0;
    dmig = line.compare(0, 4, "DMIG") == 0;
    const char first = trimmed(line)[0];
    const bool numbers = std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '-';
    if (market || substructure || dmig || (numbers && line.find('=') == std::string::npos)) break;
    if (line.compare(0, 2, "%%") == 0) market = true;
    if (market) break;
  }
  if (market) {
    read_market(text, matrix);
    return matrix;
  }
  if (substructure && bytes.find_first_of("=") != std::string::npos &&
      upper_case(text.line()).find("INPUT") == std::string::npos) {
    ModelText again(bytes, path);
    if (again.next()) read_substructure(again, stiffness ? "STIFFNESS" : "MASS", matrix);
  } else if (dmig) {
    read_dmig(bytes, stiffness ? 'K' : 'M', matrix);
  } else {
    read_entries(text, matrix);
  }
  if (matrix.entries.empty()) throw InputError(code::kModelFile, path + ": contains no entries, expected a matrix.");
  complete(matrix);
  return matrix;
}

// `node.direction` in each line.
std::vector<RowLabel> read_rows(const std::string& path) {
  ModelText text(bytes_of_model(path), path);
  std::vector<RowLabel> rows;
  while (text.next()) {
    if (text.blank()) continue;
    const std::string word = trimmed(text.line());
    const std::size_t dot = word.find('.');
    if (dot == std::string::npos) text.fail("\"" + word.substr(0, 40) + "\", expected \"node.direction\".");
    rows.push_back(
        {text.whole(word.substr(0, dot), 0, kMostNumber), static_cast<int>(text.whole(word.substr(dot + 1), 0, 1000))});
  }
  return rows;
}

// The file of rows: given, or in the folder of a .sti.
std::string rows_file(const MatrixFiles& files) {
  if (!files.rows.empty()) return files.rows;
  const std::filesystem::path stiffness(files.stiffness);
  if (stiffness.extension() != ".sti") return "";
  return std::filesystem::path(stiffness).replace_extension(".dof").string();
}

// --- Rows of the model.

struct Units {
  double length, mass, time;  // one of the files' in m, kg, s
};
Units units_of(UnitSystem system) {
  switch (system) {
    case UnitSystem::kMetre: return {1.0, 1.0, 1.0};
    case UnitSystem::kMillimetreTonne: return {1e-3, 1e3, 1.0};
    case UnitSystem::kMillimetreMillisecond: return {1e-3, 1.0, 1e-3};
    case UnitSystem::kInchPound: return {0.0254, 0.45359237 * 9.80665 / 0.0254, 1.0};  // mass: lbf s2/in
  }
  FOOTFALL_DEMAND(false);
}

// Rows of both matrices in the model: 6 j + i of node j, then those without a place.
struct Places {
  std::vector<int> stiffness, mass;
  std::vector<long> nodes;          // that have rows, in the order of the file: their index in the mesh
  std::vector<RowLabel> elsewhere;  // rows without a place
};

std::string elsewhere_text(const std::vector<RowLabel>& rows, const std::string& nodes) {
  if (rows.empty()) return "";
  return " " + std::to_string(rows.size()) + " rows, from " + text_of(rows[0]) + " on, belong to nodes that " + nodes +
         " does not list; they are taken for coordinates of modes.";
}

Places places_of(FileMatrix& K, FileMatrix& M, const FeMesh& mesh, const MatrixFiles& files) {
  const auto refuse = [](const std::string& what) { throw InputError(code::kModelFile, what); };
  const std::string from = rows_file(files);
  // CalculiX writes all diagonal terms, also zeros.
  const auto ends_in = [](const std::string& file, const char* end) {
    return std::filesystem::path(file).extension() == end;
  };
  if (ends_in(files.stiffness, ".sti") && ends_in(files.mass, ".mas") && K.size != M.size)
    refuse(files.mass + ": " + std::to_string(M.size) + " rows, expected " + std::to_string(K.size) + " as in " +
           files.stiffness + ". Name the two files of one run.");
  if (!from.empty())
    for (FileMatrix* matrix : {&K, &M})
      if (matrix->rows.empty()) {
        matrix->rows = read_rows(from);
        if (static_cast<int>(matrix->rows.size()) < matrix->size)
          refuse(matrix->path + ": " + std::to_string(matrix->size) + " rows, but " + from + " lists " +
                 std::to_string(matrix->rows.size()) + ". Export both together.");
        matrix->size = static_cast<int>(matrix->rows.size());
      }
  if (K.rows.empty() != M.rows.empty())
    refuse(files.stiffness + " and " + files.mass +
           ": one names the nodes of its rows, the other does not. Export both in one format, or give \"dof_file\".");
  Places places;
  const auto n = static_cast<long>(mesh.ids.size());
  if (K.rows.empty()) {
    const long size = std::max(K.size, M.size);
    if (K.size != M.size)
      refuse(files.mass + ": " + std::to_string(M.size) + " rows, expected " + std::to_string(K.size) + " as in " +
             files.stiffness + ".");
    if (size != 3 * n && size != 6 * n)
      refuse(files.stiffness + ": " + std::to_string(size) + " rows for the " + std::to_string(n) + " nodes of " +
             files.nodes + ", expected 3 or 6 per node: " + std::to_string(3 * n) + " or " + std::to_string(6 * n) +
             ". Give \"dof_file\" where rows have another order.");
    const int per_node = static_cast<int>(size / n);
    for (long j = 0; j < n; ++j) places.nodes.push_back(j);
    for (int i = 0; i < size; ++i) places.stiffness.push_back(6 * (i / per_node) + i % per_node);
    places.mass = places.stiffness;
    return places;
  }
  std::map<RowLabel, int> place;
  std::map<int, int> moves;  // index of a node in the mesh: bits of its degrees of freedom
  for (const FileMatrix* matrix : {&K, &M}) {
    std::set<RowLabel> own;
    for (const RowLabel& row : matrix->rows) {
      if (!own.insert(row).second)
        refuse(
            matrix->path + ": two rows belong to " + text_of(row) +
            ", expected one. CalculiX expands shells and beams to solids and writes their nodes under one number: mesh "
            "the part with solid elements, or take the matrices of a substructure.");
      const auto node = mesh.index.find(row.node);
      if (!place.emplace(row, -1).second) continue;
      if (node == mesh.index.end()) {
        places.elsewhere.push_back(row);
        continue;
      }
      if (row.dof < 1 || row.dof > 6)
        refuse(matrix->path + ": row " + text_of(row) +
               " is no displacement or rotation (1 to 6). Export a mechanical model.");
      moves[node->second] |= 1 << (row.dof - 1);
    }
  }
  if (moves.empty())
    refuse(files.stiffness + ": none of its nodes is listed in " + files.nodes + ", e.g. " +
           std::to_string(K.rows[0].node) + ". Name the file with their coordinates.");
  std::map<long, int> number;  // of a node of the mesh in the model
  for (long j = 0; j < n; ++j) {
    const auto found = moves.find(static_cast<int>(j));
    if (found == moves.end()) continue;
    if ((found->second & 7) != 7)
      refuse(files.stiffness + ": node " + std::to_string(mesh.ids[j]) +
             " lacks a displacement, expected rows for x, y and z of each node. Export the free body without supports; "
             "a reduced model keeps all displacements of a node.");
    number[mesh.ids[j]] = static_cast<int>(places.nodes.size());
    places.nodes.push_back(j);
  }
  const int behind = 6 * static_cast<int>(places.nodes.size());
  for (std::size_t k = 0; k < places.elsewhere.size(); ++k) place[places.elsewhere[k]] = behind + static_cast<int>(k);
  const auto at = [&](const RowLabel& row) {
    const auto node = number.find(row.node);
    return node == number.end() ? place.at(row) : 6 * node->second + row.dof - 1;
  };
  for (const RowLabel& row : K.rows) places.stiffness.push_back(at(row));
  for (const RowLabel& row : M.rows) places.mass.push_back(at(row));
  return places;
}

// E D A D: rows in SI units, D = 1 / length for displacements, and E for the energy.
Sparse placed(const FileMatrix& matrix, const std::vector<int>& place, int nodes, Index size, double energy,
              double length) {
  const auto scale = [&](int i) { return i < 6 * nodes && i % 6 < 3 ? 1.0 / length : 1.0; };
  std::vector<Triplet> entries;
  entries.reserve(matrix.entries.size());
  for (const Triplet& e : matrix.entries) {
    const int i = place[e.row()], j = place[e.col()];
    entries.emplace_back(i, j, energy * scale(i) * scale(j) * e.value());
  }
  Sparse result(size, size);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// M couples different nodes, displacements with rotations, or displacements with different masses.
bool is_lumped(const Sparse& M) {
  for (Index j = 0; j < M.cols(); ++j)
    for (Sparse::InnerIterator it(M, j); it; ++it) {
      const bool node = it.row() / 6 == j / 6, rotations = it.row() % 6 >= 3 && j % 6 >= 3;
      if (it.value() != 0.0 && it.row() != j && !(node && rotations)) return false;
    }
  const VectorXd m = M.diagonal();
  for (Index j = 0; j < M.cols(); j += 6)
    if ((m.segment<3>(j).array() - m(j)).abs().maxCoeff() > kSameAlong * std::abs(m(j))) return false;
  return true;
}

// The total mass is the same along x, y and z. Masses that are lumped go to their nodes, else the matrix is kept, and
// nodes are weighed by its diagonal terms, scaled to the total mass.
void set_mass(const Sparse& M, const std::string& path, FeModel& model) {
  const int n = model.node_count();
  Vector3d total, diagonal;
  for (int i = 0; i < 3; ++i) {
    VectorXd unit = VectorXd::Zero(M.rows());
    for (int j = 0; j < n; ++j) unit(6 * j + i) = 1.0;
    total(i) = unit.dot(M * unit);
    diagonal(i) = unit.dot(M.diagonal());
  }
  const double mass = total.mean();
  if (!(diagonal.minCoeff() > 0.0 && total.minCoeff() > 0.0))
    throw InputError(code::kModelFile,
                     path + ": mass matrix is not positive: the total mass is " + plain_text(mass) + " kg.");
  if (!((total.array() - mass).abs().maxCoeff() <= kOneMass * mass))
    throw InputError(code::kModelFile,
                     path + ": the total mass differs along x, y and z (" + plain_text(total.x()) + ", " +
                         plain_text(total.y()) + ", " + plain_text(total.z()) +
                         " kg); expected the same. Check that the rows are ordered node by node, x y z first.");
  const bool lumped = model.extra == 0 && is_lumped(M);
  const double factor = mass / diagonal.mean();
  model.node_mass.resize(n);
  for (int j = 0; j < n; ++j) {
    Matrix3d J;
    double m = 0.0;
    for (int i = 0; i < 3; ++i) {
      m += M.coeff(6 * j + i, 6 * j + i) / 3.0;
      for (int k = 0; k < 3; ++k) J(i, k) = factor * M.coeff(6 * j + 3 + i, 6 * j + 3 + k);
    }
    model.node_mass(j) = factor * m;
    model.node_inertia.push_back(lumped ? Matrix3d(0.5 * (J + J.transpose())) : Matrix3d(Matrix3d::Zero()));
  }
  if (!lumped) model.mass = M;
}

// Displacements and stresses of the modes in a .frd file, at the nodes of the model.
void read_stresses(const MatrixFiles& files, const FeMesh& mesh, const Places& places, const Units& units,
                   FeModel& model) {
  const FrdModes modes = parse_frd_modes(bytes_of_model(files.stress), files.stress, mesh);
  const Index n = model.node_count(), count = static_cast<Index>(modes.stresses.size());
  model.known_shapes.setZero(6 * n + model.extra, count);
  model.known_stresses.setZero(6 * n, count);
  const double pressure = units.mass / (units.length * units.time * units.time);
  for (Index k = 0; k < count; ++k)
    for (Index j = 0; j < static_cast<Index>(places.nodes.size()); ++j) {
      const auto in_mesh = static_cast<Index>(places.nodes[j]);
      const std::size_t mode = k;
      model.known_shapes.block<3, 1>(6 * j, k) = units.length * modes.displacements[mode].col(in_mesh);
      model.known_stresses.block<6, 1>(6 * j, k) = pressure * modes.stresses[mode].col(in_mesh);
      if (!model.known_shapes.col(k).segment<3>(6 * j).allFinite() ||
          !model.known_stresses.col(k).segment<6>(6 * j).allFinite())
        throw InputError(code::kModelFile, files.stress + ": mode " + std::to_string(k + 1) +
                                               " has no displacement or stress at node " +
                                               std::to_string(mesh.ids[in_mesh]) + ", expected all nodes of " +
                                               files.nodes + ". Write *NODE FILE and *EL FILE for all.");
    }
}

}  // namespace

double mass_unit(UnitSystem units) { return units_of(units).mass; }

double length_unit(UnitSystem units) { return units_of(units).length; }

FeModel read_matrix_model(const MatrixFiles& files) {
  const FeMesh mesh = parse_fe_mesh(bytes_of_model(files.nodes), files.nodes);
  if (!mesh.turned.empty())
    throw InputError(code::kModelFile, mesh.turned + ", expected the axes of the model. Export without them.");
  FileMatrix K = read_file_matrix(files.stiffness, true), M = read_file_matrix(files.mass, false);
  const Places places = places_of(K, M, mesh, files);
  const Units units = units_of(files.units);
  const auto n = static_cast<Index>(places.nodes.size());

  FeModel model;
  model.extra = static_cast<int>(places.elsewhere.size());
  model.nodes.resize(3, n);
  std::vector<int> number(mesh.ids.size(), -1);
  for (Index j = 0; j < n; ++j) {
    const std::size_t in_mesh = places.nodes[j];
    model.nodes.col(j) = units.length * mesh.points[in_mesh];
    number[in_mesh] = static_cast<int>(j);
  }
  const double energy = units.mass * units.length * units.length;  // times 1 / s2
  const Index size = 6 * n + model.extra;
  model.stiffness =
      placed(K, places.stiffness, static_cast<int>(n), size, energy / (units.time * units.time), units.length);
  model.rotations = false;
  const VectorXd diagonal = model.stiffness.diagonal();
  for (Index j = 0; j < n; ++j) model.rotations = model.rotations || !diagonal.segment<3>(6 * j + 3).isZero(0.0);
  set_mass(placed(M, places.mass, static_cast<int>(n), size, energy, units.length), files.mass, model);
  for (const Eigen::Vector3i& t : skin_of(mesh)) {
    const Eigen::Vector3i corners(number[t(0)], number[t(1)], number[t(2)]);
    if (corners.minCoeff() >= 0) model.triangles.push_back(corners);
  }
  model.stress.resize(0, size);
  model.remark = elsewhere_text(places.elsewhere, files.nodes);
  if (!files.stress.empty()) read_stresses(files, mesh, places, units, model);
  for (const InterfaceSpec& spec : files.interfaces) {
    std::vector<int> nodes;
    const int before = static_cast<int>(model.spiders.size());  // nodes in front
    for (const int in_mesh : mesh.set(spec.node_set, files.nodes))
      if (const int j = number[in_mesh]; j >= 0) nodes.push_back(j + before);
    if (nodes.empty())
      throw InputError(code::kModelFile, files.nodes + ": no node of the set \"" + spec.node_set + "\" has rows in " +
                                             files.stiffness + ".");
    add_spider(model, nodes, spec.kind, spec.point ? &*spec.point : nullptr, "\"" + spec.node_set + "\"");
  }
  return model;
}

}  // namespace footfall
