#pragma once
// Runs of the script beyond the end of the scene. Loops of the script continue beyond this end: after a
// jump, runs beyond it are left out as long as the script couples.

namespace footfall {

class ScriptRuns {
 public:
  void script_jumps() { jumps_ = true; }  // after the first run
  // The number of runs left out, including the present run, when the scene has ended; 0: the present run is
  // executed.
  int left_out(bool couples) { return jumps_ && couples ? ++left_out_ : 0; }
  // A loop waits for steps that do not come.
  void end_script() { script_is_over_ = true; }
  bool script_is_over() const { return script_is_over_; }
  void set_repeats(bool every) { repeats_ = every; }  // the run that begins is a `run N every M`
  bool repeats() const { return repeats_; }

 private:
  bool jumps_ = false;    // the script has jumped since the first run
  bool repeats_ = false;  // the present command runs several times
  int left_out_ = 0;      // runs
  bool script_is_over_ = false;
};

}  // namespace footfall
