#pragma once
// The grains' side of a coupled run without LIGGGHTS, in this process: what a test says instead of grains.

#include <functional>
#include <string>
#include <thread>
#include <utility>

#include "coupler/link.h"
#include "tests/support/transport_loopback.h"

namespace footfall::test {

inline constexpr double kPatience = 30.0;  // [s]: a test that hangs fails

// Shakes hands, then answers every motion on a thread of its own.
class LoopbackGrains {
 public:
  using Answer = std::function<void(const Motion&, Load&)>;  // load: one zero load per body

  LoopbackGrains(Start start, Answer answer) : LoopbackGrains(TransportLoopback::make_pair(), start, answer) {}
  ~LoopbackGrains() {
    mbd_end_.reset();  // a run that failed has nothing more to say
    join();
  }
  Transport& transport() { return *mbd_end_; }
  void cannot_keep_quietly_before(std::int64_t window) { cannot_before_ = window; }  // before the first motion
  // Waits for the end; what went wrong on the grains' side, or nothing.
  std::string join() {
    if (thread_.joinable()) thread_.join();
    return failure_;
  }
  // After join(): all that the mechanism's side sent.
  const Geometry& geometry() const { return geometry_; }
  const Accept& accept() const { return accept_; }
  const std::vector<Motion>& motions() const { return motions_; }

 private:
  using Ends = std::pair<std::unique_ptr<TransportLoopback>, std::unique_ptr<TransportLoopback>>;
  LoopbackGrains(Ends ends, Start start, Answer answer)
      : dem_end_(std::move(ends.first)),
        mbd_end_(std::move(ends.second)),
        thread_([this, start = std::move(start), answer = std::move(answer)] {
          try {
            serve(start, answer);
          } catch (const std::exception& error) {
            failure_ = error.what();
          }
        }) {}

  void serve(const Start& start, const Answer& answer) {
    Link link(*dem_end_, kPatience);
    Hello hello;
    hello.unit_style = "si";
    link.send(hello);
    link.receive(geometry_);
    link.send(start);
    link.receive(accept_);
    Motion motion;
    while (!motion.last_window) {
      link.receive(motion);
      motions_.push_back(motion);
      Load load;
      load.window = motion.window;
      load.particles = 1000;
      for (const BodyMotion& body : motion.bodies) {
        load.bodies.emplace_back();
        load.bodies.back().mean = MeanLoad(body.mode_count());
      }
      answer(motion, load);
      link.send(load);
      if (motion.checkpoint.empty()) continue;
      CheckpointDone kept;
      kept.window = motion.window;
      kept.done = !(motion.undisturbed && motion.window < cannot_before_);
      link.send(kept);
    }
    link.close();
  }

  Geometry geometry_;
  Accept accept_;
  std::vector<Motion> motions_;
  std::string failure_;
  std::int64_t cannot_before_ = 0;
  std::unique_ptr<TransportLoopback> dem_end_, mbd_end_;
  std::thread thread_;
};

}  // namespace footfall::test
