#pragma once
// Where a grain and a wall are apart, LIGGGHTS' cohesion easo/capillary/viscous reads the velocity of the wall as that of an atom:
// atom->v[j] with j = -type, a place before the array. While a WallAsAtom lives, this place exists and holds the velocity of the wall.
// Of the atoms only number i is there: the one that the contact model is asked about.

#include <cstddef>
#include <vector>

namespace footfall {

class WallAsAtom {
 public:
  // array: Atom::v; rows: memory that is kept from contact to contact; wall: 3 numbers [m/s].
  WallAsAtom(double**& array, std::vector<double*>& rows, int i, int type, double* wall)
      : array_(array), before_(array) {
    const std::size_t last = static_cast<std::size_t>(i) + static_cast<std::size_t>(type);
    if (rows.size() <= last) rows.resize(2 * last + 1);
    double** const first = rows.data() + type;
    first[i] = array[i];
    first[-type] = wall;
    array_ = first;
  }
  ~WallAsAtom() { array_ = before_; }
  WallAsAtom(const WallAsAtom&) = delete;
  WallAsAtom& operator=(const WallAsAtom&) = delete;

 private:
  double**& array_;
  double** const before_;
};

}  // namespace footfall
