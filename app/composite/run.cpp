// `airlight composite`: adds the air to the pictures of other programs.

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "app/cli/json_writer.h"
#include "app/cli/picture_options.h"
#include "app/cli/terminal.h"
#include "app/composite/air.h"
#include "app/composite/foreground.h"
#include "app/composite/order.h"
#include "app/render/picture_files.h"
#include "app/render/report.h"
#include "core/air/scene_block.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/library/validity.h"
#include "core/measure/frames.h"
#include "core/methods/ready.h"
#include "core/output/atomic_file.h"
#include "core/output/finite.h"
#include "core/output/parallel.h"
#include "core/scene/angle.h"
#include "core/sequence/frame_files.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;
using composite::Rgb;

// Number of parts of a deep sample with a back.
constexpr int kParts = 4;

// One frame's pixels, in linear Rec.709, rows from the top.
struct Composite {
  std::vector<Rgb> colours;
  std::vector<Rgb> inscatter;
  std::vector<Rgb> transmittance;
  std::vector<float> alpha;  // of a deep picture, flattened
};

Rgb pixel_of(const RadianceImage& sky, std::size_t pixel) {
  if (sky.rgba.empty()) {
    return {};
  }
  return {sky.rgba[4 * pixel], sky.rgba[4 * pixel + 1], sky.rgba[4 * pixel + 2]};
}

std::vector<Sample> samples_of(const Foreground& fore) {
  std::vector<Sample> samples;
  samples.reserve(fore.things.size());
  for (std::size_t i = 0; i < fore.things.size(); ++i) {
    const auto pixel = fore.pixel_of.empty() ? static_cast<std::uint32_t>(i) : fore.pixel_of[i];
    const bool thick = !fore.backs.empty() && fore.backs[i] < composite::kSky && fore.backs[i] > fore.distances[i];
    if (!thick) {
      samples.push_back({pixel, fore.things[i], fore.distances[i]});
      continue;
    }
    const std::vector<composite::Thing> parts = composite::split(fore.things[i], kParts);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const float place = (static_cast<float>(k) + (parts.size() > 1 ? 0.5F : 0.0F)) / kParts;
      samples.push_back({pixel, parts[k], fore.distances[i] + place * (fore.backs[i] - fore.distances[i])});
    }
  }
  if (!fore.pixel_of.empty()) {
    // Nearest first; samples without depth last.
    std::ranges::stable_sort(samples, [](const Sample& a, const Sample& b) {
      return a.pixel != b.pixel ? a.pixel < b.pixel : a.distance < b.distance;
    });
  }
  return samples;
}

// Removes things that those of the scene hide: there the picture shows the scene's.
void hide_behind_things(std::vector<Sample>& samples, const Stage& stage) {
  const Scene& scene = stage.scene();
  const physics::uint projection = projection_code(scene.camera.projection);
  const auto width = static_cast<std::uint32_t>(scene.image.width);
  for_row_strips(static_cast<int>(samples.size()), [&](int first, int end) {
    physics::Physics p = geometry_of(scene);
    stage.whole().things.put_into(p);
    for (int i = first; i < end; ++i) {
      Sample& sample = samples[static_cast<std::size_t>(i)];
      if (!(sample.distance < composite::kSky)) {
        continue;
      }
      const auto view = p.view_ray(p.scene.camera, projection, sample.pixel % width + 0.5, sample.pixel / width + 0.5);
      const auto hit = p.nearest_thing(p.scene.planet, p.sight_of(view.direction), physics::kNoBody);
      if (p.hits_thing(hit) && static_cast<double>(sample.distance) > hit.distance_) {
        sample.thing = {{}, 0.0F};
        sample.distance = composite::kSky;
      }
    }
  });
}

// `with_air`: also returns inscatter and transmittance.
Composite blended(const Foreground& fore, const std::vector<Sample>& samples, const std::vector<AirTo>& airs,
                  const RadianceImage& sky, bool with_air) {
  const auto pixels = static_cast<std::size_t>(fore.picture.width) * static_cast<std::size_t>(fore.picture.height);
  Composite out;
  out.colours.reserve(pixels);
  if (with_air) {
    out.inscatter.assign(pixels, Rgb{});
    out.transmittance.assign(pixels, Rgb{1.0F, 1.0F, 1.0F});
  }
  std::vector<composite::Thing> things;
  std::size_t first = 0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    std::size_t last = first;
    things.clear();
    float clear = 1.0F;
    for (; last < samples.size() && samples[last].pixel == pixel; ++last) {
      things.push_back(samples[last].thing);
      clear *= 1.0F - samples[last].thing.alpha;
    }
    const std::span<const AirTo> mine(airs.data() + first, last - first);
    const Rgb behind = pixel_of(sky, pixel);
    out.colours.push_back(fore.picture.deep ? composite::behind_air(things, mine, behind)
                                            : composite::behind_air(things.front(), mine.front(), behind));
    if (with_air && !mine.empty()) {
      out.inscatter[pixel] = mine.front().radiance;
      out.transmittance[pixel] = mine.front().transmittance;
    }
    if (fore.picture.deep) {
      out.alpha.push_back(1.0F - clear);
    }
    first = last;
  }
  return out;
}

bool needs_sky(const std::vector<Sample>& samples, const Foreground& fore) {
  return fore.picture.deep || std::ranges::any_of(samples, [](const Sample& sample) {
           return sample.thing.alpha < 1.0F || !(sample.distance < composite::kSky);
         });
}

std::vector<float> planes_in(const std::vector<Rgb>& colours, WorkingSpace space) {
  RadianceImage image{static_cast<int>(colours.size()), 1, {}};
  image.rgba.reserve(4 * colours.size());
  for (const Rgb& c : colours) {
    image.rgba.insert(image.rgba.end(), {c[0], c[1], c[2], 1.0F});
  }
  return converted(std::move(image), WorkingSpace::linear_rec709, space).rgba;
}

// The file: the new colours in place of the beauty's, its other channels unchanged, the requested layers.
ExrFile encoded(const CompositeOrder& order, const Foreground& fore, const Composite& made,
                const PictureContext& context) {
  const WorkingSpace space = order.colorspace.empty() ? fore.space : *working_space(order.colorspace);
  const bool was_half = fore.picture.find(fore.colours[0])->half;
  const bool half = order.half || (was_half && !order.full_float);
  const std::vector<float> colours = planes_in(made.colours, space);
  const ExtraLayers extra = extra_layers(order.layers);
  const std::vector<float> inscatter = extra.inscatter ? planes_in(made.inscatter, space) : std::vector<float>();
  const std::vector<float> through = extra.transmittance ? planes_in(made.transmittance, space) : std::vector<float>();
  std::vector<ExrChannel> channels;
  for (std::size_t c = 0; c < 3; ++c) {
    channels.push_back({fore.colours[c], colours.data() + c, 4, !half});
  }
  if (fore.picture.deep) {
    if (!fore.alpha.empty()) {
      channels.push_back({fore.alpha, made.alpha.data(), 1, !half});
    }
  } else {
    for (const foreign::Channel& channel : fore.picture.channels) {
      if (std::ranges::find(fore.colours, channel.name) == fore.colours.end()) {
        channels.push_back({channel.name, channel.values.data(), 1, !channel.half});
      }
    }
  }
  const auto add = [&](const char* layer, const std::vector<float>& planes) {
    for (std::size_t c = 0; c < 3 && !planes.empty(); ++c) {
      channels.push_back({std::string(layer) + "." + "RGB"[c], planes.data() + c, 4, !half});
    }
  };
  add("inscatter", inscatter);
  add("transmittance", through);
  ExrOptions options = exr_options(context, true);
  options.space = space;
  return encode_exr(fore.picture.width, fore.picture.height, channels, options);
}

struct Frame {
  std::string beauty;
  std::string depth;
  std::string output;
};

std::string percent(std::size_t part, std::size_t whole) {
  return airlight::percent(static_cast<double>(part) / static_cast<double>(whole), 3);
}

void tell_about(const CompositeOrder& order, const Foreground& fore, const Frame& frame, const FrontAir& air,
                const ExrCounts& counts) {
  if (order.quiet) {
    return;
  }
  for (const std::string& warning : mended_warnings(fore.mended, frame.beauty)) {
    complain("warning: " + warning);
  }
  if (fore.counts.nan > 0) {
    complain("warning: " + frame.beauty + ": " + std::to_string(fore.counts.nan) +
             " depths are not numbers; they are taken as sky");
  }
  if (fore.replaced > 0) {
    complain("note: " + frame.beauty + ": " + std::to_string(fore.replaced) +
             " opaque pixels have no depth; the sky takes the place of their background");
  }
  if (fore.picture.is_airlight && order.layer.empty()) {
    complain("note: " + frame.beauty + ": is a picture of airlight's: what air is in it already stays under the air " +
             "put before it");
  }
  for (const std::string& warning : exr_warnings(counts)) {
    complain("warning: " + warning);
  }
  tell(fore.camera + "; " + percent(fore.counts.sky, fore.things.size()) + " of the depths are sky\n" +
       told(order, air) + "\n" + frame.output + "\n");
}

// The device's milliseconds by pass.
void write_passes(JsonWriter& json, const std::vector<PassTiming>& passes) {
  json.begin_object();
  for (const PassTiming& pass : passes) {
    json.key(pass.name).value(pass.milliseconds);
  }
  json.end_object();
}

std::string as_json(const Foreground& fore, const Frame& frame, const FrontAir& air, const Rendering& sky) {
  JsonWriter json;
  json.begin_object().key("file").value(frame.output).key("camera").value(fore.camera);
  json.key("samples").value(static_cast<double>(fore.things.size()));
  json.key("sky").value(static_cast<double>(fore.counts.sky));
  json.key("nan_depths").value(static_cast<double>(fore.counts.nan));
  json.key("mended_colours").value(static_cast<double>(fore.mended.colours.count));
  json.key("mended_alphas").value(static_cast<double>(fore.mended.alphas.count));
  json.key("background_replaced").value(static_cast<double>(fore.replaced));
  json.key("air").value(air.way).key("volume_error").value(air.volume_error);
  json.key("air_passes_ms");
  write_passes(json, air.passes);
  json.key("sky_passes_ms");
  write_passes(json, sky.passes);
  return json.end_object().take();
}

// Empty where the air before things lacks nothing that counts: with the sun at -4 degrees the smooth light of the night
// adds at most 4e-4 to the sky of `earth`.
std::string night_warning(const Scene& scene) {
  constexpr double kBrightDusk = -4.0;
  const bool counts = scene.night_sky && degrees_from_radians(scene.sun.elevation) < kBrightDusk;
  return counts ? "the air before things has the light of sun and moon alone; that of night_sky is left out there, so "
                  "far things are darker than the sky behind them"
                : "";
}

// `preset`: the preset's own scene. A frame has its camera.
void composite_frame(const CompositeOrder& order, const Frame& frame, const Stage& preset,
                     const DeviceOnDemand& device) {
  Scene scene = preset.scene();
  const Foreground fore = read_foreground(order, frame.beauty, frame.depth, scene);
  const Stage stage = ready(scene, preset);
  if (!order.quiet) {
    std::vector<std::string> warnings = scene_warnings(stage);
    if (std::string night = night_warning(scene); !night.empty()) {
      warnings.push_back(std::move(night));
    }
    for (const std::string& warning : warnings) {
      complain("warning: " + warning);
    }
  }
  std::vector<Sample> samples = samples_of(fore);
  if (stage.whole().things.stand_in_the_air()) {
    hide_behind_things(samples, stage);
  }
  Rendering sky;
  if (needs_sky(samples, fore)) {
    sky = render(device, stage, {});
    if (!sky.fault().empty()) {
      throw RunError(order.scene.preset + ": " + sky.fault() + "; nothing was written");
    }
  }
  const FrontAir air = air_before(order, samples, stage, device);
  require_valid_vulkan();
  const Composite made = blended(fore, samples, air.airs, sky.radiance, !order.layers.empty());
  const auto width = static_cast<std::size_t>(fore.picture.width);
  for (const auto& [name, colours] : {std::pair{"the picture", &made.colours}, {"inscatter", &made.inscatter}}) {
    const std::string fault = finite_fault(name, planes_in(*colours, WorkingSpace::linear_rec709), width, 4);
    if (!fault.empty()) {
      throw RunError(frame.beauty + ": " + fault + "; nothing was written: look for values near the largest float");
    }
  }
  const PictureContext context{
      scene, sky, {to_json(scene), scene.render.method, AIRLIGHT_VERSION, device().device().name}};
  const ExrFile file = encoded(order, fore, made, context);
  write_file(frame.output, file.bytes);
  tell_about(order, fore, frame, air, file.counts);
  if (order.json) {
    print(as_json(fore, frame, air, sky));
  }
}

// "FILE:CHANNEL" with the frame's number in FILE.
std::string depth_of_frame(const std::string& depth, long number) {
  const std::size_t colon = depth.rfind(':');
  const bool has_channel = colon != std::string::npos && depth.find('/', colon) == std::string::npos;
  const std::string file = has_channel ? depth.substr(0, colon) : depth;
  const std::optional<measure::FramePattern> pattern = measure::frame_pattern(file);
  return pattern ? sequence::frame_file(*pattern, number) + (has_channel ? depth.substr(colon) : "") : depth;
}

std::vector<Frame> frames_of(const CompositeOrder& order) {
  const std::optional<measure::FramePattern> beauty = measure::frame_pattern(order.beauty);
  const std::optional<measure::FramePattern> output = measure::frame_pattern(order.output);
  if (beauty.has_value() != output.has_value()) {
    throw InputError("composite: --beauty " + order.beauty + " and -o " + order.output +
                     ": give both as patterns of frames (sky.####.exr) or neither");
  }
  if (!beauty) {
    return {{order.beauty, order.depth, order.output}};
  }
  std::map<long, std::string> found;
  std::error_code problem;
  for (const fs::directory_entry& entry : fs::directory_iterator(beauty->folder, problem)) {
    if (const std::optional<long> number = measure::frame_number(*beauty, entry.path().filename().string())) {
      found[*number] = sequence::frame_file(*beauty, *number);
    }
  }
  if (found.empty()) {
    throw InputError(order.beauty + ": no frame of this pattern is there; --beauty needs the files of another program");
  }
  std::vector<Frame> frames;
  for (const auto& [number, file] : found) {
    frames.push_back({file, depth_of_frame(order.depth, number), sequence::frame_file(*output, number)});
  }
  return frames;
}

void require_spans(const Scene& scene, bool by_method) {
  if (scene.camera.polariser) {
    throw InputError(
        "composite: camera.polariser: nothing tells how the beauty's light is polarised, so no filter can "
        "be put before it; take the filter out of the preset");
  }
  if (!by_method) {
    return;
  }
  if (method_of(scene).add_span_passes != nullptr) {
    if (const std::string why = no_layers(scene); !why.empty()) {
      throw InputError("composite: " + why);
    }
    return;
  }
  const std::string names = joined_of(methods(), [](const SkyMethod& method) {
    return method.add_span_passes != nullptr ? method.info.name : std::string_view();
  });
  throw InputError("composite: the method " + scene.render.method +
                   " does not tell the air before a thing from the sky behind it; choose " + names + " with --method");
}

// Refuses an output that is also the input: a second run would add the air twice, and the picture without air would be
// lost.
void require_other_file(const Frame& frame) {
  for (const std::string& input : {frame.beauty, depth_place(frame.depth, frame.beauty).file}) {
    std::error_code absent;
    if (fs::equivalent(frame.output, input, absent)) {
      throw InputError("composite: -o " + frame.output + " is the file " + input +
                       " that it reads, which would be lost; write to another name");
    }
  }
}

}  // namespace

int run_composite(const CompositeOrder& order) {
  check(order);
  const std::vector<Frame> frames = frames_of(order);
  const Stage preset = ready(load_scene(order.scene));
  require_spans(preset.scene(), order.fog.empty());
  for (const Frame& frame : frames) {
    require_ending(frame.output, "composite: -o", ".exr");
    require_other_file(frame);
    require_writable(frame.output);
  }
  std::unique_ptr<Executor> executor;
  const DeviceOnDemand device = device_on_demand(order.scene, executor);
  for (const Frame& frame : frames) {
    composite_frame(order, frame, preset, device);
  }
  return 0;
}

}  // namespace airlight::cli
