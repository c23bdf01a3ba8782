// The coordinates that types of joints leave free, and the members of specs that belong to them.
#include <algorithm>

#include "coupler/base/text.h"
#include "mbd_solver/scene/run_spec.h"

namespace footfall {
namespace {

template <class T, class Owner>
const std::optional<T>& one_of(const Owner& owner, Coordinate coordinate) {
  static const std::optional<T> nothing;
  switch (coordinate) {
    case Coordinate::kAngle: return owner.angle;
    case Coordinate::kDisplacement: return owner.displacement;
    case Coordinate::kDisplacementX: return owner.displacement_x;
    case Coordinate::kDisplacementY: return owner.displacement_y;
  }
  return nothing;
}

}  // namespace

std::vector<Coordinate> coordinates_of(JointType type) {
  const JointTraits traits = traits_of(type);
  std::vector<Coordinate> out;
  if (traits.turns) out.push_back(Coordinate::kAngle);
  if (traits.slides) out.push_back(Coordinate::kDisplacement);
  if (traits.slides_across) {
    out.push_back(Coordinate::kDisplacementX);
    out.push_back(Coordinate::kDisplacementY);
  }
  return out;
}

bool has_coordinate(JointType type, Coordinate coordinate) {
  const std::vector<Coordinate> has = coordinates_of(type);
  return std::find(has.begin(), has.end(), coordinate) != has.end();
}

std::string coordinate_names(JointType type) {
  std::vector<std::string> names;
  for (const Coordinate coordinate : coordinates_of(type))
    names.push_back("\"" + std::string(name_of(coordinate)) + "\"");
  if (names.size() < 2) return joined(names);
  const std::string last = names.back();
  names.pop_back();
  return joined(names) + " or " + last;
}

const std::optional<CoordinateSpec>& JointSpec::acting_on(Coordinate coordinate) const {
  return one_of<CoordinateSpec>(*this, coordinate);
}

const std::optional<double>& InitialJointSpec::value(Coordinate coordinate) const {
  return one_of<double>(*this, coordinate);
}

}  // namespace footfall
