#include "core/render/sky.h"

#include "core/methods/scene_air.h"
#include "core/methods/sky_pass.h"
#include "core/methods/spectral_sums.h"
#include "core/post/host_post.h"
#include "core/post/post.h"
#include "core/render/group_runs.h"

namespace airlight {
namespace {

// A picture for each group, and their sum.
SkyPasses add_groups(Plan& plan, const Scene& scene, const SpectralScene& spectral, const View& view) {
  SkyPasses all;
  std::vector<BufferId> parts;
  for (std::size_t g = 0; g < spectral.groups.size(); ++g) {
    const Scene& group = spectral.groups[g].scene;
    begin_group(plan, spectral, g, tile_of(scene, view));
    const SkyPasses sky = method_of(scene).add_passes(plan, group, air_of(group), view);
    parts.push_back(sky.radiance);
    all.tables.insert(all.tables.end(), sky.tables.begin(), sky.tables.end());
    all.more_tables.insert(all.more_tables.end(), sky.more_tables.begin(), sky.more_tables.end());
  }
  plan.end_scene();
  all.radiance = plan.add_buffer(radiance_buffer(view, plan.buffers()[parts.front().index].bytes));
  for (std::size_t g = 0; g < parts.size(); ++g) {
    add_colours(plan, parts[g], all.radiance, spectral.groups[g].colours, g, g == 0);
  }
  return all;
}

// The disc seen through the groups' tables of transmittance, one each, or through tables added here.
bool add_coloured_disc(Plan& plan, const Scene& scene, const SpectralScene& spectral, std::vector<ImageId> tables,
                       const Picture& picture) {
  if (!sun_disc_shows(scene, picture)) {
    return false;
  }
  const Tile tile{static_cast<int>(picture.x), static_cast<int>(picture.y), static_cast<int>(picture.width),
                  static_cast<int>(picture.height)};
  std::vector<std::array<Rgb, 3>> colours;
  const bool has_tables = !tables.empty();
  for (std::size_t g = 0; g < spectral.groups.size(); ++g) {
    if (!has_tables) {
      begin_group(plan, spectral, g, tile);
      tables.push_back(add_disc_transmittance(plan, air_of(spectral.groups[g].scene)));
    }
    colours.push_back(over_the_sun(spectral.groups[g].colours, spectral.sun));
  }
  plan.end_scene();
  const ImageId through = add_colour_table(plan, "sunlight_colours", {}, tables, colours);
  return add_sun_disc(plan, scene, air_of(scene), through, picture);
}

Sky add_spectral_sky(Plan& plan, const Scene& scene, const View& view, bool with_disc) {
  const SpectralScene spectral = spectral_scene(scene);
  const SkyMethod& method = method_of(scene);
  std::optional<SkyPasses> sky;
  if (method.add_spectral_passes != nullptr) {
    sky = method.add_spectral_passes(plan, scene, spectral, view);
  }
  if (!sky) {
    sky = add_groups(plan, scene, spectral, view);
  }
  Sky all{sky->radiance, sky->tables, false, sky->more_tables};
  if (with_disc) {
    std::vector<ImageId> through;
    const std::size_t each = all.tables.size() / spectral.groups.size();
    for (std::size_t g = 0; each > 0 && g < spectral.groups.size(); ++g) {
      through.push_back(all.tables[g * each]);
    }
    all.disc =
        add_coloured_disc(plan, scene, spectral, std::move(through), picture_of(all.radiance, tile_of(scene, view)));
  }
  return all;
}

physics::vec3 in_colours(const physics::vec3& channels, const std::array<Rgb, 3>& colours) {
  const auto sum = [&](std::size_t c) {
    return colours[0][c] * channels.x + colours[1][c] * channels.y + colours[2][c] * channels.z;
  };
  return {sum(0), sum(1), sum(2)};
}

}  // namespace

Sky add_sky(Plan& plan, const Scene& scene, const View& view, bool with_disc) {
  const Air air = air_of(scene);
  plan.scene_data = device_scene_bytes(air, scene, tile_of(scene, view));
  if (scene.spectra) {
    return add_spectral_sky(plan, scene, view, with_disc);
  }
  const SkyPasses sky = method_of(scene).add_passes(plan, scene, air, view);
  Sky made{sky.radiance, sky.tables, false, sky.more_tables};
  if (with_disc) {
    const std::optional<ImageId> table = sky.tables.empty() ? std::nullopt : std::optional(sky.tables.front());
    made.disc = add_sun_disc(plan, scene, air, table, picture_of(sky.radiance, tile_of(scene, view)));
  }
  return made;
}

bool add_disc_over(Plan& plan, const Scene& scene, BufferId radiance, const Tile& tile) {
  const Picture picture = picture_of(radiance, tile);
  return scene.spectra ? add_coloured_disc(plan, scene, spectral_scene(scene), {}, picture)
                       : add_sun_disc(plan, scene, air_of(scene), std::nullopt, picture);
}

bool draw_disc_over(RadianceImage& rows, const Scene& scene, const Tile& tile) {
  if (!scene.spectra) {
    return draw_sun_disc(rows, scene, air_of(scene), tile);
  }
  const SpectralScene spectral = spectral_scene(scene);
  bool shines = false;
  for (const WavelengthGroup& group : spectral.groups) {
    RadianceImage part{rows.width, rows.height, std::vector<float>(rows.rgba.size())};
    shines = draw_sun_disc(part, group.scene, air_of(group.scene), tile);
    if (shines) {
      add_part(rows, part, group.colours);
    }
  }
  return shines;
}

std::vector<physics::GlarePoint> glare_points_of(const Scene& scene) {
  if (!scene.spectra) {
    return glare_points(scene, air_of(scene));
  }
  const SpectralScene spectral = spectral_scene(scene);
  std::vector<physics::GlarePoint> all;
  for (const WavelengthGroup& group : spectral.groups) {
    std::vector<physics::GlarePoint> points = glare_points(group.scene, air_of(group.scene));
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].irradiance = in_colours(points[i].irradiance, group.colours);
      if (all.size() == points.size()) {
        points[i].irradiance = points[i].irradiance + all[i].irradiance;
      }
    }
    all = std::move(points);
  }
  return all;
}

HostPicture render_on_host(const Scene& scene, const View& view, const HostOptions& options) {
  return method_of(scene).render_on_host(scene, air_of(scene), view, options);
}

std::vector<std::string> spared_by(const Scene& scene) {
  const auto spared = method_of(scene).spared;
  return spared == nullptr ? std::vector<std::string>() : spared(scene, air_of(scene));
}

Rgb transmittance_unit(const Scene& scene) {
  return scene.spectra ? sun_colour(band_colours(scene.spectra->sun, scene.spectra->white)) : Rgb{1.0, 1.0, 1.0};
}

}  // namespace airlight
