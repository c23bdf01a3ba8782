// What a run must know to go on from the end of a window: mbd_solver/run/simulation.h.
#include "mbd_solver/run/simulation.h"

namespace footfall {

template <>
inline constexpr auto kFields<State> = std::tuple{Field{"time", &State::time},
                                                  Field{"q", &State::q},
                                                  Field{"v", &State::v},
                                                  Field{"z", &State::z},
                                                  Field{"dissipated", &State::dissipated},
                                                  Field{"load_work", &State::load_work},
                                                  Field{"supplied", &State::supplied},
                                                  Field{"step", &State::step}};

template <>
inline constexpr auto kFields<TangentLoad> =
    std::tuple{Field{"K", &TangentLoad::K}, Field{"C", &TangentLoad::C}, Field{"r_mean", &TangentLoad::r_mean},
               Field{"L_mean", &TangentLoad::L_mean}, Field{"v_mean", &TangentLoad::v_mean}};

template <>
inline constexpr auto kFields<ExternalLoad> =
    std::tuple{Field{"F_W", &ExternalLoad::F_W}, Field{"T_B", &ExternalLoad::T_B}, Field{"Q_a", &ExternalLoad::Q_a},
               Field{"tangent", &ExternalLoad::tangent}};

template <>
inline constexpr auto kFields<Inputs> =
    std::tuple{Field{"loads", &Inputs::loads}, Field{"values", &Inputs::values}};

template <>
inline constexpr auto kFields<IntegratorStatistics> =
    std::tuple{Field{"windows", &IntegratorStatistics::windows},
               Field{"steps", &IntegratorStatistics::steps},
               Field{"rejected", &IntegratorStatistics::rejected},
               Field{"newton_failures", &IntegratorStatistics::newton_failures},
               Field{"residuals", &IntegratorStatistics::residuals},
               Field{"jacobians", &IntegratorStatistics::jacobians},
               Field{"factorizations", &IntegratorStatistics::factorizations},
               Field{"drift_position", &IntegratorStatistics::drift_position},
               Field{"drift_velocity", &IntegratorStatistics::drift_velocity},
               Field{"removed_position", &IntegratorStatistics::removed_position},
               Field{"removed_velocity", &IntegratorStatistics::removed_velocity},
               Field{"reported_error", &IntegratorStatistics::reported_error}};

template <>
inline constexpr auto kFields<RunTimes> =
    std::tuple{Field{"total", &RunTimes::total}, Field{"mbd", &RunTimes::mbd}, Field{"beside", &RunTimes::beside},
               Field{"control", &RunTimes::control}, Field{"keeping", &RunTimes::keeping}};

// The integrator's own memory is dropped at a checkpoint, by the run that goes on and by the one that is resumed.
void Simulation::visit(Archive& archive) {
  archive("state", state_);
  archive("rates", rates_);
  archive("inputs", inputs_);
  archive("window", window_);
  archive("inputs_change", inputs_change_);
  archive("times", times_);
  archive("next_checkpoint", checkpoints_);
  archive("control", control_);
  IntegratorStatistics statistics = integrator_->statistics();
  archive("statistics", statistics);
  if (archive.restores()) integrator_->resume(statistics);
  if (coupled_) archive("coupled", *coupled_);
  resumed_ = archive.restores();
}

}  // namespace footfall
