// Opening a device: devices listed, refusals and their messages.

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <link.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/gpu/executor.h"
#include "core/gpu/physical_device.h"
#include "tests/gpu/gpu_fixture.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

// Some tests below apply only to the software device.
bool has_software_device() {
  const std::vector<DeviceInfo> devices = list_devices();
  return std::any_of(devices.begin(), devices.end(), [](const DeviceInfo& device) { return device.is_cpu; });
}

std::string failure(const DeviceOptions& options) {
  return message_of<RunError>([&] { Executor executor(options); });
}

TEST(Device, IsTheSoftwareDeviceUnlessAskedOtherwise) {
  if (!has_software_device()) GTEST_SKIP() << "no software device";
  const ScopedEnvironment none("AIRLIGHT_DEVICE", nullptr);
  const Executor executor({});
  EXPECT_TRUE(executor.device().is_cpu) << executor.device().name;
  EXPECT_TRUE(executor.device().missing.empty());
  EXPECT_FALSE(executor.device().driver.empty());
  EXPECT_EQ(executor.device().api_version.substr(0, 2), "1.");
}

TEST(Device, IsChosenBySubstringThenByTheEnvironment) {
  if (!has_software_device()) GTEST_SKIP() << "no software device";
  const ScopedEnvironment environment("AIRLIGHT_DEVICE", "no such card");
  EXPECT_NE(Executor({.name_substring = "LLVMpipe"}).device().name.find("llvmpipe"), std::string::npos);
  const std::string message = message_of<InputError>([] { Executor executor({}); });
  EXPECT_EQ(message.find("no Vulkan device is named \"no such card\"; there are: "), 0U) << message;
  EXPECT_NE(message.find("llvmpipe"), std::string::npos) << message;
  const ScopedEnvironment named("AIRLIGHT_DEVICE", "llvmpipe");
  EXPECT_EQ(failure({}), "");
}

bool is_loaded(const fs::path& library) {
  void* handle = dlopen(library.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (handle != nullptr) dlclose(handle);
  return handle != nullptr;
}

fs::path software_library() {
  list_devices();  // loads it
  fs::path found;
  const auto is_it = [](dl_phdr_info* library, std::size_t, void* path) {
    const std::string name = library->dlpi_name;
    if (name.find("libvulkan_lvp") == std::string::npos) return 0;
    *static_cast<fs::path*>(path) = name;
    return 1;
  };
  dl_iterate_phdr(is_it, &found);
  return found;
}

// Manifests of drivers with other names, each for a copy of the software device's library.
class Manifests {
 public:
  explicit Manifests(const std::vector<std::string>& names) : folder_(make_folder()) {
    const fs::path software = software_library();
    for (const std::string& name : names) {
      const fs::path file = folder_ / name;
      fs::copy_file(software, library_of(name));
      std::ofstream(file) << R"({"ICD": {"api_version": "1.1.230", "library_path": )" << library_of(name)
                          << R"(}, "file_format_version": "1.0.0"})";
      files_ += (files_.empty() ? "" : ":") + file.string();
    }
  }
  ~Manifests() { fs::remove_all(folder_); }
  Manifests(const Manifests&) = delete;
  Manifests& operator=(const Manifests&) = delete;

  const char* files() const { return files_.c_str(); }
  fs::path library_of(const std::string& name) const { return folder_ / (name + ".so"); }

 private:
  static fs::path make_folder() {
    std::string name = (fs::temp_directory_path() / "airlight-manifests-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder " + name);
    return name;
  }

  fs::path folder_;
  std::string files_;
};

// The environment in which a user starts the program: no device named, no drivers selected, no validation layer.
struct PlainStart {
  ScopedEnvironment device{"AIRLIGHT_DEVICE", nullptr};
  ScopedEnvironment validation{"AIRLIGHT_VALIDATION", nullptr};
  ScopedEnvironment selected{"VK_LOADER_DRIVERS_SELECT", nullptr};
};

TEST(Device, OfTheSoftwareDeviceTheDriverAloneIsOpened) {
  if (!has_software_device()) GTEST_SKIP() << "no software device";
  const PlainStart plain;
  const Manifests manifests({"a_card.json", "lvp_icd.json"});
  const ScopedEnvironment drivers("VK_DRIVER_FILES", manifests.files());
  EXPECT_EQ(failure({}), "");
  EXPECT_TRUE(is_loaded(manifests.library_of("lvp_icd.json")));
  EXPECT_FALSE(is_loaded(manifests.library_of("a_card.json")));
  EXPECT_EQ(std::getenv("VK_LOADER_DRIVERS_SELECT"), nullptr) << "what is started from here inherits it";
  EXPECT_EQ(list_devices().size(), 2U);
}

TEST(Device, NamedIsLookedForAmongAllDrivers) {
  if (!has_software_device()) GTEST_SKIP() << "no software device";
  const PlainStart plain;
  const Manifests manifests({"a_card.json", "lvp_icd.json"});
  const ScopedEnvironment drivers("VK_DRIVER_FILES", manifests.files());
  EXPECT_EQ(failure({.name_substring = "llvmpipe"}), "");
  EXPECT_TRUE(is_loaded(manifests.library_of("a_card.json")));
}

TEST(Device, IsFoundWhereTheSoftwareDeviceHasNoDriver) {
  if (!has_software_device()) GTEST_SKIP() << "no software device";
  const PlainStart plain;
  const Manifests manifests({"a_card.json"});
  const ScopedEnvironment drivers("VK_DRIVER_FILES", manifests.files());
  EXPECT_EQ(failure({}), "");
}

TEST(Device, DriversThatTheUserSelectsStay) {
  if (!has_software_device()) GTEST_SKIP() << "no software device";
  const PlainStart plain;
  const Manifests manifests({"a_card.json", "lvp_icd.json"});
  const ScopedEnvironment selected("VK_LOADER_DRIVERS_SELECT", "a_*");
  const ScopedEnvironment drivers("VK_DRIVER_FILES", manifests.files());
  EXPECT_EQ(failure({}), "");
  EXPECT_TRUE(is_loaded(manifests.library_of("a_card.json")));
  EXPECT_FALSE(is_loaded(manifests.library_of("lvp_icd.json")));
  EXPECT_STREQ(std::getenv("VK_LOADER_DRIVERS_SELECT"), "a_*");
}

TEST(Device, ListsWhatTheMachineHas) {
  const std::vector<DeviceInfo> devices = list_devices();
  ASSERT_FALSE(devices.empty());
  EXPECT_FALSE(devices[0].name.empty());
}

TEST(Device, SaysWhichPackageBringsADriver) {
  const ScopedEnvironment no_validation("AIRLIGHT_VALIDATION", nullptr);  // it would count the loader's message
  const ScopedEnvironment drivers("VK_DRIVER_FILES", "/nonexistent.json");
  const ScopedEnvironment old_name("VK_ICD_FILENAMES", "/nonexistent.json");
  const char* expected =
      "no Vulkan device on this machine; install a driver, for the software device the package mesa-vulkan-drivers";
  EXPECT_EQ(failure({}), expected);
  EXPECT_EQ(message_of<RunError>([] { list_devices(); }), expected);
}

TEST(Device, SaysWhichPackageBringsTheValidationLayer) {
  const ScopedEnvironment layers("VK_LAYER_PATH", "/nonexistent");
  EXPECT_EQ(failure({.validation = true}),
            "validation was asked for, but VK_LAYER_KHRONOS_validation is not installed; install the package "
            "vulkan-validationlayers");
}

TEST(Device, ListsEachMissingFeature) {
  PhysicalDevice old;
  old.info = {.name = "Old Card", .driver = "", .api_version = "1.1.0", .is_cpu = false, .missing = {}};
  old.info.missing = {"Vulkan 1.2 (it has 1.1.0)", "scalarBlockLayout", "timestamps on a compute queue"};
  PhysicalDevice good;
  good.info = {.name = "Good Card", .driver = "", .api_version = "1.3.0", .is_cpu = false, .missing = {}};
  PhysicalDevice software = good;
  software.info.name = "Software";
  software.info.is_cpu = true;
  const char* lacks = "Old Card, lacks Vulkan 1.2 (it has 1.1.0), scalarBlockLayout and timestamps on a compute queue";
  const auto said = [](const std::vector<PhysicalDevice>& devices, std::string_view name) {
    return message_of<RunError>([&] { choose(devices, name); });
  };
  EXPECT_EQ(said({old, good}, "old"), std::string("the Vulkan device cannot be used: ") + lacks);
  EXPECT_EQ(said({old}, ""), std::string("no Vulkan device can be used: ") + lacks);
  EXPECT_EQ(message_of<InputError>([&] {
              choose({good, software}, "nvidia");
            }),
            "no Vulkan device is named \"nvidia\"; there are: Good Card; Software");
  const std::vector<PhysicalDevice> all = {old, good, software};
  EXPECT_EQ(choose(all, "").info.name, "Software");
  EXPECT_EQ(choose(all, "good").info.name, "Good Card");
  EXPECT_EQ(choose(all, "card").info.name, "Good Card");
  const std::vector<PhysicalDevice> cards = {old, good};
  EXPECT_EQ(choose(cards, "").info.name, "Good Card");
}

TEST(Device, NamesItsLimits) {
  Executor executor({}, test_shaders());
  if (!executor.device().is_cpu) GTEST_SKIP() << "the limits below are the software device's";
  const auto refusal = [&](const Plan& plan) { return message_of<RunError>([&] { executor.run(plan); }); };
  const std::string device = executor.device().name;

  Plan large;
  const ImageId image = large.add_image({.name = "sky", .extent = {16384, 16384}});
  large.add_pass({.shader = "ramp", .writes = {{"ramp_out", image}}, .grid = {1, 1}, .push_constants = {1}});
  EXPECT_EQ(refusal(large), "cannot allocate 4.0 GiB for image sky, 16384x16384 rgba32f: the device " + device +
                                " takes at most 2.0 GiB at once");

  Plan wide;
  const ImageId strip = wide.add_image({.name = "strip", .extent = {20000, 1}});
  wide.add_pass({.shader = "ramp", .writes = {{"ramp_out", strip}}, .grid = {1, 1}, .push_constants = {1}});
  EXPECT_EQ(refusal(wide),
            "image strip, 20000x1 rgba32f is too large: the device " + device + " takes at most 16384 texels a side");

  Plan storage;
  const BufferId numbers = storage.add_buffer({.name = "radiance", .bytes = std::size_t{200} << 20});
  storage.add_pass({.shader = "accumulate", .writes = {{"numbers", numbers}}, .grid = {1, 1}, .push_constants = {1}});
  EXPECT_EQ(refusal(storage), "pass accumulate: numbers (buffer radiance) has 200.0 MiB; the device " + device +
                                  " takes at most 128.0 MiB in a storage buffer");

  Plan grid;
  const BufferId few = grid.add_buffer({.name = "few", .bytes = 4});
  grid.add_pass({.shader = "accumulate", .writes = {{"numbers", few}}, .grid = {32 * 65536, 1}, .push_constants = {1}});
  EXPECT_EQ(refusal(grid), "pass accumulate: its grid needs 65536 workgroups along one axis; the device " + device +
                               " takes at most 65535");
}

}  // namespace
}  // namespace airlight
