#pragma once
// Places of bodies, joints and forces in the frames of VtkSeries, from which the viewer draws their symbols and tracks.
// A mark is a text and four vectors in W:
//   text: KIND, TYPE, NAME, BODY, BODY, separated by tabs
//   body    origin p, p, force and moment of the ground about it [N, N m]
//   joint   points on a and b [m], its axis, its second axis (rolling: times the radius [m])
//   strut   its ends [m], its force on the second end [N], 0
//   cable   a piece of a polygon along it, from end to end: its ends [m], tension on the second end [N], 0
//   spring  points on a and b [m], its axis, its second axis
//   force   point, point [m], force and moment about the point [N, N m]
//   drive   points on a and b [m], axis of its coordinate times its torque or force [N m or N], that axis
//   gear    one mark per joint: its point, the next joint's point [m], axis of the coordinate, (factor, 1 for an angle, 0)

#include <variant>

#include "mbd_solver/session/observe/sampler.h"

namespace footfall {

class Marks {
 public:
  explicit Marks(const Subject& subject);  // its parts must outlive this
  const std::vector<std::string>& texts() const { return texts_; }
  // Four columns per mark, valid until the next call. sample: null where no loads are known yet.
  const Eigen::Matrix3Xd& vectors(const Kinematics& kinematics, const Sample* sample);

 private:
  struct FromGround {
    int body;
  };
  using Load =
      std::variant<std::monostate, FromGround, Handle<Strut>, Handle<AppliedForce>, Handle<JointForce>, Handle<Cable>>;
  struct Axis {  // `length` times axis k of marker `on` (0 or 1)
    int on = 0, k = 2;
    double length = 1.0;
  };
  struct Mark {
    Marker m1, m2;
    Axis axes[2];
    Load load = {};
    int pieces = 0;                       // of a cable, at the first of its marks
    bool has_numbers = false;             // of a gear, instead of the second axis
    Eigen::Vector3d numbers = {0, 0, 0};  // of a gear
  };
  void add(const std::string& kind, const std::string& type, const std::string& name, Mark mark);
  void add_joints();
  void add_elements();
  void add_cables();
  // All marks of one.
  void put_cable(std::size_t first, Handle<Cable> cable, const Kinematics& kinematics, const Sample* sample);
  void put_load(const Mark& mark, const Sample& sample, Eigen::Index column);

  Subject subject_;
  std::vector<Mark> marks_;
  std::vector<std::string> texts_;
  Eigen::Matrix3Xd vectors_;
};

}  // namespace footfall
