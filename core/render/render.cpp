#include "core/render/render.h"

#include <algorithm>
#include <utility>

#include "core/methods/ready.h"
#include "core/methods/sky_pass.h"
#include "core/plan/bytes.h"
#include "core/post/night_sky.h"
#include "core/render/after_sky.h"
#include "core/render/bands.h"
#include "core/render/sky.h"

namespace airlight {
namespace {

std::string fault_line(const std::string& name, const Statistics& s) {
  return name + " holds " + std::to_string(s.not_finite) + " non-finite and " + std::to_string(s.negative) +
         " negative values, the first at column " + std::to_string(s.first_bad_x) + ", row " +
         std::to_string(s.first_bad_y);
}

}  // namespace

std::string Rendering::picture_fault() const {
  for (const NamedStatistics& table : tables_statistics) {
    if (!table.statistics.sound()) {
      return fault_line("the table " + table.name, table.statistics);
    }
  }
  return picture.sound() ? std::string() : fault_line("the picture", picture);
}

std::string Rendering::fault() const {
  if (std::string in_picture = picture_fault(); !in_picture.empty()) {
    return in_picture;
  }
  for (const NamedStatistics& layer : layer_statistics) {
    if (!layer.statistics.sound()) {
      return fault_line("the layer " + layer.name, layer.statistics);
    }
  }
  return {};
}

void open_for_post(const DeviceOnDemand& device, const Stage& stage, const RenderRequest& request) {
  if (needs_whole_picture(stage.scene(), request) || request.gpu_tone) {
    device();
  }
}

Rendering render(const DeviceOnDemand& device, const Stage& stage, const RenderRequest& request) {
  Pixels pixels;
  const BandsRequest one_band{
      .picture = request, .past_faults = true, .sink = [&](Band& band) { pixels = std::move(band.rows); }};
  Rendering out = render_bands(device, stage, one_band);
  static_cast<Pixels&>(out) = std::move(pixels);
  return out;
}

Plan plan_for(const Stage& stage, const RenderRequest& request) {
  if (request.spectrum) {
    const Stage listed = ready_at(stage.scene(), *request.spectrum, stage);
    return plan_for(ready_part(listed.parts().front().scene, listed, 0), {});
  }
  const Scene& scene = stage.scene();
  const Tile whole{0, 0, scene.image.width, scene.image.height};
  Plan plan;
  Picture picture;
  if (!samples(stage)) {
    const Sky sky = add_sky(plan, stage, View{.directions = {}, .all_lights = request.tables}, true);
    const TableReads reads(plan, sky, request.tables);
    picture = picture_of(sky.radiance, whole);
    add_picture_statistics(plan, picture, brightest_metered(scene), stage.in_colours());
  } else if (needs_whole_picture(scene, request) || request.gpu_tone) {
    plan.scene_data = device_scene_bytes(stage.whole().air, scene);
    picture = picture_of(plan.add_buffer(uploaded_radiance(whole)), whole);
  } else {
    return plan;  // nothing runs on a device
  }
  std::optional<Bloomed> bloom;
  if (request.bloom && scene.bloom.enabled) {
    bloom = bloom_of(stage);
  }
  PostPasses(plan, scene, picture, request, bloom, 1.0);
  return plan;
}

namespace {

// Radiance and transmittance of each listed direction, alternating, or four values each with Q and U (View::stokes).
// `undone`: gets the method's notes.
RadianceImage pairs_by_light(const DeviceOnDemand& device, const Stage& stage, const View& view,
                             std::vector<std::string>& undone) {
  const auto count = static_cast<int>(view.directions.size());
  if (!samples(stage)) {
    Plan plan;
    const Sky sky = add_sky(plan, stage, view, false);
    const RunResult result = device().run(plan);
    const int values = static_cast<int>(vectors_of(view)) * count;
    return RadianceImage{values, 1, values_of<float>(result.contents(sky.radiance))};
  }
  HostPicture host = stage.method().render_on_host(stage, view, {});
  undone = std::move(host.notes);
  RadianceImage pairs{2 * count, 1, {}};
  for (int i = 0; i < count; ++i) {
    for (const RadianceImage* image : {&host.radiance, &host.transmittance}) {
      pairs.rgba.insert(pairs.rgba.end(), image->at(i, 0), image->at(i, 0) + 4);
    }
  }
  return pairs;
}

// The same in all lights.
RadianceImage pairs_of(const DeviceOnDemand& device, const Stage& stage, const View& view,
                       std::vector<std::string>& undone) {
  RadianceImage pairs = pairs_by_light(device, stage, view, undone);
  const std::size_t each = view.stokes ? 16 : 8;
  for (const Stage& other : stage.others()) {
    const RadianceImage more = pairs_by_light(device, other, view, undone);
    for (std::size_t i = 0; i < pairs.rgba.size(); ++i) {
      const bool is_transmittance = i % each >= 4 && i % each < 8;
      pairs.rgba[i] += is_transmittance || i % 4 == 3 ? 0.0F : more.rgba[i];
    }
  }
  if (stage.scene().night_sky) {
    physics::Physics p = night_formulas(stage);
    for (std::size_t i = 0; i < view.directions.size(); ++i) {
      const Direction& d = view.directions[i];
      const physics::vec3 light = night_sky_along(p, p.direction_from_angles(d.elevation, d.azimuth));
      pairs.rgba[each * i] += narrowed(light.x);
      pairs.rgba[each * i + 1] += narrowed(light.y);
      pairs.rgba[each * i + 2] += narrowed(light.z);
    }
  }
  return pairs;
}

}  // namespace

Stage without_filter(const Stage& stage) {
  Scene scene = stage.scene();
  scene.camera.polariser.reset();
  return ready(scene, stage);
}

View probe_view(const Stage& stage, const std::vector<Direction>& directions) {
  return {.directions = directions, .stokes = stage.method().has_stokes && stage.scene().render.polarisation};
}

ProbeResults probe(const DeviceOnDemand& device, const Stage& stage, const std::vector<Direction>& directions) {
  ProbeResults results;
  if (directions.empty()) {
    return results;
  }
  if (stage.scene().camera.polariser) {
    return probe(device, without_filter(stage), directions);
  }
  const View view = probe_view(stage, directions);
  const RadianceImage pairs = pairs_of(device, stage, view, results.undone);
  const Rgb unit = stage.sunlight();
  for (std::size_t i = 0; i < directions.size(); ++i) {
    ProbeResult r;
    r.direction = directions[i];
    const auto triple = [&](std::size_t k) {
      const float* const at = pairs.at(static_cast<int>(vectors_of(view) * i + k), 0);
      return std::array<double, 3>{double{at[0]}, double{at[1]}, double{at[2]}};
    };
    r.radiance = triple(0);
    for (std::size_t c = 0; c < 3; ++c) {
      r.transmittance[c] = triple(1)[c] / unit[c];
    }
    if (view.stokes) {
      r.q = triple(2);
      r.u = triple(3);
    }
    results.directions.push_back(r);
  }
  return results;
}

std::vector<float> probe_picture(const DeviceOnDemand& device, const Stage& stage,
                                 const std::vector<Direction>& directions) {
  std::vector<float> rgb;
  if (directions.empty()) {
    return rgb;
  }
  std::vector<std::string> ignored;
  const RadianceImage pairs = pairs_of(device, stage, View{.directions = directions, .as_picture = true}, ignored);
  for (int i = 0; i < pairs.width; i += 2) {
    rgb.insert(rgb.end(), pairs.at(i, 0), pairs.at(i, 0) + 3);
  }
  return rgb;
}

std::vector<TableDump> bake_tables(const DeviceOnDemand& device, const Stage& stage) {
  Scene one_pixel = stage.scene();
  one_pixel.image = {1, 1};
  const SkyMethod& method = stage.method();
  for (const auto& [key, value] : method.all_tables) {
    const auto is_it = [&name = key](const ParameterInfo& parameter) { return parameter.key == name; };
    ParameterValue& chosen = one_pixel.render.parameters.find(key)->second;
    chosen = chosen == std::ranges::find_if(method.info.parameters, is_it)->default_value ? value : chosen;
  }
  RenderRequest request;
  request.tables = true;
  return render(device, ready(one_pixel, stage), request).tables;
}

}  // namespace airlight
