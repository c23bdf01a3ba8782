#include "liggghts_fix/beam_neighbours.h"

#include <algorithm>
#include <limits>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

bool takes_part(const GrainView& grains, int i) {
  return grains.mask == nullptr || (grains.mask[i] & grains.group_bit) != 0;
}

Eigen::Vector3d place(const GrainView& grains, int i) { return Eigen::Map<const Eigen::Vector3d>(grains.x[i]); }

}  // namespace

GrainExtent::GrainExtent(const GrainView& grains) {
  for (int i = 0; i < grains.count; ++i) {
    if (!takes_part(grains, i)) continue;
    const Eigen::Vector3d r = Eigen::Vector3d::Constant(grains.radius[i]);
    box.extend(Eigen::AlignedBox3d(place(grains, i) - r, place(grains, i) + r));
    largest_radius = std::max(largest_radius, grains.radius[i]);
  }
}

void BeamNeighbours::grains_renumbered(const GrainExtent& grains) {
  renumbered_ = true;
  extent_ = grains;
}

bool BeamNeighbours::update(const BeamChain& chain, const GrainView& grains) {
  const bool nodes_moved =
      x_build_.cols() == 0 || (chain.x() - x_build_).colwise().squaredNorm().maxCoeff() > 0.25 * skin_ * skin_;
  if (!renumbered_ && !nodes_moved) return false;
  build(chain, grains);
  return true;
}

void BeamNeighbours::build(const BeamChain& chain, const GrainView& grains) {
  ++builds_;
  renumbered_ = false;
  x_build_ = chain.x();
  grain_.clear();
  segment_.clear();
  first_.assign(1, 0);

  // Far from all grains: done. Grains stay within skin/2 of where they stood when their box was made.
  Eigen::AlignedBox3d chain_box;
  for (int node = 0; node < chain.node_count(); ++node) chain_box.extend(Eigen::Vector3d(chain.x().col(node)));
  const double far = chain.largest_radius() + 1.5 * skin_ + reach_ * extent_.largest_radius;
  clearance_ =
      extent_.box.isEmpty() ? std::numeric_limits<double>::infinity() : chain_box.exteriorDistance(extent_.box) - far;
  if (clearance_ > 0.0) return;
  clearance_ = 0.0;

  box_.resize(4 * static_cast<std::size_t>(chain.segment_count()));
  build_boxes(chain, 0, 0, chain.segment_count());
  for (int i = 0; i < grains.count; ++i) {
    if (!takes_part(grains, i)) continue;
    collect(chain, 0, 0, chain.segment_count(), place(grains, i), grains.radius[i]);
    if (static_cast<int>(segment_.size()) == first_.back()) continue;
    grain_.push_back(i);
    first_.push_back(static_cast<int>(segment_.size()));
  }
}

void BeamNeighbours::build_boxes(const BeamChain& chain, int box, int first, int last) {
  Eigen::AlignedBox3d& here = box_[static_cast<std::size_t>(box)];
  here.setEmpty();
  if (last - first == 1) {
    const BeamSegment& s = chain.segments()[static_cast<std::size_t>(first)];
    const Eigen::Vector3d R = Eigen::Vector3d::Constant(s.radius);
    for (const int node : {s.start, s.end})
      here.extend(Eigen::AlignedBox3d(chain.x().col(node) - R, chain.x().col(node) + R));
    return;
  }
  const int middle = (first + last) / 2;
  build_boxes(chain, 2 * box + 1, first, middle);
  build_boxes(chain, 2 * box + 2, middle, last);
  here.extend(box_[static_cast<std::size_t>(2 * box + 1)]);
  here.extend(box_[static_cast<std::size_t>(2 * box + 2)]);
}

void BeamNeighbours::collect(const BeamChain& chain, int box, int first, int last, const Eigen::Vector3d& x, double r) {
  ++box_tests_;
  const double margin = 1.5 * skin_ + reach_ * r;
  const double limit = r + margin;
  if (box_[static_cast<std::size_t>(box)].squaredExteriorDistance(x) > limit * limit) return;
  if (last - first == 1) {
    if (chain.touch(first, x, r).gap <= margin) segment_.push_back(first);
    return;
  }
  const int middle = (first + last) / 2;
  collect(chain, 2 * box + 1, first, middle, x, r);
  collect(chain, 2 * box + 2, middle, last, x, r);
}

BeamTouch BeamNeighbours::closest(const BeamChain& chain, int k, const Eigen::Vector3d& x, double r) const {
  const int first = first_[static_cast<std::size_t>(k)];
  const int last = first_[static_cast<std::size_t>(k) + 1];
  FOOTFALL_DEMAND(first < last);
  BeamTouch best = chain.touch(segment_[static_cast<std::size_t>(first)], x, r);
  for (int pair = first + 1; pair < last; ++pair) {
    const BeamTouch other = chain.touch(segment_[static_cast<std::size_t>(pair)], x, r);
    if (other.gap < best.gap) best = other;
  }
  return best;
}

}  // namespace footfall
