#pragma once
// The subjects: each method of the registry, and variants of it that take another path through the shaders.

#include <string>
#include <utility>
#include <vector>

#include "core/methods/method.h"
#include "core/stability/sweep.h"

namespace airlight::stability {

struct Subject {
  std::string name;  // the method's, then the variant's: "analytic zenith-density"
  const SkyMethod* method = nullptr;
  std::vector<std::pair<std::string_view, ParameterValue>> parameters;  // over the defaults
  bool as_picture = false;  // rendered as pictures, else as listed directions, which bring transmittances too
};

struct LeftOut {
  std::string name;
  std::string reason;
};

std::vector<Subject> subjects();
std::vector<LeftOut> subjects_left_out();

// Whether any quantity of the sweep affects the subject: an analytic sky, for example, has no steps.
bool takes_part(const Subject& subject, const Sweep& sweep);

// The scene as the subject renders it, with the place's steps and table sizes; the second is at converged quality.
Scene rendered_by(const Subject& subject, Scene scene, const Place& place);
Scene converged_for(const Subject& subject, Scene scene, const Place& place);

}  // namespace airlight::stability
