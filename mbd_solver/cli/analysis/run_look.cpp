// One look at the folder of a run: mbd_solver/cli/analysis/watch.h
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/folder_lock.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/watch.h"
#include "mbd_solver/cli/launch/liggghts_log.h"
#include "mbd_solver/output/run_note.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// Somebody runs into the folder, and has not yet said how it ended.
bool goes_on(const fs::path& run) {
  const fs::path lock = run / kLockFile, summary = run / "summary.json";
  if (!is_alive(owner_of(lock.string()))) return false;
  std::error_code error;
  if (!fs::exists(summary, error)) return true;
  return fs::last_write_time(summary, error) < fs::last_write_time(lock, error);
}

RunLook::State state_of(const std::string& status) {
  if (status == "done") return RunLook::State::kDone;
  return status == "interrupted" ? RunLook::State::kInterrupted : RunLook::State::kFailed;
}

double largest_contact(const LastRow& row) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 2 < row.names.size(); ++i) {
    if (!ends_with(row.names[i], ".contact.fx")) continue;
    const double* f = &row.values[i];
    largest = std::max(largest, std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]));
  }
  return largest;
}

}  // namespace

LastRow last_row(const std::string& history) {
  LastRow row;
  const std::optional<std::string> text = read_whole_file(history);
  if (!text) return row;
  const std::size_t units = text->find('\n');
  const std::size_t names = units == std::string::npos ? units : text->find('\n', units + 1);
  const std::size_t end = text->rfind('\n');
  if (names == std::string::npos) return row;
  row.names = split(text->substr(units + 1, names - units - 1), ',');
  row.rows = std::count(text->begin() + static_cast<long>(names) + 1, text->begin() + static_cast<long>(end) + 1, '\n');
  if (row.rows == 0) return row;
  const std::size_t start = text->rfind('\n', end - 1) + 1;
  for (const std::string& cell : split(text->substr(start, end - start), ','))
    row.values.push_back(std::strtod(cell.c_str(), nullptr));
  if (row.values.size() != row.names.size())
    throw InputError(history + ": its last row has " + std::to_string(row.values.size()) + " values, expected " +
                     std::to_string(row.names.size()));
  return row;
}

RunLook look_at_run(const std::string& run) {
  const fs::path folder(run);
  const bool ended = fs::exists(folder / "summary.json");
  if (!ended && !fs::exists(folder / kLockFile) && !fs::exists(folder / "history.csv"))
    throw InputError(run + ": holds neither a run that is under way nor the results of one");
  RunLook look;
  if (fs::exists(folder / kRunNote)) {
    const RunNote note = read_run_note(run);
    look.title = note.title;
    look.end_time = note.end_time;
  }
  const LastRow row = last_row((folder / "history.csv").string());
  look.rows = row.rows;
  if (row.rows > 0) {
    look.state = RunLook::State::kRunning;
    look.time = row.values.front();
    look.contact_force = largest_contact(row);
  } else if (const LogProgress log = log_progress((folder / "liggghts.log").string()); log.begun()) {
    look.preparation = log.text();
  }
  if (goes_on(folder)) return look;
  look.state = RunLook::State::kGone;
  if (!ended) return look;
  const nlohmann::ordered_json summary = read_summary((folder / "summary.json").string());
  return with_summary_of(run, [&] {
    look.state = state_of(summary.value("status", ""));
    look.reason = summary.value("reason", "");
    return look;
  });
}

}  // namespace footfall
