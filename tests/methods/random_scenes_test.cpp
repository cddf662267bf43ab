// Unforeseen scenes: valid presets by a seed, each rendered small.

#include <algorithm>

#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/methods/render_fixture.h"
#include "tests/scene/random_preset.h"
#include "tests/this_build.h"

namespace airlight::test {
namespace {

constexpr std::uint64_t kScenes = 200;  // two times kSameKinds
// A new list of profiles and phase functions needs new pipelines, two to three seconds of a software device's compiler,
// so a hundred scenes in a row share one list. The seeds are ones whose lists are long and differ: eight media of four
// profiles and five phase functions. airlight_fuzz has a new list in each scene.
constexpr std::uint64_t kSameKinds = 100;
constexpr std::uint64_t kKindsOf[] = {40, 160};
constexpr std::uint64_t kOrdersTurn = 20;
const std::uint64_t kStride = sanitized() ? 25 : 1;

Scene random_scene(std::uint64_t seed) {
  return resolve(parse_preset(random_preset(seed), "random " + std::to_string(seed), {}), method_infos());
}

// A scene with its own planet, sun, camera and coefficients, and with the kinds of media of another.
Scene random_scene_of(std::uint64_t seed, std::uint64_t kinds_of) {
  Scene scene = random_scene(seed);
  const std::vector<Medium> own = scene.media;
  scene.media = random_scene(kinds_of).media;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const Medium& from = own[i % own.size()];
    scene.media[i].scattering = from.scattering;
    scene.media[i].absorption = from.absorption;
    scene.media[i].phase_g = from.phase_g;
  }
  return scene;
}

TEST(RandomScenes, AreSoundByTheirOwnMethod) {
  int lit = 0;
  int rendered = 0;
  for (std::uint64_t seed = 0; seed < kScenes; seed += kStride) {
    Scene scene = random_scene_of(seed, kKindsOf[seed / kSameKinds]);
    scene.image = {16, 9};
    // Thick air takes `orders`, the default method, seconds to bake: one scene in twenty.
    if (scene.render.method == "orders" && seed % kOrdersTurn != 0) {
      scene = with_method(scene, *find_method("march"));
    }
    const Rendering rendering = render_now(scene);
    expect_sound(rendering, "seed " + std::to_string(seed));
    lit += greatest(rendering.radiance) > 0.0 ? 1 : 0;
    ++rendered;
  }
  // Night, space and black ground leave some scenes dark, but not most.
  EXPECT_GT(lit, rendered / 2);
}

TEST(RandomScenes, AreSoundByEveryMethod) {
  for (const SkyMethod& method : methods()) {
    for (std::uint64_t seed = 1000; seed < 1012; seed += std::min<std::uint64_t>(kStride, 6)) {
      Scene scene = random_scene_of(seed, 1000);
      scene.render.parameters.clear();
      scene = with_method(scene, method, true);
      scene.image = on_device(method) ? ImageSize{16, 9} : ImageSize{4, 3};
      expect_sound(render_now(scene), std::string(method.info.name) + ", seed " + std::to_string(seed));
    }
  }
}

}  // namespace
}  // namespace airlight::test
