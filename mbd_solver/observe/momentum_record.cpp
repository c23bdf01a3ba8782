#include "mbd_solver/observe/momentum_record.h"

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"

namespace footfall {

MomentumSum momentum_of(const Model& model, const Kinematics& kinematics) {
  MomentumSum sum;
  const auto add = [&sum](double m, const Eigen::Vector3d& v) {
    sum.linear += m * v;
    sum.size += m * v.norm();
  };
  for (int i = 0; i < model.body_count(); ++i) {
    const BodyKinematics& b = kinematics.of(i);
    sum.mass += model.body(i).mass();
    if (b.modes == 0) {
      add(model.body(i).mass(), b.dr);
      continue;
    }
    const ModalBody& modal = *model.body(i).modal();
    for (int j = 0; j < modal.node_count(); ++j) {
      const auto Phi = modal.Phi.middleRows(3 * j, 3);
      const Eigen::Vector3d arm = b.A * (modal.rho0.col(j) + Phi * b.a);
      const Eigen::Vector3d bends = b.A * (Phi * b.da);
      add(modal.node_mass[j], b.dr + b.w.cross(arm) + bends);
    }
  }
  return sum;
}

bool is_free(const Model& model) {
  for (int i = 0; i < model.joint_count(); ++i)
    if (model.joint(i).m1.body == kGround || model.joint(i).m2.body == kGround) return false;
  for (int i = 0; i < model.force_count(); ++i)
    for (const int body : model.force(i).bodies())
      if (body == kGround) return false;
  return true;
}

MomentumRecord::MomentumRecord(const Subject& subject, const std::string& folder)
    : subject_(subject), path_(folder + "/mechanism.csv") {
  make_folder(folder);
  file_.open(path_);
  file_.precision(17);
  file_ << "time,px,py,pz,size,mass,gx,gy,gz,free,reacts";
  for (const int i : subject.agreement->boundaries) {
    const std::string& name = subject.mechanism.boundaries[static_cast<std::size_t>(i)].boundary.name();
    for (const char* what : {"fx", "fy", "fz", "mx", "my", "mz", "received"}) file_ << "," << name << "." << what;
  }
  file_ << "\n";
  if (!file_.flush()) throw InputError(path_ + ": cannot be written");
}

void MomentumRecord::write(const Sample& sample) {
  const Model& model = subject_.mechanism.model;
  const MomentumSum sum = momentum_of(model, sample.kinematics);
  const auto put = [this](const Eigen::Vector3d& v) { file_ << "," << v.x() << "," << v.y() << "," << v.z(); };
  file_ << sample.state.time;
  put(sum.linear);
  file_ << "," << sum.size << "," << sum.mass;
  put(model.gravity());
  file_ << "," << is_free(model) << "," << subject_.agreement->scheme->wants_tangent();
  for (const int i : subject_.agreement->boundaries) {
    const int body = subject_.mechanism.boundaries[static_cast<std::size_t>(i)].body;
    const ExternalLoad& load = sample.inputs.loads[static_cast<std::size_t>(body)];
    put(load.F_W);
    put(load.T_B);
    file_ << "," << sample.state.load_work(body);
  }
  file_ << "\n";
  if (!file_.flush()) throw InputError(path_ + ": cannot be written: is the disk full?");
}

}  // namespace footfall
