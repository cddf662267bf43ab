#pragma once
// Light over the columns of a level, periodic cloud without air above black ground: what the cases of the
// intercomparison of 3-D radiation codes (Cahalan and others 2005) ask for, by path-trace's own walks.

#include <memory>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace airlight::test {

struct ColumnCase {
  std::shared_ptr<CloudFile> cloud;  // in cells; periodic
  double sun_elevation = 90.0;       // degrees; light travels toward the east
  double albedo = 1.0;               // of single scattering
  double g = 0.85;                   // of Henyey and Greenstein's phase function
};

// The step cloud: 32 columns of 15.625 m, endless in y, 0.25 km thick, of depth 2 and 18.
std::shared_ptr<CloudFile> step_cloud();

// A cloud of nx x ny columns of 30 m whose base is at 0.2 km: thickness (km) and optical depth of each, x fastest.
std::shared_ptr<CloudFile> column_cloud(int nx, int ny, const std::vector<double>& thickness,
                                        const std::vector<double>& depth);

// Of each column, x fastest; over the flux that the sun brings down on a level plane.
struct ColumnLight {
  std::vector<double> reflectance;    // upward flux at the top
  std::vector<double> transmittance;  // downward flux at the base, with the sun's own
  std::vector<double> absorptance;    // within the column
  std::vector<double> zenith;         // pi times the radiance straight up at the top
  // Standard errors of their means over all columns.
  double reflectance_error = 0.0;
  double transmittance_error = 0.0;
  double absorptance_error = 0.0;
  double zenith_error = 0.0;
};

double mean_of(const std::vector<double>& values);

// `samples`: of a column, paths of sunlight that falls on it, and paths back from the eye for each radiance. `threads`:
// at least 1.
ColumnLight column_light(const ColumnCase& scene, int samples, int threads, unsigned seed = 1);

}  // namespace airlight::test
