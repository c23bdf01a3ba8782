#pragma once
// Which keys belong to each kind of joint, spring, drive, controller and signal, for the pages of the reference:
//
//   { "joints": { "revolute": { "required": ["axis"], "optional": ["angle"] }, ... }, "springs": { ... }, ... }
//
// It is made of what the checks of a scene know (joint_spec.h, kind_keys.h). Keys that every kind has (name, bodies,
// points ...) are not in it. `footfall schema` writes it as "x-kinds".

#include "mbd_solver/scene/field_json.h"

namespace footfall {

Json kind_schema();

}  // namespace footfall
