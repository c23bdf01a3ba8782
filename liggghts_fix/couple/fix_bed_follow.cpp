// The end of a step decides from the pose of the body, the same on all ranks; the next step builds its neighbour lists
// anew and the slab is changed before them, while contact histories are with the grains. The new slab is held at rest
// until the next slab comes, which then fits to it exactly: otherwise its end, free towards the rut behind, would slump.

#include "liggghts_fix/couple/fix_bed_follow.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "coupler/communicator.h"
#include "domain.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/couple/rank_numbers.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/dem_link.h"
#include "modify.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

namespace code = footfall::code;

constexpr int kSlabs = 10;             // of the box along each direction
constexpr int kMostPeriods = 500;      // of the box: LIGGGHTS counts up to 511
constexpr double kMoreOverlap = 0.05;  // more than in the bed at rest, over the radius [-]
constexpr int kFixedNumbers = 11;      // of a grain, packed

int period_of(int slab) { return static_cast<int>(std::floor(static_cast<double>(slab) / kSlabs)); }
int place_in_box(int slab) { return slab - kSlabs * period_of(slab); }

// Counts of LIGGGHTS within lists of double.
double as_double(int count) {
  const std::int64_t bits = count;
  double number = 0.0;
  std::memcpy(&number, &bits, sizeof(number));
  return number;
}
int as_count(double number) {
  std::int64_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  return static_cast<int>(bits);
}

int image_of(int period_x, int period_y) {
  return (IMGMAX << IMG2BITS) | (((IMGMAX + period_y) & IMGMASK) << IMGBITS) | ((IMGMAX + period_x) & IMGMASK);
}

}  // namespace

FixBedFollow::FixBedFollow(LAMMPS* lmp_, int narg, char** arg)
    : Fix(lmp_, narg, arg), link_(footfall::dem_link_of(lmp_)) {
  bool good = narg % 2 == 1;
  for (int i = 3; good && i + 1 < narg; i += 2) {
    const std::string value = arg[i + 1];
    if (std::strcmp(arg[i], "body") == 0) {
      body_name_ = value;
    } else if (std::strcmp(arg[i], "directions") == 0) {
      good = value == "x" || value == "y" || value == "xy";
      follows_ = {value != "y", value != "x"};
    } else if (std::strcmp(arg[i], "distance") == 0) {
      distance_ = footfall::read_number(arg[i + 1], nullptr);
    } else {
      good = false;
    }
  }
  for (int axis = 0; axis < 2; ++axis)
    good = good && (!follows_[axis] || (domain->periodicity[axis] != 0 && distance_ > 0.0 &&
                                        2.0 * distance_ + 3.0 * slab_width(axis) <= kSlabs * slab_width(axis)));
  if (!good || body_name_.empty())
    throw footfall::InputError(code::kSourceSyntax, "fix ", id,
                               ": expected: fix ID all bed/follow body BODY directions x|y|xy distance D, with sides "
                               "of the box that are periodic, and D from 0 to 0.35 of their distance");
  link_.bodies().scene_body(body_name_, update->unit_style);  // an unknown name ends here
  if (!link_.resumed())
    for (int i = 0; i < atom->nlocal; ++i) atom->image[i] = image_of(0, 0);
  restart_global = 1;
  force_reneighbor = 1;
  next_reneighbor = 0;
  vector_flag = 1;
  size_vector = 4;
  global_freq = 1;
  nevery = 1;
}

int FixBedFollow::setmask() { return FixConst::END_OF_STEP | FixConst::PRE_EXCHANGE | FixConst::POST_FORCE; }

void FixBedFollow::init() {
  const std::vector<std::string>& names = link_.bodies().names();
  const auto found = std::find(names.begin(), names.end(), body_name_);
  if (found == names.end())
    throw footfall::InputError(code::kBodyNotInScene, "fix ", id, ": body \"", body_name_,
                               "\" touches no grains: name it in fix couple/mbd");
  body_ = static_cast<int>(found - names.begin());
}

double FixBedFollow::slab_width(int axis) const { return (domain->boxhi[axis] - domain->boxlo[axis]) / kSlabs; }

double FixBedFollow::limit(int axis, int slab) const { return domain->boxlo[axis] + slab * slab_width(axis); }

// The slab of a place that may lie a little outside the box.
int FixBedFollow::place_of(double x, int axis) const {
  return place_in_box(static_cast<int>(std::floor((x - domain->boxlo[axis]) / slab_width(axis))));
}

bool FixBedFollow::is_in(const Slab& slab, const double* x) const {
  return place_of(x[slab.axis], slab.axis) == slab.place;
}

Fix* FixBedFollow::pair_history() const {
  for (int i = 0; i < modify->nfix; ++i)
    if (std::strcmp(modify->fix[i]->style, "contacthistory") == 0) return modify->fix[i];
  return nullptr;
}

std::vector<Fix*> FixBedFollow::plane_histories() const {
  std::vector<Fix*> all;
  for (int i = 0; i < modify->nfix; ++i)
    if (std::strcmp(modify->fix[i]->style, "property/atom") == 0 &&
        std::strncmp(modify->fix[i]->id, "history_", 8) == 0 && modify->fix[i]->array_atom != nullptr)
      all.push_back(modify->fix[i]);
  return all;
}

// --- The bed at rest.

// Before the first step: places and histories are those that the script has read.
void FixBedFollow::setup_pre_exchange() {
  if (bed_.empty()) keep_bed();
}

void FixBedFollow::keep_bed() {
  Fix* const history = pair_history();
  const std::vector<Fix*> planes = plane_histories();
  std::vector<double> mine, pairs(4096);
  for (int i = 0; i < atom->nlocal; ++i) {
    mine.insert(mine.end(), {static_cast<double>(atom->tag[i]), atom->x[i][0], atom->x[i][1], atom->x[i][2],
                             atom->radius[i], atom->rmass[i], atom->density[i], static_cast<double>(atom->type[i]),
                             static_cast<double>(atom->mask[i])});
    const int size = history == nullptr ? 0 : history->pack_exchange(i, pairs.data());
    const int partners = size == 0 ? 0 : as_count(pairs[0]);
    const int values = partners == 0 ? 0 : (size - 1) / partners - 1;
    mine.push_back(partners);
    mine.push_back(values);
    for (int k = 0; k < partners; ++k) {
      const double* const one = pairs.data() + 1 + k * (values + 1);
      mine.push_back(as_count(one[0]));
      mine.insert(mine.end(), one + 1, one + 1 + values);
    }
    for (const Fix* const plane : planes)
      mine.insert(mine.end(), plane->array_atom[i], plane->array_atom[i] + plane->size_peratom_cols);
  }
  std::size_t per_plane = 0;
  for (const Fix* const plane : planes) per_plane += static_cast<std::size_t>(plane->size_peratom_cols);
  std::vector<double> numbers = footfall::of_all_ranks(mine, world);
  const double head[3] = {0.0, static_cast<double>(per_plane), 0.0};
  numbers.insert(numbers.begin(), head, head + 3);
  numbers[2] = static_cast<double>(numbers.size() - 3);
  unpack(numbers.data());
}

// kind (0: partners by tag, 1: by place in the list), numbers of planes, size of the rest; then the grains.
void FixBedFollow::unpack(const double* numbers) {
  const bool by_tag = numbers[0] == 0.0;
  const auto per_plane = static_cast<std::size_t>(numbers[1]), size = static_cast<std::size_t>(numbers[2]);
  const double* next = numbers + 3;
  const double* const end = next + size;
  bed_.clear();
  while (next < end) {
    RestingGrain grain;
    grain.tag = static_cast<int>(next[0]);
    grain.x << next[1], next[2], next[3];
    grain.radius = next[4], grain.mass = next[5], grain.density = next[6];
    grain.type = static_cast<int>(next[7]), grain.mask = static_cast<int>(next[8]);
    const auto partners = static_cast<int>(next[9]), values = static_cast<int>(next[10]);
    pair_values_ = std::max(pair_values_, values);
    next += kFixedNumbers;
    for (int k = 0; k < partners; ++k) {
      grain.partners.push_back(static_cast<int>(next[0]));
      grain.pairs.insert(grain.pairs.end(), next + 1, next + 1 + values);
      next += values + 1;
    }
    grain.planes.assign(next, next + per_plane);
    next += per_plane;
    bed_.push_back(std::move(grain));
  }
  if (by_tag) {
    std::sort(bed_.begin(), bed_.end(), [](const auto& a, const auto& b) { return a.tag < b.tag; });
    std::map<int, int> places;
    for (std::size_t k = 0; k < bed_.size(); ++k) places.emplace(bed_[k].tag, static_cast<int>(k));
    for (RestingGrain& grain : bed_) {
      for (int& partner : grain.partners) partner = places.at(partner);
      for (int axis = 0; axis < 2; ++axis) {  // a grain outside the box is on the other side
        if (domain->periodicity[axis] == 0) continue;
        const double period = domain->boxhi[axis] - domain->boxlo[axis];
        grain.x[axis] -= period * std::floor((grain.x[axis] - domain->boxlo[axis]) / period);
        if (grain.x[axis] >= domain->boxhi[axis]) grain.x[axis] = domain->boxlo[axis];
      }
    }
  }
  tags_.clear();
  for (const RestingGrain& grain : bed_) tags_.push_back(grain.tag);
  double overlap = 0.0;
  for (const RestingGrain& grain : bed_)
    for (const int partner : grain.partners) {
      const RestingGrain& other = bed_[partner];
      Eigen::Vector3d d = other.x - grain.x;
      domain->minimum_image(d[0], d[1], d[2]);
      overlap = std::max(overlap, (grain.radius + other.radius - d.norm()) / std::min(grain.radius, other.radius));
    }
  allowed_overlap_ = overlap + kMoreOverlap;
}

std::vector<double> FixBedFollow::packed() const {
  std::vector<double> numbers = {1.0, bed_.empty() ? 0.0 : static_cast<double>(bed_.front().planes.size()), 0.0};
  std::size_t numbers_of = 0;
  for (const RestingGrain& grain : bed_) {
    const std::size_t values = grain.partners.empty() ? 0 : grain.pairs.size() / grain.partners.size();
    numbers.insert(numbers.end(),
                   {static_cast<double>(tags_[numbers_of++]), grain.x[0], grain.x[1], grain.x[2], grain.radius,
                    grain.mass, grain.density, static_cast<double>(grain.type), static_cast<double>(grain.mask),
                    static_cast<double>(grain.partners.size()), static_cast<double>(values)});
    for (std::size_t k = 0; k < grain.partners.size(); ++k) {
      numbers.push_back(grain.partners[k]);
      const auto from = grain.pairs.begin() + static_cast<std::ptrdiff_t>(k * values);
      numbers.insert(numbers.end(), from, from + static_cast<std::ptrdiff_t>(values));
    }
    numbers.insert(numbers.end(), grain.planes.begin(), grain.planes.end());
  }
  numbers[2] = static_cast<double>(numbers.size() - 3);
  return numbers;
}

// --- The window.

void FixBedFollow::setup(int) {
  post_force(0);
  require_all_inside();
  find_next();
}

void FixBedFollow::end_of_step() { find_next(); }

void FixBedFollow::find_next() {
  next_axis_ = -1;
  const Eigen::Vector3d& place = link_.window().body(body_).pose().r;
  for (int axis = 0; axis < 2 && next_axis_ < 0; ++axis) {
    if (!follows_[axis]) continue;
    const int first = first_[axis];
    if (place[axis] + distance_ > limit(axis, first + kSlabs - 1)) {
      next_way_ = 1;
    } else if (place[axis] - distance_ < limit(axis, first + 1)) {
      next_way_ = -1;
    } else {
      continue;
    }
    next_axis_ = axis;
    next_reneighbor = update->ntimestep + 1;
  }
}

std::array<double, 2> FixBedFollow::extent_of(int body, int axis) const {
  const footfall::DemBody& one = link_.window().body(body);
  Eigen::Matrix3Xd x(3, one.boundary().node_count());
  one.boundary().node_positions(one.pose(), x);
  if (x.cols() == 0) return {HUGE_VAL, -HUGE_VAL};
  return {x.row(axis).minCoeff(), x.row(axis).maxCoeff()};
}

void FixBedFollow::require_all_inside() const {
  for (int body = 0; body < link_.bodies().count(); ++body) {
    for (int axis = 0; axis < 2; ++axis) {
      if (!follows_[axis]) continue;
      const int first = first_[axis];
      const double low = limit(axis, first), high = limit(axis, first + kSlabs);
      const auto [least, most] = extent_of(body, axis);
      if (least >= low && most <= high) continue;
      throw footfall::NumericalError(
          code::kMeshLeavesBox, "t = ", footfall::number_text(static_cast<double>(update->ntimestep) * update->dt),
          " s: body \"", link_.bodies().name(body), "\" reaches from ", footfall::number_text(least, 4), " to ",
          footfall::number_text(most, 4), " m along ", "xy"[axis], ", the bed that follows body \"", body_name_,
          "\" from ", footfall::number_text(low, 4), " to ", footfall::number_text(high, 4),
          " m: all bodies that grains touch must stay near that body. Make the bed longer (particles.box.size), or let "
          "them move together");
    }
  }
}

void FixBedFollow::pre_exchange() {
  if (next_axis_ < 0 || next_reneighbor != update->ntimestep) return;
  const auto axis = static_cast<std::size_t>(next_axis_);
  const int last = first_[axis] + kSlabs - 1;
  const int fresh = next_way_ > 0 ? last + 1 : first_[axis] - 1;
  require_all_inside();
  first_[axis] += next_way_;
  if (std::abs(period_of(fresh)) >= kMostPeriods)
    throw footfall::NumericalError(
        code::kMeshLeavesBox, "t = ", footfall::number_text(static_cast<double>(update->ntimestep) * update->dt),
        " s: the bed has followed body \"", body_name_, "\" over ", kMostPeriods,
        " of its lengths, the most that LIGGGHTS can count. Make the bed longer, or end the scene earlier");
  require_all_inside();
  const Slab slab = {next_axis_, place_in_box(fresh)};
  const footfall::BedExchange all = footfall::bed_exchange(change_of(slab, next_way_));
  next_axis_ = -1;
  footfall::GrainChanges changes;
  int most = 0;  // tag of all grains, also of those that go: their neighbours still name them
  for (int i = 0; i < atom->nlocal; ++i) most = std::max(most, atom->tag[i]);
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT, MPI_MAX, world), "MPI_Allreduce");
  exchange(all, changes);
  insert(slab, most, changes);
  held_[axis] = fresh;
  std::array<double, 4> counts = {changes.added, changes.added_mass, changes.removed, changes.removed_mass};
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, counts.data(), 4, MPI_DOUBLE, MPI_SUM, world), "MPI_Allreduce");
  sum_.added += counts[0];
  sum_.added_mass += counts[1];
  sum_.removed += counts[2];
  sum_.removed_mass += counts[3];
  link_.grains().changed(changes);
  atom->natoms += static_cast<bigint>(counts[0]) - static_cast<bigint>(counts[2]);
  if (atom->map_style) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
}

double FixBedFollow::energy_of(int i) const {
  const Eigen::Map<const Eigen::Vector3d> v(atom->v[i]), w(atom->omega[i]);
  const double m = atom->rmass[i], r = atom->radius[i];
  double x[3];
  domain->unmap(atom->x[i], atom->image[i], x);
  return 0.5 * m * v.squaredNorm() + 0.2 * m * r * r * w.squaredNorm() -
         m * link_.script_gravity().dot(Eigen::Map<const Eigen::Vector3d>(x));
}

// With the grains of all ranks in the slab and its neighbours, by their tags.
footfall::SlabChange FixBedFollow::change_of(const Slab& slab, int way) const {
  constexpr std::size_t kNumbers = 6;
  const int axis = slab.axis;
  std::vector<double> mine;
  for (int i = 0; i < atom->nlocal; ++i) {
    const double* const x = atom->x[i];
    const int away = std::abs(place_of(x[axis], axis) - slab.place);
    if (away <= 1 || away == kSlabs - 1)
      mine.insert(mine.end(), {static_cast<double>(atom->tag[i]), x[0], x[1], x[2], atom->radius[i], atom->rmass[i]});
  }
  const std::vector<double> numbers = footfall::of_all_ranks(mine, world);
  footfall::SlabChange change;
  for (std::size_t k = 0; k + kNumbers <= numbers.size(); k += kNumbers) {
    const double* const of = numbers.data() + k;
    (is_in(slab, of + 1) ? change.in_slab : change.beside)
        .push_back({static_cast<int>(of[0]), Eigen::Vector3d(of[1], of[2], of[3]), of[4], of[5]});
  }
  for (std::vector<footfall::BedGrain>* const list : {&change.in_slab, &change.beside})
    std::sort(list->begin(), list->end(), [](const auto& a, const auto& b) { return a.tag < b.tag; });
  for (const RestingGrain& grain : bed_)
    if (is_in(slab, grain.x.data())) change.coming.push_back({grain.tag, grain.x, grain.radius, grain.mass});
  change.axis = axis;
  change.way = way;
  change.end = limit(axis, slab.place + (way > 0 ? 1 : 0));
  change.room = room_behind(axis, way);
  for (int k = 0; k < 2; ++k) change.period[k] = domain->periodicity[k] == 0 ? 0.0 : kSlabs * slab_width(k);
  change.allowed_overlap = allowed_overlap_;
  change.excess = sum_.removed_mass - sum_.added_mass;
  return change;
}

// From the end of the window that bodies have passed to the nearest of them, at most a slab [m].
double FixBedFollow::room_behind(int axis, int way) const {
  const double end = limit(axis, first_[axis] + (way > 0 ? 0 : kSlabs));
  double room = slab_width(axis);
  for (int body = 0; body < link_.bodies().count(); ++body) {
    const auto [least, most] = extent_of(body, axis);
    room = std::min(room, way > 0 ? least - end : end - most);
  }
  return room;
}

// Grains that are lifted are at rest and without contacts, as those that come.
void FixBedFollow::exchange(const footfall::BedExchange& exchange, footfall::GrainChanges& changes) {
  Fix* const history = pair_history();
  const std::vector<Fix*> planes = plane_histories();
  for (int i = 0; i < atom->nlocal;) {
    if (const auto lifted = exchange.lifted.find(atom->tag[i]); lifted != exchange.lifted.end()) {
      changes.changed -= energy_of(i);
      for (int c = 0; c < 3; ++c) {
        atom->x[i][c] = lifted->second[c];
        atom->v[i][c] = atom->omega[i][c] = 0.0;
      }
      changes.changed += energy_of(i);
      double none = as_double(0);
      if (history != nullptr) history->unpack_exchange(i, &none);
      for (Fix* const plane : planes) std::fill_n(plane->array_atom[i], plane->size_peratom_cols, 0.0);
    }
    if (!std::binary_search(exchange.removed.begin(), exchange.removed.end(), atom->tag[i])) {
      ++i;
      continue;
    }
    changes.left -= energy_of(i);
    changes.removed += 1.0;
    changes.removed_mass += atom->rmass[i];
    atom->avec->copy(atom->nlocal - 1, i, 1);
    --atom->nlocal;
  }
}

bool FixBedFollow::is_held(int i) const {
  for (int c = 0; c < 3; ++c)
    if (atom->v[i][c] != 0.0 || atom->omega[i][c] != 0.0) return false;
  for (int axis = 0; axis < 2; ++axis) {
    const int slab = held_[axis];
    if (slab != kNoSlab && place_of(atom->x[i][axis], axis) == place_in_box(slab)) return true;
  }
  return false;
}

// A grain whose speed is exactly zero is a new grain at rest: all others move, if only little.
void FixBedFollow::post_force(int) {
  if (held_[0] == kNoSlab && held_[1] == kNoSlab) return;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (atom->v[i][0] != 0.0 || !is_held(i)) continue;
    for (int c = 0; c < 3; ++c) atom->f[i][c] = atom->torque[i][c] = 0.0;
  }
}

// The contacts that grain k had at rest with grains that have a tag in `tags`, as LIGGGHTS packs them, after those given.
void FixBedFollow::add_contacts(std::size_t k, const std::vector<int>& tags, std::vector<double>& pairs) const {
  const RestingGrain& grain = bed_[k];
  int partners = as_count(pairs[0]);
  for (std::size_t p = 0; p < grain.partners.size(); ++p) {
    const int partner = tags[grain.partners[p]];
    if (partner == 0) continue;
    ++partners;
    pairs.push_back(as_double(partner));
    const auto from = grain.pairs.begin() + p * pair_values_;
    pairs.insert(pairs.end(), from, from + pair_values_);
  }
  pairs[0] = as_double(partners);
}

// At rest, with the histories of contacts among the new grains, with those that are held, and with planes. Tags follow the
// list, on any ranks.
void FixBedFollow::insert(const Slab& slab, int last_tag, footfall::GrainChanges& changes) {
  std::vector<int> coming(bed_.size(), 0), there(bed_.size(), 0);  // tags of new grains and of held neighbours
  std::vector<double> held_tags;
  for (int i = 0; i < atom->nlocal; ++i)
    if (is_held(i)) held_tags.push_back(atom->tag[i]);
  held_tags = footfall::of_all_ranks(held_tags, world);
  std::sort(held_tags.begin(), held_tags.end());
  std::map<int, std::size_t> held_places;
  for (std::size_t k = 0; k < bed_.size(); ++k) {
    if (is_in(slab, bed_[k].x.data())) {
      coming[k] = tags_[k] = ++last_tag;
    } else if (std::binary_search(held_tags.begin(), held_tags.end(), static_cast<double>(tags_[k]))) {
      there[k] = tags_[k];
      held_places.emplace(tags_[k], k);
    }
  }
  Fix* const history = pair_history();
  const std::vector<Fix*> planes = plane_histories();
  std::vector<double> pairs(4096);
  for (int i = 0; i < atom->nlocal && history != nullptr; ++i) {
    const auto held = held_places.find(atom->tag[i]);
    if (held == held_places.end()) continue;
    pairs.resize(4096);
    pairs.resize(history->pack_exchange(i, pairs.data()));
    add_contacts(held->second, coming, pairs);
    history->unpack_exchange(i, pairs.data());
  }
  for (std::size_t k = 0; k < bed_.size(); ++k) {
    const RestingGrain& grain = bed_[k];
    bool mine = coming[k] != 0;
    for (int c = 0; c < 3; ++c) mine = mine && grain.x[c] >= domain->sublo[c] && grain.x[c] < domain->subhi[c];
    if (!mine) continue;
    Eigen::Vector3d x = grain.x;
    atom->avec->create_atom(grain.type, x.data());
    const int i = atom->nlocal - 1;
    atom->tag[i] = coming[k];
    atom->mask[i] = grain.mask;
    std::array<int, 2> periods = {0, 0};
    for (int axis = 0; axis < 2; ++axis) {
      const int first = first_[axis], place = place_of(x[axis], axis);
      const int period = period_of(first);
      periods[axis] = place >= place_in_box(first) ? period : period + 1;
    }
    atom->image[i] = image_of(periods[0], periods[1]);
    for (int c = 0; c < 3; ++c) atom->v[i][c] = atom->omega[i][c] = 0.0;
    atom->radius[i] = grain.radius;
    atom->rmass[i] = grain.mass;
    atom->density[i] = grain.density;
    for (int f = 0; f < modify->nfix; ++f)
      if (modify->fix[f]->create_attribute) modify->fix[f]->set_arrays(i);
    pairs.assign(1, as_double(0));
    add_contacts(k, coming, pairs);
    add_contacts(k, there, pairs);
    if (history != nullptr && pairs.size() > 1) history->unpack_exchange(i, pairs.data());
    std::size_t at = 0;
    for (Fix* const plane : planes)
      for (int c = 0; c < plane->size_peratom_cols && at < grain.planes.size(); ++c)
        plane->array_atom[i][c] = grain.planes[at++];
    changes.inserted += energy_of(i);
    changes.added += 1.0;
    changes.added_mass += grain.mass;
  }
}

double FixBedFollow::compute_vector(int i) {
  const std::array<double, 4> all = {sum_.added, sum_.added_mass, sum_.removed, sum_.removed_mass};
  return all.at(static_cast<std::size_t>(i));
}

void FixBedFollow::write_restart(FILE* file) {
  if (comm->me != 0) return;
  std::vector<double> state = {static_cast<double>(first_[0]),
                               static_cast<double>(first_[1]),
                               static_cast<double>(held_[0]),
                               static_cast<double>(held_[1]),
                               sum_.added,
                               sum_.added_mass,
                               sum_.removed,
                               sum_.removed_mass};
  const std::vector<double> bed = packed();
  state.insert(state.end(), bed.begin(), bed.end());
  const int size = static_cast<int>(state.size() * sizeof(double));
  std::fwrite(&size, sizeof(int), 1, file);
  std::fwrite(state.data(), sizeof(double), state.size(), file);
}

void FixBedFollow::restart(char* buffer) {
  double head[11];  // with the head of the bed
  std::memcpy(head, buffer, sizeof(head));
  first_ = {static_cast<int>(head[0]), static_cast<int>(head[1])};
  held_ = {static_cast<int>(head[2]), static_cast<int>(head[3])};
  sum_.added = head[4], sum_.added_mass = head[5], sum_.removed = head[6], sum_.removed_mass = head[7];
  std::vector<double> bed(static_cast<std::size_t>(head[10]) + 3);
  std::memcpy(bed.data(), buffer + 8 * sizeof(double), bed.size() * sizeof(double));
  unpack(bed.data());
}

}  // namespace LAMMPS_NS
