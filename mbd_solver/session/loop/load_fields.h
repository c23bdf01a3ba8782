#pragma once
// Loads and inputs in an archive.

#include "coupler/base/field_list.h"
#include "mbd_solver/dynamics/equations.h"

namespace footfall {

template <>
inline constexpr auto kFields<TangentLoad> =
    std::tuple{Field{"K", &TangentLoad::K}, Field{"C", &TangentLoad::C}, Field{"r_mean", &TangentLoad::r_mean},
               Field{"L_mean", &TangentLoad::L_mean}, Field{"v_mean", &TangentLoad::v_mean}};

template <>
inline constexpr auto kFields<ExternalLoad> =
    std::tuple{Field{"F_W", &ExternalLoad::F_W}, Field{"T_B", &ExternalLoad::T_B}, Field{"Q_a", &ExternalLoad::Q_a},
               Field{"tangent", &ExternalLoad::tangent}};

template <>
inline constexpr auto kFields<Inputs> = std::tuple{Field{"loads", &Inputs::loads}, Field{"values", &Inputs::values}};

}  // namespace footfall
