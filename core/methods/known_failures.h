#pragma once
// The known failures of a method for the scene at hand.

#include <string_view>
#include <vector>

#include "core/methods/method.h"

namespace airlight {

// The causes of those known failures of the method whose region contains the scene. Sun, camera, air, planet and ground
// count. Steps and tables count where they are fewer or smaller than the method's own. A view counts where a tenth of
// the picture or more has it.
std::vector<std::string_view> known_failures_of(const SkyMethod& method, const Part& part);

// Quantity::light_kept of a scene, for the channel that keeps most.
double light_kept(const Part& part);

}  // namespace airlight
