#pragma once
// One factory function for each method; registry.cpp lists them.

#include "core/methods/method.h"

namespace airlight {

// Failures shared by several methods.
inline KnownFailure rounding_at_the_horizon() {
  return {"R",
          {{Quantity::view, -0.003, 0.003}},
          "a view so near the horizon that rounding decides between sky and ground"};
}

inline KnownFailure dark_air_over_waves() {
  return {"",
          {{Quantity::waves, 0, 1e3}, {Quantity::sun_elevation, 0, 20}, {Quantity::altitude, 0, 1}},
          "an ocean under a low sun: the air close over it lacks the sunlight that waves throw up, up to 8 %"};
}

SkyMethod analytic_method();
SkyMethod nested_method();
SkyMethod march_method();
SkyMethod sky_view_method();
SkyMethod orders_method();
SkyMethod path_trace_method();

}  // namespace airlight
