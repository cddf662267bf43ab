#include "core/render/render.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/methods/ready.h"
#include "core/plan/bytes.h"
#include "core/post/host_post.h"
#include "core/render/band_passes.h"
#include "core/render/sky.h"
#include "core/render/tiled.h"
#include "core/render/timings.h"

namespace airlight {
namespace {

struct PlannedFrame {
  Plan plan;
  Picture picture;
  std::optional<BufferId> rows;  // statistics; none: the host computes them from the picture
  std::optional<TableReads> tables;
  std::vector<std::string> left_out;
};

Picture picture_of(const Scene& scene, BufferId buffer) {
  return {buffer, static_cast<std::uint32_t>(scene.image.width), static_cast<std::uint32_t>(scene.image.height)};
}

void note_disc(std::vector<std::string>& left_out, bool shines) {
  if (!shines) {
    left_out.push_back("sun disc: switched off, outside the picture or behind the planet");
  }
}

// Sky, disc and, with `measured`, statistics: all passes before the exposure is known.
PlannedFrame sky_frame(const Stage& stage, const RenderRequest& request, bool measured) {
  const Scene& scene = stage.scene();
  PlannedFrame frame;
  const Sky sky = add_sky(frame.plan, stage, View{}, true);
  frame.picture = picture_of(scene, sky.radiance);
  frame.left_out = spared_by(stage);
  note_disc(frame.left_out, sky.disc);
  frame.tables.emplace(frame.plan, sky, request.tables);
  if (measured) {
    frame.rows = add_picture_statistics(frame.plan, frame.picture, brightest_metered(scene), stage.in_colours());
  }
  return frame;
}

// A buffer with a picture of the host's, for passes that read it. A plan that is only inspected gets no contents.
BufferDesc uploaded(const Scene& scene, const RadianceImage& radiance) {
  const std::size_t size =
      4 * sizeof(float) * static_cast<std::size_t>(scene.image.width) * static_cast<std::size_t>(scene.image.height);
  return {.name = "radiance", .bytes = size, .host_readable = true, .contents = bytes_of(radiance.rgba)};
}

Tile whole_tile(const Scene& scene) {
  return {0, 0, scene.image.width, scene.image.height};
}

struct PostFrame {
  Plan plan;
  std::optional<BufferId> bloom;
  std::optional<BufferId> encoded;
};

Glow add_glow(Plan& plan, const Stage& stage, const Picture& picture, double exposure) {
  const Scene& scene = stage.scene();
  if (scene.bloom.model == BloomModel::glare) {
    return add_glare_sources(plan, glare_points_of(stage));
  }
  return add_bloom(plan, scene, add_bloom_base(plan, scene, picture), exposure);
}

void add_post(PostFrame& post, const Stage& stage, const Picture& picture, const RenderRequest& request, bool glows,
              double exposure) {
  const Scene& scene = stage.scene();
  std::optional<Glow> glow;
  if (glows && (request.bloom_picture || request.gpu_tone)) {
    glow = add_glow(post.plan, stage, picture, exposure);
  }
  if (glow && request.bloom_picture) {
    post.bloom = add_glow_picture(post.plan, scene, picture, *glow);
  }
  if (request.gpu_tone) {
    post.encoded = add_tonemap(post.plan, scene, picture, glow, exposure);
  }
}

RadianceImage image_from(std::span<const std::byte> bytes, int width, int height) {
  return {width, height, values_of<float>(bytes)};
}

// Whether there is bloom to see in the picture.
bool wanted_bloom_glows(const Stage& stage, const RenderRequest& request, Rendering& out) {
  const Scene& scene = stage.scene();
  const bool wants_bloom = request.bloom && scene.bloom.enabled;
  const bool glows = wants_bloom && bloom_glows(stage.whole(), out.picture, out.exposure);
  if (wants_bloom && !glows) {
    out.left_out.push_back(no_bloom(scene));
  }
  return glows;
}

// Bloom and tone curve of a picture that an earlier plan has left on the device under the buffer's key, or that the
// buffer contains.
void run_post(Executor& executor, const Stage& stage, const RenderRequest& request, BufferDesc buffer, bool glows,
              Rendering& out) {
  const Scene& scene = stage.scene();
  PostFrame post;
  post.plan.scene_data = device_scene_bytes(stage.whole().air, scene);
  const Picture picture = picture_of(scene, post.plan.add_buffer(std::move(buffer)));
  add_post(post, stage, picture, request, glows, out.exposure);
  RunResult result = executor.run(post.plan);
  Timings{out.passes, out.host}.add(result);
  if (post.bloom) {
    out.bloom = image_from(result.contents(*post.bloom), scene.image.width, scene.image.height);
  }
  if (post.encoded) {
    out.encoded = values_of<std::uint16_t>(result.contents(*post.encoded));
  }
}

void add_layers(Rendering& out, Executor& executor, const Stage& stage) {
  out.layers = render_layers(executor, stage, {out.passes, out.host});
  for (const Layer& layer : out.layers) {
    out.layer_statistics.push_back(
        {layer.name, layer_statistics(layer, stage.scene().image.width, stage.in_colours())});
  }
}

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

namespace {

Rendering render_there(Executor& executor, const Stage& stage, const RenderRequest& request) {
  const Scene& scene = stage.scene();
  Rendering out;
  PlannedFrame frame = sky_frame(stage, request, !host_measures(executor));
  RunResult result = executor.run(frame.plan, request.host.report);
  Timings{out.passes, out.host}.add(result);
  frame.tables->take(result, out.tables_statistics, out.tables);
  out.left_out = std::move(frame.left_out);
  out.radiance = image_from(result.contents(frame.picture.buffer), scene.image.width, scene.image.height);
  out.picture = frame.rows ? summarize(result.contents(*frame.rows), frame.picture.width)
                           : picture_statistics(out.radiance, scene);
  out.exposure = exposure_for(scene, out.picture);
  if (!out.fault().empty()) {
    return out;
  }
  const bool glows = wanted_bloom_glows(stage, request, out);
  if (glows || request.gpu_tone) {
    BufferDesc carried = frame.plan.buffers()[frame.picture.buffer.index];
    carried.contents.clear();
    run_post(executor, stage, request, std::move(carried), glows, out);
  }
  if (request.layers) {
    add_layers(out, executor, stage);
  }
  return out;
}

// The device is opened only for a bloom chain and for the GPU tone curve.
Rendering render_here(const DeviceOnDemand& device, const Stage& stage, const RenderRequest& request) {
  open_for_finish(device, stage, request);
  Rendering out;
  HostPicture host = stage.method().render_on_host(stage, View{}, request.host);
  out.undone = std::move(host.notes);
  if (!host.standard_error.rgba.empty()) {
    out.standard_error = std::move(host.standard_error);
  }
  out.radiance = std::move(host.radiance);
  note_disc(out.left_out, draw_disc_over(out.radiance, stage, whole_tile(stage.scene())));
  finish(device, stage, request, out);
  return out;
}

}  // namespace

void open_for_finish(const DeviceOnDemand& device, const Stage& stage, const RenderRequest& request) {
  if (needs_whole_picture(stage.scene(), request) || request.gpu_tone) {
    device();
  }
}

void finish(const DeviceOnDemand& device, const Stage& stage, const RenderRequest& request, Rendering& out) {
  const Scene& scene = stage.scene();
  out.picture = picture_statistics(out.radiance, scene);
  out.exposure = exposure_for(scene, out.picture);
  if (!out.fault().empty()) {
    return;
  }
  const bool glows = wanted_bloom_glows(stage, request, out);
  const bool on_device = !samples(stage) || scene.bloom.model == BloomModel::chain;
  if (request.gpu_tone || (glows && on_device)) {
    run_post(device(), stage, request, uploaded(scene, out.radiance), glows, out);
  } else if (glows) {
    out.bloom = glare_picture(scene, glare_points_of(stage), whole_tile(scene));
  }
}

Rendering render(const DeviceOnDemand& device, const Stage& stage, const RenderRequest& request) {
  if (samples(stage)) {
    return render_here(device, stage, request);
  }
  return render_there(device(), stage, request);
}

Plan plan_for(const Stage& stage, const RenderRequest& request) {
  const Scene& scene = stage.scene();
  Plan plan;
  Picture picture;
  const bool wants_bloom = request.bloom && scene.bloom.enabled;
  if (!samples(stage)) {
    PlannedFrame frame = sky_frame(stage, request, true);
    plan = std::move(frame.plan);
    picture = frame.picture;
  } else if (request.gpu_tone || (wants_bloom && scene.bloom.model == BloomModel::chain)) {
    plan.scene_data = device_scene_bytes(stage.whole().air, scene);
    picture = picture_of(scene, plan.add_buffer(uploaded(scene, {})));
  } else {
    return plan;  // nothing runs on a device
  }
  PostFrame post{std::move(plan), {}, {}};
  add_post(post, stage, picture, request, wants_bloom, 1.0);
  return std::move(post.plan);
}

namespace {

// Radiance and transmittance of each listed direction, alternating. `undone`: gets the method's notes.
RadianceImage pairs_of(const DeviceOnDemand& device, const Stage& stage, const View& view,
                       std::vector<std::string>& undone) {
  const auto count = static_cast<int>(view.directions.size());
  if (!samples(stage)) {
    Plan plan;
    const Sky sky = add_sky(plan, stage, view, false);
    const RunResult result = device().run(plan);
    return image_from(result.contents(sky.radiance), 2 * count, 1);
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

}  // namespace

ProbeResults probe(const DeviceOnDemand& device, const Stage& stage, const std::vector<Direction>& directions) {
  ProbeResults results;
  if (directions.empty()) {
    return results;
  }
  const RadianceImage pairs = pairs_of(device, stage, View{directions}, results.undone);
  const Rgb unit = stage.sunlight();
  for (std::size_t i = 0; i < directions.size(); ++i) {
    ProbeResult r;
    r.direction = directions[i];
    for (std::size_t c = 0; c < 3; ++c) {
      r.radiance[c] = static_cast<double>(pairs.rgba[8 * i + c]);
      r.transmittance[c] = static_cast<double>(pairs.rgba[8 * i + 4 + c]) / unit[c];
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
