#pragma once
// The scene's lights. Whatever computes light knows one, the scene's sun; for another it gets a scene whose sun that
// is.

#include "core/scene/scene.h"
#include "core/stage/stage.h"

namespace airlight {

// The scene, which has a moon, with the moon in place of the sun. White and exposure stay those of sunlight.
Scene by_moonlight(const Scene& scene);

// Radiance of the sky over the sun's irradiance, at most, for a camera up to 5 km high and a sun so many radians below
// its horizon that no air in sight is sunlit, at most pi. Such light has been scattered twice or more: it has come up
// past the planet's edge to some altitude, on past the edge again, up to the same altitude and down. Each of these four
// ways goes a quarter of the angle round the planet, which tells the altitude, and each scattering turns the light by
// half of the angle. So the light falls with the square of the depth above that altitude that scatters by that angle.
double deep_twilight(const Air& air, double below);

// Whether the scattered light of the sun, and of the further lights, is seen in pictures of the stage. It is not where
// less than 1e-3 of any pixel is left of it beside another light: the sun's beside moon and airglow late at night, the
// moon's beside the sun's with the sun 10 degrees up. From above 5 km and under clouds all lights count as seen.
struct LightsSeen {
  bool sun = true;
  bool others = true;
};
LightsSeen lights_seen(const Stage& stage);

}  // namespace airlight
