// A message is "file:line: key: text [code name]"; each finding of a scene is a separate line that ends with a code.

#include "mbd_solver/session/error_report.h"

#include <regex>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/helper_process.h"
#include "mbd_solver/session/observe/start_check.h"

namespace footfall {
namespace {

ErrorReport::Kind kind_of(const std::exception& error) {
  using Kind = ErrorReport::Kind;
  if (dynamic_cast<const InputError*>(&error) || dynamic_cast<const ProtocolError*>(&error)) return Kind::kInput;
  if (dynamic_cast<const NumericalError*>(&error)) return Kind::kNumerical;
  if (dynamic_cast<const PartnerError*>(&error) || dynamic_cast<const ForeignError*>(&error)) return Kind::kPartner;
  if (dynamic_cast<const FileError*>(&error)) return Kind::kFile;
  return Kind::kInternal;
}

}  // namespace

ErrorReport report_of(const std::string& message) {
  static const std::regex place("^([^:\n]+):([0-9]+): (?:([A-Za-z0-9_.{}-]+): )?"), setting("^--set ([^:\n]+): ");
  ErrorReport report;
  report.message = report.text = message;
  if (has_code(message)) {
    const std::size_t start = message.rfind(" [");
    report.code = message.substr(start + 2, 5);
    report.name = message.substr(start + 8, message.size() - start - 9);
    report.text = message.substr(0, start);
  }
  std::smatch found;
  const std::string text = report.text;
  if (std::regex_search(text, found, place)) {
    report.file = found[1];
    report.line = std::stoi(found[2]);
    report.key = found[3];
  } else if (std::regex_search(text, found, setting)) {
    report.line = -1;
    report.key = found[1];
  } else {
    return report;
  }
  report.text = text.substr(static_cast<std::size_t>(found.length(0)));
  return report;
}

std::vector<ErrorReport> reports_of(const std::exception& error) {
  std::vector<ErrorReport> reports;
  std::string message;
  for (const std::string& line : split(error.what(), '\n')) {
    message += (message.empty() ? "" : "\n") + line;
    if (!has_code(message)) continue;
    reports.push_back(report_of(message));
    message.clear();
  }
  if (!message.empty() || reports.empty()) reports.push_back(report_of(message));
  for (ErrorReport& report : reports) report.kind = kind_of(error);
  return reports;
}

CheckedScene check_for_findings(const std::function<Scene()>& read) {
  CheckedScene checked;
  const auto warn = [&](const std::string& warning) { checked.warnings.push_back(report_of(warning)); };
  try {
    const Scene scene = read();
    check_by_building(scene, true, warn);
  } catch (const InputError& error) {
    checked.errors = reports_of(error);
  }
  return checked;
}

}  // namespace footfall
