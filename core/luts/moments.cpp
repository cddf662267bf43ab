#include "core/luts/moments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "core/air/phase_functions.h"
#include "core/air/phase_samples.h"
#include "core/air/shells.h"
#include "core/luts/level_orders.h"
#include "core/luts/luts.h"
#include "core/physics/gauss.h"
#include "core/plan/bytes.h"

namespace airlight {
namespace {

// Directions over half the sphere (the other half mirrors it), as orders_bake.comp reads them. Zenith nodes stand at
// squares of Gauss nodes, dense at the horizon.
std::vector<float> direction_nodes(int up, int down, int half_azimuths) {
  std::vector<float> nodes;
  for (const bool upward : {true, false}) {
    const GaussRule gauss = gauss_legendre(upward ? up : down);
    for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
      for (int j = 0; j < half_azimuths; ++j) {
        nodes.push_back(static_cast<float>(gauss.nodes[i] * gauss.nodes[i]));
        nodes.push_back(
            static_cast<float>(2.0 * gauss.nodes[i] * gauss.weights[i] * 2.0 * std::numbers::pi / half_azimuths));
        nodes.push_back(static_cast<float>(std::cos(std::numbers::pi * (j + 0.5) / half_azimuths)));
        nodes.push_back(upward ? 1.0f : -1.0f);
      }
    }
  }
  return nodes;
}

struct OrderQuadrature {
  int up;
  int down;
  int half_azimuths;
  int steps;  // two a panel
};

// The threads that share the directions of a node, as orders_bake.comp has them.
constexpr std::uint32_t kThreads = 64;

// How an order is gathered where rays go by steps: what it takes from the one before and keeps, and the directions.
struct OrderWay {
  int degree;
  OrderQuadrature quadrature;
};

// Sunlight scattered once is the least smooth, by the forward peaks and by the planet's shadow; what follows needs
// fewer directions, and after the second order most of the harmonics are spent. `hazy`: the table has more rows, a ray
// more steps, and a peak more azimuths. `aloft`: by 10 zenith angles in place of 20 the zenith of `paranal`, whose
// second order is light of such a layer seen from the side, is 9 % too bright with the sun at -9 degrees.
OrderWay stepped_way(int order, const MomentSettings& settings) {
  const int after = std::min(settings.degree, std::max(settings.hazy ? 4 : 3, settings.degree - 3));
  const int degree = order <= 2 ? settings.degree : after;
  const int azimuths = std::max((degree + 3) / 2, 3);
  if (order == 1) {
    if (settings.sharp) {
      return {degree, {16, 16, 12, 24}};
    }
    return {degree, {settings.aloft ? 20 : 10, 5, settings.hazy ? 12 : 8, 24}};
  }
  if (settings.hazy) {
    return {degree, {6, 4, std::max(azimuths, 4), 12}};
  }
  return order == 2 ? OrderWay{degree, {5, 3, azimuths, 10}} : OrderWay{degree, {4, 3, azimuths, 8}};
}

// The quadrature by shells, where light from below counts as much as from above and the shells are the steps. Peaked
// sunlight wants many directions in the first order: 24 x 16 a side change a forward-scattering slab by 0.2 % at most.
// Later orders: more than 6 zenith nodes a side change nothing in a level slab of optical depth 5; azimuths are exact
// for products of two harmonics. What a forward peak leaves in high harmonics is spent after a few scatterings: with
// degree 6 for the third order and 4 for those after it, the sky under a forward-scattering slab of depth 1 and a sun 5
// degrees high is 6.5 % off where it is 2.8 % with these.
OrderWay shell_way(int order, const MomentSettings& settings) {
  const int degree = std::min(settings.degree, order <= 6 ? 8 : 6);
  if (order == 1) {
    return {degree, settings.peaked || settings.sharp ? OrderQuadrature{16, 16, settings.azimuths, 1}
                                                      : OrderQuadrature{10, 10, 6, 1}};
  }
  const int zeniths = degree > 6 ? 8 : 6;
  return {degree, {zeniths, zeniths, degree + 1, 1}};
}

OrderWay order_way(int order, const MomentSettings& settings) {
  return settings.shells ? shell_way(order, settings) : stepped_way(order, settings);
}

BufferId add_nodes(Plan& plan, const std::string& name, const OrderQuadrature& q) {
  return plan.add_buffer(filled_buffer(name, bytes_of(direction_nodes(q.up, q.down, q.half_azimuths))));
}

int harmonic_count(const MomentSettings& s) {
  return (s.degree + 1) * (s.degree + 2) / 2;
}

int block_count(const MomentSettings& s) {
  return harmonic_count(s) + (s.polarised ? static_cast<int>(physics::kPolarisedMoments) : 0) + 1;
}

Extent atlas_extent(const MomentSettings& s) {
  return {static_cast<std::uint32_t>(s.size[0] * block_count(s)), static_cast<std::uint32_t>(s.size[1]), 1};
}

// Moments that a bake of so many orders fetches, at all steps of all rays. A device runs all of a loop's code: later
// orders of a lower degree take no less. The first order fetches none.
double bake_fetches(const MomentSettings& settings, int orders) {
  constexpr int kOfStep = 15;  // that the rest of a step takes as long as
  double fetches = 0.0;
  for (int order = 1; order <= orders; ++order) {
    const OrderQuadrature q = order_way(order, settings).quadrature;
    const double along = settings.shells ? settings.size[1] - 1.0 : q.steps;
    const int of_step = kOfStep + (order > 1 ? block_count(settings) - 1 : 0);
    fetches += static_cast<double>(q.up + q.down) * q.half_azimuths * along * of_step;
  }
  return fetches * settings.size[0] * settings.size[1];
}

// The same for all orders at once: each correction is one order at half of the suns.
double fetches_at_once(const MomentSettings& settings) {
  const double first = bake_fetches(settings, 1);
  return first + 0.5 * settings.corrections * (bake_fetches(settings, 2) - first);
}

std::string row_altitudes(const physics::SceneData& scene) {
  return table_constant("altitudes_km",
                        {scene.shell_altitudes, scene.shell_altitudes + static_cast<std::ptrdiff_t>(scene.shell_rows)});
}

// The inverse of sun_table_coordinate(), rows at the edges of shells.
TableText sun_table_text(const Air& air) {
  return {.quantity = "mean extinction along the ray to the top of the atmosphere",
          .unit = "1/km",
          .axes = {{"x", "mu", "1", "zenith cosine of the ray, quadratic from the true horizon to the zenith"},
                   {"y", "altitude_km", "km", "listed: the edges of shells"}},
          .constants = planet_constants(optical_planet(air)) + row_altitudes(air.formulas().scene),
          .decode = R"(altitude_km = take(altitudes_km, j)
horizon_mu = -sqrt(altitude_km * (2 * ground_radius_km + altitude_km)) / (ground_radius_km + altitude_km)
x = i / (width - 1)
mu = horizon_mu + (1 - horizon_mu) * x * x
)"};
}

// The map of moment_state().
TableText moments_text(const Air& air, const MomentSettings& settings) {
  const physics::SceneData& scene = air.formulas().scene;
  const physics::MomentTableData& map = scene.moments;
  const std::string last = std::to_string(block_count(settings) - 1);
  const int first = harmonic_count(settings);
  const std::string molecules = settings.polarised
                                    ? "; in blocks " + std::to_string(first) + " to " + std::to_string(first + 2) +
                                          " P_m / M_00, to which Q and U add as I does to M_2m"
                                    : "";
  return {.quantity =
              "moments M_lm of the radiance scattered or reflected at least once, over the real orthonormal "
              "harmonics of the direction, azimuths from the sun's: log of M_00 in block 0, M_lm / M_00 in "
              "those behind it" +
              molecules + "; log of the irradiance of that light on level ground in block " + last +
              "; for a sun of irradiance 1",
          .unit = "1",
          .axes = {{"x", "mu_sun", "1", "zenith cosine of the sun, its elevation as a hyperbolic sine"},
                   {"y", "altitude_km", "km",
                    settings.shells ? "listed: the edges of shells" : "quadratic, from the ground to the highest row"},
                   {"block", "l", "1", "degree of the harmonic, 2 of P_m; of no meaning in block " + last},
                   {"block", "m", "1", "its order, 0 to l"}},
          .constants = table_constant("columns", settings.size[0]) + table_constant("harmonics", first) +
                       (settings.shells ? row_altitudes(scene) : table_constant("highest_km", map.top)) +
                       table_constant("elevation_scale", map.elevation_scale) + table_constant("v_low", map.v_low) +
                       table_constant("v_high", map.v_high),
          .decode = std::string(R"(block = floor(i / columns)
v = v_low + (v_high - v_low) * (i - columns * block) / (columns - 1)
mu_sun = sin(elevation_scale * sinh(v))
)") +
                    (settings.shells ? "altitude_km = take(altitudes_km, j)\n"
                                     : "altitude_km = highest_km * (j / (height - 1)) * (j / (height - 1))\n") +
                    (settings.polarised ? R"(polarised = block >= harmonics
l = 2 * polarised + (1 - polarised) * floor((sqrt(8 * block + 1) - 1) / 2)
m = polarised * (block - harmonics) + (1 - polarised) * (block - l * (l + 1) / 2)
)"
                                        : R"(l = floor((sqrt(8 * block + 1) - 1) / 2)
m = block - l * (l + 1) / 2
)")};
}

// Whether harmonics up to `degree` leave a forward peak of some medium that scatters.
bool leaves_a_peak(const Air& air, int degree) {
  constexpr double kLeast = 1e-4;  // quadrature leaves less in a smooth phase function
  for (std::size_t i = 0; i < air.media().size(); ++i) {
    const physics::vec3& peak = air.formulas().scene.media[i].peak[static_cast<std::size_t>(degree)];
    if ((air.scattering_media() >> i & 1U) != 0 && std::max({peak.x, peak.y, peak.z}) > kLeast) {
      return true;
    }
  }
  return false;
}

// Whether a medium that scatters is such a one.
template <class Such>
bool scatters_as(const Air& air, Such such) {
  for (std::size_t i = 0; i < air.media().size(); ++i) {
    if ((air.scattering_media() >> i & 1U) != 0 && such(air.media()[i])) {
      return true;
    }
  }
  return false;
}

// Whether a medium that scatters, not smoothly, is less than half as dense at the ground as above.
bool has_layer_aloft(const Air& air) {
  const Column& column = air.column();
  for (std::size_t i = 0; i < air.media().size(); ++i) {
    const Medium& medium = air.media()[i];
    const auto density = [i](const Column::PerMedium& cell) { return cell[i]; };
    if ((air.scattering_media() >> i & 1U) != 0 && !phase_row(medium.phase).is_smooth &&
        density(column.density.front()) < 0.5 * density(*std::ranges::max_element(column.density, {}, density))) {
      return true;
    }
  }
  return false;
}

// Azimuths of half a turn that gather sunlight scattered once by these media. n of them mistake what a peak holds in
// harmonics of 2n periods a turn for an even field, of the other sign. So many that the Legendre moments, which fall by
// about the same factor a degree, have fallen to kLeft. Under a sun 3 to 8 degrees high, around which all of a peak's
// harmonics stand, level layers of g 0.85 and depth 3 and 10 are 4 % darker with 12 than with these 20.
// Peaks by table are gathered without such harmonics.
int peak_azimuths(const Air& air) {
  constexpr double kLeft = 2e-3;
  constexpr double kFewest = 12.0;
  constexpr double kMost = 24.0;
  double most = kFewest;
  for (std::size_t i = 0; i < air.media().size(); ++i) {
    const auto& moments = air.formulas().scene.media[i].legendre;
    const double before = std::abs(moments[physics::kLegendreMoments - 2].x);
    const double last = std::abs(moments[physics::kLegendreMoments - 1].x);
    if (!has_samples(air.media()[i]) && (air.scattering_media() >> i & 1U) != 0 && last > 1e-4 && last < before) {
      most = std::max(most, std::ceil(std::log(kLeft) / (2.0 * std::log(last / before))));
    }
  }
  return static_cast<int>(std::min(most, kMost));
}

}  // namespace

MomentSettings moment_settings(const Air& air, const MomentRequest& request) {
  constexpr double kThick = 0.02;
  constexpr int kMostOrders = 40;
  constexpr double kHazy = 0.4;
  constexpr double kLevel = 0.1;  // air higher than this, in radii, is too round to be taken as level
  constexpr double kDeep = 1.0;
  constexpr double kPeaked = 0.4;
  constexpr int kFewerHarmonics = 5;  // three times as many orders in the same time as with degree 8
  MomentSettings settings;
  const DiffusionDepths depths = air.diffusion_depths(4);
  const physics::uint shell_rows = air.formulas().scene.shell_rows;
  const bool thick = depths.forward > kThick;
  const auto counted = [&](double depth) { return static_cast<int>(std::min(depth, kMostOrders - 4.0)); };
  settings.shells = shell_rows > 0;
  settings.sharp = std::ranges::any_of(air.media(), is_sharp);
  settings.aloft = has_layer_aloft(air);
  settings.azimuths = peak_azimuths(air);
  settings.hazy = !settings.shells && (request.hazy || air.depths().scattering > kHazy);
  const auto is_molecular = [](const Medium& m) { return m.phase == PhaseFunction::rayleigh; };
  settings.polarised = request.polarised && scatters_as(air, is_molecular);
  settings.molecules_alone =
      settings.polarised && !scatters_as(air, [](const Medium& m) { return !phase_row(m.phase).is_smooth; });
  settings.degree = request.degree.value_or(!thick ? 2 : settings.shells || settings.hazy ? 8 : 5);
  settings.peaked = thick;
  settings.delta = leaves_a_peak(air, settings.degree);
  settings.size = request.size;
  if (settings.shells) {
    // Until the orders fall alike everywhere: a level slab of optical depth 5 that absorbs nothing is off by 60 to 230
    // % at its foot with 12 orders, by 3 with 18, and no longer changes from 24 on.
    settings.orders = 4 + counted(4.0 * depths.scaled);
    settings.size[1] = static_cast<int>(shell_rows);
  } else {
    // Over bright ground the third order still falls otherwise than those after it.
    const double bounce = *std::ranges::max_element(air.planet().ground_albedo);
    // In hazy dusk the third order falls otherwise too: dust with the sun at -3 degrees is 8 % off by three orders, 1
    // by four.
    settings.orders =
        3 + std::max(counted(std::max(5.0 * depths.scaled - 1.0, 3.0 * depths.transport)), settings.hazy ? 1 : 0) +
        (bounce > 0.5 ? 1 : 0);
    // Between bright ground and air that scatters back to it orders are large and small in turn, which no geometric
    // tail follows: haze of g -0.9 and depth 0.1 over white ground is 12 % off by four orders, 1.4 by six.
    if (bounce > 0.5 && depths.backward > kThick) {
      settings.orders = std::max(settings.orders, 8);
    }
    settings.size[1] = settings.hazy ? hazy_rows(request.size[1]) : request.size[1];
  }
  const Planet& planet = air.planet();
  if (settings.shells && !request.orders && planet.atmosphere_height < kLevel * planet.ground_radius) {
    const bool deep = depths.scaled > kDeep || depths.forward + depths.backward > kPeaked;
    settings.corrections = deep ? 4 : 2;
    settings.level_degree = std::min(settings.degree, deep ? 3 : 2);
  }
  settings.orders = std::max(request.orders.value_or(settings.orders), 2);
  settings.wished_orders = settings.orders;
  const double most = kMostBakeFetches * kUsualMedia / static_cast<double>(std::max(kUsualMedia, air.media().size()));
  if (fetches_at_once(settings) > most) {
    settings.corrections = 0;
  }
  const auto too_many = [&] { return settings.corrections == 0 && bake_fetches(settings, settings.orders) > most; };
  if (too_many() && settings.degree > kFewerHarmonics && !request.degree) {
    settings.degree = kFewerHarmonics;
    settings.delta = leaves_a_peak(air, settings.degree);
  }
  while (too_many() && settings.orders > 2) {
    --settings.orders;
  }
  return settings;
}

void add_moment_constants(std::vector<Specialization>& constants, const MomentSettings& settings) {
  constants.push_back({"kMomentDegree", static_cast<std::uint32_t>(settings.degree)});
  constants.push_back({"kDeltaScaled", settings.delta ? 1u : 0u});
  constants.push_back({"kMomentPolarised", settings.polarised ? 1u : 0u});
  constants.push_back(
      {"kMomentScattered", settings.molecules_alone ? 0u : static_cast<std::uint32_t>(settings.degree)});
  constants.push_back({"kMomentColumns", static_cast<std::uint32_t>(settings.size[0])});
  constants.push_back({"kMomentRows", static_cast<std::uint32_t>(settings.size[1])});
  constants.push_back({"kShellRows", settings.shells ? static_cast<std::uint32_t>(settings.size[1]) : 0u});
}

ImageId add_sun_table(Plan& plan, const Air& air, const MomentSettings& settings) {
  const TableSize size{256, settings.size[1]};
  const Extent extent{static_cast<std::uint32_t>(size[0]), static_cast<std::uint32_t>(size[1]), 1};
  if (const auto there = plan.table_of(table_key(air, "sun_table", size))) {
    return *there;
  }
  std::vector<Specialization> constants = medium_specialization(air);
  constants.push_back({"kShellRows", extent.height});
  if (air.formulas().refraction) {
    return add_bent_sunlight(
        plan, air, size,
        {"sun_table", "bent_sun_table", "sun_table_out", [air] { return in_lower_half_too(sun_table_text(air)); }},
        std::move(constants));
  }
  const ImageId out = plan.add_image(
      {.name = "sun_table", .extent = extent, .key = table_key(air, "sun_table", size), .stored = true, .text = [air] {
         return sun_table_text(air);
       }});
  plan.add_pass({.name = "sun_table",
                 .shader = "sun_table",
                 .writes = {{"sun_table_out", out}},
                 .grid = extent,
                 .specialization = constants});
  return out;
}

namespace {

// What all passes of a bake share.
struct Bake {
  Plan& plan;
  const Air& air;
  ImageId sunlight;
  const MomentSettings& settings;
  BufferId sums;
  std::map<std::string, BufferId> nodes = {};
};

Bake begin_bake(Plan& plan, const Air& air, ImageId sunlight, const MomentSettings& settings) {
  const Extent atlas = atlas_extent(settings);
  const BufferId sums = plan.add_buffer(
      {.name = "moment_sums", .bytes = std::size_t{atlas.width} * atlas.height * 4 * sizeof(float), .scratch = true});
  return {plan, air, sunlight, settings, sums};
}

// One order of scattering out of `before`, at so many suns of the table; out of the table of sunlight, the first.
ImageId add_order(Bake& bake, const std::string& name, ImageId before, const OrderWay& way, std::uint32_t columns) {
  const OrderQuadrature& q = way.quadrature;
  const std::string directions = "directions " + std::to_string(q.up) + " up, " + std::to_string(q.down) + " down, " +
                                 std::to_string(q.half_azimuths) + " azimuths";
  if (!bake.nodes.contains(directions)) {
    bake.nodes.emplace(directions, add_nodes(bake.plan, directions, q));
  }
  const ImageId out = bake.plan.add_image({.name = name, .extent = atlas_extent(bake.settings), .key = {}});
  std::vector<Specialization> constants = sunlight_specialization(bake.plan, bake.air, bake.sunlight);
  add_moment_constants(constants, bake.settings);
  constants.push_back({"kFirstOrder", before == bake.sunlight ? 1u : 0u});
  bake.plan.add_pass({.name = name,
                      .shader = "orders_bake",
                      .reads = {{"transmittance_lut", bake.sunlight},
                                {"moments_lut", before},  // the first order reads none
                                {"nodes", bake.nodes.at(directions)}},
                      .writes = {{"order_out", out}, {"sums", bake.sums}},
                      .grid = {kThreads, columns, static_cast<std::uint32_t>(bake.settings.size[1])},
                      .push_constants = {static_cast<std::uint32_t>((q.up + q.down) * q.half_azimuths),
                                         static_cast<std::uint32_t>((q.steps + 1) / 2), columns,
                                         static_cast<std::uint32_t>(way.degree)},
                      .specialization = std::move(constants),
                      .cost = 2.0 * (q.up + q.down) * q.half_azimuths * q.steps / kThreads});
  return out;
}

ImageDesc moments_image(const Plan& plan, const Air& air, ImageId sunlight, const MomentSettings& settings) {
  const std::string key = "degree " + std::to_string(settings.degree) + " delta " + std::to_string(settings.delta) +
                          " orders " + std::to_string(settings.orders) + " corrections " +
                          std::to_string(settings.corrections) + " level " + std::to_string(settings.level_degree) +
                          " polarised " + std::to_string(settings.polarised);
  const Extent sources[] = {plan.images()[sunlight.index].extent};
  return {.name = "moments",
          .extent = atlas_extent(settings),
          .key = table_key(air, "moments " + key, settings.size, sources),
          .stored = true,
          .text = [air, settings] { return moments_text(air, settings); }};
}

ImageId add_orders_one_by_one(Bake bake) {
  const MomentSettings& settings = bake.settings;
  std::vector<ImageId> orders;
  for (int order = 1; order <= settings.orders; ++order) {
    orders.push_back(add_order(bake, "order" + std::to_string(order), order == 1 ? bake.sunlight : orders.back(),
                               order_way(order, settings), static_cast<std::uint32_t>(settings.size[0])));
  }
  const ImageId moments = bake.plan.add_image(moments_image(bake.plan, bake.air, bake.sunlight, settings));
  std::vector<Specialization> shape;
  add_moment_constants(shape, settings);
  bake.plan.add_pass({.name = "orders_sum",
                      .shader = "orders_sum",
                      .reads = {{"last_order", orders.back()},
                                {"order_before", orders[orders.size() >= 2 ? orders.size() - 2 : 0]},
                                {"sums", bake.sums}},
                      .writes = {{"moments_out", moments}},
                      .grid = atlas_extent(settings),
                      .specialization = std::move(shape)});
  return moments;
}

// Of its light, what each order is taken to lose in level air: so little that it does not slow the corrections down,
// hence less than leaves deep air, which goes with the square of the depth; not so little that rounding grows.
double lost_share(const Air& air) {
  constexpr double kDepth = 5.0;
  const double depth = air.diffusion_depths(4).scaled;
  return std::clamp(0.001 * kDepth * kDepth / std::max(depth * depth, 1e-9), 1e-4, 0.001);
}

// The light of all orders as one field that is corrected until it obeys field = first order + one order of the field:
// at first by few directions and harmonics, for the light that all orders share, then by all of them. Late orders are
// smooth over the sun's elevation, and what is gathered is but what the field lacks: half of the table's suns will
// do.
ImageId add_orders_at_once(Bake bake) {
  constexpr int kRoughDegree = 4;
  constexpr OrderWay kRough{kRoughDegree, {5, 5, kRoughDegree + 1, 1}};
  const MomentSettings& settings = bake.settings;
  const int all = settings.size[0];
  const auto some = static_cast<std::uint32_t>(std::min(all, std::max(16, all / 2)));
  const LevelShape shape{settings.size[1], settings.level_degree, settings.polarised};
  const BufferId level = bake.plan.add_buffer(
      {.name = "level_orders",
       .bytes = shape.values() * 3 * sizeof(float),
       .contents_when_run = [air = bake.air, shape, degree = settings.degree, delta = settings.delta] {
         return bytes_of(level_orders(air, shape, degree, delta, lost_share(air)));
       }});
  const ImageId first =
      add_order(bake, "order1", bake.sunlight, order_way(1, settings), static_cast<std::uint32_t>(all));
  ImageId field = first;
  for (int i = 0; i <= settings.corrections; ++i) {
    const bool rough = settings.degree > kRoughDegree && i == 1;
    const ImageId gathered =
        i == 0 ? first
               : add_order(bake, "orders" + std::to_string(i), field, rough ? kRough : order_way(2, settings), some);
    const ImageId out = bake.plan.add_image(
        i == settings.corrections
            ? moments_image(bake.plan, bake.air, bake.sunlight, settings)
            : ImageDesc{.name = "field" + std::to_string(i), .extent = atlas_extent(settings), .key = {}});
    std::vector<Specialization> constants;
    add_moment_constants(constants, settings);
    constants.push_back({"kLevelDegree", static_cast<std::uint32_t>(shape.degree)});
    bake.plan.add_pass({.name = "orders_level" + std::to_string(i),
                        .shader = "orders_level",
                        .reads = {{"first_order", first}, {"field", field}, {"gathered", gathered}, {"level", level}},
                        .writes = {{"field_out", out}},
                        .grid = {kThreads, static_cast<std::uint32_t>(all), 1},
                        .push_constants = {some, i == 0 ? 1u : 0u},
                        .specialization = std::move(constants),
                        .cost = 0.1 * settings.size[1] * shape.degree * shape.degree});
    field = out;
  }
  return field;
}

}  // namespace

ImageId add_moments(Plan& plan, const Air& air, ImageId sunlight, const MomentSettings& settings) {
  if (const auto there = plan.table_of(moments_image(plan, air, sunlight, settings).key)) {
    return *there;
  }
  Bake bake = begin_bake(plan, air, sunlight, settings);
  return settings.corrections > 0 ? add_orders_at_once(std::move(bake)) : add_orders_one_by_one(std::move(bake));
}

}  // namespace airlight
