// footfall._core: Session, checks and histories as Python sees them. Everything that needs no C++ is in footfall/*.py.

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <vector>

#include "coupler/base/text.h"
#include "mbd_solver/base/kinds.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/error_report.h"
#include "mbd_solver/session/output/former_names.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/session.h"

namespace py = pybind11;

namespace footfall {
namespace {

// A scene as Python names it: a file or folder, or a text with the folder of its paths; then the settings of --set.
struct SceneSource {
  std::string file, text, folder;
  std::vector<std::string> settings;

  Scene read() const { return file.empty() ? read_scene_text(text, folder, settings) : read_scene(file, settings); }
};

constexpr std::string_view name_of(ErrorReport::Kind kind) {
  return name_in(kind, "InputError", "NumericalError", "PartnerError", "FileError", "InternalError");
}

// Text whose bytes may be no UTF-8, for example from a damaged file.
py::str text_of(const std::string& bytes) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace"));
}

py::tuple tuple_of(const char* severity, const ErrorReport& r) {
  return py::make_tuple(severity, r.code, r.name, text_of(r.file), r.line, text_of(r.key), text_of(r.text),
                        text_of(r.message));
}

py::list tuples_of(const std::vector<ErrorReport>& reports) {
  py::list all;
  for (const ErrorReport& report : reports) all.append(tuple_of("error", report));
  return all;
}

// As an exception of footfall.errors.
void raise(const std::exception& error) {
  const std::vector<ErrorReport> reports = reports_of(error);
  const py::object raised = py::module_::import("footfall.errors")
                                .attr("made")(name_of(reports.front().kind), text_of(error.what()), tuples_of(reports));
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(raised.ptr())), raised.ptr());
}

void translate(std::exception_ptr pointer) {
  try {
    std::rethrow_exception(pointer);
  } catch (const CodedError& error) {
    raise(error);
  } catch (const std::logic_error& error) {
    raise(error);
  }
}

using Array = py::array_t<double>;

Array array_of(const Eigen::VectorXd& x) { return Array(x.size(), x.data()); }

// Ctrl-C ends a step at a time that it has reached; the interruption is then raised.
void step(Session& simulation, double until) {
  bool interrupted = false;
  {
    const py::gil_scoped_release others_may_run;
    simulation.step_to(until, [&] {
      const py::gil_scoped_acquire python;
      return interrupted = PyErr_CheckSignals() != 0;
    });
  }
  if (interrupted) throw py::error_already_set();
}

// Rows of the chosen columns at the present time and every `every` [s] after it, to `until`.
Array sample(Session& simulation, double until, double every, const std::vector<std::string>& names) {
  if (!(every > 0.0))
    throw InputError(code::kWrongArgument, "every is " + number_text(every) + " s, expected a time above zero");
  std::vector<std::size_t> places;
  for (const std::string& name : names) places.push_back(simulation.column(name));
  std::vector<double> values;
  const auto take = [&] {
    const std::vector<double> row = simulation.row();
    for (const std::size_t place : places) values.push_back(row[place]);
  };
  const double begin = simulation.time(), end = std::min(until, simulation.end_time());
  take();
  for (long k = 1; simulation.time() < end * (1.0 - 1e-12); ++k) {
    const double next = begin + static_cast<double>(k) * every;
    step(simulation, next > end * (1.0 - 1e-12) ? end : next);
    take();
  }
  const std::size_t columns = std::max<std::size_t>(places.size(), 1);
  return Array({values.size() / columns, places.size()}, values.data());
}

// One array per column, which shares the memory of the history that was read.
py::dict history_of(const std::string& file) {
  const auto history = std::make_shared<History>(read_history(file));
  py::dict columns, all;
  for (std::size_t i = 0; i < history->names.size(); ++i) {
    const py::capsule keeps(new std::shared_ptr<History>(history),
                            [](void* held) { delete static_cast<std::shared_ptr<History>*>(held); });
    const std::vector<double>& values = history->columns[i];
    Array array(static_cast<py::ssize_t>(values.size()), values.data(), keeps);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    columns[history->names[i].c_str()] = array;
  }
  all["columns"] = columns;
  all["units"] = history->units;
  return all;
}

}  // namespace
}  // namespace footfall

PYBIND11_MODULE(_core, m) {
  using namespace footfall;
  using Simulation = Session;
  py::register_exception_translator(&translate);
  m.attr("__version__") = FOOTFALL_VERSION;
  py::class_<SceneSource>(m, "Source")
      .def(py::init<std::string, std::string, std::string, std::vector<std::string>>())
      .def("json", [](const SceneSource& source) { return scene_json(source.read()); })
      .def("check", [](const SceneSource& source) {
        const CheckedScene checked = check_for_findings([&] { return source.read(); });
        py::list all = tuples_of(checked.errors);
        for (const ErrorReport& warning : checked.warnings) all.append(tuple_of("warning", warning));
        return all;
      });
  py::class_<Simulation>(m, "Simulation")
      .def(py::init([](const SceneSource& source, bool record, bool trusted) {
        const py::gil_scoped_release others_may_run;
        return std::make_unique<Simulation>(source.read(), SessionOptions{trusted, record});
      }))
      .def_property_readonly("time", &Simulation::time)
      .def_property_readonly("end_time", &Simulation::end_time)
      .def_property_readonly("finished", &Simulation::finished)
      .def("step", &step)
      .def("sample", &sample)
      .def_property_readonly("names", &Simulation::names)
      .def_property_readonly("units", &Simulation::units)
      .def_property_readonly("row",
                             [](const Simulation& s) {
                               const std::vector<double> row = s.row();
                               return Array(static_cast<py::ssize_t>(row.size()), row.data());
                             })
      .def("value", &Simulation::value)
      .def_property_readonly("signals", &Simulation::signals)
      .def("set_signal", &Simulation::set)
      .def("signal", &Simulation::signal)
      .def_property_readonly("q", [](const Simulation& s) { return array_of(s.q()); })
      .def_property_readonly("v", [](const Simulation& s) { return array_of(s.v()); })
      .def_property_readonly("z", [](const Simulation& s) { return array_of(s.z()); })
      .def("place", [](Simulation& s, const Eigen::VectorXd& q, const Eigen::VectorXd& v) { s.place(q, v); })
      .def("save", [](Simulation& s) { return py::bytes(s.save()); })
      .def("restore", [](Simulation& s, const py::bytes& state) { s.restore(state); })
      .def_property_readonly("energy_balance", &Simulation::energy_balance)
      .def_property_readonly("summed_error", &Simulation::summed_error)
      .def_property_readonly("warnings", &Simulation::warnings)
      .def_property_readonly("notes", &Simulation::notes)
      .def("summary", &Simulation::summary);
  m.def("history", &history_of);
  m.def("present_name", &present_name, py::return_value_policy::copy);
  m.def("report", [](const std::string& message) { return tuple_of("error", report_of(message)); });
}
