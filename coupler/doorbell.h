#pragma once
// Wakes a process of the same mpirun on the same machine that naps while it waits for a message.
//
// A nap ends up to half a millisecond after the message is there, twice in every window. So who sends rings too: a
// datagram of one byte to the other's local socket, whose name every process of the job knows. The bell carries no data
// and may be missed: who is woken looks for the message, and who is not woken looks when the nap is over.

#include <string>

namespace footfall {

class Doorbell {
 public:
  // `job`: the same for all processes of one job and no others on this machine; `seat`: of this process, from 0.
  Doorbell(std::string job, int seat);
  ~Doorbell();
  Doorbell(const Doorbell&) = delete;
  Doorbell& operator=(const Doorbell&) = delete;

  // False where the machine gives no local socket: waits last their whole time.
  bool works() const { return socket_ >= 0; }
  bool ring(int seat) const;        // never blocks; false when nobody sits there (any more)
  void wait(double seconds) const;  // until rung, or so long; a ring since the last wait counts

 private:
  std::string job_;
  int socket_ = -1;
};

}  // namespace footfall
