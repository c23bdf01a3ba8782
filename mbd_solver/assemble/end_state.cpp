// Numbers are written with all digits, so that a scene that starts from a run continues from exactly its state.

#include "mbd_solver/assemble/end_state.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "mbd_solver/assemble/codes.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {
namespace {

using EndJson = nlohmann::json;

EndJson list_of(const Eigen::VectorXd& x) {
  EndJson out = EndJson::array();
  for (Eigen::Index i = 0; i < x.size(); ++i) out.push_back(x(i));
  return out;
}

Eigen::VectorXd vector_of(const EndJson& list) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) out(static_cast<Eigen::Index>(i)) = list[i].get<double>();
  return out;
}

}  // namespace

void refuse_end_state(const Scene& scene, const std::string& what) {
  throw InputError(code::kEndState, place_of(scene.file, scene.initial.source, "from") + what);
}

void write_end_state(const std::string& folder, const EndState& end) {
  Eigen::VectorXd axes(9);
  axes << end.placement.R_WD.col(0), end.placement.R_WD.col(1), end.placement.R_WD.col(2);
  EndJson json;
  json["time_s"] = end.time;
  json["placement"] = {{"position", list_of(end.placement.p_WD)}, {"axes", list_of(axes)}};
  json["bodies"] = json["elements"] = json["angles"] = EndJson::object();
  for (const auto& [name, body] : end.bodies)
    json["bodies"][name] = {{"position", list_of(body.q)}, {"velocity", list_of(body.v)}};
  for (const auto& [name, z] : end.elements) json["elements"][name] = list_of(z);
  for (const auto& [name, angle] : end.angles) json["angles"][name] = angle;
  write_whole_file(folder + "/" + kEndStateFile, json.dump(1) + "\n", "choose another folder for the run");
}

EndState read_end_state(const Scene& scene) {
  const std::string file = scene.initial.from + "/" + kEndStateFile;
  const std::optional<std::string> text = read_whole_file(file);
  if (!text)
    refuse_end_state(scene, "\"" + scene.initial.from + "\" has no " + kEndStateFile +
                                ", expected the folder of a run that has ended; run that scene first");
  EndState out;
  try {
    const EndJson json = EndJson::parse(*text);
    out.time = json.at("time_s").get<double>();
    const Eigen::VectorXd p = vector_of(json.at("placement").at("position")),
                          axes = vector_of(json.at("placement").at("axes"));
    if (p.size() != 3 || axes.size() != 9) refuse_end_state(scene, file + " is damaged; run that scene again");
    out.placement.p_WD = p;
    for (int k = 0; k < 3; ++k) out.placement.R_WD.col(k) = axes.segment<3>(3 * k);
    for (const auto& [name, body] : json.at("bodies").items())
      out.bodies[name] = {vector_of(body.at("position")), vector_of(body.at("velocity"))};
    for (const auto& [name, z] : json.at("elements").items()) out.elements[name] = vector_of(z);
    for (const auto& [name, angle] : json.at("angles").items()) out.angles[name] = angle.get<double>();
  } catch (const EndJson::exception&) {
    refuse_end_state(scene, file + " is damaged; run that scene again");
  }
  return out;
}

}  // namespace footfall
