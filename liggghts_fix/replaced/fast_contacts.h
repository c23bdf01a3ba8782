#pragma once
// Contacts in single precision. A grain is one line of the cache, from which a contact takes eight numbers; eight contacts
// are transposed into rows for the contact models, and their results back into records.

#include "liggghts_fix/replaced/contact_kernel.h"

namespace footfall {

// Eight numbers of a record, or of a row.
using Eight = float __attribute__((vector_size(32), may_alias));

// Rows of eight records of eight numbers, or the reverse.
FOOTFALL_INLINE void transpose(Eight (&m)[8]) {
  Eight pairs[8], fours[8];
  for (int r = 0; r < 8; r += 2) {
    pairs[r] = __builtin_shufflevector(m[r], m[r + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    pairs[r + 1] = __builtin_shufflevector(m[r], m[r + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (int r = 0; r < 8; r += 4) {
    for (int h = 0; h < 2; ++h) {
      fours[r + 2 * h] = __builtin_shufflevector(pairs[r + h], pairs[r + h + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      fours[r + 2 * h + 1] = __builtin_shufflevector(pairs[r + h], pairs[r + h + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (int r = 0; r < 4; ++r) {
    m[r] = __builtin_shufflevector(fours[r], fours[r + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    m[r + 4] = __builtin_shufflevector(fours[r], fours[r + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

// A grain, as the fast pair forces read it: one line of the cache.
struct alignas(64) FastGrain {
  double x[3], radius;
  Eight motion;  // v, omega, radius, mass
};

// Contacts in single precision: a record of eight numbers for each, and rows for their forces.
struct FastContacts {
  ContactRows<float> rows;
  struct alignas(32) Record {
    float delta[3], excess, shear[3], zero;
  };
  Record record[kMost];  // shear: of the last step, then of this one
  const Eight *motion_i[kMost], *motion_j[kMost];
  Eight load_i[kMost], load_j[kMost];  // force, torque, 0, 0
  int count = 0;

  static Eight& row(float* from, int k) { return *reinterpret_cast<Eight*>(from + k); }
  FOOTFALL_INLINE void to_rows() {
    for (int k = 0; k < count; k += 8) {
      Eight i[8], j[8], both[8];
      for (int r = 0; r < 8; ++r) {
        i[r] = *motion_i[k + r];
        j[r] = *motion_j[k + r];
        both[r] = reinterpret_cast<const Eight&>(record[k + r]);
      }
      transpose(i);
      transpose(j);
      transpose(both);
      for (int a = 0; a < 3; ++a) {
        row(rows.delta[a], k) = both[a];
        row(rows.shear[a], k) = both[4 + a];
        row(rows.velocity[a], k) = i[a] - j[a];
        row(rows.spin_i[a], k) = i[3 + a];
        row(rows.spin_j[a], k) = j[3 + a];
      }
      row(rows.square, k) = both[0] * both[0] + both[1] * both[1] + both[2] * both[2];
      row(rows.excess, k) = both[3];
      row(rows.radius_i, k) = i[6];
      row(rows.radius_j, k) = j[6];
      row(rows.mass_i, k) = i[7];
      row(rows.mass_j, k) = j[7];
    }
    rows.count = count;
  }
  FOOTFALL_INLINE void to_records() {
    for (int k = 0; k < count; k += 8) {
      Eight i[8] = {}, j[8] = {}, both[8] = {};
      for (int a = 0; a < 3; ++a) {
        i[a] = row(rows.force[a], k);
        j[a] = -i[a];
        i[3 + a] = row(rows.torque_i[a], k);
        j[3 + a] = row(rows.torque_j[a], k);
        both[4 + a] = row(rows.shear[a], k);
      }
      transpose(i);
      transpose(j);
      transpose(both);
      for (int r = 0; r < 8; ++r) {
        load_i[k + r] = i[r];
        load_j[k + r] = j[r];
        reinterpret_cast<Eight&>(record[k + r]) = both[r];
      }
    }
  }
};

FOOTFALL_INLINE void compute_any(FastContacts& c, double step, const Model& m) {
  c.to_rows();
  compute_any(c.rows, step, m);
  c.to_records();
}

}  // namespace footfall
