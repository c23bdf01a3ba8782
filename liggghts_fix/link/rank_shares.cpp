// One walk over the members for each purpose: count, append, clear, add.

#include "liggghts_fix/link/rank_shares.h"

#include <algorithm>

namespace footfall {
namespace {

template <class Visit>
void for_each_number(double& number, const Visit& visit) {
  visit(number);
}
template <class Visit>
void for_each_number(const double& number, const Visit& visit) {
  visit(number);
}
template <class Visit>
void for_each_number(std::int64_t& count, const Visit& visit) {
  auto number = static_cast<double>(count);
  visit(number);
  count = static_cast<std::int64_t>(number);
}
template <class Visit>
void for_each_number(const std::int64_t& count, const Visit& visit) {
  visit(static_cast<double>(count));
}
template <class Matrix, class Visit>
void for_each_number(Matrix& matrix, const Visit& visit) {
  for (Eigen::Index i = 0; i < matrix.size(); ++i) visit(matrix.data()[i]);
}

}  // namespace

std::size_t share_size(const BodyLoad& load) {
  std::size_t size = 0;
  visit_shares(load, [&](const auto& member, Combine) { for_each_number(member, [&](double) { ++size; }); });
  return size;
}

void append_share(const BodyLoad& share, std::vector<double>& row) {
  visit_shares(share, [&](const auto& member, Combine) {
    for_each_number(member, [&](double number) { row.push_back(number); });
  });
}

void clear(BodyLoad& load) {
  visit_shares(load, [](auto& member, Combine) { for_each_number(member, [](double& number) { number = 0.0; }); });
}

const double* add_share(const double* row, BodyLoad& load) {
  visit_shares(load, [&](auto& member, Combine combine) {
    for_each_number(member, [&](double& number) {
      switch (combine) {
        case Combine::kSum: number += *row; break;
        case Combine::kLargest: number = std::max(number, *row); break;
      }
      ++row;
    });
  });
  return row;
}

}  // namespace footfall
