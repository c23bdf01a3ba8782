#pragma once
// How soft a sphere's contact with a round beam is beside that with a plane. theory 6.2.

namespace footfall {

// Force at the same overlap over that of Hertz' sphere on a plane, of a sphere of radius r [m] on a beam of radius
// R [m] of the same materials.
//   side, a cylinder: principal radii r along the beam, rho = r R / (r + R) across; the contact is an ellipse,
//     F = 4/3 E* sqrt(R_e) (overlap / F2)^(3/2),  R_e = sqrt(r rho),  F2 = 1 - ((r/rho)^0.0684 - 1)^1.531  [Hale 1999]
//   end, a sphere of radius R: F = 4/3 E* sqrt(rho) overlap^(3/2)
// The closed form of F2 stands for Hertz' elliptic integrals; the force errs by less than 0.6 % for R > r / 50.
double hertz_on_side(double r, double R);
double hertz_on_end(double r, double R);

// LIGGGHTS' moduli E* and G* of one pair of types, times a share as long as this lives. The model's k_n and k_t are
// proportional to them and its dampings to their roots, as with a smaller radius of contact.
class Softened {
 public:
  Softened(double** young, double** shear, int grain, int wall, double share)
      : young_(share == 1.0 ? unused_ : young[grain][wall]),
        shear_(share == 1.0 ? unused_ : shear[grain][wall]),
        young_was_(young_),
        shear_was_(shear_) {
    young_ *= share;
    shear_ *= share;
  }
  ~Softened() {
    young_ = young_was_;
    shear_ = shear_was_;
  }
  Softened(const Softened&) = delete;
  Softened& operator=(const Softened&) = delete;

 private:
  double unused_ = 0.0;  // in their place where nothing changes: without `curvature yes` they are not known
  double& young_;
  double& shear_;
  double young_was_, shear_was_;  // [Pa]
};

}  // namespace footfall
