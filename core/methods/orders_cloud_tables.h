#pragma once
// A cloud's grid as tables that the passes of `orders` read.

#include <memory>
#include <string>

#include "core/clouds/cloud_grid.h"
#include "core/luts/cloud_light.h"
#include "core/plan/plan.h"

namespace airlight::orders {

// The grid; a cloud that stands alone gets empty air all around, so that its shadow does not fall on its own
// repetition. `to_sun`: x east, y north, z up, in which the sun is seen from it; z > 0.
// Throws InputError where there are then too many cells. `cloud`: the grid's, for the message.
std::shared_ptr<const CloudGrid> with_room(const Cloud& cloud, const std::shared_ptr<const CloudGrid>& grid,
                                           physics::vec3 to_sun);

// How many corners the cells have, each being cut into `finer` levels. A table of floats over kMostCloudCells fits into
// a buffer of every device.
std::size_t corners_of(const CloudGrid& grid, std::size_t finer);

CloudCells cells_of(const CloudGrid& grid);
CloudCells shape_of(const CloudGrid& grid);  // without values
// The cells of the light in a cloud, without values: at most so many across and up. A carved field of fewer levels than
// `most` gets more across, as many in all: lobes are finer than they.
CloudCells light_shape(const CloudGrid& grid, TableSize most);
// `cloud` as a text, and how many cells it has.
std::string key_on(const std::string& cloud, const CloudCells& cells);

// Extinction, 1/km, and how far inside the cloud the place is, km. `key`: of the cloud.
ImageId add_density(Plan& plan, const std::shared_ptr<const CloudGrid>& grid, const std::string& key);

// Where a ray need not look for water, on cells of twice the grid's. `key`: of the cloud.
ImageId add_gaps(Plan& plan, const std::shared_ptr<const CloudGrid>& grid, const std::string& key);

// What reads the edge of a cloud's water (shaders/shared/cloud_carved.glsl).
struct EdgeInputs {
  Binding noise;
  Specialization carved;
};

// `any`: an image to bind where the edge is not carved.
EdgeInputs add_edge(Plan& plan, const CloudGrid& grid, ImageId any);

}  // namespace airlight::orders
