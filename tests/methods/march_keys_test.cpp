// The keys of the march: jitter against bands, half resolution, Schlick's phase for all, and every distribution of
// steps at the edges of what a preset may ask for.

#include "core/base/error.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using Parameters = std::vector<std::pair<std::string_view, ParameterValue>>;

Scene keyed(Scene scene, std::string_view method, const Parameters& values) {
  scene.sun.disc.visible = false;
  scene.render.parameters.clear();
  scene = with_method(scene, *find_method(method));
  for (const auto& [key, value] : values) {
    scene.render.parameters.at(std::string(key)) = value;
  }
  return scene;
}

std::string choice(const char* value) {
  return value;
}

RadianceImage picture(const Scene& scene, std::string_view method, const Parameters& values) {
  return render_now(keyed(scene, method, values)).radiance;
}

double green(const RadianceImage& image, int x, int y) {
  return channel_of(image, x, y, 1);
}

// A narrow view, so that neighbours differ by steps, not by the sky; dusk, where the shadow's edge leaves bands.
Scene dusk() {
  Scene scene = earth();
  scene.sun.elevation = -3.0 * kDegree;
  scene.camera.altitude = 0.5;
  scene.camera.pitch = 9.0 * kDegree;
  scene.camera.vertical_fov = 12.0 * kDegree;
  scene.image = {64, 96};
  return scene;
}

// Relative error by pixel of a march of few steps, jittered or not, against one of many steps.
class Bands {
 public:
  explicit Bands(const char* jitter) {
    const Scene scene = dusk();
    few_ = picture(scene, "march", {{"steps", 8}, {"jitter", choice(jitter)}});
    many_ = picture(scene, "march", {{"steps", 1024}});
  }

  const RadianceImage& few() const { return few_; }
  double error(int x, int y) const { return green(few_, x, y) / green(many_, x, y) - 1.0; }

  double mean() const {
    double sum = 0.0;
    for (int y = 0; y < few_.height; ++y) {
      for (int x = 0; x < few_.width; ++x) {
        sum += error(x, y) / (few_.width * few_.height);
      }
    }
    return sum;
  }

  // Bands as the eye sees them: the error that remains when it is averaged over 8 x 8 pixels, less the mean of all.
  double coarse() const {
    double sum = 0.0;
    const double middle = mean();
    for (int v = 0; v < few_.height / 8; ++v) {
      for (int u = 0; u < few_.width / 8; ++u) {
        double block = 0.0;
        for (int k = 0; k < 64; ++k) {
          block += error(8 * u + k % 8, 8 * v + k / 8) / 64.0;
        }
        sum += (block - middle) * (block - middle);
      }
    }
    return std::sqrt(sum / (few_.height / 8 * few_.width / 8));
  }

  // Autocorrelation of the error between neighbours in a column, without the error's slow part.
  double autocorrelation() const {
    double together = 0.0;
    double alone = 0.0;
    for (int x = 0; x < few_.width; ++x) {
      for (int y = 8; y + 9 < few_.height; ++y) {
        together += detail(x, y) * detail(x, y + 1);
        alone += detail(x, y) * detail(x, y);
      }
    }
    return together / alone;
  }

 private:
  double detail(int x, int y) const {
    double around = 0.0;
    for (int k = -8; k <= 8; ++k) {
      around += error(x, y + k) / 17.0;
    }
    return error(x, y) - around;
  }

  RadianceImage few_;
  RadianceImage many_;
};

TEST(Jitter, TurnsBandsIntoGrain) {
  const Bands plain("none");
  const Bands noise("blue-noise");
  if (std::getenv("AIRLIGHT_FIGURES") != nullptr) {
    std::printf("  coarse %.4f, jittered %.4f; mean %.4f, %.4f; autocorrelation %.3f, %.3f\n", plain.coarse(),
                noise.coarse(), plain.mean(), noise.mean(), plain.autocorrelation(), noise.autocorrelation());
  }
  EXPECT_GT(plain.autocorrelation(), 0.9);
  EXPECT_LT(noise.autocorrelation(), 0.0);
  EXPECT_LT(noise.coarse(), plain.coarse());
  EXPECT_LT(std::abs(noise.mean()), std::abs(plain.mean()));
}

TEST(Jitter, IsTheSameOnEveryRun) {
  const Scene scene = keyed(dusk(), "march", {{"steps", 8}, {"jitter", choice("blue-noise")}});
  const RadianceImage once = render_now(scene).radiance;
  Executor another{{}};
  EXPECT_TRUE(once.rgba == render([&]() -> Executor& { return another; }, scene, {}).radiance.rgba);
  EXPECT_FALSE(once.rgba == picture(scene, "march", {{"steps", 8}}).rgba);
}

// Listed directions have no pixel: with blue noise they use the middle; "fixed" is the host's formula at 0.3.
TEST(Jitter, OfListedDirections) {
  const std::vector<Direction> views{{0.1, 0.2}, {0.6, 2.0}, {1.4, -1.0}};
  const Scene scene = earth();
  const auto probes = [&](const char* jitter) {
    return probe_now(keyed(scene, "nested", {{"jitter", choice(jitter)}, {"sun_steps", 8}}), views);
  };
  const auto none = probes("none");
  const auto noise = probes("blue-noise");
  const auto fixed = probes("fixed");
  physics::Physics p = make_physics(scene);
  p.sun_steps = 8;
  p.multiple_scattering_lut = {1, 1, {physics::vec3(0.0)}};
  const physics::vec3 sun = p.scene.sun.direction;
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(none[i].radiance, noise[i].radiance);
    const physics::vec3 view = p.direction_from_angles(views[i].elevation, views[i].azimuth);
    const auto ray = p.ray_in_atmosphere(p.scene.planet, scene.camera.altitude, view.y, sun.y, dot(view, sun));
    const auto path = p.march_at(p.scene.planet, p.scene.sun, ray, 16, physics::kStepsQuadratic, 0.3, 0.0);
    EXPECT_NEAR(fixed[i].radiance[2], path.radiance.z, 1e-4 * path.radiance.z);
    EXPECT_GT(std::abs(fixed[i].radiance[2] / none[i].radiance[2] - 1.0), 1e-3);
  }
}

TEST(Jitter, IsRefusedWhereNodesMustNotMove) {
  for (const char* jitter : {"fixed", "blue-noise"}) {
    const Scene scene =
        keyed(earth(), "march", {{"jitter", choice(jitter)}, {"step_distribution", choice("gauss-legendre")}});
    EXPECT_THROW(render_now(scene), InputError) << jitter;
  }
}

// Over every patch of 8 x 8 pixels the places have the mean of a step; random ones would miss it by 0.036 (one sigma).
// Of all pixels a thousandth has each thousandth of the step.
TEST(BlueNoise, IsEvenInEveryPatch) {
  physics::Physics p{};
  double worst = 0.0;
  std::vector<double> all;
  for (unsigned int y = 0; y < 128; ++y) {
    for (unsigned int x = 0; x < 128; ++x) {
      double sum = 0.0;
      for (unsigned int k = 0; k < 64; ++k) {
        sum += p.spread_place(x + k % 8, y + k / 8) / 64.0;
      }
      worst = std::max(worst, std::abs(sum - 0.5));
      all.push_back(p.spread_place(x, y));
    }
  }
  EXPECT_LT(worst, 0.036);
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_NEAR(all[i], (static_cast<double>(i) + 0.5) / static_cast<double>(all.size()), 1e-3) << i;
  }
  EXPECT_GT(all.front(), 0.0);
  EXPECT_LT(all.back(), 1.0);
}

double worst_gap(const RadianceImage& a, const RadianceImage& b) {
  double mean = 0.0;
  for (const float x : b.rgba) {
    mean += static_cast<double>(x) / static_cast<double>(b.rgba.size());
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const auto x = static_cast<double>(a.rgba[i]);
    const auto y = static_cast<double>(b.rgba[i]);
    worst = std::max(worst, std::abs(x - y) / std::max(y, 1e-3 * mean));
  }
  return worst;
}

const Parameters kHalfResolution{{"resolution", std::string("half")}, {"multiple_scattering_scale", 0.0}};
const Parameters kFull{{"resolution", std::string("full")}, {"multiple_scattering_scale", 0.0}};

// From the ground, the air and space, odd and even, every projection, ground in sight: the error never exceeds the
// permitted contrast (0.04, at the coarsest pixels, above the horizon from 12 km), and ground and sky are never mixed.
TEST(HalfResolution, IsCloseEverywhere) {
  struct Frame {
    Projection projection;
    ImageSize size;
  };
  const Frame frames[] = {{Projection::perspective, {61, 47}},      {Projection::perspective, {48, 36}},
                          {Projection::perspective, {1, 1}},        {Projection::equirectangular, {181, 91}},
                          {Projection::equirectangular, {200, 92}}, {Projection::equirectangular, {1, 1}},
                          {Projection::fisheye, {43, 47}},          {Projection::fisheye, {1, 2}}};
  for (const Frame& frame : frames) {
    for (const double altitude : {0.01, 12.0, 500.0}) {
      Scene scene = earth();
      scene.planet.ground_albedo = {0.3, 0.3, 0.3};
      scene.camera.altitude = altitude;
      scene.camera.projection = frame.projection;
      scene.camera.pitch = frame.projection == Projection::equirectangular ? 0.0 : -10.0 * kDegree;
      scene.image = frame.size;
      const RadianceImage half = picture(scene, "march", kHalfResolution);
      const RadianceImage full = picture(scene, "march", kFull);
      EXPECT_LT(worst_gap(half, full), 0.05)
          << frame.size.width << " x " << frame.size.height << " from " << altitude << " km";
      for (std::size_t i = 3; i < full.rgba.size(); i += 4) {
        ASSERT_EQ(half.rgba[i], full.rgba[i]);  // a fisheye's circle
      }
    }
  }
}

// The row of pixels with the horizon, and those that touch it, are marched: bit for bit as in full resolution.
TEST(HalfResolution, KeepsTheHorizonSharpAndSavesTheRest) {
  Scene scene = earth();
  scene.planet.ground_albedo = {0.9, 0.9, 0.9};
  scene.camera.altitude = 1.0;
  scene.camera.vertical_fov = 30.0 * kDegree;
  scene.image = {40, 120};
  const RadianceImage half = picture(scene, "march", kHalfResolution);
  const RadianceImage full = picture(scene, "march", kFull);
  physics::Physics p = make_physics(scene);
  const double horizon = p.horizon_mu(p.scene.planet, 1.0);
  int at_horizon = 0;
  int equal = 0;
  for (int y = 0; y < 120; ++y) {
    const auto mu = [&](double row) {
      return p.view_ray(p.scene.camera, physics::kProjectionPerspective, 20.0, row).direction.y;
    };
    const bool crossed = mu(y) > horizon && mu(y + 1.0) < horizon;
    at_horizon += crossed ? 1 : 0;
    int same = 0;
    for (int x = 0; x < 40; ++x) {
      same += green(half, x, y) == green(full, x, y) ? 1 : 0;
    }
    EXPECT_TRUE(!crossed || same == 40) << "row " << y;
    equal += same;
  }
  EXPECT_GE(at_horizon, 1);
  EXPECT_LT(equal, 40 * 120 / 4);
}

// The disc is a pass of its own over all pixels: its contribution is the same.
TEST(HalfResolution, LeavesTheDiscAlone) {
  Scene scene = earth();
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.vertical_fov = 4.0 * kDegree;
  scene.image = {33, 32};
  const auto disc = [&](const Parameters& values) {
    Scene with = keyed(scene, "march", values);
    const RadianceImage without = render_now(with).radiance;
    with.sun.disc.visible = true;
    RadianceImage alone = render_now(with).radiance;
    for (std::size_t i = 0; i < alone.rgba.size(); ++i) {
      alone.rgba[i] -= without.rgba[i];
    }
    return alone;
  };
  const RadianceImage half = disc(kHalfResolution);
  const double brightest = greatest(half);
  EXPECT_GT(brightest, 1000.0);
  EXPECT_NEAR(greatest(disc(kFull)), brightest, 1e-6 * brightest);
}

// With one formula for all: as if each medium asked for it. Rayleigh's and an isotropic function stay.
TEST(Schlick, ForAllIsThatOfTheMedia) {
  Scene scene = earth();
  scene.media.push_back(medium("dust", {1e-3, 2e-3, 3e-3}, {}, exponential(2.0), PhaseFunction::cornette_shanks, 0.7));
  scene.image = {17, 9};
  Scene said = scene;
  said.media[1].phase = PhaseFunction::schlick;
  said.media[3].phase = PhaseFunction::schlick;
  const RadianceImage by_key = picture(scene, "nested", {{"phase", choice("schlick")}});
  EXPECT_TRUE(by_key.rgba == picture(said, "nested", {}).rgba);
  EXPECT_FALSE(by_key.rgba == picture(scene, "nested", {}).rgba);
}

// The stability tests' conditions for each key: thick, thin and no air, the ground, the top, space.
TEST(Keys, AreSoundAtEveryEdge) {
  struct Case {
    const char* method;
    Parameters keys;
  };
  const Case cases[] = {{"march", {{"step_distribution", choice("gauss-legendre")}}},
                        {"nested", {{"resolution", choice("half")}, {"jitter", choice("blue-noise")}}}};
  for (const Case& one : cases) {
    for (const double share : {0.0, 1e-30, 1.0, 1e4}) {
      for (const double altitude : {0.0, 100.0, 500.0}) {
        for (const int steps : {1, 3, 16}) {
          Scene scene = earth();
          scene.camera.altitude = altitude;
          scene.camera.projection = Projection::fisheye;  // of 150 degrees, at 2 a pixel
          scene.camera.vertical_fov = 150.0 * kDegree;
          scene.camera.pitch = -20.0 * kDegree;
          scene.image = {76, 75};
          scene.planet.ground_albedo = {0.5, 0.5, 0.5};
          scene.sun.elevation = altitude > 50.0 ? -2.0 * kDegree : 10.0 * kDegree;
          for (Medium& m : scene.media) {
            for (std::size_t c = 0; c < 3; ++c) {
              m.scattering[c] *= share;
              m.absorption[c] *= share;
            }
          }
          scene = keyed(scene, one.method, one.keys);
          scene.render.parameters["steps"] = steps;
          const std::string what = std::string(one.method) + ", air x " + std::to_string(share) + ", " +
                                   std::to_string(altitude) + " km, " + std::to_string(steps) + " steps";
          const Rendering rendering = render_now(scene);
          expect_sound(rendering, what);
          if (share == 1.0) {
            EXPECT_GT(greatest(rendering.radiance), 0.0) << what;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace airlight::test
