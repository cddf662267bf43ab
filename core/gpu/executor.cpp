#include "core/gpu/executor.h"

#include <cstdlib>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/huge_pages.h"
#include "core/gpu/driver_code.h"
#include "core/gpu/frame.h"
#include "core/gpu/kept_files.h"
#include "core/gpu/physical_device.h"
#include "core/gpu/pipeline.h"
#include "core/gpu/resource_cache.h"
#include "core/gpu/run.h"
#include "core/gpu/stored_tables.h"

namespace airlight {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool wants_validation(const DeviceOptions& options) {
  return options.validation || environment("AIRLIGHT_VALIDATION") == "1";
}

std::string wanted_device(const DeviceOptions& options) {
  return options.name_substring.empty() ? environment("AIRLIGHT_DEVICE") : options.name_substring;
}

// A folder of its own for each kind, so that no other file in the user's folder is ever taken for code, or removed.
std::filesystem::path cache_folder(const DeviceOptions& options, const char* kind) {
  const std::filesystem::path folder = options.cache_folder ? *options.cache_folder : user_cache_folder();
  return folder.empty() ? folder : folder / kind;
}

// Where no device is named, opens the software device's driver alone, if it exists and can be used. Not with the
// validation layer, which would count the loader's messages about a missing driver.
std::unique_ptr<Instance> open_instance(const DeviceOptions& options) {
  take_driver_code(cache_folder(options, ""));
  const bool validation = wants_validation(options);
  if (!validation && wanted_device(options).empty()) {
    try {
      auto software = std::make_unique<Instance>(validation, Drivers::software);
      if (choose(physical_devices(*software), "").info.is_cpu) return software;
    } catch (const RunError&) {
      // The driver does not exist: all drivers are opened below.
    }
  }
  return std::make_unique<Instance>(validation);
}

SamplerHandle make_sampler(const Device& device) {
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = VK_FILTER_LINEAR;
  info.minFilter = VK_FILTER_LINEAR;
  info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
  info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  return SamplerHandle::make(device.get(), vkCreateSampler, info, "make the sampler");
}

}  // namespace

struct Executor::Impl {
  Impl(const DeviceOptions& options, std::span<const EmbeddedShader> extra_shaders)
      : instance(open_instance(options)),
        device(*instance, wanted_device(options)),
        pipelines(device, extra_shaders, cache_folder(options, "modules"), options.pipelines_max),
        cache(device, options.kept_bytes_max),
        frame(device),
        sampler(make_sampler(device)),
        teams(options.teams.value_or(!device.info().is_cpu)),
        tables(options.stores_tables ? cache_folder(options, "tables") : std::filesystem::path(),
               options.stores_buffers.value_or(device.info().is_cpu) ? cache_folder(options, "buffers")
                                                                     : std::filesystem::path(),
               built_tables(), device.info(), teams) {
    device.keep_halves(options.halves.value_or(!device.info().is_cpu));
  }

  Stopwatch stopwatch;
  std::unique_ptr<Instance> instance;
  double instance_milliseconds = stopwatch.lap();
  Device device;
  PipelineCache pipelines;
  ResourceCache cache;
  Frame frame;
  SamplerHandle sampler;
  bool teams;
  StoredTables tables;
  double device_milliseconds = stopwatch.lap();
  bool has_run = false;
};

Executor::Executor(const DeviceOptions& options, std::span<const EmbeddedShader> extra_shaders)
    : impl_(std::make_unique<Impl>(options, extra_shaders)) {}

Executor::~Executor() = default;

RunResult Executor::run(const Plan& plan, const std::function<void(double)>& report) {
  check(plan);
  impl_->cache.begin_run();
  const Machinery machinery{impl_->device,        impl_->pipelines, impl_->cache, impl_->frame,
                            impl_->sampler.get(), impl_->teams,     impl_->tables};
  RunResult result = run_plan(machinery, plan, report);
  impl_->cache.end_run();
  if (!impl_->has_run) {
    result.host.insert(result.host.begin(),
                       {{"instance", impl_->instance_milliseconds}, {"device", impl_->device_milliseconds}});
    impl_->has_run = true;
  }
  return result;
}

void Executor::free_pictures(bool but_results) {
  const std::size_t before = impl_->cache.memory_use().bytes;
  impl_->cache.free_pictures(but_results);
  // Of fewer bytes the host's pictures take most again, and new pages cost more than they save.
  constexpr std::size_t kWorthwhile = std::size_t{24} << 20;
  if (before - impl_->cache.memory_use().bytes > kWorthwhile) {
    return_free_memory();
  }
}

const DeviceInfo& Executor::device() const {
  return impl_->device.info();
}

MemoryUse Executor::memory_use() const {
  MemoryUse use = impl_->cache.memory_use();
  use.pipelines = impl_->pipelines.count();
  use.pipelines_made = impl_->pipelines.made();
  return use;
}

int Executor::validation_message_count() {
  return validation_messages();
}

std::vector<DeviceInfo> list_devices() {
  const Instance instance(false);
  std::vector<DeviceInfo> infos;
  for (const PhysicalDevice& device : physical_devices(instance)) infos.push_back(device.info);
  return infos;
}

}  // namespace airlight
