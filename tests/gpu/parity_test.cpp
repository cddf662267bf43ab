// Each function of shaders/physics on the device in float against the same text on double. Bounds name the source of
// the error. Other bounds are about three times the software device's error, for other drivers: Vulkan grants 2.5 ulp
// to a division, 3 to a square root by way of its inverse, 2^-11 absolute to sin and cos in the range.

#include "tests/gpu/parity_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

class Parity : public testing::Test {
 protected:
  static void SetUpTestSuite() { executor_ = new Executor({}, test_shaders()); }
  static void TearDownTestSuite() {
    delete executor_;
    executor_ = nullptr;
  }

  std::vector<Values> on_device(const Scene& scene, unsigned int function, const std::vector<Inputs>& inputs) {
    Plan plan;
    plan.scene_data = device_scene_bytes(air_of(scene), scene);
    const BufferId in =
        plan.add_buffer({.name = "inputs", .bytes = inputs.size() * sizeof(Inputs), .contents = bytes_of(inputs)});
    const BufferId out =
        plan.add_buffer({.name = "outputs", .bytes = inputs.size() * sizeof(Inputs), .host_readable = true});
    std::vector<Specialization> constants = medium_specialization(air_of(scene));
    constants.push_back({"kFunction", function});
    plan.add_pass({.shader = "parity_functions",
                   .reads = {{"inputs", in}},
                   .writes = {{"outputs", out}},
                   .grid = {static_cast<std::uint32_t>(inputs.size()), 1},
                   .specialization = constants});
    const RunResult result = executor_->run(plan);
    std::vector<Values> values;
    for (const Inputs& found : values_of<Inputs>(result.contents(out))) {
      values.emplace_back();
      std::copy(found.begin(), found.end(), values.back().begin());
    }
    return values;
  }

  std::vector<Values> on_host(const Scene& scene, unsigned int function, const std::vector<Inputs>& inputs) {
    HostCalls calls{make_physics(scene)};
    std::vector<Values> values;
    for (const Inputs& x : inputs) {
      const HostCalls::Arguments arguments{x[0], x[1], x[2], x[3], x[4], x[5]};
      const HostCalls::Results r = calls.call(function, arguments);
      values.push_back({r.a, r.b, r.c, r.d, r.e, r.f});
    }
    return values;
  }

  // Compares, and records the share of each bound that was used.
  void compare(const Scene& wished, unsigned int function, const std::vector<Inputs>& inputs, const Bounds& bounds) {
    const Scene scene = float_exact(wished);
    const std::vector<Values> device = on_device(scene, function, inputs);
    const std::vector<Values> host = on_host(scene, function, inputs);
    ASSERT_EQ(device.size(), inputs.size());
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      double worst = -1.0;
      std::size_t at = 0;
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double error = std::abs(device[i][k] - host[i][k]);
        const double allowed = bounds[k].allowed(host[i][k]);
        const double used = error == 0.0 ? 0.0 : !(error <= 1e300) ? 1e300 : error / std::max(allowed, 1e-300);
        if (used > worst) {
          worst = used;
          at = i;
        }
      }
      RecordProperty("used_" + std::to_string(k), std::to_string(worst));
      if (std::getenv("AIRLIGHT_PARITY") != nullptr) {
        std::printf("  function %u, result %zu: %.3g of the bound\n", function, k, worst);
      }
      EXPECT_LE(worst, 1.0) << "function " << function << ", result " << k << ": device " << device[at][k] << ", host "
                            << host[at][k] << " for " << inputs[at][0] << ", " << inputs[at][1] << ", " << inputs[at][2]
                            << ", " << inputs[at][3] << ", " << inputs[at][4] << ", " << inputs[at][5];
    }
  }

  static Executor* executor_;
};

Executor* Parity::executor_ = nullptr;

constexpr int kCount = 20000;

// Directions far enough from the true horizon for a float to tell.
bool clear_of_horizon(double h, double mu) {
  physics::Physics p = make_physics(vacuum());
  return std::abs(mu - p.horizon_mu(p.scene.planet, h)) > 3e-7;
}

// Computed with the radius, a float would be wrong by 2.9 % at 1 m and by 100 % at 0.1 m.
TEST_F(Parity, Horizon) {
  std::vector<Inputs> inputs{{0.0f}, {1e-4f}, {1e-3f}, {99.9f}, {100.0f}, {500.0f}, {4e5f}};
  Random random;
  for (int i = 0; i < kCount; ++i) {
    inputs.push_back({static_cast<float>(random.log_uniform(1e-9, 1e6))});
  }
  compare(vacuum(), physics::kCallHorizon, inputs, {Bound{0.0, 5e-7}, Bound{0.0, 5e-7}});
}

TEST_F(Parity, Distances) {
  std::vector<Inputs> inputs;
  Random random;
  for (int i = 0; i < kCount; ++i) {
    const auto h = static_cast<float>(random.altitude());
    const auto mu = static_cast<float>(random.cosine());
    if (clear_of_horizon(h, mu)) {
      inputs.push_back({h, mu});
    }
  }
  compare(vacuum(), physics::kCallDistances, inputs, {Bound{0.0, 1e-6}, Bound{0.0, 2e-6}, kExact});
}

// At 99.9 km the textbook root is wrong by 0.7 %.
TEST_F(Parity, DistanceToTheTopJustBelowIt) {
  std::vector<Inputs> inputs;
  for (const float h : {99.0f, 99.9f, 99.99f, 99.9999f}) {
    for (double mu = 1e-4; mu <= 1.0; mu *= 1.1) {
      inputs.push_back({h, static_cast<float>(mu)});
      inputs.push_back({h, static_cast<float>(-mu)});
    }
  }
  compare(vacuum(), physics::kCallDistances, inputs, {Bound{0.0, 1e-6}, Bound{0.0, 2e-6}, kExact});
}

TEST_F(Parity, RaysFromInsideAndFromSpace) {
  std::vector<Inputs> inside;
  std::vector<Inputs> space;
  Random random;
  for (int i = 0; i < kCount; ++i) {
    const double h = random.altitude();
    const Cosines c = cosines(random.cosine(), random.cosine(), random.uniform(0.0, 6.28));
    if (clear_of_horizon(h, static_cast<double>(c.mu))) {
      inside.push_back({static_cast<float>(h), c.mu, c.mu_sun, c.nu});
    }
    const double far = random.log_uniform(101.0, 40000.0);
    const double limb = -std::sqrt(1.0 - std::pow(6460.0 / (6360.0 + far), 2));
    const double mu = -1.0 + (limb + 1.0) * random.uniform(0.0, 0.999);
    if (std::abs(mu - make_physics(vacuum()).horizon_mu(make_physics(vacuum()).scene.planet, far)) > 1e-5) {
      const Cosines d = cosines(mu, random.uniform(-1.0, 1.0), random.uniform(0.0, 6.28));
      space.push_back({static_cast<float>(far), d.mu, d.mu_sun, d.nu});
    }
  }
  compare(vacuum(), physics::kCallRay, inside, {kExact, kExact, kExact, kExact, Bound{1e-6, 3e-6}, kExact});
  // From space the ray's lowest point is known to r^2 1e-7 / R: 3e-4 km from 40 000 km, more than that along the ray.
  compare(vacuum(), physics::kCallRay, space,
          {kExact, Bound{1e-4, 0.0}, Bound{1e-4, 0.0}, kExact, Bound{0.1, 2e-3}, kExact});
  // Away from the planet and past its limb there is no air, whatever the rounding.
  std::vector<Inputs> away;
  for (int i = 0; i < 1000; ++i) {
    const double far = random.log_uniform(100.001, 1e6);
    const double limb = -std::sqrt(1.0 - std::pow(6460.0 / (6360.0 + far), 2));
    const double mu = limb + (1.0 - limb) * random.log_uniform(1e-4, 1.0);
    away.push_back({static_cast<float>(far), static_cast<float>(mu), 0.3f, 0.2f});
  }
  compare(vacuum(), physics::kCallRay, away, {kExact, kExact, kExact, kExact, kExact, kExact});
}

TEST_F(Parity, PointsOnARay) {
  std::vector<Inputs> inputs;
  Random random;
  physics::Physics p = make_physics(vacuum());
  for (int i = 0; i < kCount; ++i) {
    const double h = as_float(random.altitude());
    const Cosines c = cosines(random.cosine(), random.cosine(), random.uniform(0.0, 6.28));
    const auto ray = p.ray_in_atmosphere(p.scene.planet, h, static_cast<double>(c.mu), 0.0, 0.0);
    const double t = ray.length_ * random.uniform(0.0, 1.0);
    inputs.push_back({static_cast<float>(h), c.mu, c.mu_sun, c.nu, static_cast<float>(t)});
  }
  // 3e-5 km in altitude, and the rounding of the altitude itself.
  compare(vacuum(), physics::kCallPoint, inputs, {Bound{3e-5, 3e-7}, Bound{3e-7, 0.0}, Bound{3e-7, 0.0}});
}

TEST_F(Parity, PhaseFunctions) {
  std::vector<Inputs> inputs;
  Random random;
  for (int i = 0; i < kCount; ++i) {
    const auto kind = static_cast<float>(i % 5);
    const double g = i % 10 < 5 ? random.uniform(-0.99, 0.99) : (i % 20 < 10 ? 0.99 : -0.99);
    inputs.push_back({kind, static_cast<float>(g), static_cast<float>(random.cosine())});
  }
  // In the peak at |g| = 0.99 the denominator is 1e-4: Schlick's 1 - k nu has a rounding error of 6e-8 there, and is
  // squared.
  compare(vacuum(), physics::kCallPhase, inputs, {Bound{1e-8, 3e-3}});
  std::vector<Inputs> mild;
  for (const Inputs& x : inputs) {
    if (std::abs(x[1]) < 0.9f) {
      mild.push_back(x);
    }
  }
  compare(vacuum(), physics::kCallPhase, mild, {Bound{1e-8, 3e-5}});
}

// Tables behind the scene's block, of two media, and molecules that depolarise.
TEST_F(Parity, PhaseTables) {
  Scene scene = earth();
  scene.media[0].depolarization = {0.0, 0.02, 0.5};
  take_table(scene.media[1], peaked_table({0.5, 0.7, 0.85}));
  scene.media.push_back(medium("more", {1e-3, 2e-3, 3e-3}, {}, exponential(2.0)));
  take_table(scene.media.back(), peaked_table({-0.4}));
  std::vector<Inputs> inputs;
  Random random;
  for (int i = 0; i < kCount; ++i) {
    inputs.push_back({static_cast<float>(random.uniform(0.0, 20.0)), static_cast<float>(random.cosine())});
  }
  // In the peak the angle is known to 3e-4, the rounding of a cosine near 1.
  const Bound extinction{1e-8, 3e-6};
  const Bound scattered{1e-8, 2e-3};
  compare(scene, physics::kCallAir, inputs, {extinction, extinction, extinction, scattered, scattered, scattered});
}

// Over fifteen orders of magnitude; 1 - exp(-x) over x is 6 % off at 1e-6.
TEST_F(Parity, SegmentIntegral) {
  std::vector<Inputs> inputs{{0.0f}, {0.5f}, {std::nextafter(0.5f, 0.0f)}};
  for (double exponent = -12.0; exponent < 3.0; exponent += 0.001) {
    inputs.push_back({static_cast<float>(std::pow(10.0, exponent))});
  }
  compare(vacuum(), physics::kCallSegment, inputs, {Bound{0.0, 1e-6}});
}

TEST_F(Parity, Steps) {
  std::vector<Inputs> inputs;
  Random random;
  for (int i = 0; i < kCount; ++i) {
    const auto length = static_cast<float>(random.log_uniform(1e-3, 3000.0));
    const auto falling = static_cast<float>(random.uniform(-1.0, 2.0)) * length;
    const int count = 1 + static_cast<int>(random.log_uniform(1.0, 4096.0)) % 4096;
    const int step = static_cast<int>(random.uniform(0.0, count - 0.5));
    inputs.push_back({static_cast<float>(i % 2), falling, length, static_cast<float>(step), static_cast<float>(count)});
  }
  // The number of steps before the lowest point may round either way; such rays are not compared.
  const Scene scene = float_exact(vacuum());
  const std::vector<Values> device = on_device(scene, physics::kCallStep, inputs);
  const std::vector<Values> host = on_host(scene, physics::kCallStep, inputs);
  std::size_t other = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (device[i][2] != host[i][2]) {
      ++other;
      continue;
    }
    const double length = static_cast<double>(inputs[i][2]);
    // 5e-7 of the ray: a step's width is the difference of two distances of its size.
    EXPECT_NEAR(device[i][0], host[i][0], 5e-7 * length) << i;
    EXPECT_NEAR(device[i][1], host[i][1], 5e-7 * length) << i;
    EXPECT_GE(device[i][1], 0.0) << i;
  }
  EXPECT_LT(other, inputs.size() / 1000);
}

TEST_F(Parity, TransmittanceMap) {
  std::vector<Inputs> inputs;
  Random random;
  physics::Physics p = make_physics(vacuum());
  for (int i = 0; i < kCount; ++i) {
    // Above the horizon, dense toward it; and below, where the map stays at its edge.
    const double h = as_float(std::min(random.altitude(), 99.99));
    const double horizon = p.horizon_mu(p.scene.planet, h);
    const double mu =
        i % 10 == 0 ? random.uniform(-1.0, horizon) : horizon + (1.0 - horizon) * random.log_uniform(1e-7, 1.0);
    inputs.push_back({static_cast<float>(h), static_cast<float>(mu)});
  }
  // In units of the whole axis; 2e-6 is a 2000th of a texel at 256 x 64.
  compare(vacuum(), physics::kCallTransmittanceCoordinate, inputs, {Bound{2e-6, 0.0}, Bound{1e-6, 0.0}});
}

// Every texel centre of the default table: its state, and its way back.
TEST_F(Parity, TransmittanceTexels) {
  std::vector<Inputs> inputs;
  for (int j = 0; j < 64; ++j) {
    for (int i = 0; i < 256; ++i) {
      inputs.push_back({static_cast<float>(i) / 255.0f, static_cast<float>(j) / 63.0f});
    }
  }
  const std::vector<Inputs> below_top(inputs.begin(), inputs.end() - 256);
  // Relative in the bottom rows, whose altitude comes from a square; the zenith's mu comes from a difference of squares
  // over a path of 100 to 2 km.
  compare(vacuum(), physics::kCallTransmittanceState, below_top,
          {Bound{1e-9, 1e-6}, Bound{3e-6, 0.0}, Bound{2e-6, 0.0}, Bound{1e-6, 0.0}});
  // The way back, on the device itself: to a 200th of a texel in every row but the top one.
  const std::vector<Values> found = on_device(vacuum(), physics::kCallTransmittanceState, inputs);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double tolerance = i < below_top.size() ? 0.005 : 0.5;
    EXPECT_NEAR(found[i][2] * 255.0, static_cast<double>(inputs[i][0]) * 255.0, tolerance)
        << i % 256 << ", " << i / 256;
    EXPECT_NEAR(found[i][3] * 63.0, static_cast<double>(inputs[i][1]) * 63.0, 0.005) << i % 256 << ", " << i / 256;
  }
}

TEST_F(Parity, ScatteringMap) {
  std::vector<Inputs> inputs;
  Random random;
  for (int i = 0; i < 2000; ++i) {
    inputs.push_back({static_cast<float>(random.altitude()), static_cast<float>(random.cosine())});
  }
  compare(vacuum(), physics::kCallScattering, inputs,
          {Bound{1.2e-7, 0.0}, Bound{1.2e-7, 3e-7}, Bound{1e-9, 5e-7}, Bound{3e-7, 0.0}});
}

TEST_F(Parity, AirOfEveryDensityAndPhase) {
  std::vector<Inputs> inputs;
  Random random;
  for (int i = 0; i < kCount; ++i) {
    const auto h = static_cast<float>(random.altitude());
    inputs.push_back({h, static_cast<float>(random.cosine())});
  }
  // Vulkan grants exp(x) 3 + 2|x| ulp: 3e-6 eight scale heights up of twelve. The software device is good to 1.1e-6.
  const Bound bound{1e-12, 1e-5};
  compare(every_kind(), physics::kCallAir, inputs, {bound, bound, bound, bound, bound, bound});
  compare(earth(), physics::kCallAir, inputs, {bound, bound, bound, bound, bound, bound});
}

TEST_F(Parity, OpticalDepth) {
  std::vector<Inputs> inputs;
  Random random;
  physics::Physics p = make_physics(vacuum());
  for (int i = 0; i < 500; ++i) {
    const double h = as_float(std::min(random.altitude(), 90.0));
    const double horizon = p.horizon_mu(p.scene.planet, h);
    const double mu = horizon + (1.0 - horizon) * random.log_uniform(1e-5, 1.0);
    inputs.push_back({static_cast<float>(h), static_cast<float>(mu), i % 2 == 0 ? 40.0f : 1000.0f});
  }
  // An altitude off by 3e-5 km in a scale height of 1.2 km.
  const Bound bound{1e-8, 1e-5};
  compare(earth(), physics::kCallDepth, inputs, {bound, bound, bound});
}

TEST_F(Parity, SunDiscAndFade) {
  Scene scene = vacuum();
  scene.render.parameters["sun_fade"] = SunFade{10.0, 0.1};
  std::vector<Inputs> inputs;
  const double radius = as_float(2.0 * std::sin(0.5 * as_float(scene.sun.disc.angular_radius)));
  for (int i = 0; i < 2000; ++i) {
    const double share = i / 1500.0;
    if (std::abs(share - 1.0) > 1e-6) {
      inputs.push_back({static_cast<float>(share * radius), static_cast<float>(i / 1000.0 - 1.0)});
    }
  }
  // At the limb the profile falls as a square root: 1e-7 of the radius is 3e-4 of the profile.
  const auto fade_off = [&] {
    Scene plain = scene;
    plain.render.parameters.clear();
    return plain;
  }();
  compare(fade_off, physics::kCallDisc, inputs, {Bound{3e-4, 0.0}, kExact});
}

// sin and cos on the software device are good to about 1e-7. Vulkan grants 2^-11 = 4.9e-4 within -pi to pi, but no
// desktop driver is that far off: 2e-6 rad is a 30th of a pixel at 65536 columns.
TEST_F(Parity, ViewRays) {
  Random random;
  const ImageSize cube_sizes[] = {{300, 1800}, {1536, 256}, {1023, 1364}};
  for (int k = 0; k < 15; ++k) {
    Scene scene = vacuum();
    scene.camera.projection = static_cast<Projection>(k % 5);
    scene.camera.azimuth = random.uniform(-3.1, 3.1);
    scene.camera.pitch = is_map(scene.camera.projection) ? 0.0 : random.uniform(-1.57, 1.57);
    scene.camera.roll = is_map(scene.camera.projection) ? 0.0 : random.uniform(-3.0, 3.0);
    scene.camera.vertical_fov = random.uniform(0.1, 3.0);
    scene.image = {k < 6 ? 1920 : 333, k < 6 ? 1080 : 777};
    if (scene.camera.projection == Projection::cube) {
      scene.camera.cube_layout = static_cast<CubeLayout>(k / 5);
      scene.image = cube_sizes[k / 5];
    }
    std::vector<Inputs> inputs;
    const double side = 0.5 * std::min(scene.image.width, scene.image.height);
    for (int i = 0; i < 3000; ++i) {
      const double x = std::floor(random.uniform(0.0, scene.image.width)) + 0.5;
      const double y = std::floor(random.uniform(0.0, scene.image.height)) + 0.5;
      const double from_centre = std::hypot(x - 0.5 * scene.image.width, y - 0.5 * scene.image.height) / side;
      if (scene.camera.projection != Projection::fisheye || from_centre < 0.9999) {
        inputs.push_back({static_cast<float>(x), static_cast<float>(y)});
      }
    }
    const Bound bound{2e-6, 0.0};
    compare(scene, physics::kCallViewRay + projection_code(scene.camera.projection), inputs,
            {bound, bound, bound, kExact});
  }
}

}  // namespace
}  // namespace airlight::test
