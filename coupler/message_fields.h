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
inline constexpr auto kFields<Hello> =
    std::tuple{HeadField{"protocol", &Hello::protocol, &MessageHead::protocol},
               Field{"footfall_version", &Hello::footfall_version}, Field{"unit_style", &Hello::unit_style}};

template <>
inline constexpr auto kFields<Geometry> =
    std::tuple{Field{"footfall_version", &Geometry::footfall_version}, Field{"bodies", &Geometry::bodies},
               Field{"resume", &Geometry::resume}};

template <>
inline constexpr auto kFields<CoupledBody> =
    std::tuple{Field{"boundary", &CoupledBody::boundary}, Field{"initial", &CoupledBody::initial}};

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
inline constexpr auto kFields<BoundaryParts> = std::tuple{Field{"name", &BoundaryParts::name},
                                                          Field{"rho0", &BoundaryParts::rho0},
                                                          Field{"triangles", &BoundaryParts::triangles},
                                                          Field{"segments", &BoundaryParts::segments},
                                                          Field{"Phi", &BoundaryParts::Phi},
                                                          Field{"Psi", &BoundaryParts::Psi}};

template <>
inline constexpr auto kFields<BeamSegment> =
    std::tuple{Field{"start", &BeamSegment::start}, Field{"end", &BeamSegment::end},
               Field{"radius", &BeamSegment::radius}, Field{"chain", &BeamSegment::chain}};

template <>
inline constexpr auto kFields<BodyMotion> =
    std::tuple{Field{"r", &BodyMotion::r},     Field{"L", &BodyMotion::L},   Field{"a", &BodyMotion::a},
               Field{"dr", &BodyMotion::dr},   Field{"w", &BodyMotion::w},   Field{"da", &BodyMotion::da},
               Field{"ddr", &BodyMotion::ddr}, Field{"dw", &BodyMotion::dw}, Field{"dda", &BodyMotion::dda}};

template <>
inline constexpr auto kFields<StaticWall> =
    std::tuple{Field{"name", &StaticWall::name}, Field{"corners", &StaticWall::corners},
               Field{"point", &StaticWall::point}, Field{"normal", &StaticWall::normal}};

template <>
inline constexpr auto kFields<Start> = std::tuple{Field{"dt", &Start::dt},
                                                  Field{"n", &Start::n},
                                                  Field{"step", &Start::step},
                                                  Field{"bodies", &Start::bodies},
                                                  Field{"gravity", &Start::gravity},
                                                  Field{"gravity_known", &Start::gravity_known},
                                                  Field{"may_end_early", &Start::may_end_early},
                                                  Field{"warnings", &Start::warnings},
                                                  Field{"requires_masses", &Start::requires_masses},
                                                  Field{"dem_version", &Start::dem_version},
                                                  Field{"walls", &Start::walls}};

template <>
inline constexpr auto kFields<Accept> = std::tuple{Field{"scheme", &Accept::scheme},
                                                   Field{"t_end", &Accept::t_end},
                                                   Field{"n_max", &Accept::n_max},
                                                   Field{"patience", &Accept::patience},
                                                   Field{"held_by_walls", &Accept::held_by_walls},
                                                   Field{"gravity", &Accept::gravity},
                                                   Field{"gravity_known", &Accept::gravity_known},
                                                   Field{"outflow", &Accept::outflow}};

template <>
inline constexpr auto kFields<Motion> = std::tuple{Field{"window", &Motion::window},
                                                   Field{"time", &Motion::time},
                                                   Field{"n", &Motion::n},
                                                   Field{"last_window", &Motion::last_window},
                                                   Field{"checkpoint", &Motion::checkpoint},
                                                   Field{"undisturbed", &Motion::undisturbed},
                                                   Field{"closing", &Motion::closing},
                                                   Field{"bodies", &Motion::bodies},
                                                   Field{"paths", &Motion::paths},
                                                   Field{"inverse_masses", &Motion::inverse_masses}};

template <>
inline constexpr auto kFields<Load> = std::tuple{Field{"window", &Load::window},
                                                 Field{"particles", &Load::particles},
                                                 Field{"lost", &Load::lost},
                                                 Field{"changes", &Load::changes},
                                                 Field{"warnings", &Load::warnings},
                                                 Field{"end_requested", &Load::end_requested},
                                                 Field{"wall_seconds", &Load::wall_seconds},
                                                 Field{"waited_seconds", &Load::waited_seconds},
                                                 Field{"bodies", &Load::bodies},
                                                 Field{"gone_walls", &Load::gone_walls}};

template <>
inline constexpr auto kFields<GrainChanges> =
    std::tuple{Field{"inserted", &GrainChanges::inserted},     Field{"left", &GrainChanges::left},
               Field{"changed", &GrainChanges::changed},       Field{"lost_mass", &GrainChanges::lost_mass},
               Field{"added", &GrainChanges::added},           Field{"removed", &GrainChanges::removed},
               Field{"added_mass", &GrainChanges::added_mass}, Field{"removed_mass", &GrainChanges::removed_mass}};

template <>
inline constexpr auto kFields<ForcePeak> =
    std::tuple{Field{"force", &ForcePeak::force}, Field{"step", &ForcePeak::step}, Field{"steps", &ForcePeak::steps}};

template <>
inline constexpr auto kFields<BodyLoad> =
    std::tuple{Field{"mean", &BodyLoad::mean},
               Field{"contacts", &BodyLoad::contacts},
               Field{"mean_contacts", &BodyLoad::mean_contacts},
               Field{"contact_stiffness", &BodyLoad::contact_stiffness},
               Field{"max_overlap_over_radius", &BodyLoad::max_overlap_over_radius},
               Field{"max_patch_over_facet", &BodyLoad::max_patch_over_facet},
               Field{"grain_energy", &BodyLoad::grain_energy},
               Field{"grain_mass", &BodyLoad::grain_mass},
               Field{"grain_omega2", &BodyLoad::grain_omega2},
               Field{"peak", &BodyLoad::peak},
               Field{"tangent", &BodyLoad::tangent}};

template <>
inline constexpr auto kFields<MeanLoad> = std::tuple{Field{"F_W", &MeanLoad::F_W},
                                                     Field{"T_B", &MeanLoad::T_B},
                                                     Field{"Q_a", &MeanLoad::Q_a},
                                                     Field{"work", &MeanLoad::work},
                                                     Field{"jump_work", &MeanLoad::jump_work},
                                                     Field{"impulse_W", &MeanLoad::impulse_W}};

template <>
inline constexpr auto kFields<ContactTangent> =
    std::tuple{Field{"K", &ContactTangent::K}, Field{"C", &ContactTangent::C}};

template <>
inline constexpr auto kFields<CheckpointDone> =
    std::tuple{Field{"window", &CheckpointDone::window}, Field{"step", &CheckpointDone::step},
               Field{"done", &CheckpointDone::done}};

template <>
inline constexpr auto kFields<Close> =
    std::tuple{HeadField{"status", &Close::status, &MessageHead::status}, Field{"reason", &Close::reason}};

}  // namespace footfall
