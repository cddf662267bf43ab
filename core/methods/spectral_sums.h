#pragma once
// Passes that turn parts of three wavelengths into colours.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/plan/plan.h"
#include "core/stage/stage.h"

namespace airlight {

// Until Plan::end_scene(), added passes belong to this part: they read its scene, and their names and keys carry its
// suffix. An only part is the plan's own scene. `tile`: of the picture.
void begin_part(Plan& plan, const Part& part, const Tile& tile);

// Adds up the parts' tables, all of one size, as one table in colours, `name`; kept under `key` if that is not empty.
// `colours`: for each table those of its channels. `text`: ImageDesc::text of the sum.
ImageId add_colour_table(Plan& plan, const std::string& name, const std::string& key,
                         const std::vector<ImageId>& tables, const std::vector<std::array<Rgb, 3>>& colours,
                         const std::function<TableText()>& text = {});

// Appends `colours` to a pass's push constants.
void push_colours(std::vector<std::uint32_t>& push, const std::array<Rgb, 3>& colours);

// Adds a buffer of vec4s to one in colours, its channels as these; `suffix`: of the pass's name; `first`: the latter
// buffer holds nothing so far.
void add_colours(Plan& plan, BufferId buffer, BufferId picture, const std::array<Rgb, 3>& colours,
                 const std::string& suffix, bool first);

// Turns a buffer of vec4s into one in colours.
void turn_into_colours(Plan& plan, BufferId picture, const std::array<Rgb, 3>& colours, const std::string& suffix);

}  // namespace airlight
