// A stock fix wall/gran whose contacts are those with chains of capsules: it finds the touches, moves the beams with their
// bodies, and calls the contact model of the wall for each touch.

#include "liggghts_fix/contact/fix_wall_gran_beam.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "atom.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "coupler/communicator.h"
#include "domain.h"
#include "fix_property_atom.h"
#include "force.h"
#include "lammps.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/link/scoped_values.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

using namespace footfall;

// LIGGGHTS divides by the distance between a grain's centre and the surface: its smallest magnitude [of the radius].
constexpr double kSmallestDistance = 1e-9;

// Words as LIGGGHTS expects them: char**.
class Words {
 public:
  explicit Words(std::vector<std::string>& words) {
    for (std::string& word : words) pointers_.push_back(word.data());
  }
  int count() const { return static_cast<int>(pointers_.size()); }
  char** data() { return pointers_.data(); }

 private:
  std::vector<char*> pointers_;
};

// Materials belong to atom types: property/global has one value for each type of the box.
BeamArguments with_known_material(BeamArguments arguments, int types) {
  if (!whole_number(arguments.type, 1, types))
    throw InputError(code::kBeamMaterialUnknown, arguments.fix, ": type ", arguments.type,
                     " has no material: the box has types 1 to ", types,
                     ". Use one of them, or add a type to create_box and each property/global");
  return arguments;
}

void take(const Eigen::Vector3d& from, double* to) { Eigen::Map<Eigen::Vector3d>(to, 3) = from; }

Eigen::Vector3d vector(const double* from) { return Eigen::Map<const Eigen::Vector3d>(from); }

}  // namespace

FixWallGranBeam::FixWallGranBeam(LAMMPS* lmp_, int narg, char** arg)
    : FixWallGranBeam(lmp_, with_known_material(BeamArguments(narg, arg), lmp_->atom->ntypes)) {}

FixWallGranBeam::FixWallGranBeam(LAMMPS* lmp_, BeamArguments arguments)
    : FixWallGran(lmp_, Words(arguments.stock).count(), Words(arguments.stock).data()),
      link_(dem_link_of(lmp_)),
      arguments_(std::move(arguments)) {
  for (const BeamChoice& choice : arguments_.beams) {
    const ModalBoundary& boundary = link_.bodies().scene_body(choice.body, update->unit_style).boundary;
    const int body = link_.bodies().couple(choice.body, update->unit_style);
    for (const int number : chosen_chains(arguments_.fix, choice, boundary)) {
      beams_.push_back(std::make_unique<Beam>(boundary, body, number));
      link_.bodies().touch_chain(body, number);
    }
  }
  vector_flag = 1;
  size_vector = 8;
  array_flag = 1;
  size_array_rows = static_cast<int>(beams_.size());
  size_array_cols = 8;
  global_freq = 1;
  extvector = extarray = 0;
}

FixWallGranBeam::Beam::Beam(const ModalBoundary& boundary_, int body_, int number)
    : boundary(boundary_),
      body(body_),
      chain(boundary_, number),
      motion(boundary_, chain),
      neighbours(0.0),
      at_list(boundary_.mode_count()),
      load(boundary_.mode_count()) {}

// Stock LIGGGHTS stores one history per grain and wall, which the first beam uses. Each further beam gets a fix
// property/atom, whose values move with the grains between ranks and into restart files.
void FixWallGranBeam::post_create() {
  FixWallGran::post_create();
  if (store_force_contact_ && beams_.size() > 1)
    throw InputError(code::kBeamUnsupported, arguments_.fix,
                     ": store_force_contact stores one contact per grain and fix; give each beam a fix of its own");
  if (dnum() == 0) return;
  beams_[0]->history = fix_history_primitive_;
  for (std::size_t k = 1; k < beams_.size(); ++k) {
    const std::string name = footfall::concat("history_", id, "_", k + 1);
    std::vector<std::string> words = {
        // in restart files; not for ghosts, forth or back
        name, "all", "property/atom", name, dnum() > 1 ? "vector" : "vector_one_entry", "yes", "no", "no"};
    words.insert(words.end(), static_cast<std::size_t>(dnum()), "0.");
    Words w(words);
    modify->add_fix(w.count(), w.data());
    beams_[k]->history = static_cast<FixPropertyAtom*>(
        modify->find_fix_property(name.c_str(), "property/atom", "vector", dnum(), 0, style));
  }
}

void FixWallGranBeam::pre_delete(bool unfixed) {
  if (unfixed)
    for (std::size_t k = 1; k < beams_.size(); ++k)
      if (beams_[k]->history != nullptr) modify->delete_fix(beams_[k]->history->id);
  FixWallGran::pre_delete(unfixed);
}

void FixWallGranBeam::init() {
  FixWallGran::init();
  if (impl->get_history_offset("dissipation_force") >= 0)
    throw InputError(code::kBeamUnsupported, arguments_.fix,
                     ": LIGGGHTS' computeDissipatedEnergy works with meshes only");
  if (modify->n_fixes_style("multicontact/halfspace") > 0)
    throw InputError(code::kBeamUnsupported, arguments_.fix, ": fix multicontact/halfspace does not support beams");
  // LIGGGHTS' kn is force over overlap; Hertz' force grows as overlap^(3/2).
  if (arguments_.curvature && !impl->contact_match("normal", "hertz"))
    throw InputError(code::kBeamUnsupported, arguments_.fix, ": curvature yes requires `model hertz`; remove it");
  stiffness_per_kn_ = impl->contact_match("normal", "hertz") ? 1.5 : 1.0;
  reads_wall_as_atom_ = impl->contact_match("cohesion", "easo/capillary/viscous");
  check_segment_lengths();
}

// Every rank holds the whole chain and searches its own grains near it; segments that cross many subdomains would make
// all of these ranks search. In directions that are not divided between ranks only a segment longer than the box is
// refused: most likely its unit is wrong.
void FixWallGranBeam::check_segment_lengths() const {
  double edge[3], smallest[3];
  for (int d = 0; d < 3; ++d) edge[d] = domain->subhi[d] - domain->sublo[d];
  check_mpi(MPI_Allreduce(edge, smallest, 3, MPI_DOUBLE, MPI_MIN, world), "MPI_Allreduce");
  double limit = std::sqrt(domain->xprd * domain->xprd + domain->yprd * domain->yprd + domain->zprd * domain->zprd);
  for (int d = 0; d < 3; ++d)
    if (comm->procgrid[d] > 1) limit = std::min(limit, smallest[d]);
  for (const std::unique_ptr<Beam>& beam : beams_)
    for (int s = 0; s < beam->chain.segment_count(); ++s) {
      if (beam->chain.length(s) <= limit) continue;
      throw InputError(code::kBeamSegmentTooLong, arguments_.fix, ": segment ", s, " of body \"", beam->boundary.name(),
                       "\" is ", plain_text(beam->chain.length(s)), " m long, longer than a subdomain of this run (",
                       plain_text(limit), " m): divide the beam into more segments, or the box among fewer ranks ",
                       "(command `processors`)");
    }
}

void FixWallGranBeam::setup(int vflag) {
  if (!link_.started())
    throw InputError(code::kBeamWithoutCoupling, arguments_.fix,
                     ": no fix moves its beams. Add `fix ID all couple/mbd every N` to the script");
  const Eigen::Vector3d periods(domain->xperiodic ? domain->xprd : 0.0, domain->yperiodic ? domain->yprd : 0.0,
                                domain->zperiodic ? domain->zprd : 0.0);
  for (const std::unique_ptr<Beam>& beam : beams_)
    beam->neighbours = BeamNeighbours(neighbor->skin, neighbor->contactDistanceFactor - 1.0, periods);
  if (arguments_.curvature) {
    young_ = force->registry.getMatrixProperty("Yeff", style)->data;
    shear_ = force->registry.getMatrixProperty("Geff", style)->data;
  }
  FixWallGran::setup(vflag);
}

GrainView FixWallGranBeam::grains() const { return {atom->nlocal, atom->x, atom->radius, atom->mask, groupbit}; }

void FixWallGranBeam::pre_neighbor() { renumbered_ = true; }

void FixWallGranBeam::pre_force(int) {
  if (renumbered_) {
    const GrainExtent extent(grains());
    for (const std::unique_ptr<Beam>& beam : beams_) beam->neighbours.grains_renumbered(extent);
  }
  renumbered_ = false;
}

void FixWallGranBeam::post_force_primitive(int) {
  for (const std::unique_ptr<Beam>& beam : beams_) touch_grains(*beam);
}

void FixWallGranBeam::touch_grains(Beam& beam) {
  DemBody& body = link_.window().body(beam.body);
  const bool counts = computeflag() != 0;  // otherwise an output evaluates the contacts once more
  if (counts) {
    beam.load.set_zero();
    beam.contacts = 0;
    beam.overlap = 0.0;
  }
  if (beam.neighbours.clearance() > 0.0 &&
      beam.chain.largest_travel(beam.at_list, body.pose()) < beam.neighbours.clearance())
    return;
  beam.chain.follow(body.pose());
  if (beam.neighbours.update(beam.chain, grains())) beam.at_list = body.pose();
  if (beam.neighbours.size() == 0) return;

  beam.motion.begin_step(body.pose());
  double** const histories = beam.history != nullptr ? beam.history->array_atom : nullptr;
  const double reach = neighbor->contactDistanceFactor - 1.0;
  for (int k = 0; k < beam.neighbours.size(); ++k) {
    const int i = beam.neighbours.grain(k);
    const BeamTouch closest = beam.neighbours.closest(beam.chain, k, vector(x_[i]), radius_[i]);
    double* const history = histories == nullptr ? nullptr : histories[i];
    if (closest.gap > 0.0 && closest.gap >= reach * radius_[i]) {
      if (history != nullptr) std::fill(history, history + dnum(), 0.0);
      continue;
    }
    const double stiffness = touch(beam, i, closest, history);
    if (!counts || closest.gap > 0.0) continue;
    const double overlap = -closest.gap / radius_[i];
    body.count_contact(overlap, stiffness, body.boundary().segment_point(closest.segment, closest.mu),
                       {atom->rmass[i], radius_[i], vector(atom->v[i])});
    if (body.samples_slopes()) body.add_slope(closest.contact_point(), slope_);
    if (overlap > GrainPassages::kDeep) watch_passage(beam, i, closest);
    ++beam.contacts;
    beam.overlap = std::max(beam.overlap, overlap);
  }
  if (!counts) return;
  beam.motion.project(body.pose(), beam.load);
  body.add_load(beam.load);
}

// Through the axis.
void FixWallGranBeam::watch_passage(Beam& beam, int i, const BeamTouch& touch) {
  const double speed = (vector(atom->v[i]) - beam.motion.velocity(touch)).norm();
  const int tag = static_cast<int>(atom->tag[i]);
  const Eigen::Vector3d to_axis = touch.p - (vector(x_[i]) - touch.image);
  if (!beam.passages.passes(update->ntimestep, tag, to_axis, speed * update->dt)) return;
  link_.grains().fault({GrainFault::kPassed, link_.window().time(), tag, beam.body, speed, radius_[i]});
}

// Force on the round beam relative to a plane; the end of a beam is a sphere.
double FixWallGranBeam::softness(const Beam& beam, const BeamTouch& touch, double r) const {
  const bool at_end =
      (touch.mu == 0.0 && touch.segment == 0) || (touch.mu == 1.0 && touch.segment + 1 == beam.chain.segment_count());
  return at_end ? hertz_on_end(r, touch.radius) : hertz_on_side(r, touch.radius);
}

// One contact: the contact model of LIGGGHTS adds force and torque to the grain, and their reaction acts on the beam.
// Returns the normal stiffness [N/m].
double FixWallGranBeam::touch(Beam& beam, int i, const BeamTouch& touch, double* history) {
  const double r = radius_[i];
  const Eigen::Vector3d x = vector(x_[i]) - touch.image;
  double to_surface = r + touch.gap;  // from the grain's centre; negative inside the beam
  if (std::abs(to_surface) < kSmallestDistance * r) to_surface = kSmallestDistance * r;

  LCM::SurfacesIntersectData contact;
  contact.is_wall = true;
  contact.i = i;
  contact.radi = r;
  contact.deltan = r - to_surface;
  contact.contact_history = history;
  contact.kn = contact.kt = contact.gamman = contact.gammat = 0.0;  // some models set none
  take(to_surface * touch.normal, contact.delta);
  double v_wall[3];
  take(beam.motion.velocity(touch), v_wall);

  const Eigen::Vector3d f_before = vector(f_[i]), torque_before = vector(atom->torque[i]);
  {
    const ScopedModuli moduli(young_, shear_, atom->type[i], atom_type_wall(),
                              arguments_.curvature ? softness(beam, touch, r) : 1.0);
    const ScopedPairMass mass(atom->rmass[i], link_.window().body(beam.body).inverse_mass());
    std::optional<ScopedWallAsAtom> as_atom;
    if (reads_wall_as_atom_ && touch.gap > 0.0) as_atom.emplace(atom->v, velocities_, i, atom_type_wall(), v_wall);
    impl->compute_force(this, contact, touch.gap <= 0.0, v_wall);
  }
  const Eigen::Vector3d f_W = f_before - vector(f_[i]);
  slope_ = {touch.normal, stiffness_per_kn_ * contact.kn, contact.kt, contact.gamman, contact.gammat};
  beam.motion.add_force(touch, f_W, torque_before - vector(atom->torque[i]) + (x - touch.p).cross(f_W));
  return stiffness_per_kn_ * contact.kn;
}

// --- Output f_ID[...] of the last step.

double FixWallGranBeam::compute_vector(int n) {
  double mine = 0.0;
  for (const std::unique_ptr<Beam>& beam : beams_) {
    const GeneralizedForce& load = beam->load;
    if (n < 3) {
      mine += load.F_W[n];
    } else if (n < 6) {
      mine += load.T_W[n - 3] + link_.window().body(beam->body).pose().r.cross(load.F_W)[n - 3];
    } else if (n == 6) {
      mine += static_cast<double>(beam->contacts);
    } else {
      mine = std::max(mine, beam->overlap);
    }
  }
  return over_ranks(mine, n == 7);
}

double FixWallGranBeam::compute_array(int beam, int n) {
  const Beam& b = *beams_[beam];
  const double mine = n < 3    ? b.load.F_W[n]
                      : n < 6  ? b.load.T_W[n - 3]
                      : n == 6 ? static_cast<double>(b.contacts)
                               : b.overlap;
  return over_ranks(mine, n == 7);
}

// Largest or sum over the ranks of LIGGGHTS.
double FixWallGranBeam::over_ranks(double mine, bool largest) const {
  double all = 0.0;
  check_mpi(MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, largest ? MPI_MAX : MPI_SUM, world), "MPI_Allreduce");
  return all;
}

}  // namespace LAMMPS_NS
