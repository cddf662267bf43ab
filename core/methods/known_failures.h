#pragma once
// Where a method is known to fail, for the scene at hand.

#include <string_view>
#include <vector>

#include "core/methods/method.h"

namespace airlight {

// The causes of those of the method's known failures that the scene lies in: by sun, camera, air, planet and ground; by
// steps and tables where they are fewer or smaller than the method's own; by the view where a tenth of the picture or
// more looks there.
std::vector<std::string_view> known_failures_of(const SkyMethod& method, const Scene& scene, const Air& air);

// Quantity::light_kept of a scene: of the channel that keeps most.
double light_kept(const Scene& scene, const Air& air);

}  // namespace airlight
