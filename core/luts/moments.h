#pragma once
// The table of radiance moments by successive orders of scattering (shaders/physics/moments.glsl), for a sun of
// irradiance 1. It depends on the air and the planet alone: a whole day uses one bake.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/air/air.h"
#include "core/plan/plan.h"

namespace airlight {

// Moments that a bake may fetch in air of up to kUsualMedia, what else a step does counting as some more of them. On
// the software device each takes 2.5 to 9 ns of a processor, these 25 to 90 s. Each step asks every medium, so air of
// more media gets fewer. A level cloud of drops in Earth's air takes half of them, all orders at once.
inline constexpr double kMostBakeFetches = 1e10;
inline constexpr std::size_t kUsualMedia = 3;

struct MomentSettings {
  int degree = 2;                // highest harmonic kept, 0 to 8; orders after the second keep fewer
  bool delta = false;            // forward peaks as unscattered light (forward_peak() of shaders/physics/moments.glsl)
  bool peaked = false;           // forward-peaked media are thick: by shells the first order takes more directions
  int orders = 3;                // computed one by one; the rest is a geometric series
  int wished_orders = 3;         // more than `orders` where those would take kMostBakeFetches
  TableSize size{48, 12};        // sun elevations x altitudes
  int corrections = 0;           // above 0: all orders are found at once, as a field corrected so often
  int level_degree = 0;          // harmonics up to it are corrected as if the air were level (core/luts/level_orders.h)
  bool shells = false;           // rows at the edges of shells (core/air/shells.h)
  bool sharp = false;            // a medium's peak is gathered by a table, which many directions resolve
  bool aloft = false;            // a forward-scattering medium is densest above the ground: from above, a bright line
  int azimuths = 12;             // of half a turn, by which shells gather a peaked first order
  bool polarised = false;        // molecules polarise: P_m beside the harmonics
  bool molecules_alone = false;  // beside them no medium scatters with a direction
  bool hazy = false;             // without shells, and thick enough that light changes within the lowest rows
};

// What is asked of the table.
struct MomentRequest {
  std::optional<int> degree = {};  // else as the air needs
  std::optional<int> orders = {};
  TableSize size{48, 12};
  bool polarised = false;  // where a medium scatters as molecules do
  bool hazy = false;  // as in hazy air, whatever this air is: all wavelengths of a scene have the table of the haziest
};

// The highest degree that clear air has: more is for hazy air and for shells.
inline constexpr int kMostClearDegree = 6;

// What this air needs: degree 2, or where forward-peaked media are thick 5, in hazy air and by shells 8; three orders
// before the tail in thin air, more with the optical depth. By shells, and in hazy air, there are more rows than `size`
// says.
MomentSettings moment_settings(const Air& air, const MomentRequest& request);

// Mean extinction toward the top of the atmosphere (sun_table_mu() x edges of shells): what the passes read in place of
// the transmittance table where the air is cut into shells.
ImageId add_sun_table(Plan& plan, const Air& air, const MomentSettings& settings);

// Bakes all orders; the image holds log M_00, the ratios M_lm / M_00 (of polarised light P_m / M_00, too) and the log
// of the ground's irradiance, in blocks of size[0] columns side by side. `sunlight`: the transmittance table, or the
// sun table.
ImageId add_moments(Plan& plan, const Air& air, ImageId sunlight, const MomentSettings& settings);

// kMomentDegree, kMomentScattered, kMomentPolarised, kDeltaScaled, kMomentColumns, kMomentRows, kShellRows.
void add_moment_constants(std::vector<Specialization>& constants, const MomentSettings& settings);

}  // namespace airlight
