#pragma once
// What a plan will cost, from the plan alone: no clock, no device.

#include "core/plan/plan.h"

namespace airlight::choice {

// In units of PassDesc::cost.
struct Cost {
  double tables = 0.0;   // passes that make what is kept from picture to picture
  double picture = 0.0;  // the others
  double total() const { return tables + picture; }
};

inline constexpr auto kNothingIsKept = [](ResourceId) { return false; };

// `is_there`: tables that are made already and cost nothing.
Cost predicted_cost(const Plan& plan, const IsKept& is_there = kNothingIsKept);

// Whether a plan keeps this for later plans as a table (the frame's radiance, carried anew each time, is none).
bool is_table(const Plan& plan, ResourceId id);

}  // namespace airlight::choice
