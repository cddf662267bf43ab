#pragma once
// Media that a picture does not show, taken out of its scene.

#include <string>
#include <vector>

#include "core/stage/stage.h"

namespace airlight::choice {

struct Lighter {
  Stage stage;                       // without the media below
  std::vector<std::string> reasons;  // a line for each medium left out
  double error = 0.0;                // at most what leaving them out changes, relative
};

// Leaves out the media that change no radiance by more than `allowed` together: their extinction along the longest ray
// through the air and the sunlight's, and their scattering's share in that of all media at every altitude where any
// matters, the phase functions' peaks counted. At least one medium stays.
Lighter leave_out_media(const Stage& stage, double allowed);

}  // namespace airlight::choice
