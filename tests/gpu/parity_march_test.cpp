// The tables that the device bakes against those of the host, and the march on the host's own tables.

#include <algorithm>

#include "core/methods/method.h"
#include "core/render/render.h"
#include "core/scene/preset.h"
#include "tests/gpu/parity_fixture.h"
#include "tests/of_scene.h"
#include "tests/physics/host_tables.h"

namespace airlight::test {
namespace {

using physics::HostTable;
using physics::vec3;

struct Error {
  double median = 0.0;
  double worst = 0.0;
};

Error summary(std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  return {errors[errors.size() / 2], errors.back()};
}

// Error over texels and channels, relative to the larger of the value and `floor` times the table's greatest.
Error compare(const TableDump& device, const HostTable& host, double floor) {
  EXPECT_EQ(device.width, host.width) << device.name;
  EXPECT_EQ(device.height, host.height) << device.name;
  double greatest = 0.0;
  for (const vec3& texel : host.texels) {
    greatest = std::max({greatest, texel.x, texel.y, texel.z});
  }
  std::vector<double> errors;
  for (std::size_t i = 0; i < host.texels.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = channel(host.texels[i], c);
      const double found = static_cast<double>(device.rgba[4 * i + c]);
      errors.push_back(std::abs(found - expected) / std::max(expected, floor * greatest));
    }
    EXPECT_EQ(device.rgba[4 * i + 3], 1.0f);
  }
  return summary(errors);
}

Scene for_march(Scene scene) {
  scene = float_exact(scene);
  scene.image = {1, 1};
  scene.bloom.enabled = false;
  const SkyMethod* march = find_method("march");
  scene.render.method = "march";
  for (const ParameterInfo& parameter : march->info.parameters) {
    scene.render.parameters.emplace(parameter.key, parameter.default_value);
  }
  scene.render.parameters["transmittance_lut"] = TableSize{64, 32};
  scene.render.parameters["multiple_scattering_lut"] = TableSize{16, 8};
  return scene;
}

void expect_tables(const Scene& scene, double transmittance, double scattering) {
  Executor executor({});
  const std::vector<TableDump> device = bake_tables([&]() -> Executor& { return executor; }, scene);
  physics::Physics p = make_physics(scene);
  bake(p, {64, 32, 16, physics::kGroundIrradianceSize});
  p.multiple_scattering_lut = multiple_scattering_table(p, 16, 8);
  if (p.ground_irradiance_lut.width > 0) {
    p.ground_irradiance_lut = ground_irradiance_table(p, physics::kGroundIrradianceSize);
  }
  const HostTable* tables[] = {&p.transmittance_lut, &p.multiple_scattering_lut, &p.ground_irradiance_lut};
  ASSERT_EQ(device.size(), p.ground_irradiance_lut.width > 0 ? 3U : 2U);
  for (std::size_t i = 0; i < device.size(); ++i) {
    const Error error = compare(device[i], *tables[i], 1e-4);
    if (std::getenv("AIRLIGHT_PARITY") != nullptr) {
      std::printf("  %s: median %.3g, worst %.3g\n", device[i].name.c_str(), error.median, error.worst);
    }
    EXPECT_LE(error.worst, i == 0 ? transmittance : scattering) << device[i].name;
    EXPECT_LE(error.median, 1e-5) << device[i].name;
  }
}

// Transmittance: exp of a depth of some tens that is good to 3e-6. Scattering: the rows of sun elevation cross the
// planet's shadow, where a float's rounding decides whether a step is lit.
TEST(TableParity, Earth) {
  expect_tables(for_march(earth()), 5e-5, 3e-4);
}

TEST(TableParity, EveryKindOfMediumOverBrightGround) {
  expect_tables(for_march(every_kind()), 5e-5, 3e-4);
}

TEST(TableParity, AMetreSizedWorld) {
  expect_tables(for_march(rescaled(every_kind(), 1024.0)), 5e-5, 3e-4);
}

class MarchParity : public testing::Test {
 protected:
  // The paths on the device: radiance, transmittance, six floats each.
  std::vector<Inputs> on_device(const Scene& scene, const physics::Physics& p,
                                const std::vector<std::array<float, 4>>& rays, unsigned int steps,
                                unsigned int distribution) {
    Plan plan;
    plan.scene_data = device_scene_bytes(air_of(scene), scene);
    const ImageId transmittance = upload(plan, "transmittance", p.transmittance_lut);
    const ImageId scattering = upload(plan, "multiple_scattering", p.multiple_scattering_lut);
    const bool reflects = p.ground_irradiance_lut.width > 0;
    const ImageId ground = reflects ? upload(plan, "ground_irradiance", p.ground_irradiance_lut) : scattering;
    const BufferId in = plan.add_buffer({.name = "rays", .bytes = rays.size() * 16, .contents = bytes_of(rays)});
    const BufferId out =
        plan.add_buffer({.name = "paths", .bytes = rays.size() * sizeof(Inputs), .host_readable = true});
    std::vector<Specialization> constants = sunlight_specialization(plan, air_of(scene), transmittance);
    add_scattering_size(constants, plan, scattering);
    constants.push_back({"kGroundReflects", reflects ? 1u : 0u});
    constants.push_back({"kStepDistribution", distribution});
    plan.add_pass({.shader = "parity_march",
                   .reads = {{"transmittance_lut", transmittance},
                             {"multiple_scattering_lut", scattering},
                             {"ground_irradiance_lut", ground},
                             {"rays", in}},
                   .writes = {{"paths", out}},
                   .grid = {static_cast<std::uint32_t>(rays.size()), 1},
                   .push_constants = {steps},
                   .specialization = constants});
    return values_of<Inputs>(executor_.run(plan).contents(out));
  }

  void expect_paths(const Scene& wished, unsigned int steps, unsigned int distribution, double typical, double worst);

  Executor executor_{{}, test_shaders()};

 private:
  // As floats, like a table on the device.
  static ImageId upload(Plan& plan, const std::string& name, const HostTable& table) {
    std::vector<float> texels;
    for (const vec3& texel : table.texels) {
      texels.insert(texels.end(),
                    {static_cast<float>(texel.x), static_cast<float>(texel.y), static_cast<float>(texel.z), 1.0f});
    }
    const Extent extent{static_cast<std::uint32_t>(table.width), static_cast<std::uint32_t>(table.height), 1};
    const ImageId image = plan.add_image({.name = name, .extent = extent});
    const std::size_t size = texels.size() * sizeof(float);
    const BufferId buffer = plan.add_buffer({.name = name + "_texels", .bytes = size, .contents = bytes_of(texels)});
    plan.add_pass({.name = name,
                   .shader = "table_upload",
                   .reads = {{"texels", buffer}},
                   .writes = {{"table_out", image}},
                   .grid = extent});
    return image;
  }
};

void MarchParity::expect_paths(const Scene& wished, unsigned int steps, unsigned int distribution, double typical,
                               double worst) {
  const Scene scene = for_march(wished);
  physics::Physics p = make_physics(scene);
  bake(p, {64, 32, 16, 64});
  Random random;
  std::vector<std::array<float, 4>> rays;
  while (rays.size() < 600) {
    const double h = random.uniform(0.0, 1.0) < 0.2 ? random.log_uniform(101.0, 2000.0) : random.altitude();
    const Cosines c = cosines(random.cosine(), std::sin(random.uniform(-0.15, 1.2)), random.uniform(0.0, 6.28));
    const double horizon = p.horizon_mu(p.scene.planet, h);
    if (std::abs(static_cast<double>(c.mu) - horizon) > 1e-5) {
      rays.push_back({static_cast<float>(h), c.mu, c.mu_sun, c.nu});
    }
  }
  const std::vector<Inputs> device = on_device(scene, p, rays, steps, distribution);
  double mean = 0.0;
  std::vector<Values> host;
  for (const auto& r : rays) {
    const auto ray = p.ray_in_atmosphere(p.scene.planet, r[0], r[1], r[2], r[3]);
    const auto path = p.march(p.scene.planet, p.scene.sun, ray, steps, distribution, 1.0);
    host.push_back({path.radiance.x, path.radiance.y, path.radiance.z, path.transmittance.x, path.transmittance.y,
                    path.transmittance.z});
    mean += path.radiance.y / static_cast<double>(rays.size());
  }
  std::vector<double> errors;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      const double found = static_cast<double>(device[i][k]);
      EXPECT_GE(found, 0.0);
      const double floor = k < 3 ? 1e-3 * mean : 1e-3;
      errors.push_back(std::abs(found - host[i][k]) / std::max(host[i][k], floor));
      EXPECT_LE(errors.back(), worst) << "result " << k << " from " << rays[i][0] << " km along " << rays[i][1]
                                      << ", sun " << rays[i][2] << ", nu " << rays[i][3] << ": device " << found
                                      << ", host " << host[i][k];
    }
  }
  const Error error = summary(errors);
  if (std::getenv("AIRLIGHT_PARITY") != nullptr) {
    std::printf("  %u steps: median %.3g, worst %.3g\n", steps, error.median, error.worst);
  }
  EXPECT_LE(error.median, typical);
}

// A device's samplers weigh with at least 8 bits of fraction; the software device's weigh with a float's.
TEST_F(MarchParity, EarthWithTheDefaultSteps) {
  expect_paths(earth(), 32, physics::kStepsQuadratic, 1e-5, 2e-3);
}

TEST_F(MarchParity, EarthWithUniformSteps) {
  expect_paths(earth(), 32, physics::kStepsUniform, 1e-5, 2e-3);
}

TEST_F(MarchParity, EveryKindOfMediumOverBrightGround) {
  expect_paths(every_kind(), 32, physics::kStepsQuadratic, 1e-5, 2e-3);
}

// It is no error of the formula if rounding moves a step from one part of the ray to another, or a node across the
// shadow's edge. The typical ray has the same tight bound.
TEST_F(MarchParity, GaussLegendrePanels) {
  expect_paths(earth(), 15, physics::kStepsGaussLegendre, 1e-5, 2e-3);
}

// Rounding errors do not accumulate: 4096 steps are as close as 32.
TEST_F(MarchParity, ManySteps) {
  expect_paths(earth(), 4096, physics::kStepsQuadratic, 1e-5, 2e-3);
}

}  // namespace
}  // namespace airlight::test
