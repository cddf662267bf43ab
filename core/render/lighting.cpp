#include "core/render/lighting.h"

#include <cmath>
#include <numbers>

#include "core/air/refraction.h"
#include "core/air/scene_block.h"
#include "core/base/error.h"
#include "core/methods/ready.h"
#include "core/render/spectrum.h"

namespace airlight {
namespace {

using physics::vec3;
using std::numbers::pi;

// Size of the sky for lighting: 1.9 degrees a pixel. A finer one changes no coefficient by 0.3 % of the first.
constexpr ImageSize kSkySize{192, 96};

struct Node {
  double angle;
  double weight;
};

// Gauss and Legendre's three points over the i-th of n equal parts of [from, from + span].
std::array<Node, 3> nodes(double from, double span, int i, int n) {
  const double part = span / n;
  const double middle = from + (i + 0.5) * part;
  const double away = 0.5 * std::sqrt(0.6) * part;
  return {{{middle - away, part * 5.0 / 18.0}, {middle, part * 8.0 / 18.0}, {middle + away, part * 5.0 / 18.0}}};
}

// Calls use(direction, solid angle) for nine points of a pixel; the weights add up to the pixel's solid angle to 1e-9.
template <class Use>
void for_points(physics::Physics& p, const RadianceImage& latlong, double azimuth, int x, int y, Use use) {
  for (const Node& e : nodes(0.5 * pi, -pi, y, latlong.height)) {
    for (const Node& a : nodes(azimuth - pi, 2.0 * pi, x, latlong.width)) {
      use(p.direction_from_angles(e.angle, a.angle), -e.weight * std::cos(e.angle) * a.weight);
    }
  }
}

Vector3 numbers_of(const vec3& v) {
  return {v.x, v.y, v.z};
}

Vector3 rgb_at(const RadianceImage& image, int x, int y) {
  const float* const pixel = image.at(x, y);
  return {static_cast<double>(pixel[0]), static_cast<double>(pixel[1]), static_cast<double>(pixel[2])};
}

struct Patch {
  vec3 area;  // integral of the direction over the pixel
  Vector3 radiance{};
};

std::vector<Patch> patches_of(physics::Physics& p, const RadianceImage& latlong, double azimuth) {
  std::vector<Patch> patches;
  for (int y = 0; y < latlong.height; ++y) {
    for (int x = 0; x < latlong.width; ++x) {
      Patch patch{{}, rgb_at(latlong, x, y)};
      for_points(p, latlong, azimuth, x, y,
                 [&](const vec3& d, double solid_angle) { patch.area = patch.area + d * solid_angle; });
      patches.push_back(patch);
    }
  }
  return patches;
}

Vector3 irradiance_on(const std::vector<Patch>& patches, const vec3& normal) {
  Vector3 sum{};
  for (const Patch& patch : patches) {
    const double cosine = std::max(0.0, dot(normal, patch.area));
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += patch.radiance[c] * cosine;
    }
  }
  return sum;
}

// Points of the disc, each with its share of the disc's light above the air.
struct DiscPoint {
  Direction direction;
  double share;
};

// Rings of points; of each its distance from the disc's centre in radii, and its share of an even disc.
struct DiscRings {
  std::vector<std::pair<double, double>> rings;
  int around;
};

// For a disc that something cuts.
DiscRings fine_rings() {
  constexpr int kRings = 12;
  DiscRings fine{{}, 24};
  for (int ring = 0; ring < kRings; ++ring) {
    const double r = (ring + 0.5) / kRings;
    fine.rings.emplace_back(r, r);
  }
  return fine;
}

// Gauss and Legendre's points over the area: 24 directions. With the lower limb a radius above the horizon they are
// within 0.02 % of the sum over a dense grid.
DiscRings smooth_rings() {
  DiscRings smooth{{}, 8};
  for (const Node& node : nodes(0.0, 1.0, 0, 1)) {
    smooth.rings.emplace_back(std::sqrt(node.angle), node.weight);
  }
  return smooth;
}

std::vector<DiscPoint> disc_points(physics::Physics& p, const Sun& sun, const DiscRings& rings) {
  const vec3 s = p.scene.sun.direction;
  // East of the disc's centre, and above it.
  const vec3 a(std::cos(sun.azimuth), 0.0, std::sin(sun.azimuth));
  const vec3 b(-std::sin(sun.azimuth) * std::sin(sun.elevation), std::cos(sun.elevation),
               std::cos(sun.azimuth) * std::sin(sun.elevation));
  std::vector<DiscPoint> points;
  double total = 0.0;
  for (const auto& [r, area] : rings.rings) {
    const double limb = 1.0 - sun.disc.limb_darkening * (1.0 - std::sqrt(1.0 - r * r));
    const double off = r * sun.disc.angular_radius;
    for (int k = 0; k < rings.around; ++k) {
      const double t = 2.0 * pi * (k + 0.5) / rings.around;
      const vec3 direction = s * std::cos(off) + (a * std::cos(t) + b * std::sin(t)) * std::sin(off);
      const double profile = area * (sun.disc.lit ? p.lit_profile(p.scene.sun, direction) : limb);
      points.push_back({angles_of(direction), profile});
      total += profile;
    }
  }
  for (DiscPoint& point : points) {
    point.share /= total;
  }
  return points;
}

}  // namespace

std::array<double, 9> sh_basis(const Vector3& d) {
  const auto [x, y, z] = d;
  const double one = 0.5 / std::sqrt(pi);
  const double linear = std::sqrt(3.0) * one;
  const double product = std::sqrt(15.0) * one;
  return {one,
          linear * y,
          linear * z,
          linear * x,
          product * x * y,
          product * y * z,
          0.5 * std::sqrt(5.0) * one * (3.0 * z * z - 1.0),
          product * x * z,
          0.5 * product * (x * x - y * y)};
}

ShRadiance project_to_sh(const RadianceImage& latlong, double azimuth) {
  physics::Physics p;
  ShRadiance sum{};
  for (int y = 0; y < latlong.height; ++y) {
    for (int x = 0; x < latlong.width; ++x) {
      std::array<double, 9> pixel{};
      for_points(p, latlong, azimuth, x, y, [&](const vec3& d, double solid_angle) {
        const std::array<double, 9> basis = sh_basis(numbers_of(d));
        for (std::size_t k = 0; k < 9; ++k) {
          pixel[k] += basis[k] * solid_angle;
        }
      });
      const Vector3 radiance = rgb_at(latlong, x, y);
      for (std::size_t k = 0; k < 9; ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
          sum[k][c] += radiance[c] * pixel[k];
        }
      }
    }
  }
  return sum;
}

ShRadiance turned(const ShRadiance& light, double azimuth) {
  const double c = std::cos(azimuth);
  const double s = std::sin(azimuth);
  // A right-handed turn of x and z takes the two harmonics of an order, -m and m, into one another.
  ShRadiance out = light;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = [&](std::size_t k) { return light[k][i]; };
    out[2][i] = c * at(2) - s * at(3);  // z
    out[3][i] = s * at(2) + c * at(3);  // x
    out[4][i] = c * at(4) + s * at(5);  // xy
    out[5][i] = c * at(5) - s * at(4);  // yz
    // Among 3zz - 1, xz and xx - yy: of second degree in x and z.
    const double root3 = std::sqrt(3.0);
    const double zz = at(6) * 2.0;  // as a quadratic form: xx, yy, zz, xz
    const double xx = root3 * at(8) - at(6);
    const double xz = root3 * at(7);
    const double yy = -xx - zz;
    const double new_xx = c * c * xx + s * s * zz + 2.0 * c * s * xz;
    const double new_zz = s * s * xx + c * c * zz - 2.0 * c * s * xz;
    out[6][i] = new_zz / 2.0;
    out[7][i] = ((c * c - s * s) * xz + c * s * (zz - xx)) / root3;
    out[8][i] = (new_xx - yy) / (2.0 * root3);
  }
  return out;
}

RadianceImage irradiance_map(const RadianceImage& latlong, double latlong_azimuth, int width, int height,
                             double azimuth) {
  physics::Physics p;
  const std::vector<Patch> patches = patches_of(p, latlong, latlong_azimuth);
  RadianceImage map{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double elevation = pi * (0.5 - (y + 0.5) / height);
      const double toward = azimuth + pi * (2.0 * (x + 0.5) / width - 1);
      const Vector3 sum = irradiance_on(patches, p.direction_from_angles(elevation, toward));
      for (const double value : sum) {
        map.rgba.push_back(static_cast<float>(value));
      }
      map.rgba.push_back(1.0F);
    }
  }
  return map;
}

Vector3 level_irradiance(const RadianceImage& latlong) {
  physics::Physics p;
  return irradiance_on(patches_of(p, latlong, 0.0), vec3(0.0, 1.0, 0.0));
}

namespace {

bool is_above_ground(physics::Physics& p, const vec3& direction) {
  return !p.meets_ground(p.scene.planet, p.scene.camera.altitude, direction.y);
}

// Whether neither the planet nor a thing can cut the disc, and all of it is lit: light changes smoothly over it.
bool is_smooth(physics::Physics& p, const Stage& stage) {
  const Sun& sun = stage.scene().sun;
  const vec3 below = p.direction_from_angles(sun.elevation - 2.0 * sun.disc.angular_radius, sun.azimuth);
  return !sun.disc.lit && !stage.whole().things.stand_in_the_air() && stage.scene().clouds.empty() &&
         is_above_ground(p, seen_direction(p, below).direction);
}

// The points of the disc that the planet and things leave to be seen.
struct SeenDisc {
  std::vector<Direction> directions;
  std::vector<double> shares;  // of the disc's irradiance above the air, with the beam's spreading
  double visible_share = 0.0;
};

SeenDisc seen_disc(physics::Physics& p, const Stage& stage) {
  const Scene& scene = stage.scene();
  SeenDisc seen_disc;
  stage.whole().things.put_into(p);
  const auto is_hidden = [&](const Direction& d) {
    return p.disc_is_hidden(p.direction_from_angles(d.elevation, d.azimuth));
  };
  const DiscRings rings = is_smooth(p, stage) ? smooth_rings() : fine_rings();
  for (const DiscPoint& point : disc_points(p, scene.sun, rings)) {
    const SeenDirection seen =
        seen_direction(p, p.direction_from_angles(point.direction.elevation, point.direction.azimuth));
    if (!is_hidden(point.direction) && is_above_ground(p, seen.direction)) {
      seen_disc.directions.push_back(p.refraction ? angles_of(seen.direction) : point.direction);
      seen_disc.shares.push_back(point.share * seen.spread);
      seen_disc.visible_share += point.share;
    }
  }
  return seen_disc;
}

}  // namespace

SunLight sun_light(const DeviceOnDemand& device, const Stage& stage) {
  const Scene& scene = stage.scene();
  physics::Physics p = geometry_of(scene);
  const SeenDisc disc = seen_disc(p, stage);
  SunLight light{.direction = numbers_of(p.scene.sun.seen),
                 .elevation = std::asin(std::clamp(p.scene.sun.seen.y, -1.0, 1.0)),
                 .azimuth = scene.sun.azimuth,
                 .angular_radius = scene.sun.disc.angular_radius,
                 .irradiance_above_air = scene.sun.irradiance,
                 .visible_share = disc.visible_share};
  const std::vector<ProbeResult> probes = probe(device, stage, disc.directions).directions;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      light.irradiance[c] +=
          scene.sun.irradiance[c] * scene.sun.uncovered * probes[i].transmittance[c] * disc.shares[i];
    }
  }
  return light;
}

std::vector<double> sun_spectrum(const DeviceOnDemand& device, const Stage& stage, const Nodes& nodes) {
  physics::Physics p = geometry_of(stage.scene());
  const SeenDisc disc = seen_disc(p, stage);
  const SpectralProbes probes = probe_spectrum(device, stage, disc.directions, nodes);
  std::vector<double> irradiance(nodes.nm.size(), 0.0);
  for (std::size_t i = 0; i < probes.directions.size(); ++i) {
    for (std::size_t k = 0; k < irradiance.size(); ++k) {
      irradiance[k] += probes.wavelengths.sunlight[k] * probes.directions[i].transmittance[k] * disc.shares[i];
    }
  }
  return irradiance;
}

Rendering whole_sky(const DeviceOnDemand& device, const Stage& stage, const HostOptions& host, ImageSize size,
                    const std::optional<Nodes>& spectrum) {
  const Scene& scene = stage.scene();
  stage.parts();  // made before the whole sky's stage, which then shares their air
  Scene sky = scene;
  const Camera& camera = scene.camera;
  sky.camera = {.altitude = camera.altitude,
                .projection = Projection::equirectangular,
                .latitude = camera.latitude,
                .longitude = camera.longitude,
                .julian_date = camera.julian_date};
  sky.image = size;
  sky.sun.disc.visible = false;
  sky.bloom.enabled = false;
  RenderRequest request;
  request.host = host;
  request.host.checkpoint.clear();  // which is the picture's
  request.spectrum = spectrum;
  Rendering rendering = render(device, ready(sky, stage), request);
  if (const std::string fault = rendering.fault(); !fault.empty()) {
    throw RunError("the whole sky: " + fault);
  }
  return rendering;
}

Lighting lighting_of(const DeviceOnDemand& device, const Stage& stage, const HostOptions& host) {
  const RadianceImage sky = whole_sky(device, stage, host, kSkySize).radiance;
  Lighting lighting{irradiance_map(sky, 0.0, kIrradianceWidth, kIrradianceHeight, stage.scene().camera.azimuth),
                    project_to_sh(sky, 0.0), level_irradiance(sky), sun_light(device, stage)};
  for (const Stage& other : stage.others()) {
    lighting.moon = sun_light(device, other);
  }
  return lighting;
}

}  // namespace airlight
