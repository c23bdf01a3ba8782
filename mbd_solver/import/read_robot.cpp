// The root element of a file shows its format. FOOTFALL_SDFORMAT: the library sdformat was found, and sdf_reader.cpp is compiled.
#include "mbd_solver/import/codes.h"
#include "mbd_solver/import/xml_source.h"

namespace footfall {

Robot read_robot(const std::string& file, const ImportOptions& options) {
  const XmlSource xml(file);
  const std::string root = xml.root().name();
  if (root == "robot") return read_urdf(file, options);
  if (root == "mujoco") return read_mjcf(file, options);
#ifdef FOOTFALL_SDFORMAT
  if (root == "sdf") return read_sdf(file, options);
#else
  if (root == "sdf")
    xml.fail(
        code::kRobotWithoutSdf, xml.root(),
        "is SDF, which this build of footfall does not read: the library sdformat is not in this release of Debian, "
        "or was not installed when footfall was built. Install libsdformat-dev (Debian 12 has it) and build again, or "
        "convert the file to URDF");
#endif
  xml.fail(code::kRobotFormat, xml.root(), "is the root, expected <robot> (URDF), <sdf> (SDF) or <mujoco> (MJCF)");
}

}  // namespace footfall
