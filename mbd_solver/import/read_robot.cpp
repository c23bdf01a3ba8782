// Which format a file has is told by its root element.
#include "mbd_solver/import/codes.h"
#include "mbd_solver/import/xml_source.h"

namespace footfall {

Robot read_robot(const std::string& file, const ImportOptions& options) {
  const XmlSource xml(file);
  const std::string root = xml.root().name();
  if (root == "robot") return read_urdf(file, options);
  if (root == "mujoco") return read_mjcf(file, options);
  if (root == "sdf") return read_sdf(file, options);
  xml.fail(code::kRobotFormat, xml.root(), "is the root, expected <robot> (URDF), <sdf> (SDF) or <mujoco> (MJCF)");
}

}  // namespace footfall
