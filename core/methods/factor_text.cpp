#include "core/methods/factor_text.h"

#include <string>

namespace airlight {
namespace {

// The rows of a camera in the air, or, from space, of one at its top.
constexpr const char* kRows = R"(block = floor(i / columns)
x = (i - columns * block) / (columns - 1)
horizon_km = sqrt(eye_km * (2 * ground_radius_km + eye_km))
near_km = maximum(eye_km, 1e-5)
ground_y = clip(j / (ground_rows - 1), 0, 1)
limb_y = (j - ground_rows) / (limb_rows - 1)
path_km = eye_km + near_km * (exp(ground_y * ground_y * log(1 + (horizon_km - eye_km) / near_km)) - 1)
squares = eye_km * (2 * ground_radius_km + eye_km) + path_km * path_km
ground_mu = where(eye_km < 1e-9, -ground_y, maximum(-squares / (2 * (ground_radius_km + eye_km) * maximum(path_km, 1e-9)), -1))
limb_mu = -horizon_km / (ground_radius_km + eye_km) * (1 - limb_y * limb_y)
)";

constexpr const char* kFromInside = R"(sky_y = (j - ground_rows - limb_rows) / (sky_rows - 1)
sky_mu = sky_y * sky_y * (2 - sky_y * sky_y)
mu = where(j < ground_rows, ground_mu, where(j < ground_rows + limb_rows, limb_mu, sky_mu))
cos_azimuth = 1 - 2 * x * x
)";

// Columns by the zenith cosine of the sun where a ray meets the ground, else at its lowest point.
constexpr const char* kFromSpace = R"(entry_mu = minimum(where(j < ground_rows, ground_mu, limb_mu), 0)
r_km = ground_radius_km + camera_km
r_top_km = ground_radius_km + eye_km
entry_sine = sqrt(maximum(1 - entry_mu * entry_mu, 0))
sine = minimum(r_top_km * entry_sine / r_km, 1)
mu = -sqrt(1 - sine * sine)
way_km = (camera_km - eye_km) * (r_km + r_top_km) / maximum(-r_top_km * entry_mu - r_km * mu, 1e-9)
foot_km = way_km + where(j < ground_rows, path_km, -r_top_km * entry_mu)
foot_radius_km = where(j < ground_rows, ground_radius_km, r_top_km * entry_sine)
middle = sun_mu * (r_km + foot_km * mu) / foot_radius_km
half = sqrt(maximum(1 - sun_mu * sun_mu, 0)) * foot_km * sine / foot_radius_km
low = (middle - half) / (abs(middle - half) + 0.2)
high = (middle + half) / (abs(middle + half) + 0.2)
at = low + (high - low) * x
foot_mu_sun = 0.2 * at / (1 - abs(at))
cos_azimuth = where(half < 1e-4, 2 * x - 1, clip((foot_mu_sun - middle) / maximum(half, 1e-9), -1, 1))
)";

constexpr const char* kCarrier =
    R"(nu = mu * sun_mu + sqrt(maximum((1 - mu * mu) * (1 - sun_mu * sun_mu), 0)) * cos_azimuth
carrier = where(block < last_block, 1, where(j < ground_rows, 1, 1 + nu * nu))
)";

}  // namespace

TableText factor_text(const FactorLayout& layout) {
  const bool inside = layout.sky_rows > 0;
  const std::size_t last = layout.apart.size();
  std::string blocks;
  for (std::size_t i = 0; i < last; ++i) {
    blocks += "light that " + layout.apart[i] + " scatters once, over its phase function, in block " +
              std::to_string(i) + "; ";
  }
  TableText text;
  text.quantity =
      "radiance seen from the camera, in parts: " + blocks + "all other light, over `carrier`, in block " +
      std::to_string(last) +
      (layout.stokes ? "; Q of that light and, over the sine of the azimuth from the sun's, its U in the two "
                       "blocks behind it, by the level direction to the sun's azimuth, carried along the "
                       "great circle from the zenith, below level from the nadir"
                     : "") +
      "; for a sun of the preset's irradiance" + (layout.stokes ? ", behind a filter half of it" : "") +
      (layout.in_colours ? ", all wavelengths summed in linear Rec.709" : "");
  text.unit = "unit of sun.irradiance / sr; where a phase function is left out, unit of sun.irradiance";
  text.axes = {{"x", "cos_azimuth", "1",
                inside ? "cosine of the azimuth from the sun's, linear in the sine of its half"
                       : "cosine of the azimuth from the sun's, by the sun's height at the ray's foot"},
               {"y", "mu", "1",
                inside ? "zenith cosine of the view at the camera: rows of the ground, from straight down to the true "
                         "horizon; from there up to level; from level to the zenith"
                       : "zenith cosine of the view at the camera: rows of the ground, from straight down to the true "
                         "horizon; from there to the top of the air"},
               {"block", "carrier", "1", "what the radiance is divided by"}};
  text.constants = table_constant("ground_radius_km", layout.planet.ground_radius) +
                   table_constant("camera_km", layout.camera_altitude) +
                   table_constant("eye_km", inside ? layout.camera_altitude : layout.planet.atmosphere_height) +
                   table_constant("sun_mu", layout.sun_mu) + table_constant("columns", layout.columns) +
                   table_constant("ground_rows", layout.ground_rows) + table_constant("limb_rows", layout.limb_rows);
  text.constants += inside ? table_constant("sky_rows", layout.sky_rows) : "";
  text.constants += layout.rayleigh ? table_constant("last_block", static_cast<double>(last)) : "";
  text.decode =
      std::string(kRows) + (inside ? kFromInside : kFromSpace) + (layout.rayleigh ? kCarrier : "carrier = 1\n");
  return text;
}

}  // namespace airlight
