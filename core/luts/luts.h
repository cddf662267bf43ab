#pragma once
// The passes that bake each table. A table depends on the air, the planet and its own size alone, never on the sun's
// place or the camera, and is kept from plan to plan under a key that says so.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/air/air.h"
#include "core/plan/plan.h"

namespace airlight {

// Transmittance to the top of the atmosphere, x: mu, y: h [B08], both non-linear; alpha is 1.
ImageId add_transmittance(Plan& plan, const Air& air, TableSize size);

// A table of sunlight for air that bends light, of twice the height: below it that of seen directions (tables.glsl).
// `size`: of each. `shader` writes to `out`.
struct BentTable {
  std::string name;
  const char* shader;
  const char* out;
  std::function<TableText()> text;
};
ImageId add_bent_sunlight(Plan& plan, const Air& air, TableSize size, const BentTable& table,
                          std::vector<Specialization> constants);

// The text for such a table from that for its upper half.
TableText in_lower_half_too(TableText text);

// The air's planet, with its optical radius and height where the air bends light.
Planet optical_planet(const Air& air);

// Isotropic multiple scattering for a sun of irradiance 1, 1/sr, x: mu_sun by its signed square
// root, y: h, linear [H20].
ImageId add_multiple_scattering(Plan& plan, const Air& air, ImageId transmittance, TableSize size);

// Sky irradiance on level ground for a sun of irradiance 1, x: (1 + mu_sun)/2. Only a ground that reflects needs it.
ImageId add_ground_irradiance(Plan& plan, const Air& air, ImageId transmittance, ImageId multiple_scattering);

// A key that changes with everything that a table may depend on: air, planet, the table's own name and size, and the
// sizes of the tables that it is made from.
std::string table_key(const Air& air, std::string_view table, TableSize size, std::span<const Extent> sources = {});

// The specialisation constants that every pass of shaders/shared/device.glsl takes, and those that also fetch sunlight
// from the transmittance table of this plan.
std::vector<Specialization> medium_specialization(const Air& air);
std::vector<Specialization> sunlight_specialization(const Plan& plan, const Air& air, ImageId transmittance);

// The constants of a table's text that most maps need: ground_radius_km and top_km.
std::string planet_constants(const Planet& planet);

// For passes that fetch the multiple-scattering table.
void add_scattering_size(std::vector<Specialization>& constants, const Plan& plan, ImageId multiple_scattering);

}  // namespace airlight
