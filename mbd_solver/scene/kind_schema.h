#pragma once
// The keys of each kind of joint, spring, drive, controller and signal, for the reference pages:
//
//   { "joints": { "revolute": { "required": ["axis"], "optional": ["angle"] }, ... }, "springs": { ... }, ... }
//
// It is made of joint_spec.h and kind_keys.h, as the checks of a scene are. Keys of every kind (name, bodies, points ...) are
// omitted. `footfall schema` writes it as "x-kinds".

#include "mbd_solver/scene/field_json.h"

namespace footfall {

Json kind_schema();

}  // namespace footfall
