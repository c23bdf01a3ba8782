#pragma once
// What a run in progress has written since the last look, as events for its page (web/src/live.js).

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mbd_solver/app/live/history_tail.h"
#include "mbd_solver/app/view_page.h"

namespace footfall {

struct LiveEvent {
  // columns: {names, units, shown} of the history, once. rows: {time, values}: times [s], and the others as packed numbers, column by
  // column. bodies, grains: {run, chunks}: the parts of a page (view_page.h) with this one frame; what does not change from
  // frame to frame is in the first one only.
  std::string kind;
  std::string data;   // JSON in one line
  double time = 0.0;  // of a frame [s]
};

class RunFeed {
 public:
  explicit RunFeed(std::string run);

  // The scene is known, as mbd_solver has begun.
  bool is_known() const { return !scene_.is_null(); }
  // What the page shows before the first frame: of run.json, and the terrain.
  PageParts page() const;

  // New events, oldest first. Of more than a few new dumps of grains only the last is read. last: the run has ended, so that all
  // its files are complete. Files that cannot be read are left out.
  std::vector<LiveEvent> look(bool last);

 private:
  void read_note();
  void look_at_history(bool last, std::vector<LiveEvent>& events);
  void look_at_bodies(std::vector<LiveEvent>& events);
  void look_at_grains(bool last, std::vector<LiveEvent>& events);
  std::map<long, std::string> new_dumps();
  void add_row(const std::vector<double>& row);
  void end_span();

  std::string run_, title_;
  nlohmann::ordered_json scene_;          // as in summary.json; null: not known yet
  double end_time_ = 0.0, dt_dem_ = 0.0;  // [s]
  // History: a span of time gives two rows at most, which stand for all in it, as in a page.
  struct Span {
    long number = -1;
    long rows = 0;
    std::vector<double> first, low, high;  // low, high: of each column
    std::vector<long> low_at, high_at;     // their rows, counted from the first of the span
    double end = 0.0;                      // time of its last row [s]
  };
  HistoryTail tail_;
  Span span_;                               // that is being filled
  std::vector<std::vector<double>> ready_;  // rows to be sent
  bool columns_sent_ = false;
  // Frames.
  double last_drawing_ = -1.0;  // [s]
  bool bodies_sent_ = false;
  std::string prefix_;                           // of the dumps, once known
  std::map<std::string, std::uintmax_t> sizes_;  // of dumps that may be in writing
  long last_dump_ = -1;                          // step
};

}  // namespace footfall
