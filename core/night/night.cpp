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

// A light's spectrum over the sun's, in the unit of the sun's irradiance, in each of the bands of LightChannels.
using OverSun = std::vector<double>;

// Lights of known luminance in three channels: colours, by all fine bands, or values over the sun's in listed bands.
class LightChannels {
 public:
  LightChannels(const Scene& scene, std::span<const WaveBand> listed)
      : sun_(scene.spectra ? scene.spectra->sun : solar_irradiance()),
        colours_(band_colours(sun_, scene.spectra ? scene.spectra->white : White::sun)),
        in_colours_(listed.empty()),
        one_(radiance_of_one(scene)) {
    in_colours_ ? bands_.assign(fine_bands().begin(), fine_bands().end()) : bands_.assign(listed.begin(), listed.end());
  }

  std::span<const WaveBand> bands() const { return bands_; }

  // So many cd/m2 of a light of this spectrum. `value`: of the spectrum, up to a factor, over a band.
  template <class Value>
  OverSun of(double luminance, Value value) const {
    const auto relative = [&](const WaveBand& band) {
      return value(band) / std::max(mean_over(sun_, band.low, band.high), 1e-30);
    };
    const double scale = one_ * luminance / luminance_over_suns(relative);
    return in_bands([&](const WaveBand& band) { return scale * relative(band); });
  }
  // So many cd/m2 of sunlight, its spectrum then times a factor that the wavelength decides.
  template <class Factor>
  OverSun as_sunlight(double luminance, Factor factor) const {
    return in_bands([&](const WaveBand& band) { return one_ * luminance * factor(middle(band)); });
  }

  vec3 channels(const OverSun& light) const {
    if (!in_colours_) {
      return {light[0], light[1], light[2]};
    }
    std::array<double, kFineBands> relative{};
    std::ranges::copy(light, relative.begin());
    const Rgb colour = colour_of(colours_, relative);
    return {colour[0], colour[1], colour[2]};
  }

 private:
  template <class Value>
  OverSun in_bands(Value value) const {
    OverSun light;
    for (const WaveBand& band : bands_) {
      light.push_back(value(band));
    }
    return light;
  }

  // By the standard observer. The luminance of a colour is another by a percent or two, where the sun is white.
  template <class Relative>
  double luminance_over_suns(Relative relative) const {
    const Curve& seen = observer().y;
    double light = 0.0;
    double sunlight = 0.0;
    for (const WaveBand& band : fine_bands()) {
      const double of_sun = mean_over(seen, band.low, band.high) * mean_over(sun_, band.low, band.high);
      light += of_sun * relative(band);
      sunlight += of_sun;
    }
    return light / sunlight;
  }

  // Radiance of 1 cd/m2. A sun without a unit counts as Earth's.
  static double radiance_of_one(const Scene& scene) {
    const std::optional<double> white = white_luminance(scene.sun.unit);
    return white ? 1.0 / *white : bt709_luminance(scene.sun.irradiance) / kSunlight;
  }

  Curve sun_;
  BandColours colours_;
  bool in_colours_;
  std::vector<WaveBand> bands_;
  double one_;
};

void add(OverSun& sum, const OverSun& light, double times) {
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] += times * light[i];
  }
}

// What the air makes of even light, by night_air(), in the channels of a light. Of a scene in colours it is known at
// the parts' wavelengths; between them its logarithm is taken as straight over that of the wavelength.
class ScatteredLight {
 public:
  ScatteredLight(const NightAirs& through, double camera, NightSource source) : nm_(through.nm) {
    for (const Air& air : through.airs) {
      parts_.push_back(night_air(air, camera, source));
    }
  }

  vec3 at_slope(std::size_t i, const OverSun& light, const LightChannels& channels) const {
    return of(light, channels, [i](const NightAir& part) { return part.scattered[i]; });
  }
  vec3 on_ground(const OverSun& light, const LightChannels& channels) const {
    return of(light, channels, [](const NightAir& part) { return part.ground; });
  }

 private:
  template <class Share>
  vec3 of(const OverSun& light, const LightChannels& channels, Share share) const {
    if (nm_.empty()) {
      return channels.channels(light) * share(parts_.front());
    }
    std::vector<double> logs;
    for (const NightAir& part : parts_) {
      const vec3 three = share(part);
      for (const double one : {three.x, three.y, three.z}) {
        logs.push_back(std::log(std::max(one, 1e-30)));
      }
    }
    OverSun lit = light;
    for (std::size_t k = 0; k < lit.size(); ++k) {
      const double nm = middle(channels.bands()[k]);
      const auto above = std::ranges::upper_bound(nm_, nm) - nm_.begin();
      const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(nm_) - 2));
      const double u = std::log(nm / nm_[i]) / std::log(nm_[i + 1] / nm_[i]);
      lit[k] *= std::exp(logs[i] * (1.0 - u) + logs[i + 1] * u);
    }
    return channels.channels(lit);
  }

  std::vector<double> nm_;
  std::vector<NightAir> parts_;
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

physics::HostTable Night::table() const {
  constexpr std::size_t kSide = physics::kNightSide;
  physics::HostTable table{physics::kNightSide, physics::kNightSide + 1, beyond};
  table.texels.insert(table.texels.end(), scattered.begin(), scattered.end());
  table.texels.insert(table.texels.end(), {airglow, ground});
  table.texels.resize(kSide * (kSide + 1), vec3(0.0));
  return table;
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
    of_colour.push_back(channels.channels(channels.of(1.0, [kelvin](const WaveBand& band) {
      const double nm = middle(band);
      return std::pow(nm, -5.0) / std::expm1(1.438777e7 / (nm * kelvin));
    })));
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

// Mean over a band: its lines are narrower.
double lamp_over(Lamps lamps, const WaveBand& band) {
  constexpr int kPoints = 10;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    sum += lamp_light(lamps, band.low + (band.high - band.low) * (i + 0.5) / kPoints) / kPoints;
  }
  return sum;
}

double airglow_over(const WaveBand& band) {
  return mean_over(airglow(), band.low, band.high);
}

// Mean light from beyond the air over the upper half of the sky, in stars of 10th magnitude a square degree.
BeyondAir fill_map(Night& night, const Scene& scene, const CelestialFrame& frame, const vec3& dust, const vec3& stars,
                   physics::Physics& p) {
  const double sun = sun_longitude(scene.camera.julian_date);
  BeyondAir sum{0.0, 0.0};
  double weights = 0.0;
  for (physics::uint row = 0; row < physics::kNightSide; ++row) {
    for (physics::uint column = 0; column < physics::kNightSide; ++column) {
      const MapTexel texel = map_texel(p, column, row);
      const BeyondAir many = beyond_the_air(*scene.night_sky, frame, sun, texel.direction);
      night.beyond.push_back(dust * many.dust + stars * many.stars);
      const double weight = texel.direction.y > 0.0 ? texel.weight : 0.0;
      sum.dust += many.dust * weight;
      sum.stars += many.stars * weight;
      weights += weight;
    }
  }
  return {sum.dust / weights, sum.stars / weights};
}

void add_background(Night& night, const Scene& scene, const NightAirs& through, const LightChannels& channels,
                    const CelestialFrame& frame) {
  const NightSky& wish = *scene.night_sky;
  physics::Physics p = through.airs.front().formulas();
  const double passed = light_passed(scene.camera);
  const OverSun dust = channels.as_sunlight(kS10 * passed, zodiacal_redness);
  const OverSun stars = channels.as_sunlight(kS10 * passed, [](double) { return 1.0; });
  const OverSun glow = channels.of(wish.airglow * illuminance(airglow()) * passed, airglow_over);
  const BeyondAir mean = fill_map(night, scene, frame, channels.channels(dust), channels.channels(stars), p);
  night.airglow = channels.channels(glow);
  const double camera = optical_altitude(p, scene.camera.altitude);
  OverSun sky(dust.size());
  add(sky, dust, mean.dust);
  add(sky, stars, mean.stars);
  add(sky, glow, mean_van_rhijn(p, std::min(camera, 80.0)));
  const auto add_scattered = [&](const OverSun& light, NightSource source) {
    const ScatteredLight lit(through, camera, source);
    night.scattered.resize(2 * physics::kNightSlopes, vec3(0.0));
    for (std::size_t i = 0; i < night.scattered.size(); ++i) {
      night.scattered[i] = night.scattered[i] + lit.at_slope(i, light, channels);
    }
    night.ground = night.ground + lit.on_ground(light, channels);
  };
  add_scattered(sky, NightSource::sky);
  if (wish.light_pollution > 0.0) {
    const auto lamps = [&](const WaveBand& band) { return lamp_over(wish.lamps, band); };
    add_scattered(channels.of(wish.light_pollution * passed, lamps), NightSource::ground);
  }
}

}  // namespace

Night night_of(const Scene& scene, const NightAirs& through, std::span<const WaveBand> bands) {
  const LightChannels channels(scene, bands);
  const CelestialFrame frame = celestial_frame(scene.camera.julian_date, scene.camera.latitude, scene.camera.longitude);
  Night night;
  if (scene.stars) {
    night.stars = stars_of(scene, channels, frame);
  }
  if (scene.night_sky) {
    add_background(night, scene, through, channels, frame);
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
  const auto lamps = [&](const WaveBand& band) { return lamp_over(scene.night_sky->lamps, band); };
  return std::max(scene.night_sky && scene.night_sky->airglow > 0.0 ? error(airglow_over) : 0.0,
                  has_lamps ? error(lamps) : 0.0);
}

}  // namespace airlight
