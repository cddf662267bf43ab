#include "app/render/picture_files.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/air/scene_block.h"
#include "core/base/srgb.h"
#include "core/base/text.h"
#include "core/output/png.h"
#include "core/output/provenance_keys.h"
#include "core/output/quantize.h"
#include "core/output/rods.h"
#include "core/output/spectral_layout.h"
#include "core/scene/angle.h"
#include "core/scene/json_format.h"
#include "core/scene/photometry.h"

namespace airlight::cli {
namespace {

Axis axis(const physics::vec3& v) {
  return {v.x, v.y, v.z};
}

std::array<float, 3> floats_of(const Vector3& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

// The GPU tone curve's 16-bit picture as floats, so that 8 bits are dithered as those of any other view.
RadianceImage gpu_picture(const Rendering& rows) {
  RadianceImage picture{rows.radiance.width, rows.radiance.height, {}};
  picture.rgba.reserve(rows.encoded.size());
  for (const std::uint16_t value : rows.encoded) {
    picture.rgba.push_back(static_cast<float>(value) / 65535.0F);
  }
  return picture;
}

struct NumberKind {
  const char* words;
  std::array<float, 3> colour;  // display-encoded
  bool (*holds)(float value);
};

// In order of precedence; the last kind holds all other numbers.
const std::array<NumberKind, 5>& number_kinds() {
  static const std::array<NumberKind, 5> kinds{{
      {"NaN magenta", {1.0F, 0.0F, 1.0F}, [](float v) { return std::isnan(v); }},
      {"infinity yellow", {1.0F, 1.0F, 0.0F}, [](float v) { return std::isinf(v); }},
      {"negative blue", {0.0F, 0.0F, 1.0F}, [](float v) { return v < 0.0F; }},
      {"finite light grey", {0.8F, 0.8F, 0.8F}, [](float v) { return v > 0.0F; }},
      {"zero black", {0.0F, 0.0F, 0.0F}, [](float) { return true; }},
  }};
  return kinds;
}

const std::array<float, 3>& diagnostic_colour(const float* rgb) {
  for (const NumberKind& kind : number_kinds()) {
    if (kind.holds(rgb[0]) || kind.holds(rgb[1]) || kind.holds(rgb[2])) {
      return kind.colour;
    }
  }
  return number_kinds().back().colour;
}

// Facts about this very picture, whatever its preset's name and description are.
std::string comments_of(const PictureContext& context) {
  const Scene& scene = context.scene;
  std::string text = scene.name.empty() ? "" : scene.name + ": ";
  text += context.frame && !context.frame->label.empty() ? context.frame->label + ", " : "";
  const auto angle = [](double radians) {
    return format_number(std::round(degrees_from_radians(radians) * 1e4) / 1e4);
  };
  text += "sun at elevation " + angle(scene.sun.elevation) + ", azimuth " + angle(scene.sun.azimuth) + " degrees";
  text += "; camera at " + format_number(scene.camera.altitude) + " km, azimuth " + angle(scene.camera.azimuth) +
          ", pitch " + angle(scene.camera.pitch) + " degrees; by " + scene.render.method;
  return text;
}

PngOptions png_options(const PictureContext& context, const std::optional<ColourCode>& colours) {
  PngOptions options;
  options.colours = colours;
  options.texts["Software"] = "airlight " + context.provenance.version;
  options.texts["Description"] = comments_of(context);
  const Provenance& made = context.provenance;
  for (const auto& [key, text] : {std::pair(kPresetKey, made.preset_json), std::pair(kMethodKey, made.method),
                                  std::pair(kVersionKey, made.version), std::pair(kDeviceKey, made.device)}) {
    options.texts[key] = text;
  }
  if (!context.png_hash.empty()) {
    options.texts[kHashKey] = context.png_hash;
  }
  return options;
}

// The ACES container holds the picture alone, in halves.
bool is_aces_container(const PictureContext& context, bool half) {
  const Rendering& rendering = context.rendering;
  const bool alone = !rendering.standard_error && rendering.layers.empty() && !rendering.spectrum &&
                     !(context.scene.bloom.in_exr && rendering.bloom);
  return context.space == WorkingSpace::aces2065_1 && half && alone;
}

}  // namespace

bool is_latlong(const Scene& scene) {
  return scene.camera.projection == Projection::equirectangular && scene.image.width == 2 * scene.image.height;
}

std::string latlong_warning(const Scene& scene) {
  if (scene.camera.projection != Projection::equirectangular || is_latlong(scene)) {
    return {};
  }
  return "an equirectangular picture of " + std::to_string(scene.image.width) + "x" +
         std::to_string(scene.image.height) +
         " is not twice as wide as high: its EXR is not tagged as an environment " + "map; --size " +
         std::to_string(scene.image.width / 2 * 2) + "x" + std::to_string(scene.image.width / 2) + " is one";
}

Vector3 in_space(const Vector3& rgb, WorkingSpace space) {
  if (space == WorkingSpace::linear_rec709) {
    return rgb;
  }
  const ColorMatrix m = from_rec709(space);
  Vector3 out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = m[i][0] * rgb[0] + m[i][1] * rgb[1] + m[i][2] * rgb[2];
  }
  return out;
}

ExrLight exr_light(const Lighting& lighting, const PictureContext& context) {
  ExrLight light;
  light.vectors[kSunIrradianceKey] = floats_of(in_space(lighting.sun.irradiance, context.space));
  if (const std::optional<double> white = white_luminance(context.scene.sun.unit)) {
    Vector3 level = lighting.level;
    for (const SunLight* one : {&lighting.sun, lighting.moon ? &*lighting.moon : nullptr}) {
      for (std::size_t c = 0; one != nullptr && c < 3; ++c) {
        level[c] += one->irradiance[c] * std::max(0.0, one->direction[1]);
      }
    }
    light.numbers[kIlluminanceKey] = static_cast<float>(*white * bt709_luminance(level[0], level[1], level[2]));
  }
  return light;
}

ExrOptions exr_options(const PictureContext& context, bool half) {
  const Scene& scene = context.scene;
  ExrOptions options;
  options.half = half;
  options.space = context.space;
  options.latlong = is_latlong(scene);
  options.cube = scene.camera.projection == Projection::cube && scene.camera.cube_layout == CubeLayout::stack;
  const CameraBasis basis = camera_basis(scene.camera);
  options.world_to_camera =
      world_to_camera(axis(basis.right), axis(basis.up), axis(basis.forward), scene.camera.altitude);
  options.comments = comments_of(context);
  options.frame = context.frame;
  options.aces_container = is_aces_container(context, half);
  options.provenance = context.provenance;
  if (const std::optional<double> white = white_luminance(scene.sun.unit)) {
    options.white_luminance = static_cast<float>(*white);
  }
  if (!context.exr_hash.empty()) {
    options.strings[kHashKey] = context.exr_hash;
  }
  if (context.choice) {
    options.strings["airlight:quality"] = context.choice->quality;
    options.numbers["airlight:estimated_error"] = static_cast<float>(context.choice->error);
    std::vector<std::string> left_out = context.left_out;
    left_out.insert(left_out.end(), context.rendering.left_out.begin(), context.rendering.left_out.end());
    options.strings["airlight:left_out"] = joined(left_out, "\n");
  }
  if (std::ranges::count(context.rendering.layers, "Q", &Layer::name) > 0) {
    options.strings["airlight:stokes"] =
        "Q, U: Q > 0 swings in the plane of direction and zenith, U > 0 leans from downward toward growing azimuth "
        "(clockwise from above); degree sqrt(Q^2 + U^2)/I, angle atan2(U, Q)/2";
  }
  if (context.rendering.spectrum) {
    options.strings.merge(spectral_attributes(*context.rendering.spectrum));
  }
  options.vectors[kSunDirectionKey] = floats_of(axis(geometry_of(scene).scene.sun.seen));
  options.vectors[kSunAboveAirKey] = floats_of(in_space(scene.sun.irradiance, context.space));
  if (context.lit) {
    const ExrLight later = exr_light({}, context);
    options.numbers.insert(later.numbers.begin(), later.numbers.end());
    options.vectors.insert(later.vectors.begin(), later.vectors.end());
  }
  options.numbers[kExposureKey] = static_cast<float>(context.rendering.exposure);
  return options;
}

void PictureChannels::add_colours(std::string_view layer, const RadianceImage& image, bool with_alpha) {
  const bool ours = space_ == WorkingSpace::linear_rec709;
  const RadianceImage& stored =
      ours ? image : images_.emplace_back(converted(image, WorkingSpace::linear_rec709, space_));
  add_channels(channels_, layer, stored, with_alpha);
}

void PictureChannels::add_layer(const Layer& layer) {
  const std::size_t plane = layer.planes.size() / layer.channels.size();
  const bool is_colour = layer.channels == "RGB";
  const bool ours = !is_colour || space_ == WorkingSpace::linear_rec709;
  const std::vector<float>& planes = ours ? layer.planes : planes_.emplace_back(converted_planes(layer.planes));
  for (std::size_t c = 0; c < layer.channels.size(); ++c) {
    // Depths are floats: beyond 2048 a half is not exact to a kilometre.
    const bool is_depth = layer.channels == "Z";
    channels_.push_back({layer.name + "." + layer.channels[c], planes.data() + c * plane, 1, is_depth});
  }
}

std::vector<float> PictureChannels::converted_planes(const std::vector<float>& rgb) const {
  const ColorMatrix matrix = from_rec709(space_);
  const std::size_t plane = rgb.size() / 3;
  std::vector<float> out(rgb.size());
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      sum += matrix[i / plane][c] * static_cast<double>(rgb[c * plane + i % plane]);
    }
    out[i] = static_cast<float>(sum);
  }
  return out;
}

PictureChannels::PictureChannels(const PictureContext& context) : space_(context.space) {
  const Rendering& rendering = context.rendering;
  add_colours("", rendering.radiance, has_outside(context.scene.camera));
  if (context.scene.bloom.in_exr && rendering.bloom) {
    add_colours("bloom", *rendering.bloom);
  }
  if (rendering.standard_error) {
    add_colours("standard_error", *rendering.standard_error);
  }
  for (const Layer& layer : rendering.layers) {
    add_layer(layer);
  }
  for (std::size_t k = 0; rendering.spectrum && k < rendering.spectrum->planes.size(); ++k) {
    channels_.push_back({spectral_channel_name(rendering.spectrum->nm[k]), rendering.spectrum->planes[k].data(), 1});
  }
}

struct PicturePng::State {
  PngRows png;
  std::optional<DisplayRows> display = {};
  bool diagnostic = false;
  QuantizeOptions pixels;
  float bloom_intensity = 0.0F;
  double seen_by_rods = 0.0;  // cd/m2 of (1, 1, 1); 0: not
  int y = 0;                  // of the next row
};

PicturePng::PicturePng(PngRows::Sink sink, const PictureContext& context,
                       const std::optional<DisplayTransform>& transform, int bits) {
  const ImageSize& size = context.scene.image;
  const bool diagnostic = !transform && context.scene.display.view == kDiagnosticView;
  const QuantizeOptions pixels{bits, !diagnostic, has_outside(context.scene.camera)};
  const std::optional<ColourCode> colours = transform ? transform->colours() : kSrgbCode;
  state_ = std::unique_ptr<State>(new State{
      .png = {std::move(sink), make_pixels(size.width, 0, pixels), size.height, png_options(context, colours)},
      .diagnostic = diagnostic,
      .pixels = pixels,
      .bloom_intensity = static_cast<float>(context.scene.bloom.intensity),
      .seen_by_rods = context.scene.display.rods ? luminance_of_one(context.scene) : 0.0});
  if (transform) {
    state_->display.emplace(*transform, size.width, size.height,
                            [png = &state_->png](const PixelImage& rows) { png->add(rows); });
  }
}

PicturePng::~PicturePng() = default;

void PicturePng::add(const Rendering& rows) {
  State& state = *state_;
  if (state.display) {
    AddedLight glow;
    if (rows.bloom) {
      glow = {rows.bloom->rgba.data(), state.bloom_intensity};
    }
    if (state.seen_by_rods > 0.0) {
      RadianceImage seen = rows.radiance;
      see_by_rods(seen, state.seen_by_rods);
      state.display->add(seen, glow, static_cast<float>(rows.exposure));
      return;
    }
    state.display->add(rows.radiance, glow, static_cast<float>(rows.exposure));
    return;
  }
  state.png.add(
      quantize(state.diagnostic ? diagnostic_picture(rows.radiance) : gpu_picture(rows), state.pixels, state.y));
  state.y += rows.radiance.height;
}

void PicturePng::finish() {
  state_->png.finish();
}

RadianceImage diagnostic_picture(const RadianceImage& radiance) {
  RadianceImage picture{radiance.width, radiance.height, {}};
  picture.rgba.reserve(radiance.rgba.size());
  for (std::size_t i = 0; i < radiance.rgba.size(); i += 4) {
    const std::array<float, 3>& colour = diagnostic_colour(&radiance.rgba[i]);
    picture.rgba.insert(picture.rgba.end(), {colour[0], colour[1], colour[2], 1.0F});
  }
  return picture;
}

std::string diagnostic_legend() {
  return joined_of(number_kinds(), [](const NumberKind& kind) { return kind.words; });
}

}  // namespace airlight::cli
