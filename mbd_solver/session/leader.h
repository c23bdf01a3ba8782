#pragma once
// A run that another program leads through a socket: `footfall run` with the variable FOOTFALL_LEADER, the path of a socket on which
// that program listens (mbd_solver/python/footfall/pair.py). Both sides send lines of text; numbers have all digits.
//
//   mbd_solver                                        the program that leads
//   {"columns": [...], "units": [...],                (at the start)
//    "signals": {NAME: VALUE}, "end_time": T}
//   row VALUE...   all columns, at a time that        step T      go on to T [s]
//                  was asked for, or at the end       set NAME V  a signal of kind "host" has this value from now on
//   balance B      before each row: the relative      save        a checkpoint, at the end of the next window
//                  error of the energy balance [-]    end         now, as after SIGINT; also when the socket closes
//   saved FOLDER   before the next row
//   done
// mbd_solver answers `step` and `save` with a row, and reads nothing else meanwhile.

#include <memory>
#include <string>

#include "mbd_solver/base/line_channel.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/simulation.h"

namespace footfall {

class Leader {
 public:
  // Null unless the environment names one. Throws PartnerError when it cannot be reached. The simulation must outlive this.
  static std::unique_ptr<Leader> of_environment(Simulation& simulation);
  ~Leader();
  Leader(const Leader&) = delete;
  Leader& operator=(const Leader&) = delete;

  // At every sample. Where the leading program waits for it: sends the row and does what it says, until it lets the run go on.
  // energy_balance: its relative error so far [-].
  void observe(const Sample& sample, double energy_balance);
  void saved(const std::string& folder) { saved_ = folder; }
  void done();

 private:
  Leader(Simulation& simulation, const std::string& path);
  void send(const std::string& line);
  bool receive(std::string& line);  // false: the other side is gone, or the run is interrupted
  void set(const std::string& words);

  Simulation& simulation_;
  Observation observation_;
  int socket_ = -1;
  LineChannel lines_;
  std::string saved_;    // folder of a checkpoint that was asked for and has not been told
  double target_ = 0.0;  // of the step [s]
  bool leaves_ = false;  // no more answers are wanted
};

}  // namespace footfall
