// airlight_cloud_truth: the light over each column of a published cloud, by path-trace's own walks; scripts/cloud-truth
// runs it.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/scene/cloud_file.h"
#include "tests/methods/column_light.h"

namespace {

using namespace airlight;

constexpr const char* kUsage =
    R"(usage: cloud-truth step|landsat [--sun ELEVATION] [--albedo W] [--samples N] [--seed N] [--threads N] [--data FOLDER]
       cloud-truth step|landsat --file GRID ...

Prints, column by column, reflectance R, transmittance T and absorptance A over the sunlight that comes down on a level
plane, and Iu, pi times the radiance straight up over the same; then the means over all columns. The cloud is periodic,
of Henyey and Greenstein's phase function with g 0.85, without air, above black ground.
  --sun ELEVATION   of the sun, degrees; 90
  --albedo W        of single scattering; 1
  --file GRID       a cloud in place of the case's: plain text as presets read it, each point a cell
  --samples N       paths of the light that falls on a column, and for each radiance; 20000, of large clouds 64
  --data FOLDER     where i3rc-case3-tau-128x128.txt and i3rc-case3-thickness-128x128.txt are; ../shared/clouds
)";

struct Options {
  std::string name;
  std::string file;
  std::string data = "../shared/clouds";
  double sun = 90.0;
  double albedo = 1.0;
  int samples = 0;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  int seed = 1;
};

[[noreturn]] void refuse(const std::string& why) {
  throw InputError(why + "; see cloud-truth --help");
}

double number(std::string_view option, const std::string& text, double low, double high) {
  const auto value = number_from<double>(text);
  if (!value || !(*value >= low && *value <= high)) {
    refuse(std::string(option) + ": " + text + " is no number from " + shortest(low) + " to " + shortest(high));
  }
  return *value;
}

Options read_options(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    if (!word.starts_with("--")) {
      if (!options.name.empty() || (word != "step" && word != "landsat")) {
        refuse(word + " is no case; expected step or landsat");
      }
      options.name = word;
      continue;
    }
    if (k + 1 == words.size()) {
      refuse(word + ": expected a value behind it");
    }
    const std::string& value = words[++k];
    if (word == "--sun") {
      options.sun = number(word, value, 0.1, 90.0);
    } else if (word == "--albedo") {
      options.albedo = number(word, value, 0.0, 1.0);
    } else if (word == "--samples") {
      options.samples = static_cast<int>(number(word, value, 2.0, 1e8));
    } else if (word == "--seed") {
      options.seed = static_cast<int>(number(word, value, 0.0, 1e9));
    } else if (word == "--threads") {
      options.threads = static_cast<int>(number(word, value, 1.0, 1024.0));
    } else if (word == "--file") {
      options.file = value;
    } else if (word == "--data") {
      options.data = value;
    } else {
      refuse(word + ": unknown option");
    }
  }
  if (options.name.empty()) {
    refuse("no case; expected step or landsat");
  }
  return options;
}

std::vector<double> read_columns(const std::string& file) {
  std::ifstream in(file);
  std::vector<double> list;
  for (double value = 0.0; in >> value;) {
    list.push_back(value);
  }
  constexpr std::size_t kColumns = std::size_t{128} * 128;
  if (list.size() != kColumns) {
    throw InputError(file + ": " + std::to_string(list.size()) +
                     " numbers; expected 128 x 128: the inputs of case 3 of the intercomparison of 3-D radiation codes "
                     "(--data names their folder)");
  }
  return list;
}

std::shared_ptr<CloudFile> cloud_of(const Options& options) {
  if (!options.file.empty()) {
    auto cloud = std::make_shared<CloudFile>();
    if (const std::string problem = read_cloud_file(options.file, *cloud); !problem.empty()) {
      throw InputError(problem);
    }
    cloud->in_cells = true;
    return cloud;
  }
  if (options.name == "step") {
    return test::step_cloud();
  }
  return test::column_cloud(128, 128, read_columns(options.data + "/i3rc-case3-thickness-128x128.txt"),
                            read_columns(options.data + "/i3rc-case3-tau-128x128.txt"));
}

void print(const Options& options) {
  const test::ColumnCase scene{cloud_of(options), options.sun, options.albedo};
  const int columns = scene.cloud->nx * scene.cloud->ny;
  const int samples = options.samples > 0 ? options.samples : columns <= 1024 ? 20000 : 64;
  const test::ColumnLight light =
      test::column_light(scene, samples, options.threads, static_cast<unsigned>(options.seed));
  std::printf("# x y R T A Iu\n");
  for (int k = 0; k < columns; ++k) {
    const auto c = static_cast<std::size_t>(k);
    std::printf("%d %d %.5f %.5f %.5f %.5f\n", k % scene.cloud->nx + 1, k / scene.cloud->nx + 1, light.reflectance[c],
                light.transmittance[c], light.absorptance[c], light.zenith[c]);
  }
  std::printf("# standard errors of the means: R %.5f T %.5f A %.5f Iu %.5f\n", light.reflectance_error,
              light.transmittance_error, light.absorptance_error, light.zenith_error);
  std::printf("mean R %.4f\nmean T %.4f\nmean A %.4f\nmean Iu %.4f\n", test::mean_of(light.reflectance),
              test::mean_of(light.transmittance), test::mean_of(light.absorptance), test::mean_of(light.zenith));
}

}  // namespace

int main(int count, char** words) {
  try {
    const std::vector<std::string> list(words + 1, words + count);
    if (std::ranges::find(list, "--help") != list.end()) {
      std::cout << kUsage;
      return 0;
    }
    print(read_options(list));
    return 0;
  } catch (const InputError& error) {
    std::cerr << "cloud-truth: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "cloud-truth: " << error.what() << "\n";
    return 1;
  }
}
