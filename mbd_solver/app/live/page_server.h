#pragma once
// A page and its events (server-sent events of HTML) on 127.0.0.1, for whoever knows the token in its address. No file is named
// in a request, so that none can be reached.

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace footfall {

class PageServer {
 public:
  // Binds to a free port; `page` gives the text of the page at each request. Throws InputError when that is not possible.
  explicit PageServer(std::function<std::string()> page);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  // "http://127.0.0.1:PORT/TOKEN/". The token has 128 random bits.
  std::string address() const;

  // For all pages, also for those that are opened later: they get all that is kept, in this order. `data`: one line. An event
  // with a key takes the place of the one before with the same key.
  void send(const std::string& kind, std::string data, const std::string& key = "");
  // Leaves out every second event of this kind but the first and the last ones, for pages that are opened later.
  void thin(const std::string& kind);
  // Bytes of the events of this kind that are kept.
  std::size_t kept(const std::string& kind) const;

  // Pages that read events now.
  int readers() const;
  // Every reader has got every event.
  bool all_is_read() const;

 private:
  struct Event {
    long number;
    std::string kind, text, key;
  };
  struct Library;  // of cpp-httplib

  void serve();

  std::function<std::string()> page_;
  std::string token_;
  int port_ = 0;
  std::unique_ptr<Library> library_;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::deque<Event> events_;
  long numbers_ = 0;                 // given to events
  std::map<long, long> read_up_to_;  // of each reader, by its number: the last event that it has got
  long readers_ = 0;                 // so far
  bool ends_ = false;
};

}  // namespace footfall
