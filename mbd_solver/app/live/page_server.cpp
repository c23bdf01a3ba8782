// Every request is judged by its whole path before anything else; requests of other paths, methods and hosts get an empty answer.
// A reader of events keeps a thread of the library, which waits for news.
#include "mbd_solver/app/live/page_server.h"

#include <httplib.h>
#undef _res  // a macro of resolv.h, and a name in Eigen
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <thread>

#include "coupler/base/errors.h"
#include "mbd_solver/app/codes.h"

namespace footfall {

namespace {

constexpr int kMostReaders = 6, kThreads = 8;
constexpr std::chrono::seconds kSignOfLife(2);  // between two signs of life, by which a page that was closed is noticed
constexpr std::size_t kLongestPiece = 1u << 20;

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw InputError(code::kNoServer, "the page of the run cannot be served: the system gives no random numbers");
  std::string text;
  for (const unsigned char byte : bytes)
    for (const unsigned digit : {byte >> 4, byte & 15}) text += "0123456789abcdef"[digit];
  return text;
}

// In a time that does not depend on how much is right.
bool same(const std::string& a, const std::string& b) {
  unsigned differ = a.size() == b.size() ? 0u : 1u;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    differ |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  return differ == 0;
}

}  // namespace

struct PageServer::Library {
  httplib::Server server;
  std::thread thread;
  std::atomic<bool> over{false};
};

PageServer::PageServer(std::function<std::string()> page)
    : page_(std::move(page)), token_(random_token()), library_(std::make_unique<Library>()) {
  httplib::Server& server = library_->server;
  server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  server.set_socket_options([](socket_t) {});  // no other process shares the port
  server.set_keep_alive_timeout(1);
  server.set_read_timeout(5);
  server.set_write_timeout(5);
  server.set_payload_max_length(0);
  port_ = server.bind_to_any_port("127.0.0.1");
  if (port_ <= 0)
    throw InputError(code::kNoServer,
                     "the page of the run cannot be served: no port of 127.0.0.1 can be opened; run without it");
  serve();
  library_->thread = std::thread([this] {
    library_->server.listen_after_bind();
    library_->over = true;
  });
}

PageServer::~PageServer() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  news_.notify_all();
  while (!library_->server.is_running() && !library_->over) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  library_->server.stop();
  library_->thread.join();
}

std::string PageServer::address() const { return "http://127.0.0.1:" + std::to_string(port_) + "/" + token_ + "/"; }

void PageServer::serve() {
  httplib::Server& server = library_->server;
  const std::string home = "/" + token_ + "/", host = "127.0.0.1:" + std::to_string(port_);
  server.set_pre_routing_handler([home, host](const httplib::Request& request, httplib::Response& response) {
    const bool known = same(request.path, home) || same(request.path, home + "events");
    if (known && request.method == "GET" && request.get_header_value("Host") == host)
      return httplib::Server::HandlerResponse::Unhandled;
    response.status = 404;
    return httplib::Server::HandlerResponse::Handled;
  });
  server.set_exception_handler([](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
    response.status = 500;  // the library would send the exception's words
  });
  server.set_default_headers({{"Cache-Control", "no-store"},
                              {"Referrer-Policy", "no-referrer"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"X-Frame-Options", "DENY"},
                              {"Cross-Origin-Resource-Policy", "same-origin"}});
  server.Get(home, [this](const httplib::Request&, httplib::Response& response) {
    // A length that is known: the library would compress a text, for seconds that the run lacks.
    const auto page = std::make_shared<const std::string>(page_());
    response.set_content_provider(page->size(), "text/html; charset=utf-8",
                                  [page](std::size_t from, std::size_t count, httplib::DataSink& sink) {
                                    return sink.write(page->data() + from, count);
                                  });
  });
  server.Get(home + "events", [this](const httplib::Request&, httplib::Response& response) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (read_up_to_.size() >= static_cast<std::size_t>(kMostReaders)) {
      response.status = 503;
      return;
    }
    const long reader = ++readers_;
    read_up_to_[reader] = 0;
    const auto give = [this, reader](std::size_t, httplib::DataSink& sink) {
      std::unique_lock<std::mutex> held(mutex_);
      const long up_to = read_up_to_.at(reader);
      const auto next = [&] {
        return std::find_if(events_.begin(), events_.end(), [&](const Event& e) { return e.number > up_to; });
      };
      news_.wait_for(held, kSignOfLife, [&] { return ends_ || next() != events_.end(); });
      if (ends_) return false;
      const auto event = next();
      const std::string text = event == events_.end() ? ":\n\n" : event->text;
      const long number = event == events_.end() ? up_to : event->number;
      held.unlock();
      for (std::size_t from = 0; from < text.size(); from += kLongestPiece)
        if (!sink.write(text.data() + from, std::min(kLongestPiece, text.size() - from))) return false;
      held.lock();
      read_up_to_.at(reader) = number;
      return true;
    };
    response.set_chunked_content_provider("text/event-stream", give, [this, reader](bool) {
      const std::lock_guard<std::mutex> gone(mutex_);
      read_up_to_.erase(reader);
    });
  });
}

void PageServer::send(const std::string& kind, std::string data, const std::string& key) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!key.empty())
      events_.erase(std::remove_if(events_.begin(), events_.end(), [&](const Event& e) { return e.key == key; }),
                    events_.end());
    events_.push_back({++numbers_, kind, "event: " + kind + "\ndata: " + std::move(data) + "\n\n", key});
  }
  news_.notify_all();
}

void PageServer::thin(const std::string& kind) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto count = std::count_if(events_.begin(), events_.end(), [&](const Event& e) { return e.kind == kind; });
  long k = 0;
  events_.erase(std::remove_if(events_.begin(), events_.end(),
                               [&](const Event& e) {
                                 if (e.kind != kind) return false;
                                 ++k;
                                 return k % 2 == 0 && k < count;
                               }),
                events_.end());
}

std::size_t PageServer::kept(const std::string& kind) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::size_t bytes = 0;
  for (const Event& event : events_)
    if (event.kind == kind) bytes += event.text.size();
  return bytes;
}

int PageServer::readers() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return static_cast<int>(read_up_to_.size());
}

bool PageServer::all_is_read() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const long last = events_.empty() ? 0 : events_.back().number;
  return std::all_of(read_up_to_.begin(), read_up_to_.end(), [&](const auto& reader) { return reader.second >= last; });
}

}  // namespace footfall
