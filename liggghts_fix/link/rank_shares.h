#pragma once
// The grains that touch a body belong to several ranks, each of which knows its share of the body's load. At the end of
// a window every rank gets the shares of all, one row of numbers per rank, and adds them to the load of the window.
//
// visit_shares alone describes such a row; its size, its writing and its addition follow from it.

#include <cstddef>
#include <vector>

#include "coupler/messages.h"

namespace footfall {

enum class Combine { kSum, kLargest };

// Calls visit(member, how to combine the values of the ranks) for every member of the load. Load: BodyLoad, const or not.
// A new member of BodyLoad that is not listed here does not compile.
template <class Load, class Visit>
void visit_shares(Load& load, const Visit& visit) {
  auto& [mean, contacts, mean_contacts, contact_stiffness, max_overlap_over_radius, max_patch_over_facet, grain_energy,
         grain_mass, grain_omega2, peak, tangent] = load;
  auto& [F_W, T_B, Q_a, work, jump_work, impulse_W] = mean;
  visit(F_W, Combine::kSum);
  visit(T_B, Combine::kSum);
  visit(Q_a, Combine::kSum);
  visit(work, Combine::kSum);
  visit(jump_work, Combine::kSum);
  visit(impulse_W, Combine::kSum);
  visit(contacts, Combine::kSum);
  visit(mean_contacts, Combine::kSum);
  visit(contact_stiffness, Combine::kSum);
  visit(max_overlap_over_radius, Combine::kLargest);
  visit(max_patch_over_facet, Combine::kLargest);
  visit(grain_energy, Combine::kLargest);
  visit(grain_mass, Combine::kLargest);
  visit(grain_omega2, Combine::kLargest);
  visit(peak.force, Combine::kLargest);  // DemBody finds the peak of the sum over the ranks
  visit(peak.step, Combine::kLargest);
  visit(peak.steps, Combine::kLargest);
  for (auto& [K, C] : tangent) {
    visit(K, Combine::kSum);
    visit(C, Combine::kSum);
  }
}

// Numbers of a share. All loads of one body have the same numbers of modes and tangents.
std::size_t share_size(const BodyLoad& load);
// Appends this rank's share to its row.
void append_share(const BodyLoad& share, std::vector<double>& row);
// Sets all numbers to zero; modes and number of tangents remain.
void clear(BodyLoad& load);
// Adds the share that begins at `row`, and returns the start of the next one.
const double* add_share(const double* row, BodyLoad& load);

}  // namespace footfall
