#pragma once
// Passes that turn groups of three wavelengths into colours.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/methods/spectral_sky.h"
#include "core/plan/plan.h"

namespace airlight {

// Until Plan::end_scene(), added passes belong to this group: they read its scene, and their names and keys carry its
// suffix. `tile`: of the picture.
void begin_group(Plan& plan, const SpectralScene& spectral, std::size_t group, const Tile& tile);

// Adds up the groups' tables, all of one size, as one table in colours, `name`; kept under `key` if that is not empty.
// `colours`: for each table those of its channels. `text`: ImageDesc::text of the sum.
ImageId add_colour_table(Plan& plan, const std::string& name, const std::string& key,
                         const std::vector<ImageId>& tables, const std::vector<std::array<Rgb, 3>>& colours,
                         const std::function<TableText()>& text = {});

// Adds a group's buffer of vec4s to one in colours; `first`: the latter holds nothing so far.
void add_colours(Plan& plan, BufferId part, BufferId picture, const std::array<Rgb, 3>& colours, std::size_t group,
                 bool first);

}  // namespace airlight
