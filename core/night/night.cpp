#include "core/night/night.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/air/refraction.h"
#include "core/air/scene_block.h"
#include "core/night/background.h"
#include "core/night/celestial.h"
#include "core/night/night_air.h"
#include "core/night/planets.h"
#include "core/night/stars.h"
#include "core/scene/photometry.h"
#include "core/spectra/data.h"

namespace airlight {
namespace {

using physics::vec3;
using std::numbers::pi;

double middle(const WaveBand& band) {
  return 0.5 * (band.low + band.high);
}

// The channels of lights of known luminance: colours, or values over the sun's at wavelengths.
class LightChannels {
 public:
  LightChannels(const Scene& scene, std::span<const WaveBand> listed)
      : sun_(scene.spectra ? scene.spectra->sun : solar_irradiance()),
        bands_(band_colours(sun_, scene.spectra ? scene.spectra->white : White::sun)),
        listed_(listed.begin(), listed.end()),
        one_(radiance_of_one(scene)) {}

  // Radiance of so many cd/m2 of a light of this spectrum. `value`: of the spectrum, up to a factor, over a band.
  template <class Value>
  vec3 of(double luminance, Value value) const {
    const auto relative = [&](const WaveBand& band) {
      return value(band) / std::max(mean_over(sun_, band.low, band.high), 1e-30);
    };
    return channels(relative) * (one_ * luminance / bt709_luminance(colour(relative)));
  }
  // Radiance of so many cd/m2 of sunlight, its spectrum times a factor that the wavelength decides.
  template <class Factor>
  vec3 as_sunlight(double luminance, Factor factor) const {
    const double one = bt709_luminance(colour([](const WaveBand&) { return 1.0; }));
    return channels([&](const WaveBand& band) { return factor(middle(band)); }) * (one_ * luminance / one);
  }

 private:
  template <class Relative>
  Rgb colour(Relative relative) const {
    std::array<double, kFineBands> over_sun{};
    std::ranges::transform(fine_bands(), over_sun.begin(), relative);
    return colour_of(bands_, over_sun);
  }
  template <class Relative>
  vec3 channels(Relative relative) const {
    if (listed_.empty()) {
      const Rgb made = colour(relative);
      return {made[0], made[1], made[2]};
    }
    return {relative(listed_[0]), relative(listed_[1]), relative(listed_[2])};
  }

  // Radiance of 1 cd/m2. A sun without a unit counts as Earth's.
  static double radiance_of_one(const Scene& scene) {
    const std::optional<double> white = white_luminance(scene.sun.unit);
    return white ? 1.0 / *white : bt709_luminance(scene.sun.irradiance) / kSunlight;
  }

  Curve sun_;
  BandColours bands_;
  std::vector<WaveBand> listed_;  // of the three channels; empty: these are colours
  double one_;
};

// The middle of a texel of the map, in the preset's frame, and the solid angle that it stands for, up to a factor.
struct MapTexel {
  vec3 direction;
  double weight;
};
MapTexel map_texel(physics::Physics& p, physics::uint column, physics::uint row) {
  const auto across = [](physics::uint i) { return 2.0 * i / (physics::kNightSide - 1.0) - 1.0; };
  const vec3 point = p.octahedral_direction(across(column), across(row));
  const double length = physics::length(point);
  return {point / length, std::pow(length, -3.0)};
}

// Zodiacal light and faint stars, in stars of 10th magnitude a square degree.
struct BeyondAir {
  double dust;
  double stars;
};
BeyondAir beyond_the_air(const NightSky& wish, const CelestialFrame& frame, double sun, const vec3& direction) {
  constexpr double kObliquity = 23.4392911 * pi / 180.0;
  const vec3 star = frame.to_j2000(direction);
  const double x = star.x;
  const double y = star.y * std::cos(kObliquity) + star.z * std::sin(kObliquity);
  const double z = star.z * std::cos(kObliquity) - star.y * std::sin(kObliquity);
  const double latitude = std::atan2(z, std::hypot(x, y));
  return {wish.zodiacal * zodiacal_light(std::atan2(y, x) - sun, latitude), wish.starlight * faint_stars(star)};
}

double mean_van_rhijn(physics::Physics& p, double altitude) {
  constexpr int kSlopes = 200;
  double sum = 0.0;
  for (int i = 0; i < kSlopes; ++i) {
    sum += p.van_rhijn(p.scene.planet, altitude, (i + 0.5) / kSlopes) / kSlopes;
  }
  return sum;
}

}  // namespace

void Night::put_into(physics::Physics& p) const {
  p.night_texels = beyond;
  p.night_slopes = scattered;
  p.airglow = airglow;
  p.night_ground = ground;
}

namespace {

// Stars in the colours of black bodies, which are interpolated.
std::vector<NightStar> stars_of(const Scene& scene, const LightChannels& channels, const CelestialFrame& frame) {
  constexpr double kBluest = -0.4;
  constexpr double kStep = 0.1;
  constexpr int kColours = 30;
  std::vector<vec3> of_colour;
  for (int i = 0; i < kColours; ++i) {
    const double kelvin = star_temperature(kBluest + kStep * i);
    of_colour.push_back(channels.of(1.0, [kelvin](const WaveBand& band) {
      const double nm = middle(band);
      return std::pow(nm, -5.0) / std::expm1(1.438777e7 / (nm * kelvin));
    }));
  }
  std::vector<NightStar> stars;
  const auto add = [&](const CatalogueStar& star, std::string_view name) {
    const double x = std::clamp((star.colour - kBluest) / kStep, 0.0, kColours - 1.001);
    const auto i = static_cast<std::size_t>(x);
    const double u = x - static_cast<double>(i);
    const vec3 colour = of_colour[i] * (1.0 - u) + of_colour[i + 1] * u;
    stars.push_back({frame.apparent(place_at(star, scene.camera.julian_date)),
                     colour * (star_illuminance(star.magnitude) * light_passed(scene.camera)), name, star.magnitude});
  };
  for (const CatalogueStar& star : bright_stars()) {
    if (star.magnitude > scene.stars->magnitude_limit) {
      break;
    }
    add(star, star_name(star));
  }
  for (const PlanetInSky& planet : planets_at(scene.camera.julian_date)) {
    if (planet.star.magnitude <= scene.stars->magnitude_limit) {
      add(planet.star, planet.name);
    }
  }
  return stars;
}

double airglow_over(const WaveBand& band) {
  return mean_over(airglow(), band.low, band.high);
}

void add_background(Night& night, const Scene& scene, const Air& air, const LightChannels& channels,
                    const CelestialFrame& frame) {
  const NightSky& wish = *scene.night_sky;
  physics::Physics p = air.formulas();
  const double sun = sun_longitude(scene.camera.julian_date);
  const double passed = light_passed(scene.camera);
  const vec3 dust = channels.as_sunlight(kS10 * passed, zodiacal_redness);
  const vec3 stars = channels.as_sunlight(kS10 * passed, [](double) { return 1.0; });
  vec3 sum(0.0);
  double weights = 0.0;
  for (physics::uint row = 0; row < physics::kNightSide; ++row) {
    for (physics::uint column = 0; column < physics::kNightSide; ++column) {
      const MapTexel texel = map_texel(p, column, row);
      const BeyondAir many = beyond_the_air(wish, frame, sun, texel.direction);
      night.beyond.push_back(dust * many.dust + stars * many.stars);
      const double weight = texel.direction.y > 0.0 ? texel.weight : 0.0;
      sum = sum + night.beyond.back() * weight;
      weights += weight;
    }
  }
  night.airglow = channels.of(wish.airglow * illuminance(airglow()) * passed, airglow_over);
  const double camera = optical_altitude(p, scene.camera.altitude);
  const NightAir lit = night_air(air, camera);
  const vec3 mean = sum / weights + night.airglow * mean_van_rhijn(p, std::min(camera, 80.0));
  for (const vec3& scattered : lit.scattered) {
    night.scattered.push_back(scattered * mean);
  }
  night.ground = lit.ground * mean;
  if (wish.light_pollution > 0.0) {
    const NightAir towns = night_air(air, camera, NightSource::ground);
    const vec3 lamps = channels.of(wish.light_pollution * passed, [&](const WaveBand& band) {
      return lamp_light(wish.lamps, middle(band));
    });
    for (std::size_t i = 0; i < night.scattered.size(); ++i) {
      night.scattered[i] = night.scattered[i] + towns.scattered[i] * lamps;
    }
    night.ground = night.ground + towns.ground * lamps;
  }
}

}  // namespace

Night night_of(const Scene& scene, const Air& air, std::span<const WaveBand> bands) {
  const LightChannels channels(scene, bands);
  const CelestialFrame frame = celestial_frame(scene.camera.julian_date, scene.camera.latitude, scene.camera.longitude);
  Night night;
  if (scene.stars) {
    night.stars = stars_of(scene, channels, frame);
  }
  if (scene.night_sky) {
    add_background(night, scene, air, channels, frame);
  }
  return night;
}

double night_colour_error(const Scene& scene, const ColourMatrix& matrix, const Nodes& nodes) {
  const Curve& sun = scene.spectra->sun;
  const BandColours colours = band_colours(sun, scene.spectra->white);
  const auto error = [&](const auto& value) {
    const auto relative = [&](const WaveBand& band) {
      return value(band) / std::max(mean_over(sun, band.low, band.high), 1e-30);
    };
    std::array<double, kFineBands> exact{};
    std::ranges::transform(fine_bands(), exact.begin(), relative);
    std::vector<double> at_nodes(nodes.bands.size());
    std::ranges::transform(nodes.bands, at_nodes.begin(), relative);
    return mean_error(matrix, {{std::move(at_nodes), colour_of(colours, exact)}});
  };
  const bool has_lamps = scene.night_sky && scene.night_sky->light_pollution > 0.0;
  const auto lamps = [&](const WaveBand& band) { return lamp_light(scene.night_sky->lamps, middle(band)); };
  return std::max(scene.night_sky && scene.night_sky->airglow > 0.0 ? error(airglow_over) : 0.0,
                  has_lamps ? error(lamps) : 0.0);
}

}  // namespace airlight
