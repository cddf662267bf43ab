#include "core/post/stars.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/air/refraction.h"
#include "core/air/scene_block.h"
#include "core/luts/luts.h"
#include "core/plan/bytes.h"
#include "core/things/thing_buffers.h"

namespace airlight {
namespace {

using physics::vec3;

// The column or row that stands for one beyond the picture's edge; none where the picture ends.
std::optional<int> within_picture(int i, int size, bool round) {
  if (round) {
    return (i % size + size) % size;
  }
  return i >= 0 && i < size ? std::optional(i) : std::nullopt;
}

}  // namespace

std::vector<StarPixel> star_pixels(physics::Physics& p, const Scene& scene, const Night& night, const Tile& tile) {
  const physics::uint projection = projection_code(scene.camera.projection);
  const bool round = scene.camera.projection == Projection::equirectangular;
  const auto& camera = p.scene.camera;
  std::map<std::pair<int, int>, vec3> pixels;
  const BentSky sky(p);
  for (const NightStar& star : night.stars) {
    const SeenDirection seen = sky.seen(star.direction);
    const auto at = p.pixel_of(camera, projection, seen.direction);
    if (!at.in_front || !(std::abs(at.x) < 1e6 && std::abs(at.y) < 1e6)) {
      continue;
    }
    const double left = std::floor(at.x - 0.5);
    const double top = std::floor(at.y - 0.5);
    for (int corner = 0; corner < 4; ++corner) {
      const double x = left + corner % 2;
      const double y = top + corner / 2;
      const double share = (1.0 - std::abs(at.x - 0.5 - x)) * (1.0 - std::abs(at.y - 0.5 - y));
      const std::optional<int> column = within_picture(static_cast<int>(x), scene.image.width, round);
      const std::optional<int> row = within_picture(static_cast<int>(y), scene.image.height, false);
      if (!column || !row || *column < tile.x || *column >= tile.x + tile.width || *row < tile.y ||
          *row >= tile.y + tile.height || !p.view_ray(camera, projection, *column + 0.5, *row + 0.5).inside) {
        continue;
      }
      vec3& sum = pixels.try_emplace({*row - tile.y, *column - tile.x}, vec3(0.0)).first->second;
      sum = sum + star.irradiance * (seen.spread * share / p.pixel_solid_angle(projection, *column + 0.5, *row + 0.5));
    }
  }
  std::vector<StarPixel> found;
  for (const auto& [place, radiance] : pixels) {
    found.push_back({static_cast<std::uint32_t>(place.second), static_cast<std::uint32_t>(place.first), radiance});
  }
  return found;
}

std::vector<NamedPoint> named_points(const Stage& stage) {
  std::vector<NamedPoint> points;
  if (!stage.scene().stars) {
    return points;
  }
  physics::Physics p = geometry_of(stage.scene());
  const physics::uint projection = projection_code(stage.scene().camera.projection);
  const BentSky sky(p);
  const double horizon = p.horizon_mu(p.scene.planet, p.scene.camera.altitude);
  for (const NightStar& star : stage.night()->stars) {
    const vec3 at = star.name.empty() ? vec3(0.0) : sky.seen(star.direction).direction;
    if (star.name.empty() || at.y <= horizon) {
      continue;
    }
    const auto pixel = p.pixel_of(p.scene.camera, projection, at);
    if (!pixel.in_front || pixel.x < 0.0 || pixel.x >= stage.scene().image.width || pixel.y < 0.0 ||
        pixel.y >= stage.scene().image.height || !p.view_ray(p.scene.camera, projection, pixel.x, pixel.y).inside) {
      continue;
    }
    const double azimuth = std::atan2(at.x, -at.z);
    points.push_back({star.name, star.magnitude, std::asin(std::clamp(at.y, -1.0, 1.0)),
                      azimuth < 0.0 ? azimuth + 2.0 * std::numbers::pi : azimuth, pixel.x, pixel.y});
  }
  // Of a double star's two the brighter counts.
  std::ranges::sort(points, {}, [](const NamedPoint& point) { return std::pair(point.name, point.magnitude); });
  const auto doubles = std::ranges::unique(points, {}, &NamedPoint::name);
  points.erase(doubles.begin(), doubles.end());
  std::ranges::sort(points, {}, &NamedPoint::magnitude);
  return points;
}

void add_stars(Plan& plan, const Stage& stage, ImageId through, const Picture& picture) {
  const Part& part = stage.whole();
  physics::Physics p = geometry_of(stage.scene());
  const auto count = [](std::uint32_t n) { return static_cast<int>(n); };
  const std::vector<StarPixel> pixels =
      star_pixels(p, stage.scene(), *stage.night(),
                  {count(picture.x), count(picture.y), count(picture.width), count(picture.height)});
  if (pixels.empty()) {
    return;
  }
  std::vector<float> values;
  for (const StarPixel& pixel : pixels) {
    values.push_back(static_cast<float>(pixel.y * picture.width + pixel.x));
    values.insert(values.end(), {narrowed(pixel.radiance.x), narrowed(pixel.radiance.y), narrowed(pixel.radiance.z)});
  }
  std::vector<Specialization> constants = sunlight_specialization(plan, part.air, through);
  constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  std::vector<Binding> reads{{"transmittance_lut", through},
                             {"stars", plan.add_buffer(filled_buffer("stars", bytes_of(values)))}};
  plan.add_pass(behind_things(plan, part.scene, part.things,
                              {.name = "stars",
                               .shader = "stars",
                               .reads = std::move(reads),
                               .writes = {{"radiance_out", picture.buffer}},
                               .grid = {static_cast<std::uint32_t>(pixels.size()), 1, 1},
                               .push_constants = {static_cast<std::uint32_t>(pixels.size()), picture.width},
                               .specialization = std::move(constants)}));
}

void draw_stars(RadianceImage& picture, physics::Physics& p, const Stage& stage, const Tile& tile) {
  const physics::uint projection = projection_code(stage.scene().camera.projection);
  for (const StarPixel& pixel : star_pixels(p, stage.scene(), *stage.night(), tile)) {
    const double x = tile.x + (pixel.x + 0.5);
    const double y = tile.y + (pixel.y + 0.5);
    const vec3 direction = p.view_ray(p.scene.camera, projection, x, y).direction;
    const vec3 light = pixel.radiance * p.transmittance_from_space(direction);
    float* const at = &picture.rgba[4 * (std::size_t{pixel.y} * static_cast<std::size_t>(tile.width) + pixel.x)];
    at[0] += narrowed(light.x);
    at[1] += narrowed(light.y);
    at[2] += narrowed(light.z);
  }
}

}  // namespace airlight
