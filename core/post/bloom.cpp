#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/air/scene_block.h"
#include "core/post/post.h"

namespace airlight {
namespace {

// The chain's finest grid: 720 lines over 60 degrees.
constexpr double kBaseTexelAngle = std::numbers::pi / 3.0 / 720.0;

// Every device that airlight runs on takes images of this many texels a side.
constexpr double kMostTexels = 16384.0;

// A level of the chain: a texel's width in pixels of the picture, and the image, which is never finer than the picture
// nor larger than a device permits.
struct Level {
  double texel = 1.0;
  Extent extent;
  ImageId image;
  bool coarsened = false;  // the image's texels are larger than `texel`
};

Level level_of(const Picture& picture, double texel) {
  const double coarsest = std::max({texel, 1.0, std::max(picture.width, picture.height) / kMostTexels});
  const auto side = [&](std::uint32_t pixels) {
    return static_cast<std::uint32_t>(std::max(1.0, std::floor(pixels / coarsest + 1e-9)));
  };
  return {texel, {side(picture.width), side(picture.height), 1}, {}, coarsest > texel};
}

struct Taps {
  double x = 0.0;
  double y = 0.0;
};

// One texel of a level in texture coordinates: by the level's rounded size, or by angle where the image is coarser.
Taps taps_of(const Picture& picture, const Level& level) {
  if (level.coarsened) {
    return {level.texel / picture.width, level.texel / picture.height};
  }
  return {1.0 / level.extent.width, 1.0 / level.extent.height};
}

ImageId add_level(Plan& plan, const char* kind, int level, Extent extent) {
  return plan.add_image({.name = kind + std::to_string(level), .extent = extent, .key = {}});
}

std::uint32_t wrap(const Scene& scene) {
  return scene.camera.projection == Projection::equirectangular ? 1u : 0u;
}

Picture whole_picture(const Scene& scene) {
  return picture_of(BufferId{}, {0, 0, scene.image.width, scene.image.height});
}

// Width of a base texel in pixels of the picture.
double base_texel(const Scene& scene) {
  return kBaseTexelAngle / pixel_angle(scene);
}

Level base_level(const Scene& scene) {
  return level_of(whole_picture(scene), base_texel(scene));
}

Level chain_level(const Scene& scene, int level) {
  return level_of(whole_picture(scene), base_texel(scene) * std::exp2(level));
}

// The downsampled levels 1 to n, finest first.
std::vector<Level> add_levels(Plan& plan, const Scene& scene, ImageId base, double exposure) {
  const Picture picture = whole_picture(scene);
  Level source = base_level(scene);
  source.image = base;
  std::vector<Level> levels;
  for (int level = 1; level <= scene.bloom.levels; ++level) {
    Level out = chain_level(scene, level);
    out.image = add_level(plan, "bloom_down", level, out.extent);
    const Taps taps = level == 1 ? Taps{base_texel(scene) / picture.width, base_texel(scene) / picture.height}
                                 : taps_of(picture, source);
    plan.add_pass({.name = "bloom_down" + std::to_string(level),
                   .shader = "bloom_down",
                   .reads = {{"source", source.image}},
                   .writes = {{"level_out", out.image}},
                   .grid = out.extent,
                   .push_constants = {push_constant(taps.x), push_constant(taps.y),
                                      push_constant(scene.bloom.threshold), push_constant(exposure)},
                   .specialization = {{"kWrap", wrap(scene)}, {"kFirst", level == 1 ? 1u : 0u}}});
    levels.push_back(out);
    source = out;
  }
  return levels;
}

std::uint32_t rows_of(const Scene& scene) {
  return static_cast<std::uint32_t>(scene.image.height);
}

BufferId add_picture_buffer(Plan& plan, const char* name, const Picture& picture, std::size_t bytes_a_pixel) {
  return plan.add_buffer(
      {.name = name,
       .bytes = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * bytes_a_pixel,
       .host_readable = true,
       .zeroed = false});
}

// Adds the bindings that a pass needs for the glare at its pixels (shared/glare_pixel.glsl).
void read_glare(PassDesc& pass, const Scene& scene, const GlareSources& sources) {
  pass.reads.push_back({"sources", sources.points});
  pass.push_constants.insert(pass.push_constants.end(), {sources.count, push_constant(glare_pixel_blur(scene))});
  pass.specialization.push_back({"kProjection", projection_code(scene.camera.projection)});
}

}  // namespace

double glare_pixel_blur(const Scene& scene) {
  return 0.5 * pixel_angle(scene);
}

double pixel_angle(const Scene& scene) {
  switch (scene.camera.projection) {
    case Projection::perspective:
      return scene.camera.vertical_fov / scene.image.height;
    case Projection::equirectangular:
      return std::numbers::pi / scene.image.height;
    case Projection::fisheye:
      return scene.camera.vertical_fov / std::min(scene.image.width, scene.image.height);
    case Projection::cube:
    case Projection::octahedral:
      break;  // resolve() takes no bloom there
  }
  return kBaseTexelAngle;
}

ImageId add_bloom_base(Plan& plan, const Scene& scene, const Picture& picture) {
  const Extent extent = base_level(scene).extent;
  const ImageId base = add_level(plan, "bloom_base", 0, extent);
  plan.add_pass({.name = "bloom_base",
                 .shader = "bloom_base",
                 .reads = {{"picture", picture.buffer}},
                 .writes = {{"base_out", base}},
                 .grid = extent,
                 .push_constants = {picture.width, picture.height}});
  return base;
}

ImageId add_bloom(Plan& plan, const Scene& scene, ImageId base, double exposure) {
  const Picture picture = whole_picture(scene);
  const std::vector<Level> levels = add_levels(plan, scene, base, exposure);
  ImageId sum = levels.back().image;
  for (std::size_t i = levels.size() - 1; i-- > 0;) {
    const Taps taps = taps_of(picture, levels[i + 1]);
    const ImageId out = add_level(plan, "bloom_up", static_cast<int>(i) + 1, levels[i].extent);
    plan.add_pass({.name = "bloom_up" + std::to_string(i + 1),
                   .shader = "bloom_up",
                   .reads = {{"coarser", sum}, {"level", levels[i].image}},
                   .writes = {{"sum_out", out}},
                   .grid = levels[i].extent,
                   .push_constants = {push_constant(taps.x), push_constant(taps.y)},
                   .specialization = {{"kWrap", wrap(scene)}}});
    sum = out;
  }
  return sum;
}

BufferId add_glow_picture(Plan& plan, const Scene& scene, const Picture& picture, const Glow& glow) {
  const BufferId out = add_picture_buffer(plan, "bloom", picture, 4 * sizeof(float));
  PassDesc pass{.writes = {{"bloom_out", out}}, .grid = {picture.width, picture.height, 1}};
  if (const auto* sources = std::get_if<GlareSources>(&glow)) {
    pass.name = pass.shader = "glare";
    pass.push_constants = {picture.width, picture.height};
    read_glare(pass, scene, *sources);
  } else {
    pass.name = pass.shader = "bloom_resolve";
    pass.reads = {{"chain", std::get<ImageId>(glow)}};
    pass.push_constants = {picture.width, rows_of(scene), picture.y, picture.height};
    pass.specialization = {{"kWrap", wrap(scene)}};
  }
  plan.add_pass(std::move(pass));
  return out;
}

BufferId add_tonemap(Plan& plan, const Scene& scene, const Picture& picture, const std::optional<Glow>& glow,
                     double exposure) {
  constexpr std::uint32_t kCurves[] = {
      physics::kToneAces,        physics::kToneReinhard, physics::kToneReinhardLuminance,
      physics::kToneExponential, physics::kToneClamp,    physics::kToneNone};
  const BufferId encoded = add_picture_buffer(plan, "encoded", picture, 4 * sizeof(std::uint16_t));
  PassDesc pass{.name = "tonemap",
                .shader = "tonemap",
                .reads = {{"picture", picture.buffer}},
                .writes = {{"encoded_out", encoded}},
                .grid = {picture.width, picture.height, 1},
                .push_constants = {picture.width, picture.height, push_constant(exposure)},
                .specialization = {{"kCurve", kCurves[static_cast<std::size_t>(scene.display.tonemap)]}}};
  if (glow) {
    pass.push_constants.push_back(push_constant(scene.bloom.intensity));
    if (const auto* sources = std::get_if<GlareSources>(&*glow)) {
      pass.shader = "tonemap_glare";
      read_glare(pass, scene, *sources);
    } else {
      pass.shader = "tonemap_bloom";
      pass.reads.push_back({"chain", std::get<ImageId>(*glow)});
      pass.push_constants.insert(pass.push_constants.end(), {picture.y, rows_of(scene)});
      pass.specialization.push_back({"kWrap", wrap(scene)});
    }
  }
  plan.add_pass(std::move(pass));
  return encoded;
}

}  // namespace airlight
