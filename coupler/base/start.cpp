// Everything here would otherwise fail later, in the words of a library.

#include "coupler/base/start.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string>

#include "coupler/base/codes.h"

namespace footfall {
namespace {

// RFC 3629.
bool is_utf8(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) -> unsigned {
      return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u;
    };
    const unsigned first = byte(0);
    const std::size_t more = first < 0x80 ? 0 : first >= 0xC2 && first < 0xE0 ? 1 : (first & 0xF0) == 0xE0 ? 2 : 3;
    if (more == 3 && (first < 0xF0 || first > 0xF4)) return false;
    for (std::size_t k = 1; k <= more; ++k)
      if ((byte(k) & 0xC0) != 0x80) return false;
    const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    if (overlong || (first == 0xED && byte(1) > 0x9F) || (first == 0xF4 && byte(1) > 0x8F)) return false;
    i += more + 1;
  }
  return true;
}

std::string printable(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  return text;
}

void require_utf8(const std::string& what, const std::string& text) {
  if (!is_utf8(text))
    throw InputError(code::kNotUtf8, what + " \"" + printable(text) +
                                         "\" is not UTF-8 text, expected names in UTF-8; rename the file or folder");
}

}  // namespace

void keep_streams() {
  for (const int number : {SIGPIPE, SIGXFSZ}) std::signal(number, SIG_IGN);
  for (int file = open("/dev/null", O_RDWR); file >= 0; file = dup(file))
    if (file > STDERR_FILENO) {
      close(file);
      break;
    }
}

bool output_is_unread() {
  pollfd output{STDOUT_FILENO, 0, 0};
  return poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

void prepare_start(int argc, char** argv) {
  const char* const path = std::getenv("PATH");
  if (path == nullptr || *path == '\0') setenv("PATH", "/usr/local/bin:/usr/bin:/bin", 1);
  for (int i = 1; i < argc; ++i) require_utf8("the argument", argv[i]);
}

void require_current_folder() {
  std::error_code error;
  const std::string folder = std::filesystem::current_path(error).string();
  if (!error && access(".", X_OK) != 0) error.assign(errno, std::generic_category());
  if (error)
    throw InputError(code::kCurrentFolder, "the current folder cannot be entered: " + error.message() +
                                               "; change to a folder that exists and that you may enter");
  require_utf8("the current folder", folder);
}

InputError as_input_error(const std::filesystem::filesystem_error& error) {
  return {code::kFileSystem, error.path1().string() + ": cannot be used: " + error.code().message() +
                                 "; check that it exists, and the permissions of it and of the folders above it"};
}

bool under_mpirun() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

}  // namespace footfall
