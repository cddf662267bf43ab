#pragma once
// The passes that find the light scattered in a cloud: the sun's light in its cells, and by discrete ordinates the
// light scattered there any number of times (shaders/physics/cloud_light.glsl). Grey: drops scatter alike at all
// wavelengths, so the light of sun, sky and ground is told apart by where it comes from, and coloured when it is seen.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/clouds/cloud_physics.h"
#include "core/luts/cloud_cells.h"
#include "core/plan/plan.h"

namespace airlight {

struct CloudDrops {
  double single_scattering_albedo = 1.0;
  std::vector<double> legendre;  // moments of the phase function from 0 on, one more than the degree kept at least
};

inline constexpr int kCloudDegree = 2;  // of the harmonics kept

// Light that comes to a cloud: the sun's, of irradiance 1, or light of even radiance through the top or the base.
struct CloudIncident {
  std::string name;
  bool sun = false;
  double above = 0.0;
  double below = 0.0;
  // What comes through the base along each ordinate over `below`, its mean (passes/cloud_ground.comp).
  std::optional<BufferId> ground = {};
};

// The largest share of its light that a sweep leaves in the cloud, which Chebyshev's iteration is tuned to: from the
// depth of the columns, as if the cloud were as thick everywhere.
double light_kept(const CloudCells& cells, const CloudDrops& drops);

// What the ordinates scale the extinction by, and the ordinates.
double delta_scale(const CloudDrops& drops);
std::vector<physics::CloudOrdinate> cloud_ordinates();
physics::CloudScattering cloud_scattering(const CloudDrops& drops, physics::vec3 sun);

// So many sweeps that Chebyshev's iteration leaves 2e-3 of the first error, at most 16; at most 6 where they begin with
// the light found on coarser cells.
int sweeps_for(double kept, bool begun);

// Steps of Chebyshev's iteration for a spectrum between 0 and `kept` [GV61]: what each sweep's change is multiplied by,
// and what the change before is.
struct ChebyshevStep {
  double step;
  double momentum;
};
std::vector<ChebyshevStep> chebyshev_steps(double kept, int count);

// A cloud's cells, and their extinction on the device, delta-scaled, 1/km.
struct LaidCells {
  CloudCells cells;
  BufferId extinction;
};
LaidCells add_cloud_cells(Plan& plan, const std::string& name, CloudCells cells, const CloudDrops& drops);

struct CloudField {
  BufferId moments;  // of the mean radiance in each cell: harmonic, cell
  BufferId planes;   // what leaves the top or the base along each ordinate: ordinate, column
  BufferId means;    // radiance along each ordinate, the mean over a cell, after the last sweep: ordinate, cell
};

// Light found on coarser cells.
struct CoarserField {
  CloudField field;
  LaidCells laid;
};

struct SweepSettings {
  int sweeps = 0;                          // 0: sweeps_for() what the cloud keeps
  bool host_readable = false;              // moments and planes
  std::optional<CoarserField> start = {};  // to begin with; else the cloud is dark
};

// What all fields of one cloud and sun read. `sun`: the direction in which its light travels, in the cloud's frame.
struct CloudTables {
  BufferId ordinates;
  BufferId scattering;
};
CloudTables add_cloud_tables(Plan& plan, const CloudDrops& drops, physics::vec3 sun);

// The field of the light that comes to the cloud. `beam`: the sun's light in each cell over that above the cloud,
// delta-scaled. `key`: of what is kept; empty: nothing.
CloudField add_cloud_field(Plan& plan, const LaidCells& laid, const CloudDrops& drops, const CloudIncident& incident,
                           const SweepSettings& settings, const CloudTables& tables, BufferId beam,
                           const std::string& key);

}  // namespace airlight
