#pragma once
// One factory function for each method; registry.cpp lists them.

#include "core/methods/method.h"

namespace airlight {

// A failure shared by several methods.
inline KnownFailure rounding_at_the_horizon() {
  return {"R",
          {{Quantity::view, -0.003, 0.003}},
          "a view so near the horizon that rounding decides between sky and ground"};
}

SkyMethod analytic_method();
SkyMethod nested_method();
SkyMethod march_method();
SkyMethod sky_view_method();
SkyMethod orders_method();
SkyMethod path_trace_method();

}  // namespace airlight
