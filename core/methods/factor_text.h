#pragma once
// Description of the picture's table of factors (shaders/physics/sky_table.glsl, space_table.glsl).

#include <cstdint>
#include <string>
#include <vector>

#include "core/plan/table_text.h"
#include "core/scene/scene.h"

namespace airlight {

// The inputs of the description, from scene and table.
struct FactorLayout {
  Planet planet;
  double camera_altitude = 0.0;         // km
  double sun_mu = 0.0;                  // the sun's zenith cosine
  std::vector<std::string> apart = {};  // names of the media with a block of their own, in order
  std::uint32_t columns = 0;
  std::uint32_t ground_rows = 0;
  std::uint32_t limb_rows = 0;
  std::uint32_t sky_rows = 0;  // 0: the camera is above the air
  bool rayleigh = false;       // whether the last block is divided by 1 + nu^2 above the true horizon
  bool stokes = false;         // two blocks more, of Q and U
  bool in_colours = false;     // whether the table is a sum over wavelengths, for a scene with spectra
};

TableText factor_text(const FactorLayout& layout);

}  // namespace airlight
