#pragma once
// What the methods share that march on the tables of transmittance and multiple scattering: parameters, tables, pass.

#include <vector>

#include "core/methods/march_steps.h"
#include "core/methods/method.h"
#include "core/methods/sky_pass.h"

namespace airlight {

// Parameters by the keys that add_march_tables() and add_march_pass() read.
ParameterInfo phase_parameter();
ParameterInfo transmittance_lut_parameter();
ParameterInfo multiple_scattering_lut_parameter();
ParameterInfo multiple_scattering_scale_parameter();
ParameterInfo sun_fade_parameter();

// What every march on these tables fails at, for Validity::known_failures, and what one along each pixel's ray does.
std::vector<KnownFailure> march_table_failures();
std::vector<KnownFailure> march_failures();
// The march with neither steps nor tables to be seen, for SkyMethod::converged.
Converged converged_march();

struct MarchTables {
  ImageId transmittance;
  ImageId multiple_scattering;
  ImageId ground_irradiance;  // the multiple-scattering table under a black ground, which fetches nothing
  bool reflects = false;

  std::vector<ImageId> list() const;
};

MarchTables add_march_tables(Plan& plan, const Scene& scene, const Air& air);

// PassDesc::cost of a march along one ray.
double march_cost(int steps);

// SkyMethod's members for methods that march: what their keys leave out, keys that keep no light apart, the march in
// double.
std::vector<std::string> march_left_out(const Scene& scene, const Plan& plan);
std::string march_layers_refusal(const Scene& scene);
RayFormula march_formula(physics::Physics p, const Scene& scene, const Air& air, const HostTables& tables);

// The table of this name, empty where there is none.
physics::HostTable host_table(const HostTables& tables, const std::string& name);

// The specialisation constants of a pass that marches on these tables.
std::vector<Specialization> march_specialization(const Plan& plan, const Scene& scene, const Air& air,
                                                 const MarchTables& tables);

// The tables by the names that such a pass gives them.
std::vector<Binding> march_reads(const MarchTables& tables);

// The pass that marches every pixel or listed direction.
void add_march_pass(Plan& plan, const Scene& scene, const Air& air, const MarchTables& tables, const SkyTarget& target);

// The ground by its maps, over a picture of these tables whose ground is black; nothing where the scene has none.
void add_march_ground(Plan& plan, const Scene& scene, const Air& air, const MarchTables& tables,
                      const SkyTarget& target);

// The pass of the same march that keeps its light apart.
LayerPasses add_march_layers(Plan& plan, const Scene& scene, const Air& air, const View& view,
                             const MarchTables& tables);

}  // namespace airlight
