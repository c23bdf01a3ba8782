#pragma once
// How wide the facets of a mesh are where it is curved. LIGGGHTS lets a grain touch each facet that it overlaps. On a
// plane it counts neighbours once; on a curved surface facets narrower than the grain's patch, of radius
// sqrt(2 R overlap), add up.

#include <Eigen/Dense>
#include <vector>

#include "liggghts_fix/mesh_match.h"

namespace footfall {

// Smallest height [m] of each triangle that meets a neighbour at an angle between 0.26 and 60 degrees; infinity for the
// others, which are flat or end at an edge. rho0 [m]: nodes, 3 x N; corners: nodes of the triangles.
std::vector<double> curved_facet_widths(const Eigen::Matrix3Xd& rho0, const std::vector<CornerNodes>& corners);

}  // namespace footfall
