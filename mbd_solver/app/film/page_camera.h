#pragma once
// Photographs of a page, by Chromium without a window: the same page and the same renderer that a user sees. Chromium is told
// what to do through a pipe (--remote-debugging-pipe: JSON messages that end with a zero byte).

#include <sys/types.h>

#include <nlohmann/json.hpp>
#include <string>

namespace footfall {

// The first of these names that is a program in PATH, with its folder; empty: none is.
std::string program_in_path(std::initializer_list<const char*> names);
// Chromium, or a browser of its family; empty: none is installed.
std::string chromium_program();

struct PageSize {
  int width = 1280, height = 720;  // [pixels]
};

// A temporary folder, removed with this object.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::string& name);  // Throws InputError when it cannot be created
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

class PageCamera {
 public:
  // Opens a page of `footfall view` (a file, or the address of a live one) with what follows the # of its address, and waits until
  // it has read all frames; a live page until it shows some.
  // Throws InputError without a browser, PartnerError when the page does not get ready or complains.
  PageCamera(const std::string& page, const std::string& link, PageSize size);
  ~PageCamera();
  PageCamera(const PageCamera&) = delete;
  PageCamera& operator=(const PageCamera&) = delete;

  // The value of an expression in the page, once it is known.
  nlohmann::ordered_json evaluate(const std::string& expression);
  // What the page shows now. format: "png" or "jpeg".
  std::string picture(const std::string& format);

 private:
  void start(const std::string& program, PageSize size);
  void open(const std::string& page, const std::string& link, PageSize size);
  // Sends a command and returns its result.
  nlohmann::ordered_json call(const std::string& method,
                              const nlohmann::ordered_json& parameters = nlohmann::ordered_json::object());
  // The text of the answer to a command, which begins with its number.
  std::string answer_to(const std::string& method, const nlohmann::ordered_json& parameters);
  std::string next_message();
  void note(const nlohmann::ordered_json& event);
  [[noreturn]] void fail(const std::string& what) const;
  void end();

  ScratchFolder folder_{"footfall_page"};
  pid_t pid_ = -1;
  int to_ = -1, from_ = -1;  // ends of the pipes
  int last_id_ = 0;
  std::string session_, received_, complaint_;  // complaint_: the first error that the page has reported
};

}  // namespace footfall
