#pragma once
// The fields of every message, in the order of their bytes. pack, unpack and the tests walk these lists. A change of a
// list changes the bytes: then raise kProtocolVersion.

#include <tuple>

#include "coupler/base/field_list.h"
#include "coupler/messages.h"

namespace footfall {

using AllMessages = std::tuple<Hello, Geometry, Start, Accept, Motion, Load, CheckpointDone, Close>;

// The head of every message, four bytes each: magic, kind, protocol, status. It is the same in all protocol versions.
struct MessageHead {
  std::int32_t protocol = kProtocolVersion;
  Status status = Status::kOk;
};

// A field of a message that is stored in its head.
template <class Message, class Type>
struct HeadField {
  const char* name;
  Type Message::*member;
  Type MessageHead::*in_head;
};
template <class Message, class Type>
HeadField(const char*, Type Message::*, Type MessageHead::*) -> HeadField<Message, Type>;

template <class AnyField>
inline constexpr bool kInHead = false;
template <class Message, class Type>
inline constexpr bool kInHead<HeadField<Message, Type>> = true;

template <>
inline constexpr auto kFields<Hello> = std::tuple_cat(std::tuple{HeadField{"protocol", &Hello::protocol,
                                                                           &MessageHead::protocol}},
                                                      kFieldsOf<&Hello::footfall_version, &Hello::unit_style>);

template <>
inline constexpr auto kFields<Geometry> = kFieldsOf<&Geometry::footfall_version, &Geometry::bodies, &Geometry::resume>;

template <>
inline constexpr auto kFields<CoupledBody> = kFieldsOf<&CoupledBody::boundary, &CoupledBody::initial>;

// The arguments of the constructor of a ModalBoundary.
struct BoundaryParts {
  std::string name;
  Eigen::Matrix3Xd rho0;
  std::vector<Eigen::Vector3i> triangles;
  std::vector<BeamSegment> segments;
  Eigen::MatrixXd Phi, Psi;
};
BoundaryParts parts_of(const ModalBoundary& boundary);
// Throws ProtocolError for parts that make no valid boundary.
ModalBoundary boundary_of(BoundaryParts parts);

template <>
inline constexpr auto kFields<BoundaryParts> =
    kFieldsOf<&BoundaryParts::name, &BoundaryParts::rho0, &BoundaryParts::triangles, &BoundaryParts::segments,
              &BoundaryParts::Phi, &BoundaryParts::Psi>;

template <>
inline constexpr auto kFields<BeamSegment> =
    kFieldsOf<&BeamSegment::start, &BeamSegment::end, &BeamSegment::radius, &BeamSegment::chain>;

template <>
inline constexpr auto kFields<BodyMotion> =
    kFieldsOf<&BodyMotion::r, &BodyMotion::L, &BodyMotion::a, &BodyMotion::dr, &BodyMotion::w, &BodyMotion::da,
              &BodyMotion::ddr, &BodyMotion::dw, &BodyMotion::dda>;

template <>
inline constexpr auto kFields<StaticWall> =
    kFieldsOf<&StaticWall::name, &StaticWall::corners, &StaticWall::point, &StaticWall::normal>;

template <>
inline constexpr auto kFields<Start> =
    kFieldsOf<&Start::dt, &Start::n, &Start::step, &Start::bodies, &Start::gravity, &Start::gravity_known,
              &Start::may_end_early, &Start::warnings, &Start::requires_masses, &Start::dem_version, &Start::walls>;

template <>
inline constexpr auto kFields<Accept> =
    kFieldsOf<&Accept::scheme, &Accept::t_end, &Accept::n_max, &Accept::patience, &Accept::held_by_walls,
              &Accept::gravity, &Accept::gravity_known, &Accept::outflow>;

template <>
inline constexpr auto kFields<Motion> =
    kFieldsOf<&Motion::window, &Motion::time, &Motion::n, &Motion::last_window, &Motion::checkpoint,
              &Motion::undisturbed, &Motion::closing, &Motion::bodies, &Motion::paths, &Motion::inverse_masses>;

template <>
inline constexpr auto kFields<Load> =
    kFieldsOf<&Load::window, &Load::particles, &Load::lost, &Load::changes, &Load::warnings, &Load::end_requested,
              &Load::wall_seconds, &Load::waited_seconds, &Load::bodies, &Load::gone_walls>;

template <>
inline constexpr auto kFields<GrainChanges> =
    kFieldsOf<&GrainChanges::inserted, &GrainChanges::left, &GrainChanges::changed, &GrainChanges::lost_mass,
              &GrainChanges::added, &GrainChanges::removed, &GrainChanges::added_mass, &GrainChanges::removed_mass>;

template <>
inline constexpr auto kFields<ForcePeak> = kFieldsOf<&ForcePeak::force, &ForcePeak::step, &ForcePeak::steps>;

template <>
inline constexpr auto kFields<BodyLoad> =
    kFieldsOf<&BodyLoad::mean, &BodyLoad::contacts, &BodyLoad::mean_contacts, &BodyLoad::contact_stiffness,
              &BodyLoad::max_overlap_over_radius, &BodyLoad::max_patch_over_facet, &BodyLoad::grain_energy,
              &BodyLoad::grain_mass, &BodyLoad::grain_omega2, &BodyLoad::peak, &BodyLoad::tangent>;

template <>
inline constexpr auto kFields<MeanLoad> = kFieldsOf<&MeanLoad::F_W, &MeanLoad::T_B, &MeanLoad::Q_a, &MeanLoad::work,
                                                    &MeanLoad::jump_work, &MeanLoad::impulse_W>;

template <>
inline constexpr auto kFields<ContactTangent> = kFieldsOf<&ContactTangent::K, &ContactTangent::C>;

template <>
inline constexpr auto kFields<CheckpointDone> =
    kFieldsOf<&CheckpointDone::window, &CheckpointDone::step, &CheckpointDone::done>;

template <>
inline constexpr auto kFields<Close> =
    std::tuple_cat(std::tuple{HeadField{"status", &Close::status, &MessageHead::status}}, kFieldsOf<&Close::reason>);

}  // namespace footfall
