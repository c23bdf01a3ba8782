// Sockets are written to without SIGPIPE; any other file is a pipe.

#include "mbd_solver/base/line_channel.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

namespace footfall {

bool LineChannel::send(const std::string& line) {
  const std::string text = line + "\n";
  for (std::size_t done = 0; done < text.size();) {
    ssize_t count = ::send(to_, text.data() + done, text.size() - done, MSG_NOSIGNAL);
    if (count < 0 && errno == ENOTSOCK) count = ::write(to_, text.data() + done, text.size() - done);
    if (count > 0) done += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR) return false;
  }
  return true;
}

bool LineChannel::take_line(std::string& line) {
  const std::size_t end = received_.find('\n');
  if (end == std::string::npos) return false;
  line = received_.substr(0, end);
  received_.erase(0, end + 1);
  return true;
}

LineChannel::Heard LineChannel::receive(std::string& line, int patience) {
  if (take_line(line)) return Heard::kLine;
  pollfd wait = {from_, POLLIN, 0};
  if (poll(&wait, 1, patience) <= 0) return Heard::kNothing;
  char bytes[1 << 14];
  const ssize_t count = ::read(from_, bytes, sizeof bytes);
  if (count == 0 || (count < 0 && errno != EINTR)) return Heard::kGone;
  if (count > 0) received_.append(bytes, static_cast<std::size_t>(count));
  return take_line(line) ? Heard::kLine : Heard::kNothing;
}

}  // namespace footfall
