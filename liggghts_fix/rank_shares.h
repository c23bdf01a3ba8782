#pragma once
// The grains that touch a body belong to several ranks: each knows its share of the body's load. At the end of a window
// every rank gets the shares of all, one row of numbers per rank, and puts them together to the load of the window.
//
// visit_shares is the one description of such a row; its size, writing and adding up follow from it.

#include <cstddef>
#include <vector>

#include "coupler/messages.h"

namespace footfall {

enum class Together { kSum, kLargest };

// Calls visit(member, how the ranks' values of it come together) for every member of the load. `Load`: BodyLoad, const
// or not. A member that is new and not named here does not compile.
template <class Load, class Visit>
void visit_shares(Load& load, const Visit& visit) {
  auto& [mean, contacts, mean_contacts, contact_stiffness, max_overlap_over_radius, max_patch_over_facet, tangent] =
      load;
  auto& [F_W, T_B, Q_a, work, jump_work, impulse_W] = mean;
  visit(F_W, Together::kSum);
  visit(T_B, Together::kSum);
  visit(Q_a, Together::kSum);
  visit(work, Together::kSum);
  visit(jump_work, Together::kSum);
  visit(impulse_W, Together::kSum);
  visit(contacts, Together::kSum);
  visit(mean_contacts, Together::kSum);
  visit(contact_stiffness, Together::kSum);
  visit(max_overlap_over_radius, Together::kLargest);
  visit(max_patch_over_facet, Together::kLargest);
  for (auto& [K, C] : tangent) {
    visit(K, Together::kSum);
    visit(C, Together::kSum);
  }
}

// Numbers in a row. All loads of one body have the same modes and as many tangents.
std::size_t share_size(const BodyLoad& load);
// Appends this rank's share to its row.
void append_share(const BodyLoad& share, std::vector<double>& row);
// A load that nothing was added to; modes and number of tangents stay.
void clear(BodyLoad& load);
// Adds the share that begins at `row` and returns where the next one begins.
const double* add_share(const double* row, BodyLoad& load);

}  // namespace footfall
