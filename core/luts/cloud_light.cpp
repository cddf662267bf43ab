#include "core/luts/cloud_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "core/physics/device_scene.h"
#include "core/physics/gauss.h"
#include "core/plan/bytes.h"

namespace airlight {
namespace {

// The share of the scattered light that counts as not scattered.
double peak_of(const CloudDrops& drops) {
  return drops.legendre.at(kCloudDegree + 1);
}

// The degree of harmonic i.
int degree_of(std::uint32_t i) {
  return static_cast<int>(std::sqrt(static_cast<double>(i) + 0.5));
}

float cloud_float(double x) {
  return static_cast<float>(x);
}

device::CloudOrdinate narrowed_ordinate(const physics::CloudOrdinate& o) {
  device::CloudOrdinate out{};
  out.direction = {cloud_float(o.direction.x), cloud_float(o.direction.y), cloud_float(o.direction.z)};
  out.weight = cloud_float(o.weight);
  out.lowest = cloud_float(o.lowest);
  std::ranges::transform(o.harmonics, std::begin(out.harmonics), cloud_float);
  return out;
}

device::CloudScattering narrowed_scattering(const physics::CloudScattering& s) {
  device::CloudScattering out{};
  std::ranges::transform(s.kept, std::begin(out.kept), cloud_float);
  std::ranges::transform(s.sunlight, std::begin(out.sunlight), cloud_float);
  return out;
}

// Cells with water and their neighbours: from no other does the picture ask for a source.
std::vector<std::uint32_t> lit_cells(const CloudCells& cells) {
  const std::vector<float> gaps = gaps_of(cells);
  std::vector<std::uint32_t> list;
  for (std::uint32_t at = 0; at < gaps.size(); ++at) {
    if (gaps[at] <= 1.0F) {
      list.push_back(at);
    }
  }
  return list;
}

}  // namespace

double delta_scale(const CloudDrops& drops) {
  return 1.0 - drops.single_scattering_albedo * peak_of(drops);
}

// Diffusion in a slab of transport depth T: of the fundamental mode a sweep leaks a share B^2 / 3 times the transport
// depth over the depth, with B = pi / (T + 2 x 0.71) [CZ67].
double light_kept(const CloudCells& cells, const CloudDrops& drops) {
  const std::size_t plane = std::size_t{cells.nx} * cells.ny;
  double depth = 0.0;
  std::size_t cloudy = 0;
  for (std::size_t at = 0; at < plane; ++at) {
    double column = 0.0;
    for (std::uint32_t k = 0; k < cells.nz; ++k) {
      column += cells.extinction[k * plane + at] * cells.cell_z;
    }
    depth += column * column;
    cloudy += column > 0.0 ? 1 : 0;
  }
  depth = std::sqrt(depth / static_cast<double>(std::max<std::size_t>(cloudy, 1)));
  const double albedo = drops.single_scattering_albedo;
  const double peak = peak_of(drops);
  const double scaled = depth * (1.0 - albedo * peak);
  const double kept_albedo = albedo * (1.0 - peak) / (1.0 - albedo * peak);
  const double transport = scaled * (1.0 - kept_albedo * (drops.legendre.at(1) - peak) / (1.0 - peak));
  const double buckling = std::numbers::pi / (transport + 1.42);
  return kept_albedo / (1.0 + buckling * buckling / 3.0 * transport / std::max(scaled, 1e-9));
}

std::vector<physics::CloudOrdinate> cloud_ordinates() {
  constexpr int kZenithAngles = 3;  // of each hemisphere
  constexpr int kAzimuths = 8;
  physics::CloudPhysics p;
  std::vector<physics::CloudOrdinate> ordinates;
  const GaussRule rule = gauss_legendre(kZenithAngles);
  for (const double side : {-1.0, 1.0}) {
    double lowest = 0.0;
    for (std::size_t n = 0; n < rule.nodes.size(); lowest += rule.weights[n], ++n) {
      const double z = rule.nodes[n];
      for (int a = 0; a < kAzimuths; ++a) {
        const double turn = p.ring_is_turned(z) ? 0.5 : 0.0;
        const double azimuth = 2.0 * std::numbers::pi * (a + turn) / kAzimuths;
        const double across = std::sqrt(1.0 - z * z);
        physics::CloudOrdinate o{};
        o.direction = {across * std::cos(azimuth), across * std::sin(azimuth), side * z};
        o.weight = rule.weights[n] * 2.0 * std::numbers::pi / kAzimuths;
        o.lowest = lowest;
        for (std::uint32_t i = 0; i < physics::kCloudMoments; ++i) {
          o.harmonics[i] = p.cloud_harmonic(i, o.direction);
        }
        ordinates.push_back(o);
      }
    }
  }
  return ordinates;
}

physics::CloudScattering cloud_scattering(const CloudDrops& drops, physics::vec3 sun) {
  physics::CloudPhysics p;
  physics::CloudScattering scattering{};
  const double albedo = drops.single_scattering_albedo;
  const double peak = peak_of(drops);
  const double kept = albedo * (1.0 - peak) / (1.0 - albedo * peak);
  for (std::uint32_t i = 0; i < physics::kCloudMoments; ++i) {
    const double chi = drops.legendre.at(static_cast<std::size_t>(degree_of(i)));
    scattering.kept[i] = kept * (chi - peak) / (1.0 - peak);
    scattering.sunlight[i] = p.cloud_harmonic(i, sun);
  }
  return scattering;
}

int sweeps_for(double kept, bool begun) {
  constexpr double kLeft = 2e-3;
  constexpr int kFewest = 6;
  const int most = begun ? kFewest : 16;
  const double root = std::sqrt(1.0 - std::min(kept, 0.9999));
  return std::clamp(static_cast<int>(std::ceil(std::log(kLeft) / std::log((1.0 - root) / (1.0 + root)))), kFewest,
                    most);
}

std::vector<ChebyshevStep> chebyshev_steps(double kept, int count) {
  const double middle = 1.0 - 0.5 * kept;
  const double half = 0.5 * kept;
  std::vector<ChebyshevStep> steps;
  double step = 1.0 / middle;
  for (int n = 0; n < count; ++n) {
    double momentum = 0.0;
    if (n > 0) {
      momentum = (n == 1 ? 0.5 : 0.25) * half * half * step * step;
      step = 1.0 / (middle - momentum / step);
    }
    steps.push_back({step, momentum});
  }
  return steps;
}

CloudTables add_cloud_tables(Plan& plan, const CloudDrops& drops, physics::vec3 sun) {
  std::vector<device::CloudOrdinate> ordinates;
  std::ranges::transform(cloud_ordinates(), std::back_inserter(ordinates), narrowed_ordinate);
  const device::CloudScattering scattering = narrowed_scattering(cloud_scattering(drops, sun));
  return {plan.add_buffer(filled_buffer("cloud_ordinates", bytes_of(ordinates))),
          plan.add_buffer(filled_buffer("cloud_scattering", bytes_of_one(scattering)))};
}

LaidCells add_cloud_cells(Plan& plan, const std::string& name, CloudCells cells, const CloudDrops& drops) {
  std::vector<float> scaled = cells.extinction;
  std::ranges::for_each(scaled, [scale = cloud_float(delta_scale(drops))](float& x) { x *= scale; });
  return {std::move(cells), plan.add_buffer(filled_buffer(name, bytes_of(scaled)))};
}

CloudField add_cloud_field(Plan& plan, const LaidCells& laid, const CloudDrops& drops, const CloudIncident& incident,
                           const SweepSettings& settings, const CloudTables& tables, BufferId beam,
                           const std::string& key) {
  const CloudCells& cells = laid.cells;
  const auto count = static_cast<std::uint32_t>(cells.count());
  const std::size_t floats = cells.count() * sizeof(float);
  const std::size_t rays = floats * physics::kCloudOrdinates;
  const std::string name = "cloud_" + incident.name;
  const std::vector<std::uint32_t> lit = lit_cells(cells);
  const auto lit_count = static_cast<std::uint32_t>(lit.size());
  const BufferId list =
      plan.add_buffer(filled_buffer(name + "_list", bytes_of(lit.empty() ? std::vector<std::uint32_t>(1) : lit)));
  const auto add = [&](const char* of, std::size_t bytes, bool kept) {
    return plan.add_buffer({.name = name + of,
                            .bytes = bytes,
                            .host_readable = kept && settings.host_readable,
                            .key = kept && !key.empty() ? key + " " + name + of : std::string(),
                            .scratch = !kept});
  };
  const BufferId sources = add("_sources", 2 * rays, false);
  const BufferId means = add("_means", rays, false);
  const BufferId changes = add("_changes", floats * physics::kCloudMoments, false);
  const CloudField field{add("_moments", floats * physics::kCloudMoments, true), add("_planes", rays / cells.nz, true),
                         means};
  const std::uint32_t longest = std::max({cells.nx * cells.ny, cells.nx * cells.nz, cells.ny * cells.nz});
  const BufferId fronts = add("_fronts", std::size_t{2} * physics::kCloudOrdinates * longest * sizeof(float), false);
  std::uint32_t sweep = 0;
  const double kept = light_kept(cells, drops);
  BufferId moments = field.moments;
  if (settings.start) {
    const CloudCells& coarser = settings.start->laid.cells;
    plan.add_pass({.name = name + "_start",
                   .shader = "cloud_start",
                   .reads = {{"lit_cells", list},
                             {"found", settings.start->field.moments},
                             {"coarser_cells", settings.start->laid.extinction}},
                   .writes = {{"moments_out", field.moments}},
                   .grid = {std::max(lit_count, 1U), 1, 1},
                   .push_constants = {lit_count, cells.nx, cells.ny, cells.nz, coarser.nx, coarser.ny, coarser.nz},
                   .cost = 10.0});
  } else {
    const std::vector<float> dark(physics::kCloudMoments * cells.count());
    moments = plan.add_buffer(filled_buffer(name + "_nothing", bytes_of(dark)));
  }
  for (const ChebyshevStep& step :
       chebyshev_steps(kept, settings.sweeps > 0 ? settings.sweeps : sweeps_for(kept, settings.start.has_value()))) {
    plan.add_pass({.name = name + "_emission",
                   .shader = "cloud_emission",
                   .reads = {{"ordinates", tables.ordinates},
                             {"scattering", tables.scattering},
                             {"lit_cells", list},
                             {"beam", incident.sun ? beam : laid.extinction},
                             {"extinctions", laid.extinction},
                             {"moments", moments}},
                   .writes = {{"sources_out", sources}},
                   .grid = {std::max(lit_count, 1U), 1, 1},
                   .push_constants = {lit_count, cells.nx, cells.ny, cells.nz, push_constant(cells.cell_x),
                                      push_constant(cells.cell_y), push_constant(cells.cell_z),
                                      push_constant(incident.sun ? 1.0 : 0.0)},
                   .cost = 20.0});
    plan.add_pass(
        {.name = name + "_sweep",
         .shader = "cloud_sweep",
         .reads = {{"ordinates", tables.ordinates},
                   {"cells", laid.extinction},
                   {"sources", sources},
                   {"ground", incident.ground.value_or(laid.extinction)}},
         .writes = {{"means_out", means}, {"fronts", fronts}, {"planes_out", field.planes}},
         .grid = {16 * physics::kCloudOrdinates, 8, 1},
         .push_constants = {cells.nx, cells.ny, cells.nz, push_constant(cells.cell_x), push_constant(cells.cell_y),
                            push_constant(cells.cell_z), push_constant(incident.above), push_constant(incident.below),
                            sweep++, longest, incident.ground ? 1U : 0U},
         .cost = 2.0 * static_cast<double>(cells.count()) / 256.0});
    plan.add_pass({.name = name + "_gather",
                   .shader = "cloud_gather",
                   .reads = {{"ordinates", tables.ordinates}, {"lit_cells", list}, {"means", means}},
                   .writes = {{"moments", field.moments}, {"changes", changes}},
                   .grid = {std::max(lit_count, 1U), 1, 1},
                   .push_constants = {lit_count, count, push_constant(step.step), push_constant(step.momentum)},
                   .cost = 10.0});
    moments = field.moments;
  }
  return field;
}

}  // namespace airlight
