#pragma once
// Shared by the methods that march on the tables of transmittance and multiple scattering: parameters, tables, pass.

#include <vector>

#include "core/methods/march_steps.h"
#include "core/methods/method.h"
#include "core/methods/sky_pass.h"

namespace airlight {

// The parameters whose keys add_march_tables() and add_march_pass() read.
ParameterInfo phase_parameter();
ParameterInfo transmittance_lut_parameter();
ParameterInfo multiple_scattering_lut_parameter();
ParameterInfo multiple_scattering_scale_parameter();
ParameterInfo sun_fade_parameter();

// For Validity::known_failures: the failures of every march on these tables, and of marches along each pixel's ray.
std::vector<KnownFailure> march_table_failures();
std::vector<KnownFailure> march_failures();
// For SkyMethod::converged: the march with steps and tables so fine that neither shows.
Converged converged_march();

struct MarchTables {
  ImageId transmittance;
  ImageId multiple_scattering;
  ImageId ground_irradiance;  // under a black ground, which fetches nothing, it is the multiple-scattering table
  bool reflects = false;

  std::vector<ImageId> list() const;
};

MarchTables add_march_tables(Plan& plan, const Part& part);

// PassDesc::cost of a march along one ray.
double march_cost(int steps);

// Members of SkyMethod for methods that march: left_out and formula.
std::vector<std::string> march_left_out(const Scene& scene, const Plan& plan);
RayFormula march_formula(physics::Physics p, const Part& part, const HostTables& tables);

// The table of this name, empty where there is none.
physics::HostTable host_table(const HostTables& tables, const std::string& name);

// The specialisation constants of a pass that marches on these tables.
std::vector<Specialization> march_specialization(const Plan& plan, const Part& part, const MarchTables& tables);

// Bindings of the tables by the names in such a pass's shader.
std::vector<Binding> march_reads(const MarchTables& tables);

// The pass that marches every pixel or listed direction.
void add_march_pass(Plan& plan, const Part& part, const MarchTables& tables, const SkyTarget& target);

// Adds the ground by its maps to a picture of these tables with a black ground. No effect where the scene has no maps.
void add_march_ground(Plan& plan, const Part& part, const MarchTables& tables, const SkyTarget& target);

}  // namespace airlight
