#include "app/composite/air.h"

#include "core/air/scene_block.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/choice/aerial.h"
#include "core/render/picture_key.h"

namespace airlight::cli {
namespace {

using composite::Rgb;

Rgb rgb(const physics::vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// Distances are in the fog's own unit, km; heights are above the ground along the flat vertical, as in the published
// forms.
void fill_with_fog(const std::vector<Sample>& samples, const Scene& scene, const composite::Fog& fog, double unit,
                   std::vector<AirTo>& airs) {
  physics::Physics p = geometry_of(scene);
  const physics::uint projection = projection_code(scene.camera.projection);
  const auto width = static_cast<std::uint32_t>(scene.image.width);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!(samples[i].distance < composite::kSky)) {
      continue;
    }
    const auto ray =
        p.view_ray(p.scene.camera, projection, samples[i].pixel % width + 0.5, samples[i].pixel / width + 0.5);
    const composite::FogTerms terms =
        composite::fog_terms(fog, {static_cast<double>(samples[i].distance) / unit, scene.camera.altitude / unit,
                                   ray.direction.y, physics::dot(ray.direction, p.scene.sun.direction)});
    airs[i] = {rgb(terms.adds), rgb(terms.keeps)};
  }
}

// Whether to use the volume: where the order asks for it, or where a tolerance permits it.
bool takes_volume(const CompositeOrder& order, const std::vector<Span>& spans, const Stage& stage,
                  const DeviceOnDemand& device, const SpanWay& volume, FrontAir& out) {
  const Scene& scene = stage.scene();
  const SkyMethod& method = stage.method();
  const bool holds = method.has_volume != nullptr && method.has_volume(scene);
  if (order.aerial == "volume" && !holds) {
    throw InputError(order.beauty +
                     (stage.whole().things.stand_in_the_air()
                          ? ": the scene's things shade the air, and --aerial volume holds no shadows; "
                      : !scene.clouds.empty() ? ": --aerial volume holds no clouds; "
                                              : ": the camera stands above the air, where --aerial volume does not "
                                                "hold; ") +
                     "use --aerial march");
  }
  if (!order.tolerance || !holds) {
    return order.aerial == "volume";
  }
  out.volume_error = choice::volume_error(device(), stage, spans, volume);
  return *out.volume_error <= *order.tolerance;
}

std::vector<Span> spans_of(const std::vector<Sample>& samples, const Scene& scene) {
  const auto width = static_cast<std::uint32_t>(scene.image.width);
  std::vector<Span> spans;
  for (const Sample& sample : samples) {
    if (sample.distance < composite::kSky) {
      spans.push_back({static_cast<std::uint16_t>(sample.pixel % width),
                       static_cast<std::uint16_t>(sample.pixel / width), sample.distance});
    }
  }
  return spans;
}

// A list takes 24 bytes a thing, results included; whole rows of the picture take 20 bytes a pixel.
bool as_rows(const std::vector<Sample>& samples, const std::vector<Span>& spans, const Scene& scene) {
  const auto width = static_cast<std::size_t>(scene.image.width);
  const bool is_picture = samples.size() == width * static_cast<std::size_t>(scene.image.height);
  const auto in_order = [&] {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i].pixel != i) {
        return false;
      }
    }
    return true;
  };
  return is_picture && 24 * spans.size() > 20 * samples.size() && in_order();
}

void march_or_fetch(const CompositeOrder& order, const std::vector<Sample>& samples, const Stage& stage,
                    const DeviceOnDemand& device, FrontAir& out) {
  const Scene& scene = stage.scene();
  out.way = "march";
  std::vector<Span> spans = spans_of(samples, scene);
  if (spans.empty()) {
    return;
  }
  SpanWay way{true, picture_key()};
  if (!takes_volume(order, spans, stage, device, way, out)) {
    way = {};
  }
  out.way = way.volume ? "volume" : "march";
  if (as_rows(samples, spans, scene)) {
    spans.clear();
    std::vector<float> distances;
    distances.reserve(samples.size());
    for (const Sample& sample : samples) {
      distances.push_back(sample.distance);
    }
    out.airs = air_to_all(device(), stage, distances, way, &out.passes);
    return;
  }
  const std::vector<AirTo> found = air_to(device(), stage, spans, way, &out.passes);
  out.airs.assign(samples.size(), AirTo{{}, {1.0F, 1.0F, 1.0F}});
  auto next = found.begin();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].distance < composite::kSky) {
      out.airs[i] = *next++;
    }
  }
}

}  // namespace

FrontAir air_before(const CompositeOrder& order, const std::vector<Sample>& samples, const Stage& stage,
                    const DeviceOnDemand& device) {
  FrontAir out;
  const auto clear_all = [&] { out.airs.assign(samples.size(), AirTo{{}, {1.0F, 1.0F, 1.0F}}); };
  if (const std::optional<composite::Fog> fog = fog_of(order)) {
    clear_all();
    out.way = order.fog;
    fill_with_fog(samples, stage.scene(), *fog, unit_km(order.unit).value_or(1.0), out.airs);
  } else {
    march_or_fetch(order, samples, stage, device, out);
    if (out.airs.empty()) {
      clear_all();
    }
  }
  return out;
}

std::string told(const CompositeOrder& order, const FrontAir& air) {
  if (!order.tolerance) {
    return "air: by " + air.way;
  }
  if (!air.volume_error) {
    return "air: by march; nothing is before the things, or the camera stands above the air, or terrain shades it";
  }
  return "air: by " + air.way + "; the volume's mean error is at most " + percent(*air.volume_error, 2) + " of " +
         percent(*order.tolerance, 2) + " allowed";
}

}  // namespace airlight::cli
