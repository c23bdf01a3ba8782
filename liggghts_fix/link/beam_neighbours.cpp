// A binary tree of boxes over the segments of the chain; each grain descends into the boxes near it.

#include "liggghts_fix/link/beam_neighbours.h"

#include <algorithm>
#include <cmath>
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
  image_.clear();
  first_.assign(1, 0);

  // Far from all grains: done. Grains stay within skin/2 of their positions when their box was computed.
  Eigen::AlignedBox3d chain_box;
  for (int node = 0; node < chain.node_count(); ++node) chain_box.extend(Eigen::Vector3d(chain.x().col(node)));
  const double far = chain.largest_radius() + 1.5 * skin_ + reach_ * extent_.largest_radius;
  clearance_ = extent_.box.isEmpty() ? std::numeric_limits<double>::infinity() : find_images(chain_box, far) - far;
  if (clearance_ > 0.0) return;
  clearance_ = 0.0;

  box_.resize(4 * static_cast<std::size_t>(chain.segment_count()));
  build_boxes(chain, 0, 0, chain.segment_count());
  for (int i = 0; i < grains.count; ++i) {
    if (!takes_part(grains, i)) continue;
    for (std::size_t image = 0; image < images_.size(); ++image) {
      collect(chain, 0, 0, chain.segment_count(), place(grains, i) - images_[image], grains.radius[i]);
      image_.resize(segment_.size(), static_cast<int>(image));
    }
    if (static_cast<int>(segment_.size()) == first_.back()) continue;
    grain_.push_back(i);
    first_.push_back(static_cast<int>(segment_.size()));
  }
}

double BeamNeighbours::find_images(const Eigen::AlignedBox3d& chain_box, double far) {
  // From the last image before the grains to the first one after them.
  Eigen::Vector3i first = Eigen::Vector3i::Zero(), last = Eigen::Vector3i::Zero();
  for (int d = 0; d < 3; ++d) {
    if (periods_[d] == 0.0) continue;
    first[d] = static_cast<int>(std::floor((extent_.box.min()[d] - chain_box.max()[d]) / periods_[d]));
    last[d] = static_cast<int>(std::ceil((extent_.box.max()[d] - chain_box.min()[d]) / periods_[d]));
  }
  images_.clear();
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = first[0]; i <= last[0]; ++i)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int k = first[2]; k <= last[2]; ++k) {
        const Eigen::Vector3d image = Eigen::Vector3d(i, j, k).cwiseProduct(periods_);
        const double distance = chain_box.translated(image).exteriorDistance(extent_.box);
        nearest = std::min(nearest, distance);
        if (distance <= far) images_.push_back(image);
      }
  return nearest;
}

void BeamNeighbours::build_boxes(const BeamChain& chain, int box, int first, int last) {
  Eigen::AlignedBox3d& here = box_[box];
  here.setEmpty();
  if (last - first == 1) {
    const BeamSegment& s = chain.segments()[first];
    const Eigen::Vector3d R = Eigen::Vector3d::Constant(s.radius);
    for (const int node : {s.start, s.end})
      here.extend(Eigen::AlignedBox3d(chain.x().col(node) - R, chain.x().col(node) + R));
    return;
  }
  const int middle = (first + last) / 2;
  build_boxes(chain, 2 * box + 1, first, middle);
  build_boxes(chain, 2 * box + 2, middle, last);
  here.extend(box_[2 * box + 1]);
  here.extend(box_[2 * box + 2]);
}

void BeamNeighbours::collect(const BeamChain& chain, int box, int first, int last, const Eigen::Vector3d& x, double r) {
  ++box_tests_;
  const double margin = 1.5 * skin_ + reach_ * r;
  const double limit = r + margin;
  if (box_[box].squaredExteriorDistance(x) > limit * limit) return;
  if (last - first == 1) {
    if (chain.touch(first, x, r).gap <= margin) segment_.push_back(first);
    return;
  }
  const int middle = (first + last) / 2;
  collect(chain, 2 * box + 1, first, middle, x, r);
  collect(chain, 2 * box + 2, middle, last, x, r);
}

BeamTouch BeamNeighbours::closest(const BeamChain& chain, int k, const Eigen::Vector3d& x, double r) const {
  const int first = first_[k];
  const int last = first_[static_cast<std::size_t>(k) + 1];
  FOOTFALL_DEMAND(first < last);
  const auto touch_of = [&](int pair) {
    const Eigen::Vector3d& image = images_[image_[pair]];
    BeamTouch touch = chain.touch(segment_[pair], x - image, r);
    touch.image = image;
    return touch;
  };
  BeamTouch best = touch_of(first);
  for (int pair = first + 1; pair < last; ++pair) {
    const BeamTouch other = touch_of(pair);
    if (other.gap < best.gap) best = other;
  }
  return best;
}

}  // namespace footfall
