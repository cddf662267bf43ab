#pragma once
// The air before the samples of a picture.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/composite/order.h"
#include "core/composite/blend.h"
#include "core/render/render.h"

namespace airlight::cli {

// One ray up to the distance of a sample, or of a part of one.
struct Sample {
  std::uint32_t pixel = 0;
  composite::Thing thing;
  float distance = composite::kSky;
};

struct FrontAir {
  std::vector<AirTo> airs;             // for each sample; without depth there is no air before it
  std::string way;                     // "march", "volume" or the fog's name
  std::optional<double> volume_error;  // measured if a tolerance was given
  std::vector<PassTiming> passes;
};

// Throws InputError where the order wants the volume and the camera stands above the air.
FrontAir air_before(const CompositeOrder& order, const std::vector<Sample>& samples, const Stage& stage,
                    const DeviceOnDemand& device);

// "air: the aerial volume, ...", for people.
std::string told(const CompositeOrder& order, const FrontAir& air);

}  // namespace airlight::cli
