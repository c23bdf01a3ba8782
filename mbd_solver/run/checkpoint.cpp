#include "mbd_solver/run/checkpoint.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

void write(std::FILE* file, const char* name, const double* values, std::size_t count) {
  std::fprintf(file, "%s %zu", name, count);
  for (std::size_t i = 0; i < count; ++i) std::fprintf(file, " %a", values[i]);
  std::fprintf(file, "\n");
}

void write(std::FILE* file, const char* name, const Eigen::VectorXd& values) {
  write(file, name, values.data(), static_cast<std::size_t>(values.size()));
}

}  // namespace

void write_checkpoint(const std::string& path, const State& state, const Mechanism& mechanism,
                      const Eigen::VectorXd& voltages) {
  const std::string partial = path + ".partial";
  {
    const std::unique_ptr<std::FILE, Closer> file(std::fopen(partial.c_str(), "w"));
    if (!file) throw InputError(partial + ": cannot be written: " + std::strerror(errno));
    std::FILE* out = file.get();
    std::fprintf(out, "footfall-checkpoint 1\n");
    write(out, "time", &state.time, 1);
    write(out, "q", state.q);
    write(out, "v", state.v);
    write(out, "z", state.z);
    write(out, "dissipated", state.dissipated.by_kind.data(), state.dissipated.by_kind.size());
    write(out, "load_work", state.load_work);
    write(out, "supplied", state.supplied.by_kind.data(), state.supplied.by_kind.size());
    write(out, "step", &state.step, 1);
    write(out, "voltages", voltages);
    for (const ControllerEntry& entry : mechanism.controllers)
      write(out, ("controller/" + entry.name).c_str(), entry.controller->memory());
  }
  if (std::rename(partial.c_str(), path.c_str()) != 0)
    throw InputError(path + ": cannot be written: " + std::strerror(errno));
}

}  // namespace footfall
