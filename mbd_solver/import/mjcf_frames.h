#pragma once
// The elements <frame> and <replicate> of later versions of MJCF than the library's: their contents are put into their
// body, with the placement, names and classes that they define. mujoco.readthedocs.io, XML Reference: frame, replicate.

#include <functional>

#include "mbd_solver/import/xml_source.h"

namespace footfall {

// mujoco: the root. origin: of an element; copied(copy, of): called for every new element. Throws InputError.
void resolve_frames(pugi::xml_node mujoco, const std::function<Origin(const pugi::xml_node&)>& origin,
                    const std::function<void(const pugi::xml_node&, const pugi::xml_node&)>& copied);

}  // namespace footfall
