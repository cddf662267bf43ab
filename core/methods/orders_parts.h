#pragma once
// What the pictures, layers and spans of `orders` have in common: the light that their rays read, and the picture's own
// table of factors.

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/clouds/cloud_grid.h"
#include "core/clouds/cloud_physics.h"
#include "core/luts/moments.h"
#include "core/methods/factor_text.h"
#include "core/methods/method.h"
#include "core/methods/sky_pass.h"
#include "core/things/thing_buffers.h"

namespace airlight::orders {

bool inside_the_air(const Scene& scene);

// From above the air, or where next to nothing of it is left above: planet and limb are seen as a whole.
bool looks_from_space(const Part& part);

MomentSettings settings_of(const Part& part);

// What the sky passes take: steps along a ray, or parts of a shell, so many that a ray from the ground up has as many.
std::uint32_t steps_of(const Scene& scene, const MomentSettings& settings);

// What the passes over view rays read: the sun's light, the moments, and how they are told of them.
struct Light {
  ImageId transmittance;
  ImageId sunlight;  // the table of transmittance or, by shells, of mean extinction
  ImageId moments;
  std::vector<Specialization> constants;
  std::uint32_t steps;
  bool by_shells;

  std::vector<Binding> reads() const { return {{"transmittance_lut", sunlight}, {"moments_lut", moments}}; }

  // Beside that of transmittance, for SkyPasses::more_tables.
  std::vector<ImageId> more() const {
    return by_shells ? std::vector<ImageId>{sunlight, moments} : std::vector<ImageId>{moments};
  }
};

Light add_light(Plan& plan, const Part& part);

// Predicted cost of one ray of so many steps (PassDesc::cost).
double ray_cost(std::uint32_t steps);

// Whether the view's passes compute Q and U, and for what: kStokes.
std::uint32_t stokes_of(const Part& part, const View& view);

// The picture's own table of factors, as shaders/shared/sky_table.glsl is told of it.
struct FactorTable {
  std::uint32_t columns;
  std::uint32_t ground_rows;
  std::uint32_t limb_rows;
  std::uint32_t sky_rows;
  std::uint32_t apart;   // media of a block each, bit i
  std::uint32_t folded;  // media whose phase function is in the table
  bool rayleigh;         // among the folded
  std::uint32_t stokes;  // kStokes: unless none, Q and U of the diffuse light have a block each
  std::uint32_t blocks;

  std::uint32_t rows() const { return ground_rows + limb_rows + sky_rows; }
  long long rays() const { return static_cast<long long>(columns) * rows(); }
};

// From space the rows resolve the halo of the limb, and the terminator at the middle of the disc. `media`: those that
// scatter. `layers`: all of them apart, else the folded ones share the last block with the diffuse light. With `stokes`
// no molecules are folded.
FactorTable factor_table(const Part& part, std::uint32_t media, bool layers, std::uint32_t stokes);

// The table with nothing folded: shadows take light scattered once from each medium.
FactorTable unfolded_table(const Part& part);

void add_table_constants(std::vector<Specialization>& constants, const FactorTable& table);

// Froxels over a side of the picture: one for four pixels, unless those were too many.
std::uint32_t froxels_over(int pixels);

// What the table's EXR says of itself.
FactorLayout layout_of(const Scene& scene, const FactorTable& table, bool in_colours);

// Of a cone around the camera's axis that holds the picture, radians; pi where the whole table is wanted.
float half_angle_of(const Scene& scene, const View& view);

// `shader`: sky_factors, or layers_factors with one block more.
ImageId add_factors(Plan& plan, const std::string& shader, const Scene& scene, const FactorTable& table,
                    const View& view, const Light& light);

// Whether the picture's light is tabulated over view directions: `render.tabulate`, where nothing stands in the air.
bool tabulates(const Part& part, const View& view);

// The picture by its table of factors. Returns the table.
ImageId add_tabulated_sky(Plan& plan, const Part& part, const View& view, const SkyTarget& target, const Light& light);

// SkyMethod::add_coloured_passes. The phase functions stand outside of the factors, so factors of all wavelengths are
// summed into colours, and the pixels know of none. Among things pixels see one part's wavelengths, and write colours.
std::optional<SkyPasses> add_coloured(Plan& plan, const Stage& stage, const View& view,
                                      const std::optional<Canvas>& canvas);

// What terrain leaves of light that is not sunlight scattered once, in its own grid (shaders/shared/thing_shares.glsl).
struct ThingLight {
  ImageId shares;
  ImageId slopes;

  std::vector<Binding> reads() const { return {{"shares_lut", shares}, {"slopes_lut", slopes}}; }
};
ThingLight add_thing_light(Plan& plan, const Part& part, const Light& light, const ThingInputs& things);

// The light of caps of the sky, which bodies hide (shaders/physics/sky_caps.glsl); any image where none stand.
ImageId add_sky_caps(Plan& plan, const Part& part, const Light& light, const ThingInputs& things);

// kShafts of a march.
std::uint32_t march_shafts(const Part& part);

// Adds things to what a march reads that sees their shadows in the air.
void add_things_to_march(Plan& plan, const Part& part, const Light& light, std::vector<Binding>& reads,
                         std::vector<Specialization>& constants);

// Steps of such a march: half of the picture's are 0.02 % off in the mean where terrain is in the air.
std::uint32_t steps_past_things(const Part& part, const Light& light);

// The aerial volume and what stands beside it (shaders/physics/aerial_volume.glsl).
struct Volume {
  ImageId sources;
  ImageId extinction;
  ImageId peaks;

  std::vector<Binding> reads() const { return {{"volume_lut", sources}, {"extinction_lut", extinction}}; }
};

// Two thirds of the picture's table each way. What it leaves out shows far less: light before things is gathered over
// less air, and divided by what the transmittance takes.
// `apart`: light scattered once by each medium, and all other light, in blocks of their own.
FactorTable volume_table(Part part, bool apart);

// `half_angle`: of a cone around the camera's axis that holds all directions asked for, radians; pi: all there are.
Volume add_volume(Plan& plan, const Scene& scene, const Light& light, const FactorTable& table, const View& view,
                  float half_angle);

// The constants of passes that read it.
void add_volume_constants(std::vector<Specialization>& constants, const Scene& scene, const FactorTable& table);

struct StandingCloud {
  const Cloud* cloud;
  std::shared_ptr<const CloudGrid> grid;
};

// The scene's clouds, the lowest first, without those that hold no water, unless none does: then one.
std::vector<StandingCloud> standing_clouds(const Part& part);

// A cloud and its light as passes read them.
struct LitCloud {
  std::string name;  // Plan::tell_apart
  std::shared_ptr<const CloudGrid> grid;
  std::string key;
  device::CloudData head;
  std::vector<Binding> shade;             // its cells, and what all clouds leave of the sun's and the sky's light
  std::vector<Specialization> constants;  // of passes that read `shade`
  ImageId sources;
  ImageId phase;
};

// The light of standing_clouds(), none of which begins below the top of the one before.
std::vector<LitCloud> add_cloud_light(Plan& plan, const Part& part, const Light& light);

// Whether the passes over things go block by block, and then write in any colours.
bool lists_blocks(const Part& part, const View& view);

// How a picture shows things.
struct ThingsShown {
  std::array<Rgb, 3> colours = kAsTheyAre;  // of the part's channels in the target; others only where lists_blocks()
  std::vector<LitCloud> under = {};         // clouds that are yet to come into the picture
};

// What clouds ask of such a picture.
struct ThingsUnderCloud {
  std::vector<Binding> air;  // the air among them (shaders/shared/thing_tables.glsl)
  std::vector<Specialization> constants;
  FactorTable table;
  BufferId seen = {};  // what pixels show of things (shaders/shared/things_seen.glsl)
};

// The passes over things, the ground and the air about them.
ThingsUnderCloud add_things_sky(Plan& plan, const Part& part, const View& view, const SkyTarget& target,
                                const Light& light, const ThingsShown& shown = {});

// The first mirror, by its number, that stands too far away to show what the camera sees in that direction.
std::optional<std::size_t> far_mirror(const Scene& scene);

// The planes of its layers.
BufferId add_things_layers(Plan& plan, const Part& part, const View& view, const Light& light);

// Where clouds stand so, or among such things, as add_clouds() does not know.
std::vector<Misfit> cloud_misfits(const Scene& scene);

// SkyMethod::no_layers.
std::string no_layers_of(const Scene& scene);

// Throws InputError for the first of these. `no_picture`: what is asked for is no picture, but layers or the air before
// things.
void refuse_around_clouds(const Scene& scene, bool no_picture);

// Puts the clouds into the picture of their clear sky, or of things under them (null: there are none). Adds the buffer
// `cloud_transmittance`: what all clouds leave of a beam along each pixel's ray.
void add_clouds(Plan& plan, const Part& part, const View& view, const SkyTarget& target, const Light& light,
                const std::vector<LitCloud>& clouds, const ThingsUnderCloud* things);

// What they make of the light behind them in all directions from the camera, for mirrors
// (shaders/shared/cloud_map.glsl). `air`: of the picture of things.
BufferId add_cloud_map(Plan& plan, const Part& part, const View& view, const Light& light,
                       const std::vector<LitCloud>& clouds, const ThingsUnderCloud& air);

// Likewise into the planes of layers (add_layer_planes()), those of the clear sky being made: what stands in them is
// then seen through the clouds, and the clouds' planes are filled in.
void add_clouds_to_layers(Plan& plan, const Part& part, const View& view, const Light& light, BufferId planes);

// Rays to things, what shaders/shared/span_list.glsl reads.
struct SpanInput {
  BufferId list;
  std::uint32_t columns;
  std::uint32_t count;
  std::uint32_t first_row;
  bool whole_rows;

  Extent grid() const { return {std::min(columns, count), (count + columns - 1) / columns, 1}; }
};

// Likewise into the clear air before things, six floats a span.
void add_clouds_to_spans(Plan& plan, const Part& part, const View& view, const Light& light, const SpanInput& spans,
                         BufferId air);

// SkyMethod::add_span_passes of the method.
SpanPasses add_spans(Plan& plan, const Part& part, const Spans& spans, const SpanWay& way);

}  // namespace airlight::orders
