#pragma once
// Runs a Plan on a device, reads results back, times each pass.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/gpu/embedded_shaders.h"
#include "core/plan/plan.h"

namespace airlight {

struct DeviceInfo {
  std::string name;
  std::string driver;       // driver name and version as text
  std::string api_version;  // "1.3.230"
  bool is_cpu = false;
  std::vector<std::string> missing;  // features that airlight needs and the device lacks; empty: usable
};

struct DeviceOptions {
  std::string name_substring = {};  // empty: $AIRLIGHT_DEVICE, else the software device, else the first usable one
  // Load the validation layer; every message is counted and printed to stderr. AIRLIGHT_VALIDATION=1 does the same.
  bool validation = false;
  std::optional<bool> halves = {};  // whether 16-bit images are stored so; absent: except on processors
  std::optional<bool> teams = {};   // as no processor: passes get teams (PassDesc::team); absent: by the device
  // Folder for data that saves time at later starts; empty: none. Absent: user_cache_folder().
  std::optional<std::filesystem::path> cache_folder = {};
  bool stores_tables = false;               // also tables, in that folder; false: each executor bakes its own
  std::optional<bool> stores_buffers = {};  // where tables are, also BufferDesc::stored; absent: on processors alone
  std::size_t kept_bytes_max = std::size_t{1} << 30;  // beyond it the least recently used kept resources go
  // Likewise pipelines beyond those of the current run. A scene has some ten to thirty, so a program may go to and fro
  // between several kinds of scenes without compiling one anew.
  std::size_t pipelines_max = 160;
};

// Between the names of passes that the device, no processor, had at once: those between two barriers. They have one
// time.
inline constexpr std::string_view kAtOnce = " + ";

struct PassTiming {
  std::string name;
  double milliseconds = 0.0;  // by device timestamps
};

// Host work inside the executor: "instance", "device" (in the first run's result only), "pipelines", "record",
// "execute" (submission to completion), "readback", "storing tables" (where any were baked for later starts).
struct Milestone {
  std::string name;
  double milliseconds = 0.0;
};

struct RunResult {
  std::vector<PassTiming> passes;  // in order; a skipped pass (kept outputs) is left out
  std::vector<Milestone> host;
  // Contents of a host-readable buffer; valid until the executor's next run or its end.
  std::span<const std::byte> contents(BufferId id) const { return buffers[id.index]; }
  std::vector<std::span<const std::byte>> buffers;  // by BufferId, empty where not host-readable
};

struct MemoryUse {  // images and buffers that an executor holds on the device
  std::size_t resources = 0;
  std::size_t bytes = 0;
  std::size_t kept_bytes = 0;      // of these, those kept by key
  std::size_t pipelines = 0;       // beside the bytes: compiled code
  std::size_t pipelines_made = 0;  // so far, dropped ones included
};

class Executor {
 public:
  // Opens the device. Throws RunError: no Vulkan loader or device (names the Debian package that brings one), no
  // device of that name (lists the names), a device that lacks features (lists each).
  // `extra_shaders` are added to airlight's own and replace those of the same name; they must outlive the executor.
  explicit Executor(const DeviceOptions& options, std::span<const EmbeddedShader> extra_shaders = {});
  ~Executor();
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  // Checks the plan, builds what is missing, runs it and waits. Throws RunError when the device runs out of memory
  // (says what was asked for) or fails; std::logic_error when a binding name does not match its shader (names both).
  // `report`: called some times a second with the share of all passes' threads that is done, 0 to 1; each pass is then
  // a submission of its own.
  RunResult run(const Plan& plan, const std::function<void(double done)>& report = {});

  // Frees images and buffers that are no kept tables; a later run makes its own anew. With `but_results` those stay
  // that the last run's result shows or that are carried to the next; else contents of results are no longer valid.
  void free_pictures(bool but_results);

  const DeviceInfo& device() const;
  MemoryUse memory_use() const;
  // Validation messages seen so far by any executor of this process.
  static int validation_message_count();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Every Vulkan device of the machine, usable or not. Throws RunError when there is no Vulkan loader or none at all.
std::vector<DeviceInfo> list_devices();

}  // namespace airlight
