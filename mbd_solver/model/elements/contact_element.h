#pragma once
// The contact of a body with the ground, a plane or walls, or of two bodies: what outputs and checks read from every kind.

#include <initializer_list>
#include <string_view>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/model/force_element.h"

namespace footfall {

// In the order in which their loads on a body are added. The name is the active part's in summary.json.
enum class ContactKind { kPlane, kTerrain, kSoil, kSurface };
constexpr std::string_view name_of(ContactKind kind) { return name_in(kind, "plane", "plane", "soil", "contacts"); }

// Dissipations that contacts of one kind alone have: history.csv has their columns in scenes with such a contact.
struct OwnDissipation {
  ContactKind kind;
  Dissipation dissipation;
};
inline constexpr std::initializer_list<OwnDissipation> kOwnDissipations = {
    {ContactKind::kSoil, Dissipation::kSoil}, {ContactKind::kSoil, Dissipation::kSoilInertia}};

// bodies(): a body, and the other body or kGround.
class ContactElement : public ForceElement {
 public:
  using ForceElement::ForceElement;

  virtual ContactKind kind() const = 0;
  // Force on the first body [N] and moment about its Bo [N m], in W. The other one takes the opposite at the same points.
  virtual Eigen::Matrix<double, 6, 1> wrench(const ElementInput& in) const = 0;
  // [m], 0 without contact. On a soil: depth of the middle of a facet below the undisturbed ground.
  virtual double largest_overlap(const ElementInput& in) const = 0;
};

}  // namespace footfall
