#pragma once
// Nodes that move with a set of others, where a joint acts on a face or in a hole of a solid: fe_model.h, Spider.

#include <Eigen/Sparse>
#include <string>
#include <vector>

#include "mbd_solver/fe/fe_model.h"

namespace footfall {

// Adds a node in front of the others, with all six motions, at the point or at the mean of the set. nodes: indices into the
// model. Throws InputError beginning with `who`: a set on one line (averaged), too large, or with nodes of another one.
void add_spider(FeModel& model, std::vector<int> nodes, SpiderKind kind, const Eigen::Vector3d* point,
                const std::string& who);

// The model in its independent motions: x = T x', with rows of zeros in K' = T^T K T and M' for those that follow.
struct Constrained {
  FeModel model;                  // spiders are none; `follows` is set
  Eigen::SparseMatrix<double> T;  // square
};
Constrained constrained(const FeModel& model);

}  // namespace footfall
