#include "core/things/ground.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "core/things/planet_map.h"

namespace airlight {
namespace {

using physics::GroundData;
using physics::HostGround;
using physics::vec3;

constexpr int kColourChannels = 3;
constexpr int kMostGroundRows = 2048;  // with its means 45 MB, of 128 that a buffer may hold

std::string digits_of(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

PlanetLevel level_of(const std::vector<float>& values, int rows, int channels) {
  const PlanetLevel level{rows, values};
  return rows > kMostGroundRows ? resampled(level, kMostGroundRows, channels) : level;
}

physics::uint packed_colour(const ColourMix& mix, const float* colour) {
  physics::uint bits = 0;
  for (physics::uint c = 0; c < 3; ++c) {
    const double root = std::sqrt(std::clamp(mixed(mix, c, colour), 0.0, 1.0));
    bits |= static_cast<physics::uint>(std::lround(root * 1023.0)) << (10U * c);
  }
  return bits;
}

void put_albedo(HostGround& out, const std::vector<PlanetLevel>& levels, const ColourMix& mix) {
  out.head.shape.albedo_rows = static_cast<physics::uint>(levels.front().rows);
  out.head.shape.albedo_levels = static_cast<physics::uint>(levels.size());
  auto albedo = std::make_shared<std::vector<physics::uint>>();
  for (std::size_t k = 0; k < levels.size(); ++k) {
    out.head.albedo_first[k] = static_cast<physics::uint>(albedo->size());
    for (std::size_t i = 0; i < levels[k].values.size(); i += kColourChannels) {
      albedo->push_back(packed_colour(mix, &levels[k].values[i]));
    }
  }
  out.albedo = std::move(albedo);
}

void put_water(HostGround& out, const std::vector<PlanetLevel>& levels) {
  out.head.shape.water_rows = static_cast<physics::uint>(levels.front().rows);
  out.head.shape.water_levels = static_cast<physics::uint>(levels.size());
  auto water = std::make_shared<std::vector<physics::uint>>();
  std::size_t count = 0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    out.head.water_first[k] = static_cast<physics::uint>(count);
    for (const float share : levels[k].values) {
      water->resize(count / 4 + 1);
      const auto bits = static_cast<physics::uint>(std::lround(std::clamp(share, 0.0F, 1.0F) * 255.0F));
      (*water)[count / 4] |= bits << (8U * (count % 4));
      ++count;
    }
  }
  out.water = std::move(water);
}

}  // namespace

HostGround planet_maps(const GroundMap& map, const Spectrum& albedo) {
  const GroundFiles* files = map.files.get();
  HostGround out;
  if (files != nullptr && !files->colours.empty()) {
    put_albedo(out, planet_levels(level_of(files->colours, files->colour_rows, kColourChannels), kColourChannels),
               map.mix);
  } else {
    std::vector<float> same;
    for (int i = 0; i < 2; ++i) {
      for (const double channel : albedo) {
        same.push_back(static_cast<float>(channel));
      }
    }
    put_albedo(out, {{1, same}}, kColoursThemselves);
  }
  const bool masked = files != nullptr && !files->water.empty();
  if (masked) {
    put_water(out, planet_levels(level_of(files->water, files->water_rows, 1), 1));
  } else {
    put_water(out, {{1, {1.0F, 1.0F}}});
  }
  if (map.ocean) {
    physics::Physics p;
    out.head.shape.slope_variance = p.ocean_slope_variance(map.ocean->wind);
    for (physics::uint i = 0; i < physics::kGlintShares; ++i) {
      const double root = i / (physics::kGlintShares - 1.0);
      out.head.glint_share[i] = glint_share(out.head.shape.slope_variance, root * root);
    }
  }
  return out;
}

// The planet's axes in the camera's frame: x east, y up, -z north.
HostGround seen_from(HostGround maps, const Camera& camera) {
  GroundData& head = maps.head;
  const double s = std::sin(camera.latitude);
  const double c = std::cos(camera.latitude);
  const double sl = std::sin(camera.longitude);
  const double cl = std::cos(camera.longitude);
  head.shape.pole = vec3(0.0, s, -c);
  head.shape.greenwich = vec3(-sl, c * cl, s * cl);
  head.shape.east = vec3(cl, c * sl, s * sl);
  return maps;
}

double glint_share(double slope_variance, double mu_sun) {
  constexpr int kParts = 64;
  physics::Physics p;
  const double mu = std::max(mu_sun, 1e-3);
  const vec3 up(0.0, 1.0, 0.0);
  const vec3 sun(std::sqrt(1.0 - mu * mu), mu, 0.0);
  double sum = 0.0;
  // Equal shares of the slopes: rings of equal probability, and directions around each.
  for (int i = 0; i < kParts; ++i) {
    const double square = -slope_variance * std::log((i + 0.5) / kParts);
    const double upright = 1.0 / std::sqrt(1.0 + square);
    for (int j = 0; j < kParts; ++j) {
      const double turn = std::numbers::pi * (j + 0.5) / kParts;  // half a turn, by symmetry
      const double level = std::sqrt(square) * upright;
      const vec3 facet(level * std::cos(turn), upright, level * std::sin(turn));
      const double facing = dot(facet, sun);
      const vec3 away = facet * (2.0 * facing) - sun;
      if (facing > 0.0 && away.y > 0.0) {
        // The slopes' density cancels: the summand is the radiance over that density, times the ratio of solid angles.
        const double density = std::exp(-square / slope_variance) / (std::numbers::pi * slope_variance);
        sum += p.ocean_glint(slope_variance, up, sun, away) * away.y * 4.0 * facing * std::pow(upright, 3) / density;
      }
    }
  }
  return std::min(sum / (kParts * kParts) / mu, 1.0);
}

Spectrum mean_albedo(const GroundFiles& files) {
  const std::vector<double> mean = planet_mean({files.colour_rows, files.colours}, kColourChannels);
  return {mean[0], mean[1], mean[2]};
}

std::string ground_key(const Scene& scene) {
  std::string key = scene.ground->files ? "ground of " + scene.ground->files->identity : "ground";
  if (!scene.ground->files || scene.ground->files->colours.empty()) {
    for (const double albedo : scene.planet.ground_albedo) {
      key += " " + digits_of(albedo);
    }
  }
  for (std::size_t c = 0; c < 3 && scene.ground->mix != kColoursThemselves; ++c) {
    for (const double share : scene.ground->mix[c]) {
      key += " " + digits_of(share);
    }
  }
  return key + (scene.ground->ocean ? " wind " + digits_of(scene.ground->ocean->wind) : "");
}

}  // namespace airlight
