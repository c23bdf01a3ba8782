#include "mbd_solver/cli/analysis/audit_files.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

using Row = std::vector<std::string>;

// Calls `take` with the cells of every line behind the first, whose number of cells they have.
Row for_each_line(const std::string& path, const std::function<void(const Row&, const std::string&)>& take) {
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line))
    throw InputError(path + ": cannot be read; expected what an audited run writes (footfall audit SCENE)");
  const Row names = split(line, ',');
  for (int number = 2; std::getline(file, line); ++number) {
    const Row cells = split(line, ',');
    const std::string where = path + ":" + std::to_string(number) + ": ";
    if (cells.size() != names.size())
      throw InputError(where + "has " + std::to_string(cells.size()) + " values, expected " +
                       std::to_string(names.size()));
    take(cells, where);
  }
  return names;
}

double number(const std::string& text, const std::string& where) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value))
    throw InputError(where + "\"" + text.substr(0, 40) + "\", expected a finite number");
  return value;
}

Eigen::Vector3d vector(const Row& cells, std::size_t at, const std::string& where) {
  return {number(cells[at], where), number(cells[at + 1], where), number(cells[at + 2], where)};
}

}  // namespace

const AuditSource& AuditWindow::find(const std::string& kind, const std::string& name) const {
  for (const AuditSource& source : sources)
    if (source.kind == kind && source.name == name) return source;
  throw InputError("the audit has no " + kind + " of \"" + name + "\" in window " + std::to_string(this->number));
}

GrainsAudit read_grains_audit(const std::string& path) {
  GrainsAudit audit;
  for_each_line(path, [&audit](const Row& cells, const std::string& where) {
    if (cells.size() != 11) throw InputError(where + "expected eleven values");
    const long window = std::lround(number(cells[0], where));
    AuditSource one;
    one.kind = cells[1];
    one.name = cells[2];
    one.linear = vector(cells, 3, where);
    one.angular = vector(cells, 6, where);
    one.force = number(cells[9], where);
    one.moment = number(cells[10], where);
    if (one.kind == "clock") {
      AuditWindow& next = audit.windows.emplace_back();
      next.number = window;
      next.end = one.linear.x();
      next.length = one.linear.y();
      next.substeps = one.angular.x();
      next.periodic = static_cast<int>(one.angular.z());
      return;
    }
    if (window < 0) {
      if (one.kind == "state") audit.start = one;
      if (one.kind == "energy") audit.start_energy = one.linear, audit.start_count = one.linear.z();
      return;
    }
    if (audit.windows.empty() || audit.windows.back().number != window)
      throw InputError(where + "window " + std::to_string(window) + " has not begun");
    AuditWindow& now = audit.windows.back();
    if (one.kind == "state") {
      now.state = one;
    } else if (one.kind == "energy") {
      now.energy = one.linear;
      now.count = one.linear.z();
    } else {
      now.sources.push_back(one);
    }
  });
  return audit;
}

MechanismAudit read_mechanism_audit(const std::string& path) {
  MechanismAudit audit;
  std::vector<Row> lines;
  const Row names = for_each_line(path, [&](const Row& cells, const std::string& where) {
    for (const std::string& text : cells) number(text, where);
    lines.push_back(cells);
  });
  constexpr std::size_t kOwn = 11, kPerBody = 7;  // columns
  for (const Row& cells : lines) {
    MechanismRow& row = audit.rows.emplace_back();
    row.time = number(cells[0], path);
    row.momentum = vector(cells, 1, path);
    row.size = number(cells[4], path);
    row.mass = number(cells[5], path);
    row.gravity = vector(cells, 6, path);
    audit.free = cells[9] == "1";
    audit.reacts = cells[10] == "1";
    for (std::size_t at = kOwn; at + kPerBody <= cells.size(); at += kPerBody) {
      const std::string body = names[at].substr(0, names[at].rfind('.'));
      row.loads[body] = {vector(cells, at, path), vector(cells, at + 3, path), number(cells[at + 6], path)};
    }
  }
  return audit;
}

}  // namespace footfall
