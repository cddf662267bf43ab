// The picture of `orders` by a table of factors over its view directions, which pixels multiply by the phase functions.

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "core/luts/luts.h"
#include "core/methods/orders_parts.h"
#include "core/methods/sky_pass.h"
#include "core/methods/spectral_sums.h"

namespace airlight::orders {
namespace {

// A ray of the table costs what a pixel does without it; from space many pixels miss the planet and cost nothing. At
// dusk the table is 0.4 % off in the mean near the horizon (`earth-twilight`), which small pictures do without.
long long pixels_worth_a_table(const Part& part, const View& view) {
  const long long rays = factor_table(part, part.air.scattering_media(), false, stokes_of(part, view)).rays();
  if (part.scene.sun.elevation < 0.0) {
    return 4 * rays;
  }
  return looks_from_space(part) ? 3 * rays / 2 : rays;
}

void add_factor_pixels(Plan& plan, const Part& part, const View& view, const FactorTable& table,
                       const SkyTarget& target, ImageId factors) {
  std::vector<Specialization> constants = medium_specialization(part.air);
  constants.push_back({"kProjection", target.projection});
  add_table_constants(constants, table);
  constants.push_back({"kStokes", table.stokes});
  constants.push_back({"kAdds", target.adds ? 1u : 0u});
  add_pass_with_edges(plan, part, view, target,
                      {.name = "sky",
                       .shader = "sky_from_factors",
                       .reads = {{"factors_lut", factors}, {"directions", target.directions}},
                       .writes = {{"radiance_out", target.radiance}},
                       .grid = target.grid,
                       .push_constants = {target.grid.width, target.grid.height},
                       .specialization = std::move(constants),
                       .cost = 2.0});
}

// Whether the media that the pixels multiply by their phase function are the same at all wavelengths but for how much
// they scatter and absorb.
bool phases_are_alike(const Stage& stage, std::uint32_t apart) {
  const std::vector<Medium>& media = stage.scene().media;
  for (const Part& part : stage.parts()) {
    for (std::size_t i = 0; i < media.size(); ++i) {
      Medium alike = part.scene.media[i];
      alike.scattering = media[i].scattering;
      alike.absorption = media[i].absorption;
      alike.phase_wavelengths = media[i].phase_wavelengths;
      const bool by_wavelength = alike.phase == PhaseFunction::table && alike.phase_table.rows.size() > 1;
      if ((apart >> i & 1u) != 0 && (by_wavelength || alike != media[i])) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

bool tabulates(const Part& part, const View& view) {
  const std::string& choice = part.scene.render.get<std::string>("tabulate");
  const bool holds = view.directions.empty() || view.as_picture;
  const long long pixels = part.scene.image.width * static_cast<long long>(part.scene.image.height);
  const bool pays = pixels >= pixels_worth_a_table(part, view);
  return holds && !part.things.stand_in_the_air() && (choice == "always" || (choice == "auto" && pays));
}

ImageId add_tabulated_sky(Plan& plan, const Part& part, const View& view, const SkyTarget& target, const Light& light) {
  const FactorTable table = factor_table(part, part.air.scattering_media(), false, stokes_of(part, view));
  const ImageId factors = add_factors(plan, "sky_factors", part.scene, table, view, light);
  add_factor_pixels(plan, part, view, table, target, factors);
  return factors;
}

namespace {

// Things of one part, in a picture of their own where they would have to add to the canvas.
std::optional<SkyPasses> add_coloured_things(Plan& plan, const Stage& stage, const View& view,
                                             const std::optional<Canvas>& canvas) {
  const Part& part = stage.parts().front();
  if (stage.parts().size() > 1 || !part.scene.clouds.empty() || !lists_blocks(part, view)) {
    return std::nullopt;
  }
  const bool is_blank = canvas && canvas->is_blank;
  const SkyTarget target = add_sky_target(plan, part.scene, view, is_blank ? canvas : std::nullopt);
  begin_part(plan, part, tile_of(part.scene, view));
  const Light light = add_light(plan, part);
  add_things_sky(plan, part, view, target, light, {.colours = part.colours});
  plan.end_scene();
  return SkyPasses{target.radiance, {light.transmittance}, light.more()};
}

}  // namespace

std::optional<SkyPasses> add_coloured(Plan& plan, const Stage& stage, const View& view,
                                      const std::optional<Canvas>& canvas) {
  const Part& whole = stage.whole();
  if (whole.things.stand_in_the_air()) {
    return add_coloured_things(plan, stage, view, canvas);
  }
  if (!tabulates(whole, view) || whole.scene.ground || !whole.scene.clouds.empty()) {
    return std::nullopt;
  }
  const FactorTable table = factor_table(whole, stage.scattering_media(), false, stokes_of(whole, view));
  if (!phases_are_alike(stage, table.apart)) {
    return std::nullopt;
  }
  const SkyTarget target = add_sky_target(plan, whole.scene, view, canvas);
  SkyPasses passes{target.radiance, {}};
  std::vector<ImageId> factors;
  std::vector<std::array<Rgb, 3>> colours;
  for (const Part& part : stage.parts()) {
    begin_part(plan, part, tile_of(whole.scene, view));
    const Light light = add_light(plan, part);
    factors.push_back(add_factors(plan, "sky_factors", part.scene, table, view, light));
    passes.tables.push_back(light.transmittance);
    std::ranges::copy(light.more(), std::back_inserter(passes.more_tables));
    passes.more_tables.push_back(factors.back());
    colours.push_back(part.colours);
  }
  plan.end_scene();
  const std::string name = "sky_factors_in_colours";
  const ImageId sum = add_colour_table(plan, name, picture_table_key(view, name), factors, colours,
                                       [layout = layout_of(whole.scene, table, true)] { return factor_text(layout); });
  passes.more_tables.push_back(sum);
  add_factor_pixels(plan, whole, view, table, target, sum);
  return passes;
}

}  // namespace airlight::orders
