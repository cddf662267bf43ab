#pragma once
// One maker a method; registry.cpp lists them.

#include "core/methods/method.h"

namespace airlight {

SkyMethod analytic_method();
SkyMethod nested_method();
SkyMethod march_method();
SkyMethod sky_view_method();
SkyMethod orders_method();
SkyMethod path_trace_method();

}  // namespace airlight
