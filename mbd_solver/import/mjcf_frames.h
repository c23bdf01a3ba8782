#pragma once
// The elements <frame> and <replicate> of MJCF, which later versions have than that of the library: what they hold is put into
// their body, placed, named and of the class that they give. mujoco.readthedocs.io, XML Reference: frame, replicate.

#include <functional>

#include "mbd_solver/import/xml_source.h"

namespace footfall {

// mujoco: the root. origin: of an element; copied(copy, of): is told of every element that is made. Throws InputError.
void resolve_frames(pugi::xml_node mujoco, const std::function<Origin(const pugi::xml_node&)>& origin,
                    const std::function<void(const pugi::xml_node&, const pugi::xml_node&)>& copied);

}  // namespace footfall
