#pragma once
// In which order a rank holds its elements of a mesh after a restart file is read.

#include <vector>

namespace footfall {

// The file holds the elements of rank 0, then those of rank 1, ... Each rank reads all of them and deletes those that are
// not its own, from the first on; the last of the list takes the place of one that is deleted. Returns for every place
// which of this rank's elements comes there. before, after: elements of lower and of higher ranks.
std::vector<int> order_after_restart(int before, int own, int after);

}  // namespace footfall
