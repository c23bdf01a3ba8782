#pragma once
// The coupled pair, controlled through a socket (run/leader.h): `footfall run`, which starts mbd_solver and LIGGGHTS, in a temporary
// folder that is removed with the object.

#include <sys/types.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mbd_solver/base/line_channel.h"
#include "mbd_solver/fmi/model/stepped_model.h"

namespace footfall {

struct PairToLead {
  std::string programs;               // folder with footfall, mbd_solver and liggghts_mbd
  std::string scene;                  // file
  std::vector<std::string> settings;  // key=value
  bool trusted = false;               // --trust-script
  std::string carried;  // folder that is copied first, with the scene below it; empty: the scene remains where it is
  std::string kept;     // folder in which the results remain; empty: nowhere
  std::string name;     // of the folder of results in `kept`
};

class LedPair : public SteppedModel {
 public:
  // Makes the bed, starts the programs and waits for the first row. Throws InputError or PartnerError with the words of the programs.
  // unwanted: called while it waits; true ends the programs, and throws Interrupted.
  LedPair(const PairToLead& pair, std::function<bool()> unwanted);
  // Ends the programs in order; some seconds later they are killed.
  ~LedPair() override;
  LedPair(const LedPair&) = delete;
  LedPair& operator=(const LedPair&) = delete;

  // At most one coupling interval beyond the requested time.
  double time() const override { return row_.empty() ? 0.0 : row_[0]; }
  bool finished() const override { return time() >= end_time_ * (1.0 - 1e-12); }
  const std::vector<std::string>& names() const override { return names_; }
  const std::vector<std::string>& units() const override { return units_; }
  std::vector<double> row() const override { return row_; }
  std::vector<std::string> signals() const override;
  double signal(const std::string& name) const override;
  void set_signal(const std::string& name, double value) override;
  bool step(double until, bool early) override;
  std::string save() override;
  void restore(const std::string& state) override;
  double energy_balance() const override { return balance_; }
  double summed_error() const override { return error_; }
  std::vector<std::string> warnings() const override;

 private:
  void make_folder();
  void start(const PairToLead& pair);
  void end();  // the programs, in order
  std::string line();
  void say(const std::string& line);
  void read_row();
  std::string said() const;
  [[noreturn]] void fail();  // with the words of programs that have ended, or are ended here
  bool has_ended();
  bool has_ended_within(double time);  // [s]

  std::function<bool()> unwanted_;
  std::string folder_, log_;
  int listener_ = -1, socket_ = -1;
  pid_t process_ = -1;
  int exit_code_ = 0;
  LineChannel lines_;
  std::vector<std::string> names_, units_;
  std::map<std::string, double> signals_;
  double end_time_ = 0.0;  // [s]
  std::vector<double> row_;
  double balance_ = 0.0, error_ = 0.0;
};

}  // namespace footfall
