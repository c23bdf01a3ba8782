#pragma once
// What the boundary of one body does in the grains during a window, known here without being told: the grains' side
// walks the same path.

#include "coupler/schemes/scheme.h"
#include "coupler/window.h"

namespace footfall {

// Scheme `tangent` needs the means of the path: the mean load belongs to them, and with the path itself instead of its
// mean the scheme is unstable. The choice of windows needs the gap between computed and predicted motion.
class PredictedWindow {
 public:
  // The scheme must outlive this. The boundary stands at `initial` until the first window.
  PredictedWindow(const Scheme& scheme, const BodyMotion& initial);

  // A window of n substeps of dt [s] begins with the motion that is sent, `start`.
  void begin(const BodyMotion& start, int n, double dt);
  const PredictedPath& path() const { return path_; }
  void visit(Archive& archive) { walk_.visit(archive); }  // between two windows

 private:
  const Scheme& scheme_;
  BoundaryPath walk_;
  PredictedPath path_;
};

}  // namespace footfall
