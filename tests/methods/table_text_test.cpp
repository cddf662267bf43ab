// Every table that is written to a file: decoded by that file's attributes alone, and compared with direct evaluation
// in double of what they describe.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <set>

#include "core/methods/march_passes.h"
#include "core/output/table_exr.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/table_program.h"
#include "tests/of_scene.h"
#include "tests/physics/host_tables.h"

namespace airlight::test {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;
using physics::vec3;
using Quantities = std::map<std::string, double>;

// A table as an outside program reads it.
struct TableFile {
  std::map<std::string, std::string> texts;
  physics::HostTable table;

  Quantities at(int i, int j) const {
    const auto found = texts.find("airlight:constants");
    const std::string constants = found == texts.end() ? "" : found->second;
    return TableProgram(constants + texts.at("airlight:decode")).at(i, j, table.width, table.height);
  }
  const vec3& texel(int i, int j) const {
    return table
        .texels[static_cast<std::size_t>(j) * static_cast<std::size_t>(table.width) + static_cast<std::size_t>(i)];
  }
};

TableFile read_table(const std::filesystem::path& path) {
  imf::InputFile file(path.c_str());
  TableFile read;
  for (auto at = file.header().begin(); at != file.header().end(); ++at) {
    if (const auto* text = dynamic_cast<const imf::StringAttribute*>(&at.attribute())) {
      // A long one stands in pieces NAME:000, NAME:001 and so on, in this order.
      const std::string name = at.name();
      const bool is_piece = name.size() > 4 && name[name.size() - 4] == ':' && std::isdigit(name.back()) != 0;
      read.texts[is_piece ? name.substr(0, name.size() - 4) : name] += text->value();
    }
  }
  const auto window = file.header().dataWindow();
  read.table = empty_table(window.max.x + 1, window.max.y + 1);
  const std::size_t count = read.table.texels.size();
  std::vector<float> rgb(3 * count);
  imf::FrameBuffer frame;
  for (std::size_t c = 0; c < 3; ++c) {
    frame.insert(std::string(1, "RGB"[c]),
                 imf::Slice(imf::FLOAT, reinterpret_cast<char*>(rgb.data() + c), 3 * sizeof(float),
                            3 * sizeof(float) * static_cast<std::size_t>(read.table.width)));
  }
  file.setFrameBuffer(frame);
  file.readPixels(0, window.max.y);
  for (std::size_t k = 0; k < count; ++k) {
    read.table.texels[k] = vec3(rgb[3 * k], rgb[3 * k + 1], rgb[3 * k + 2]);
  }
  return read;
}

std::map<std::string, TableFile> written(const std::vector<TableDump>& dumps) {
  std::string name = (std::filesystem::temp_directory_path() / "airlight-tables-XXXXXX").string();
  const std::filesystem::path folder = ::mkdtemp(name.data());
  std::map<std::string, TableFile> files;
  for (const TableDump& dump : dumps) {
    const std::filesystem::path file = folder / "table.exr";
    write_table_exr(file, {dump.width, dump.height, dump.rgba.data(), dump.text, dump.channels}, {});
    files[dump.name] = read_table(file);
  }
  std::filesystem::remove_all(folder);
  return files;
}

// The tables of a picture that is large enough for all of them.
std::map<std::string, TableFile> tables_of(const Scene& scene) {
  return written(bake_tables([]() -> Executor& { return executor(); }, scene));
}

Scene table_scene(const std::string& method, double altitude, double sun_degrees) {
  Scene scene = earth();
  scene.planet.ground_albedo = {0.3, 0.3, 0.3};
  scene.camera.altitude = altitude;
  scene.sun.elevation = sun_degrees * kDegree;
  return with_method(std::move(scene), *find_method(method));
}

struct Bound {
  double relative = 0.0;
  double of_greatest = 0.0;  // of the greatest value compared
};

// Texels `apart` from each other, first and last columns and rows among them.
std::vector<std::pair<int, int>> texels(const TableFile& file, int apart) {
  std::vector<std::pair<int, int>> all;
  for (int j = 0; j < file.table.height;
       j += j + apart < file.table.height || j + 1 == file.table.height ? apart : file.table.height - 1 - j) {
    for (int i = 0; i < file.table.width;
         i += i + apart < file.table.width || i + 1 == file.table.width ? apart : file.table.width - 1 - i) {
      all.emplace_back(i, j);
    }
  }
  return all;
}

// `truth` returns the value that a texel of these quantities should have, or none where it cannot tell.
void compare(const TableFile& file, int apart, const Bound& bound,
             const std::function<std::optional<vec3>(const Quantities&)>& truth) {
  struct Pair {
    vec3 found, expected;
    int i, j;
  };
  std::vector<Pair> pairs;
  double greatest = 0.0;
  for (const auto& [i, j] : texels(file, apart)) {
    if (const std::optional<vec3> expected = truth(file.at(i, j))) {
      pairs.push_back({file.texel(i, j), *expected, i, j});
      greatest = std::max({greatest, std::abs(expected->x), std::abs(expected->y), std::abs(expected->z)});
    }
  }
  ASSERT_GT(pairs.size(), 8U);
  for (const Pair& pair : pairs) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = channel(pair.expected, c);
      EXPECT_NEAR(channel(pair.found, c), expected, bound.relative * std::abs(expected) + bound.of_greatest * greatest)
          << "column " << pair.i << ", row " << pair.j << ", channel " << c;
    }
  }
}

physics::Physics physics_of(const Scene& scene, const std::map<std::string, TableFile>& files) {
  physics::Physics p = make_physics(scene);
  p.transmittance_lut = files.at("transmittance").table;
  return p;
}

TEST(TableText, Transmittance) {
  const Scene scene = table_scene("march", 0.2, 10.0);
  const auto files = tables_of(scene);
  physics::Physics p = physics_of(scene, files);
  // With as many steps as the table's own; with 1000 a ray the table is 2e-3 off, at the kinks of the ozone.
  compare(files.at("transmittance"), 5, {0.0, 2e-5}, [&](const Quantities& q) -> std::optional<vec3> {
    return physics::exp(
        -p.optical_depth_to_top(p.scene.planet, q.at("altitude_km"), q.at("mu"), physics::kTransmittanceSteps));
  });
}

TEST(TableText, MultipleScatteringAndGroundIrradiance) {
  const Scene scene = table_scene("march", 0.2, 10.0);
  const auto files = tables_of(scene);
  physics::Physics p = physics_of(scene, files);
  const TableFile& scattering = files.at("multiple_scattering");
  compare(scattering, 5, {2e-4, 1e-6}, [&](const Quantities& q) -> std::optional<vec3> {
    const auto mean = mean_gather(p, q.at("altitude_km"), q.at("mu_sun"));
    return p.sum_of_orders(mean.second_order, mean.transfer);
  });
  p.multiple_scattering_lut = scattering.table;
  p.scene.sun.irradiance = vec3(1.0);
  compare(files.at("ground_irradiance"), 3, {2e-4, 1e-6}, [&](const Quantities& q) -> std::optional<vec3> {
    vec3 sum;
    for (unsigned int k = 0; k < physics::kGroundIrradianceDirections; ++k) {
      const auto ray = p.irradiance_ray(p.scene.planet, q.at("mu_sun"), k);
      sum = sum + p.march(p.scene.planet, p.scene.sun, ray, physics::kMultipleScatteringSteps, physics::kStepsQuadratic,
                          p.scene.multiple_scattering_scale)
                      .radiance;
    }
    return sum * p.irradiance_weight();
  });
}

// Directions beside the true horizon, where rounding decides whether a ray meets the ground; they are not compared.
bool beside_horizon(physics::Physics& p, double h, double mu) {
  return std::abs(mu - p.horizon_mu(p.scene.planet, h)) < 1e-5;
}

physics::Physics::Ray factor_ray(physics::Physics& p, const Scene& scene, double mu, double cos_azimuth) {
  const double sun = std::sin(scene.sun.elevation);
  const double nu = mu * sun + std::sqrt(std::max((1.0 - mu * mu) * (1.0 - sun * sun), 0.0)) * cos_azimuth;
  return p.ray_in_atmosphere(p.scene.planet, scene.camera.altitude, mu, sun, nu);
}

TEST(TableText, SkyView) {
  const Scene scene = table_scene("sky-view", 0.2, 10.0);
  const auto files = tables_of(scene);
  physics::Physics p = physics_of(scene, files);
  p.multiple_scattering_lut = files.at("multiple_scattering").table;
  p.ground_irradiance_lut = files.at("ground_irradiance").table;
  compare(files.at("sky_view"), 9, {2e-3, 1e-6}, [&](const Quantities& q) -> std::optional<vec3> {
    const double mu = std::sin(q.at("elevation_rad"));
    if (beside_horizon(p, scene.camera.altitude, mu)) {
      return std::nullopt;
    }
    const auto ray = factor_ray(p, scene, mu, std::cos(q.at("azimuth_rad")));
    return p.march(p.scene.planet, p.scene.sun, ray, 32, physics::kStepsQuadratic, 1.0).radiance;
  });
}

Scene by_shells(Scene scene) {
  scene.render.parameters.insert_or_assign("shells", std::string("always"));
  return scene;
}

TEST(TableText, SunTable) {
  const Scene scene = by_shells(table_scene("orders", 0.2, 10.0));
  const auto files = tables_of(scene);
  physics::Physics p = make_physics(scene);
  // Two points a shell: 1e-3.
  compare(files.at("sun_table"), 17, {3e-3, 1e-7}, [&](const Quantities& q) -> std::optional<vec3> {
    const double h = q.at("altitude_km");
    const double length = p.distance_to_top(p.scene.planet, h, q.at("mu"));
    if (length < 1e-6) {
      return std::nullopt;
    }
    return p.optical_depth_to_top(p.scene.planet, h, q.at("mu"), 4000) / length;
  });
}

// The radiance around a point by the formulas that a picture is made of, times harmonics, summed over directions: dense
// at the horizon, azimuths even.
struct FieldMoments {
  vec3 m00, m10, m11, ground;
};

FieldMoments gathered(const RayFormula& radiance, physics::Physics& p, double h, double mu_sun) {
  constexpr int kZeniths = 24;
  constexpr int kAzimuths = 8;
  FieldMoments sums;
  for (const double side : {1.0, -1.0}) {
    for (int a = 0; a < kZeniths; ++a) {
      const double x = (a + 0.5) / kZeniths;
      const double mu = side * x * x;
      for (int b = 0; b < kAzimuths; ++b) {
        const double azimuth = std::numbers::pi * (b + 0.5) / kAzimuths;
        const double sines = std::sqrt((1.0 - mu * mu) * (1.0 - mu_sun * mu_sun));
        const vec3 light =
            radiance(p.ray_in_atmosphere(p.scene.planet, h, mu, mu_sun, mu * mu_sun + sines * std::cos(azimuth))) *
            (2.0 * x / kZeniths * 2.0 * std::numbers::pi / kAzimuths);
        const auto y = p.harmonics(mu, std::cos(azimuth));
        sums.m00 = sums.m00 + light * y.of[0];
        sums.m10 = sums.m10 + light * y.of[1];
        sums.m11 = sums.m11 + light * y.of[2];
        sums.ground = sums.ground + light * std::max(mu, 0.0);
      }
    }
  }
  return sums;
}

// The sky is that of the same table. The directions of a bake leave out 5.7 % at most.
TEST(TableText, Moments) {
  for (const bool shells : {false, true}) {
    Scene scene = table_scene("orders", 0.2, 10.0);
    scene = shells ? by_shells(scene) : scene;
    scene.render.parameters.insert_or_assign("degree", std::string("2"));
    const auto files = tables_of(scene);
    HostTables tables;
    for (const auto& [name, file] : files) {
      tables[name] = file.table;
    }
    const TableFile& moments = files.at("moments");
    physics::Physics p = make_physics(scene);
    p.scene.sun.irradiance = vec3(1.0);
    const RayFormula radiance = find_method("orders")->formula(p, part_of(scene), tables);
    int compared = 0;
    for (const auto& [i, j] : texels(moments, 4)) {
      const Quantities q = moments.at(i, j);
      const double mu_sun = q.at("mu_sun");
      const double h = q.at("altitude_km");
      const bool last = q.at("block") == 9.0;  // behind six harmonics and P_m
      if (mu_sun < -0.03 || q.at("l") > (last ? 3.0 : 1.0) || (last && h > 1e-3) || (j % 8 == 4)) {
        continue;
      }
      const FieldMoments truth = gathered(radiance, p, h, mu_sun);
      ++compared;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::string where = std::string(shells ? "shells, " : "") + "column " + std::to_string(i) + ", row " +
                                  std::to_string(j) + ", channel " + std::to_string(c);
        const double found = channel(moments.texel(i, j), c);
        const double m00 = channel(truth.m00, c);
        if (last) {
          EXPECT_NEAR(std::exp(found) / channel(truth.ground, c), 1.0, 0.065) << where;
        } else if (q.at("l") == 0.0) {
          EXPECT_NEAR(std::exp(found) / m00, 1.0, 0.065) << where;
        } else {
          EXPECT_NEAR(found, channel(q.at("m") == 0.0 ? truth.m10 : truth.m11, c) / m00, 0.03) << where;
        }
      }
    }
    EXPECT_GT(compared, 12);
  }
}

TEST(TableText, Factors) {
  for (const double altitude : {2.0, 700.0}) {
    const Scene scene = table_scene("orders", altitude, 20.0);
    const auto files = tables_of(scene);
    physics::Physics p = physics_of(scene, files);
    const auto settings_columns = std::get<TableSize>(scene.render.parameters.find("moments_lut")->second)[0];
    p.moments_lut = files.at("moments").table;
    p.moment_columns = static_cast<physics::uint>(settings_columns);
    p.delta = true;  // the aerosol has a peak
    p.polarisation = true;
    const TableFile& file = files.at("sky_factors");
    const std::string& parts = file.texts.at("airlight:quantity");
    const auto block_of = [&](const std::string& medium) {
      const std::string line = "light that " + medium + " scatters once, over its phase function, in block ";
      const std::size_t at = parts.find(line);
      return at == std::string::npos ? -1 : parts[at + line.size()] - '0';
    };
    EXPECT_EQ(block_of("aerosol"), 0) << parts;
    EXPECT_EQ(block_of("rayleigh"), -1) << parts;
    compare(file, 7, {0.01, 1e-5}, [&](const Quantities& q) -> std::optional<vec3> {
      // A ray straight along the top of the air has length 0.
      if (beside_horizon(p, altitude, q.at("mu"))) {
        return std::nullopt;
      }
      const auto ray = factor_ray(p, scene, q.at("mu"), q.at("cos_azimuth"));
      if (ray.length_ < 50.0 && altitude > 100.0) {
        return std::nullopt;
      }
      const auto factors = p.sky_factors(p.scene.planet, p.scene.moments, ray, 48);
      const vec3 aerosol = factors.single[1];
      const auto phases = p.phases(ray.nu);
      const vec3 rest = p.phased(factors, phases) - aerosol * phases.of[1];
      return (q.at("block") == 0.0 ? aerosol : rest) / q.at("carrier") * p.scene.sun.irradiance;
    });
  }
}

// For every method and scene: each written table has a description, and each quantity named in it is decoded.
TEST(TableText, EveryTableHasOne) {
  for (const SkyMethod& method : methods()) {
    if (!on_device(method)) {
      continue;
    }
    for (const bool shells : {false, true}) {
      const Scene scene = with_method(every_kind(), method, true);
      for (const auto& [name, file] : tables_of(shells && takes(method, "shells") ? by_shells(scene) : scene)) {
        const std::string what = std::string(method.info.name) + ", " + name;
        ASSERT_FALSE(file.texts.at("airlight:quantity").empty()) << what;
        EXPECT_FALSE(file.texts.at("airlight:unit").empty()) << what;
        const Quantities q = file.at(0, 0);
        int named = 0;
        for (const auto& [key, text] : file.texts) {
          std::istringstream lines(key.starts_with("airlight:axis:") ? text : "");
          for (std::string line; std::getline(lines, line); ++named) {
            EXPECT_TRUE(q.contains(line.substr(0, line.find(' ')))) << what << ": " << line;
          }
        }
        EXPECT_GT(named, 0) << what;
      }
    }
  }
}

}  // namespace
}  // namespace airlight::test
