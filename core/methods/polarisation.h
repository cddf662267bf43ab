#pragma once
// Whether light is polarised (shaders/physics/polarisation.glsl), for the methods whose light scatters more than once
// with its direction.

#include "core/scene/parameters.h"
#include "core/stage/stage.h"

namespace airlight {

inline ParameterInfo polarisation_parameter() {
  return parameter::on_or_off("polarisation", true,
                              "whether molecules polarise the light that they scatter, which changes the brightness of "
                              "what is scattered again; false: scalar light");
}

// Of a method that has the parameter.
inline bool polarises(const Part& part) {
  return part.scene.render.get<bool>("polarisation");
}

}  // namespace airlight
