// Files of a run in progress grow, or are complete once the next look finds them unchanged. Each frame becomes the parts of a page
// with one frame, so that what writes view.html writes events as well.
#include "mbd_solver/app/live/run_feed.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/mechanism_shape.h"
#include "mbd_solver/app/packed_series.h"
#include "mbd_solver/app/scenery/scenery.h"
#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/session/observe/terrain_patch.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

using LiveJson = nlohmann::ordered_json;

constexpr double kSpansOfRun = 2000.0;         // of time, as in a page
constexpr double kSpanOfUnknownEnd = 1e-3;     // [s]
constexpr std::size_t kMostBytes = 16u << 20;  // of a history at one look
constexpr std::size_t kMostDumps = 3;          // at one look

// {run, chunks}, on one line.
std::string event_text(const PageParts& parts, bool first, const std::vector<const char*>& once) {
  LiveJson json = {{"run", parts.run}, {"chunks", LiveJson::object()}};
  for (const auto& [name, text] : parts.chunks)
    if (first || std::find(once.begin(), once.end(), name) == once.end()) json["chunks"][name] = text;
  return json.dump(-1, ' ', true, LiveJson::error_handler_t::replace);
}

// What a reader of damaged or incomplete files leaves out.
template <class Read>
bool can_read(const Read& read) {
  try {
    read();
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

RunFeed::RunFeed(std::string run) : run_(std::move(run)), tail_((fs::path(run_) / "history.csv").string()) {
  read_note();
}

void RunFeed::read_note() {
  if (!scene_.is_null() || !fs::exists(fs::path(run_) / kRunNote)) return;
  can_read([&] {
    const RunNote note = read_run_note(run_);
    title_ = note.title;
    end_time_ = note.end_time;
    const LiveNote live = read_live_note(run_);
    dt_dem_ = live.dt_dem;
    scene_ = live.scene;
  });
}

PageParts RunFeed::page() const {
  PageParts parts;
  parts.run["live"] = true;
  parts.run["title"] = title_.empty() ? fs::absolute(run_).lexically_normal().filename().string() : title_;
  parts.run["end"] = end_time_;
  if (const auto terrain = read_whole_file((fs::path(run_) / kTerrainFile).string()))
    can_read([&] { parts.run["terrain"] = LiveJson::parse(*terrain); });
  if (!scene_.is_object()) return parts;
  add_surroundings(scene_, parts);
  std::vector<std::string> unseen;
  can_read([&] { add_static_meshes(scene_, parts, unseen); });
  return parts;
}

std::vector<LiveEvent> RunFeed::look(bool last) {
  std::vector<LiveEvent> events;
  read_note();
  can_read([&] { look_at_history(last, events); });
  if (is_known()) can_read([&] { look_at_bodies(events); });
  if (dt_dem_ > 0.0) can_read([&] { look_at_grains(last, events); });
  return events;
}

void RunFeed::add_row(const std::vector<double>& row) {
  const double length = end_time_ > 0.0 ? end_time_ / kSpansOfRun : kSpanOfUnknownEnd;
  const long number = static_cast<long>(std::clamp(row.front() / length, 0.0, 1e15));
  if (number != span_.number && span_.rows > 0) end_span();
  if (span_.rows == 0)
    span_ = {number, 0, row, row, row, std::vector<long>(row.size(), 0), std::vector<long>(row.size(), 0), 0.0};
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] < span_.low[i]) {
      span_.low[i] = row[i];
      span_.low_at[i] = span_.rows;
    }
    if (row[i] > span_.high[i]) {
      span_.high[i] = row[i];
      span_.high_at[i] = span_.rows;
    }
  }
  ++span_.rows;
  span_.end = row.front();
}

void RunFeed::end_span() {
  if (span_.rows == 0) return;
  if (span_.rows == 1) {
    ready_.push_back(std::move(span_.first));
  } else {
    std::vector<double> one = span_.low, other = span_.high;
    for (std::size_t i = 1; i < one.size(); ++i)
      if (span_.high_at[i] < span_.low_at[i]) std::swap(one[i], other[i]);
    one.front() = span_.first.front();
    other.front() = span_.end;
    ready_.push_back(std::move(one));
    ready_.push_back(std::move(other));
  }
  span_.rows = 0;
}

void RunFeed::look_at_history(bool last, std::vector<LiveEvent>& events) {
  const std::string text = tail_.read(last ? std::string::npos : kMostBytes);
  if (tail_.names().empty()) return;
  if (!columns_sent_) {
    columns_sent_ = true;
    const std::vector<std::string>&names = tail_.names(), &units = tail_.units();
    const auto accelerated =
        std::find_if(names.begin(), names.end(), [](const auto& n) { return ends_with(n, ".az"); });
    const std::string body = accelerated == names.end() ? "" : accelerated->substr(0, accelerated->size() - 3);
    const LiveJson head = {{"names", std::vector<std::string>(names.begin() + 1, names.end())},
                           {"units", std::vector<std::string>(units.begin() + 1, units.end())},
                           {"shown", first_columns({names, units, {}}, body)}};
    events.push_back({"columns", head.dump(), 0.0});
  }
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = text.find('\n', from);
    add_row(row_values(text.substr(from, end - from), tail_.names().size(), run_));
    from = end + 1;
  }
  if (last) end_span();
  if (ready_.empty()) return;
  std::vector<float> values;
  LiveJson json = {{"time", LiveJson::array()}};
  for (const std::vector<double>& row : ready_) json["time"].push_back(row.front());
  for (std::size_t i = 1; i < tail_.names().size(); ++i)
    for (const std::vector<double>& row : ready_) values.push_back(static_cast<float>(row[i]));
  json["values"] = packed_numbers(values);
  events.push_back({"rows", json.dump(), ready_.front().front()});
  ready_.clear();
}

void RunFeed::look_at_bodies(std::vector<LiveEvent>& events) {
  if (!fs::exists(fs::path(run_) / "bodies.pvd")) return;
  const LiveJson summary = {{"scene", scene_}};
  const MechanismShapes shapes(run_, summary);
  if (!shapes.drawn()) return;
  for (const double t : shapes.times()) {
    if (t <= last_drawing_) continue;
    PageParts parts;
    add_shapes({t}, {shapes.near(t)}, parts);
    if (!bodies_sent_) parts.run["bodyNames"] = shapes.body_names();
    events.push_back(
        {"bodies",
         event_text(parts, !bodies_sent_, {"bodies-triangles", "bodies-lines", "bodies-cells", "bodies-radius"}), t});
    bodies_sent_ = true;
    last_drawing_ = t;
  }
}

// PREFIX_STEP.ENDING of the prefix that find_bed_frames chose.
std::map<long, std::string> RunFeed::new_dumps() {
  std::map<long, std::string> dumps;
  if (prefix_.empty()) {
    dumps = find_bed_frames(run_);
    if (dumps.empty()) return dumps;
    const std::string stem = fs::path(dumps.begin()->second).stem().string();
    prefix_ = stem.substr(0, stem.rfind('_') + 1);
    return dumps;
  }
  std::error_code gone;
  for (fs::directory_iterator it(run_, gone), end; !gone && it != end; it.increment(gone)) {
    const std::string stem = it->path().stem().string(), ending = it->path().extension().string();
    if (stem.rfind(prefix_, 0) != 0 || (ending != ".vtk" && ending != ".txt" && ending != ".vtp")) continue;
    const auto step = whole_number(stem.substr(prefix_.size()), 0, std::numeric_limits<int>::max());
    if (!step || *step <= last_dump_) continue;
    std::string& file = dumps[*step];
    if (file.empty() || ending != ".vtp") file = it->path().string();
  }
  return dumps;
}

void RunFeed::look_at_grains(bool last, std::vector<LiveEvent>& events) {
  std::map<long, std::string> dumps = new_dumps();
  // The newest may be in writing: it is complete when it has kept its size since the last look.
  if (!last && !dumps.empty()) {
    std::error_code gone;
    const auto newest = std::prev(dumps.end());
    const std::uintmax_t size = fs::file_size(newest->second, gone);
    const auto before = sizes_.find(newest->second);
    const bool complete = before != sizes_.end() && before->second == size;
    sizes_ = {{newest->second, size}};
    if (!complete) dumps.erase(newest);
  }
  if (dumps.size() > kMostDumps) dumps.erase(dumps.begin(), std::prev(dumps.end()));
  for (const auto& [step, file] : dumps) {
    last_dump_ = step;
    can_read([&, step = step, file = file] {
      PageParts parts;
      FrameLimits limits;
      limits.with_ids = true;
      add_dumps({{step, file}}, 1, dt_dem_, limits, parts);
      events.push_back({"grains", event_text(parts, true, {}), static_cast<double>(step) * dt_dem_});
    });
  }
}

}  // namespace footfall
