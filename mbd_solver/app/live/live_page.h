#pragma once
// The page of a run in progress, in the browser of this machine: run --view and view --follow. A thread of the lowest priority
// reads what the run has written, while a page is open; without one it reads nothing.

#include <memory>
#include <string>

namespace footfall {

class LivePage {
 public:
  // Serves the page of the run in this folder, and opens it in a browser where there is a screen. Throws InputError where it
  // cannot be served.
  explicit LivePage(const std::string& run);
  ~LivePage();
  LivePage(const LivePage&) = delete;
  LivePage& operator=(const LivePage&) = delete;

  // For the user: "Live page: http://127.0.0.1:..."
  std::string announcement() const;
  // A browser reads the page now.
  bool is_open() const;
  // What the page says of the run, such as "t = 0.1 of 1 s (10 %)"; of the run's time so far [0 ... 1].
  void tell(const std::string& text, double share);
  // The run has ended: pages that are open get its last frames, and `text`. Waits for them, and for a browser that was just
  // started, for some seconds.
  void finish(const std::string& text);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace footfall
