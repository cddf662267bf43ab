#include "core/render/render.h"

#include <cassert>
#include <cstring>
#include <span>
#include <utility>

#include "core/methods/scene_air.h"
#include "core/render/sky.h"
#include "core/render/timings.h"

namespace airlight {
namespace {

struct Frame {
  Plan plan;
  Picture picture;
  BufferId rows;
  std::vector<BufferId> table_rows;
  std::vector<ImageId> tables;
  std::vector<BufferId> dumps;
  std::vector<std::string> left_out;
};

Picture picture_of(const Scene& scene, BufferId buffer) {
  return {buffer, static_cast<std::uint32_t>(scene.image.width), static_cast<std::uint32_t>(scene.image.height)};
}

const SkyMethod& method_of(const Scene& scene) {
  const SkyMethod* method = find_method(scene.render.method);
  assert(method != nullptr);  // resolve() refuses unknown names
  return *method;
}

void note_disc(Frame& frame, bool shines) {
  if (!shines) {
    frame.left_out.push_back("sun disc: switched off, outside the picture or behind the planet");
  }
}

// Sky, disc and statistics: everything before the exposure is known.
Frame sky_frame(const Scene& scene, const RenderRequest& request) {
  Frame frame;
  const Sky sky = add_sky(frame.plan, scene, View{}, true);
  frame.picture = picture_of(scene, sky.radiance);
  frame.tables = sky.tables;
  note_disc(frame, sky.disc);
  for (const ImageId table : sky.tables) {
    frame.table_rows.push_back(add_table_statistics(frame.plan, table));
    if (request.tables) {
      frame.dumps.push_back(frame.plan.add_readback(table));
    }
  }
  frame.rows = add_picture_statistics(frame.plan, frame.picture, brightest_metered(scene), scene.spectra.has_value());
  return frame;
}

// Uploads what a method rendered on the host, so that the passes after it are the same. Nothing, in a plan that is only
// looked at.
Frame host_frame(const Scene& scene, const RadianceImage& radiance) {
  Frame frame;
  frame.plan.scene_data = device_scene_bytes(air_of(scene), scene);
  std::vector<std::byte> bytes(radiance.rgba.size() * sizeof(float));
  if (!bytes.empty()) {
    std::memcpy(bytes.data(), radiance.rgba.data(), bytes.size());
  }
  const std::size_t size =
      4 * sizeof(float) * static_cast<std::size_t>(scene.image.width) * static_cast<std::size_t>(scene.image.height);
  frame.picture = picture_of(
      scene, frame.plan.add_buffer(
                 {.name = "radiance", .bytes = size, .host_readable = true, .contents = std::move(bytes), .key = {}}));
  note_disc(frame,
            add_disc_over(frame.plan, scene, frame.picture.buffer, {0, 0, scene.image.width, scene.image.height}));
  frame.rows = add_picture_statistics(frame.plan, frame.picture, brightest_metered(scene), scene.spectra.has_value());
  return frame;
}

struct PostFrame {
  Plan plan;
  std::optional<BufferId> bloom;
  std::optional<BufferId> encoded;
};

Glow add_glow(Plan& plan, const Scene& scene, const Air& air, const Picture& picture, double exposure) {
  if (scene.bloom.model == BloomModel::glare) {
    return add_glare_sources(plan, scene, air);
  }
  return add_bloom(plan, scene, add_bloom_base(plan, scene, picture), exposure);
}

void add_post(PostFrame& post, const Scene& scene, const Air& air, const Picture& picture, const RenderRequest& request,
              bool glows, double exposure) {
  std::optional<Glow> glow;
  if (glows && (request.bloom_picture || request.gpu_tone)) {
    glow = add_glow(post.plan, scene, air, picture, exposure);
  }
  if (glow && request.bloom_picture) {
    post.bloom = add_glow_picture(post.plan, scene, picture, *glow);
  }
  if (request.gpu_tone) {
    post.encoded = add_tonemap(post.plan, scene, picture, glow, exposure);
  }
}

RadianceImage image_from(std::span<const std::byte> bytes, int width, int height) {
  RadianceImage image{width, height, {}};
  image.rgba.resize(bytes.size() / sizeof(float));
  std::memcpy(image.rgba.data(), bytes.data(), bytes.size());
  return image;
}

void take_tables(Rendering& out, const Frame& frame, const RunResult& result) {
  for (std::size_t i = 0; i < frame.tables.size(); ++i) {
    const ImageDesc& image = frame.plan.images()[frame.tables[i].index];
    out.tables_statistics.push_back({image.name, summarize(result.contents(frame.table_rows[i]), image.extent.width)});
    if (!frame.dumps.empty()) {
      const auto width = static_cast<int>(image.extent.width);
      const auto height = static_cast<int>(image.extent.height);
      out.tables.push_back(
          {image.name, width, height, image_from(result.contents(frame.dumps[i]), width, height).rgba});
    }
  }
}

// Bloom and tone curve of the picture that the first plan left on the device.
void run_post(Executor& executor, const Scene& scene, const Air& air, const RenderRequest& request, const Plan& first,
              const Picture& picture, Rendering& out) {
  const bool wants_bloom = request.bloom && scene.bloom.enabled;
  const bool glows = wants_bloom && bloom_glows(scene, air, out.picture, out.exposure);
  if (wants_bloom && !glows) {
    out.left_out.push_back(no_bloom(scene));
  }
  if (!glows && !request.gpu_tone) {
    return;
  }
  PostFrame post;
  post.plan.scene_data = device_scene_bytes(air, scene);
  BufferDesc carried = first.buffers()[picture.buffer.index];
  const bool kept = !carried.key.empty();
  if (kept) {
    carried.contents.clear();
  } else {
    std::memcpy(carried.contents.data(), out.radiance.rgba.data(), carried.contents.size());  // with the disc
  }
  const Picture again = picture_of(scene, post.plan.add_buffer(std::move(carried)));
  add_post(post, scene, air, again, request, glows, out.exposure);
  RunResult result = executor.run(post.plan);
  Timings{out.passes, out.host}.add(result);
  if (post.bloom) {
    out.bloom = image_from(result.contents(*post.bloom), scene.image.width, scene.image.height);
  }
  if (post.encoded) {
    const std::span<const std::byte> bytes = result.contents(*post.encoded);
    out.encoded.resize(bytes.size() / sizeof(std::uint16_t));
    std::memcpy(out.encoded.data(), bytes.data(), bytes.size());
  }
}

void add_layers(Rendering& out, Executor& executor, const Scene& scene) {
  out.layers = render_layers(executor, scene, {out.passes, out.host});
  for (const Layer& layer : out.layers) {
    out.layer_statistics.push_back({layer.name, layer_statistics(layer, scene.image.width)});
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

Rendering render(const DeviceOnDemand& device, const Scene& scene, const RenderRequest& request) {
  Rendering out;
  const SkyMethod& method = method_of(scene);
  // Opened before a method on the host begins: hours of samples must not end in a machine that lacks a device.
  Executor& executor = device();
  Frame frame;
  if (method.render_on_host != nullptr) {
    HostPicture host = render_on_host(scene, View{}, request.host);
    frame = host_frame(scene, host.radiance);
    out.undone = std::move(host.notes);
    if (!host.standard_error.rgba.empty()) {
      out.standard_error = std::move(host.standard_error);
    }
  } else {
    frame = sky_frame(scene, request);
  }
  // A method on the host has reported its own work.
  RunResult result = executor.run(frame.plan, method.render_on_host ? nullptr : request.host.report);
  Timings{out.passes, out.host}.add(result);
  take_tables(out, frame, result);
  out.left_out = std::move(frame.left_out);
  out.picture = summarize(result.contents(frame.rows), frame.picture.width);
  out.exposure = exposure_for(scene, out.picture);
  out.radiance = image_from(result.contents(frame.picture.buffer), scene.image.width, scene.image.height);
  if (out.fault().empty()) {
    run_post(executor, scene, air_of(scene), request, frame.plan, frame.picture, out);
    if (request.layers) {
      add_layers(out, executor, scene);
    }
  }
  return out;
}

Plan plan_for(const Scene& scene, const RenderRequest& request) {
  Frame frame = method_of(scene).render_on_host != nullptr ? host_frame(scene, {}) : sky_frame(scene, request);
  PostFrame post{std::move(frame.plan), {}, {}};
  add_post(post, scene, air_of(scene), frame.picture, request, request.bloom && scene.bloom.enabled, 1.0);
  return std::move(post.plan);
}

ProbeResults probe(const DeviceOnDemand& device, const Scene& scene, const std::vector<Direction>& directions) {
  ProbeResults results;
  if (directions.empty()) {
    return results;
  }
  const SkyMethod& method = method_of(scene);
  const View view{directions};
  RadianceImage pairs;  // radiance and transmittance in turn
  if (method.render_on_host != nullptr) {
    HostPicture host = render_on_host(scene, view, {});
    results.undone = std::move(host.notes);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      for (const RadianceImage* image : {&host.radiance, &host.transmittance}) {
        pairs.rgba.insert(pairs.rgba.end(), image->at(static_cast<int>(i), 0), image->at(static_cast<int>(i), 0) + 4);
      }
    }
  } else {
    Plan plan;
    const Sky sky = add_sky(plan, scene, view, false);
    const RunResult result = device().run(plan);
    pairs = image_from(result.contents(sky.radiance), static_cast<int>(2 * directions.size()), 1);
  }
  const Rgb unit = transmittance_unit(scene);
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

std::vector<float> probe_picture(const DeviceOnDemand& device, const Scene& scene,
                                 const std::vector<Direction>& directions) {
  if (directions.empty()) {
    return {};
  }
  const SkyMethod& method = method_of(scene);
  const View view{.directions = directions, .as_picture = true};
  std::vector<float> rgb;
  const auto append = [&](const float* pixel) { rgb.insert(rgb.end(), pixel, pixel + 3); };
  if (method.render_on_host != nullptr) {
    const HostPicture host = render_on_host(scene, view, {});
    for (std::size_t i = 0; i < directions.size(); ++i) {
      append(host.radiance.at(static_cast<int>(i), 0));
    }
    return rgb;
  }
  Plan plan;
  const Sky sky = add_sky(plan, scene, view, false);
  const RunResult result = device().run(plan);
  const RadianceImage pairs = image_from(result.contents(sky.radiance), static_cast<int>(2 * directions.size()), 1);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    append(pairs.at(static_cast<int>(2 * i), 0));
  }
  return rgb;
}

std::vector<TableDump> bake_tables(const DeviceOnDemand& device, const Scene& scene) {
  Scene one_pixel = scene;
  one_pixel.image = {1, 1};
  RenderRequest request;
  request.tables = true;
  return render(device, one_pixel, request).tables;
}

}  // namespace airlight
