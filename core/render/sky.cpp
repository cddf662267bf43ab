#include "core/render/sky.h"

#include "core/methods/sky_pass.h"
#include "core/methods/spectral_sums.h"
#include "core/post/host_post.h"
#include "core/stage/sums.h"

namespace airlight {
namespace {

// A picture of each part, and their sum.
SkyPasses add_parts(Plan& plan, const Stage& stage, const View& view) {
  const auto add_passes = stage.method().add_passes;
  if (!stage.in_colours()) {
    return add_passes(plan, stage.whole(), view);
  }
  SkyPasses all;
  std::vector<BufferId> pictures;
  for (const Part& part : stage.parts()) {
    begin_part(plan, part, tile_of(stage.scene(), view));
    const SkyPasses sky = add_passes(plan, part, view);
    pictures.push_back(sky.radiance);
    all.tables.insert(all.tables.end(), sky.tables.begin(), sky.tables.end());
    all.more_tables.insert(all.more_tables.end(), sky.more_tables.begin(), sky.more_tables.end());
  }
  plan.end_scene();
  all.radiance = plan.add_buffer(radiance_buffer(view, plan.buffers()[pictures.front().index].bytes));
  for (std::size_t g = 0; g < pictures.size(); ++g) {
    add_colours(plan, pictures[g], all.radiance, stage.parts()[g], g == 0);
  }
  return all;
}

// A disc a part: air that bends light bends each wavelength by an angle of its own.
bool add_parted_disc(Plan& plan, const Stage& stage, const std::vector<ImageId>& tables, const Picture& picture,
                     const Tile& tile) {
  const std::size_t bytes = std::size_t{picture.width} * picture.height * 4 * sizeof(float);
  std::vector<BufferId> discs;
  for (std::size_t g = 0; g < stage.parts().size(); ++g) {
    const Part& part = stage.parts()[g];
    begin_part(plan, part, tile);
    discs.push_back(plan.add_buffer({.name = "disc", .bytes = bytes}));
    add_sun_disc(plan, part, tables.empty() ? std::nullopt : std::optional(tables[g]), picture_of(discs[g], tile));
  }
  plan.end_scene();
  for (std::size_t g = 0; g < discs.size(); ++g) {
    add_colours(plan, discs[g], picture.buffer, stage.parts()[g], false);
  }
  return true;
}

// The disc seen through the parts' tables of transmittance, one each, or through tables added here.
bool add_disc(Plan& plan, const Stage& stage, std::vector<ImageId> tables, const Picture& picture) {
  if (!stage.in_colours()) {
    return add_sun_disc(plan, stage.whole(), tables.empty() ? std::nullopt : std::optional(tables.front()), picture);
  }
  if (!sun_disc_shows(stage.scene(), picture)) {
    return false;
  }
  const Tile tile{static_cast<int>(picture.x), static_cast<int>(picture.y), static_cast<int>(picture.width),
                  static_cast<int>(picture.height)};
  if (stage.scene().planet.refraction) {
    return add_parted_disc(plan, stage, tables, picture, tile);
  }
  std::vector<std::array<Rgb, 3>> colours;
  const bool has_tables = !tables.empty();
  for (const Part& part : stage.parts()) {
    if (!has_tables) {
      begin_part(plan, part, tile);
      tables.push_back(add_disc_transmittance(plan, part.air));
    }
    colours.push_back(part.shares);
  }
  plan.end_scene();
  const ImageId through = add_colour_table(plan, "sunlight_colours", {}, tables, colours);
  return add_sun_disc(plan, stage.whole(), through, picture);
}

physics::vec3 in_colours(const physics::vec3& channels, const std::array<Rgb, 3>& colours) {
  const auto sum = [&](std::size_t c) { return add_colour(0.0, colours, c, channels.x, channels.y, channels.z); };
  return {sum(0), sum(1), sum(2)};
}

}  // namespace

Sky add_sky(Plan& plan, const Stage& stage, const View& view, bool with_disc) {
  const Tile tile = tile_of(stage.scene(), view);
  plan.scene_data = device_scene_bytes(stage.whole().air, stage.scene(), tile);
  std::optional<SkyPasses> sky;
  if (stage.in_colours() && stage.method().add_coloured_passes != nullptr) {
    sky = stage.method().add_coloured_passes(plan, stage, view);
  }
  if (!sky) {
    sky = add_parts(plan, stage, view);
  }
  Sky made{sky->radiance, sky->tables, false, sky->more_tables};
  if (with_disc) {
    std::vector<ImageId> through;
    const std::size_t each = made.tables.size() / stage.parts().size();
    for (std::size_t g = 0; each > 0 && g < stage.parts().size(); ++g) {
      through.push_back(made.tables[g * each]);
    }
    made.disc = add_disc(plan, stage, std::move(through), picture_of(made.radiance, tile));
  }
  return made;
}

bool draw_disc_over(RadianceImage& rows, const Stage& stage, const Tile& tile) {
  bool shines = false;
  for (const Part& part : stage.parts()) {
    RadianceImage disc{rows.width, rows.height, std::vector<float>(rows.rgba.size())};
    shines = draw_sun_disc(disc, part, tile);
    if (shines) {
      add_part(rows, disc, part.colours);
    }
  }
  return shines;
}

std::vector<physics::GlarePoint> glare_points_of(const Stage& stage) {
  std::vector<physics::GlarePoint> all;
  for (const Part& part : stage.parts()) {
    std::vector<physics::GlarePoint> points = glare_points(part);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].irradiance = in_colours(points[i].irradiance, part.colours);
      if (all.size() == points.size()) {
        points[i].irradiance = points[i].irradiance + all[i].irradiance;
      }
    }
    all = std::move(points);
  }
  return all;
}

std::vector<std::string> spared_by(const Stage& stage) {
  const auto spared = stage.method().spared;
  return spared == nullptr ? std::vector<std::string>() : spared(stage.whole());
}

}  // namespace airlight
