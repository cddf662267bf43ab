#include "core/render/sky.h"

#include <algorithm>
#include <utility>

#include "core/methods/sky_pass.h"
#include "core/methods/spectral_sums.h"
#include "core/post/host_post.h"
#include "core/post/night_sky.h"
#include "core/post/stars.h"
#include "core/render/pixels.h"
#include "core/stage/lights.h"
#include "core/stage/sums.h"

namespace airlight {

std::optional<BufferId> cloud_transmittance(const Plan& plan, std::size_t first) {
  for (std::size_t i = first; i < plan.buffers().size(); ++i) {
    if (plan.buffers()[i].name.starts_with(kCloudTransmittance)) {
      return BufferId{static_cast<std::uint32_t>(i)};
    }
  }
  return std::nullopt;
}

void add_behind_clouds(Plan& plan, BufferId behind, BufferId through, const Picture& picture) {
  plan.add_pass({.name = "behind_clouds",
                 .shader = "cloud_cover",
                 .reads = {{"behind", behind}, {"through", through}},
                 .writes = {{"radiance_out", picture.buffer}},
                 .grid = {picture.width, picture.height, 1},
                 .push_constants = {picture.width, picture.height}});
}

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
  all.radiance = pictures.front();
  turn_into_colours(plan, all.radiance, stage.parts().front().colours, stage.parts().front().suffix);
  for (std::size_t g = 1; g < pictures.size(); ++g) {
    add_colours(plan, pictures[g], all.radiance, stage.parts()[g].colours, stage.parts()[g].suffix, false);
  }
  return all;
}

// A disc a part: air that bends light bends each wavelength by an angle of its own.
bool add_parted_disc(Plan& plan, const Stage& stage, const std::vector<ImageId>& tables, const Picture& picture,
                     const Tile& tile) {
  for (std::size_t g = 0; g < stage.parts().size(); ++g) {
    const Part& part = stage.parts()[g];
    begin_part(plan, part, tile);
    add_sun_disc(plan, part, tables.empty() ? std::nullopt : std::optional(tables[g]), picture, part.colours);
  }
  plan.end_scene();
  return true;
}

// A table of transmittance in the picture's colours: of the parts' tables, one each, or of tables added here.
ImageId add_through(Plan& plan, const Stage& stage, std::vector<ImageId> tables, const Tile& tile) {
  const bool has_tables = !tables.empty();
  if (!stage.in_colours()) {
    return has_tables ? tables.front() : add_disc_transmittance(plan, stage.whole().air);
  }
  std::vector<std::array<Rgb, 3>> colours;
  for (const Part& part : stage.parts()) {
    if (!has_tables) {
      begin_part(plan, part, tile);
      tables.push_back(add_disc_transmittance(plan, part.air));
    }
    colours.push_back(part.shares);
  }
  plan.end_scene();
  return add_colour_table(plan, "sunlight_colours", {}, tables, colours);
}

void add_night(Plan& plan, const Stage& stage, ImageId through, const Picture& picture) {
  if (stage.scene().night_sky) {
    add_night_sky(plan, stage, through, picture);
  }
  if (stage.scene().stars) {
    add_stars(plan, stage, through, picture);
  }
}

physics::vec3 in_colours(const physics::vec3& channels, const std::array<Rgb, 3>& colours) {
  const auto sum = [&](std::size_t c) { return add_colour(0.0, colours, c, channels.x, channels.y, channels.z); };
  return {sum(0), sum(1), sum(2)};
}

std::vector<physics::GlarePoint> glare_points_by_light(const Stage& stage) {
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

bool is_written(const Plan& plan, BufferId buffer) {
  return std::ranges::any_of(plan.passes(), [&](const PassDesc& pass) {
    return std::ranges::any_of(pass.writes, [&](const Binding& made) { return made.resource == ResourceId(buffer); });
  });
}

// The tables of transmittance, one a part; none where the method has no tables.
std::vector<ImageId> transmittances(const Stage& stage, const Sky& sky) {
  std::vector<ImageId> tables;
  const std::size_t each = sky.tables.size() / stage.parts().size();
  for (std::size_t g = 0; each > 0 && g < stage.parts().size(); ++g) {
    tables.push_back(sky.tables[g * each]);
  }
  return tables;
}

// Draws into a picture what stands beyond the air: the disc of the stage's light and the night sky. `tables`: one of
// transmittance a part; none: they are made. Returns whether the disc is in the picture.
bool add_beyond(Plan& plan, const Stage& stage, const std::vector<ImageId>& tables, const Picture& picture,
                const Tile& tile, bool with_disc) {
  const bool shines = with_disc && sun_disc_shows(stage.scene(), picture);
  const bool is_night = stage.night() != nullptr;
  const bool parted = shines && stage.in_colours() && stage.scene().planet.refraction;
  bool disc = parted && add_parted_disc(plan, stage, tables, picture, tile);
  if (is_night || (shines && !parted)) {
    const ImageId through = add_through(plan, stage, tables, tile);
    disc = disc || (shines && add_sun_disc(plan, stage.whole(), through, picture));
    if (is_night) {
      add_night(plan, stage, through, picture);
    }
  }
  return disc;
}

// The sky by the stage's own light, in the canvas if the method can draw into it.
Sky add_sky_by_light(Plan& plan, const Stage& stage, const View& view, bool with_disc,
                     const std::optional<Canvas>& canvas = {}) {
  const Tile tile = tile_of(stage.scene(), view);
  const std::size_t before = plan.buffers().size();
  std::optional<SkyPasses> sky;
  if (stage.in_colours() && stage.method().add_coloured_passes != nullptr) {
    sky = stage.method().add_coloured_passes(plan, stage, view, canvas);
  }
  if (!sky) {
    sky = add_parts(plan, stage, view);
  }
  const std::optional<BufferId> past_clouds = cloud_transmittance(plan, before);
  Sky made{sky->radiance, sky->tables, false, sky->more_tables};
  const Picture whole = picture_of(made.radiance, tile);
  Picture picture = whole;  // that the disc and the night are drawn into
  if (!view.directions.empty()) {
    return made;
  }
  const bool is_behind =
      past_clouds && (stage.night() != nullptr || (with_disc && sun_disc_shows(stage.scene(), picture)));
  if (is_behind) {
    picture.buffer = plan.add_buffer({.name = "behind_clouds", .bytes = plan.buffers()[made.radiance.index].bytes});
  }
  made.disc = add_beyond(plan, stage, transmittances(stage, made), picture, tile, with_disc);
  if (is_behind && is_written(plan, picture.buffer)) {
    add_behind_clouds(plan, picture.buffer, *past_clouds, whole);
  }
  return made;
}

}  // namespace

Sky add_sky(Plan& plan, const Stage& stage, const View& view, bool with_disc) {
  const Tile tile = tile_of(stage.scene(), view);
  plan.scene_data = device_scene_bytes(stage.whole().air, stage.scene(), tile);
  if (!view.directions.empty()) {
    return add_sky_by_light(plan, stage, view, with_disc);
  }
  const LightsSeen seen = view.all_lights ? LightsSeen{} : lights_seen(stage);
  Sky all;
  std::vector<ImageId> tables;  // of transmittance, which all lights share
  if (seen.sun) {
    all = add_sky_by_light(plan, stage, view, with_disc);
  } else {
    all.radiance = plan.add_buffer(radiance_buffer(view, pixels_of(tile.width, tile.height) * 4 * sizeof(float)));
  }
  bool is_empty = !seen.sun;
  for (const Stage& other : stage.others()) {
    plan.begin_light(device_scene_bytes(other.whole().air, other.scene(), tile), other.light());
    if (!seen.others) {
      all.disc = add_beyond(plan, other, {}, picture_of(all.radiance, tile), tile, with_disc) || all.disc;
      plan.end_light();
      continue;
    }
    View its_view = view;
    its_view.kept_as += view.kept_as.empty() ? "" : other.light();
    const Canvas canvas{all.radiance, std::exchange(is_empty, false)};
    const Sky sky = add_sky_by_light(plan, other, its_view, with_disc, canvas);
    tables = transmittances(other, sky);
    plan.end_light();
    if (sky.radiance != canvas.radiance) {
      add_colours(plan, sky.radiance, all.radiance, kAsTheyAre, other.light(), canvas.is_blank);
    }
    all.disc = all.disc || sky.disc;
  }
  if (!seen.sun) {
    add_beyond(plan, stage, tables, picture_of(all.radiance, tile), tile, false);
  }
  return all;
}

BufferId add_night_picture(Plan& plan, const Stage& stage, const Tile& tile) {
  plan.scene_data = device_scene_bytes(stage.whole().air, stage.scene(), tile);
  const std::size_t pixels = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
  const BufferId picture =
      plan.add_buffer({.name = "night", .bytes = 4 * pixels * sizeof(float), .host_readable = true});
  add_night(plan, stage, add_through(plan, stage, {}, tile), picture_of(picture, tile));
  return picture;
}

bool draw_disc_over(RadianceImage& rows, const Stage& stage, const Tile& tile) {
  bool shines = false;
  for (const Stage& other : stage.others()) {
    shines = draw_disc_over(rows, other, tile);
  }
  for (const Part& part : stage.parts()) {
    RadianceImage disc{rows.width, rows.height, std::vector<float>(rows.rgba.size())};
    if (draw_sun_disc(disc, part, tile)) {
      shines = true;
      add_part(rows, disc, part.colours);
    }
  }
  return shines;
}

std::vector<physics::GlarePoint> glare_points_of(const Stage& stage) {
  const auto light = [](const std::vector<physics::GlarePoint>& points) {
    return physics::dot(points.front().irradiance, physics::vec3(1.0));
  };
  std::vector<physics::GlarePoint> brightest = glare_points_by_light(stage);
  for (const Stage& other : stage.others()) {
    std::vector<physics::GlarePoint> points = glare_points_by_light(other);
    if (light(points) > light(brightest)) {
      brightest = std::move(points);
    }
  }
  return brightest;
}

bool glares(const Stage& stage) {
  return sun_glares(stage.whole()) || std::ranges::any_of(stage.others(), glares);
}

std::vector<std::string> spared_by(const Stage& stage) {
  const auto spared = stage.method().spared;
  return spared == nullptr ? std::vector<std::string>() : spared(stage.whole());
}

}  // namespace airlight
