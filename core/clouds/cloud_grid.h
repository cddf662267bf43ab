#pragma once
// A cloud as a grid of extinction, ready for use. Where it stands: shaders/physics/clouds.glsl.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/clouds/cloud_edge.h"
#include "core/clouds/cloud_physics.h"
#include "core/scene/scene.h"

namespace airlight {

struct CloudGrid {
  int nx = 0;            // cells toward the east
  int ny = 0;            // toward the north
  int nz = 0;            // upward
  double cell_x = 0.0;   // km
  double cell_y = 0.0;   // km
  double base = 0.0;     // km, altitude of the grid's lower edge
  double top = 0.0;      // km; the cells are even in height
  double west = 0.0;     // km, of the grid's corner from the point under the camera, positive toward the east
  double south = 0.0;    // km, likewise, positive toward the north
  bool repeats = false;  // toward all sides; false: nothing stands outside
  // In the cells' middles, 1/km: x fastest, then y, then z. Linear between the middles; constant from the outermost
  // ones to the grid's edges where it does not repeat.
  std::vector<float> extinction;
  bool smooth = true;  // false: even in each cell
  // Where edge.tiles is above 0, `extinction` holds means around the cells' middles, and this how far inside the cloud
  // these lie, km, from which noise takes a part (shaders/physics/cloud_edge.glsl).
  std::vector<float> inside;
  physics::CloudEdge edge{};
  std::shared_ptr<const CarvingNoise> noise;

  double cell_z() const { return (top - base) / nz; }
  std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(nx) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(ny) * static_cast<std::size_t>(k));
  }
  // Extinction at a place of the plane and an altitude, km; 0 outside.
  double at(double east, double north, double h) const;
  // What the noise takes off, as a share of edge.carving. `x`, `y`, `z`: places, 0 to 1 over the grid.
  double carved(double x, double y, double z) const;
  // No place of which the cell's middle is the nearest, or one of the eight around it, has more extinction.
  double most_around(int i, int j, int k) const;
};

// The grid of a cloud: a volume's file, or a field made from its seed.
CloudGrid cloud_grid(const Cloud& cloud);

// A text of all that the grid depends on, and one of all but its place.
std::string cloud_key(const Cloud& cloud);
std::string cloud_shape_key(Cloud cloud);

// The grid at the cloud's place: itself where it stands there, else a copy.
std::shared_ptr<const CloudGrid> placed_at(const std::shared_ptr<const CloudGrid>& grid, const Cloud& cloud);

// The medium that the cloud's matter is: coefficients for an extinction of 1/km, of density 0 in the air. `channels`:
// the wavelengths (nm) that the scene's channels stand for; 0: of a scene without spectra.
Medium cloud_medium(const Cloud& cloud, const Spectrum& channels);

// The fields by seed, for cloud_grid().
CloudGrid cumulus_grid(const Cloud& cloud);
CloudGrid stratocumulus_grid(const Cloud& cloud);
CloudGrid cirrus_grid(const Cloud& cloud);

}  // namespace airlight
