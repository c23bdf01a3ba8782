// Entries of the lists never change: counting them is enough to know what is new.

#include "mbd_solver/session/run_warnings.h"

namespace footfall {

std::array<std::vector<std::string>, RunWarnings::kLists> RunWarnings::lists() const {
  const CoupledRun* const coupled = simulation_.coupled();
  return {coupled != nullptr ? coupled->watch().warnings() : std::vector<std::string>(),
          observation_.flexible().warnings(),
          observation_.joints().warnings(),
          observation_.grips().warnings(),
          simulation_.time_warnings(),
          simulation_.signal_warnings()};
}

std::vector<std::string> RunWarnings::news() {
  std::vector<std::string> out;
  const auto all = lists();
  for (std::size_t i = 0; i < kLists; ++i)
    for (; told_[i] < all[i].size(); ++told_[i]) out.push_back(all[i][told_[i]]);
  return out;
}

std::vector<std::string> RunWarnings::all() const {
  std::vector<std::string> out;
  for (const std::vector<std::string>& list : lists()) out.insert(out.end(), list.begin(), list.end());
  const std::vector<std::string> last = at_end();
  out.insert(out.end(), last.begin(), last.end());
  return out;
}

std::vector<std::string> RunWarnings::at_end() const {
  const CoupledRun* const coupled = simulation_.coupled();
  std::vector<std::string> out = coupled != nullptr ? coupled->watch().conclusions() : std::vector<std::string>();
  const std::vector<std::string> extremes = metrics_.warnings();
  out.insert(out.end(), extremes.begin(), extremes.end());
  if (const std::string text = simulation_.integrator().warning(); !text.empty()) out.push_back(text);
  return out;
}

}  // namespace footfall
