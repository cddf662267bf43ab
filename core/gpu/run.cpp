// The only file that records commands.

#include "core/gpu/run.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/base/clock.h"
#include "core/gpu/descriptors.h"
#include "core/gpu/run_resources.h"
#include "core/gpu/step.h"

namespace airlight {
namespace {

constexpr VkPipelineStageFlags kCompute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags kTransfer = VK_PIPELINE_STAGE_TRANSFER_BIT;
constexpr VkPipelineStageFlags kHostStage = VK_PIPELINE_STAGE_HOST_BIT;
constexpr VkAccessFlags kShaderAccess =
    VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_UNIFORM_READ_BIT;
constexpr VkAccessFlags kTransferAccess = VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;

struct Scope {
  VkPipelineStageFlags stages;
  VkAccessFlags access;
};

void memory_barrier(VkCommandBuffer commands, Scope made, Scope used,
                    const std::vector<VkImageMemoryBarrier>& images = {}) {
  const VkMemoryBarrier barrier{
      .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER, .srcAccessMask = made.access, .dstAccessMask = used.access};
  vkCmdPipelineBarrier(commands, made.stages, used.stages, 0, 1, &barrier, 0, nullptr,
                       static_cast<std::uint32_t>(images.size()), images.data());
}

// One execution of one plan.
class Run {
 public:
  Run(const Machinery& machinery, const Plan& plan, const std::function<void(double)>& report)
      : device_(machinery.device),
        machinery_(machinery),
        plan_(plan),
        report_(report),
        resources_(machinery.device, machinery.cache, machinery.tables, plan) {}

  RunResult execute();

 private:
  void choose_steps();
  void compile();
  void record();
  void submit();
  void record_start(VkCommandBuffer commands) const;
  void record_contents(VkCommandBuffer commands);
  void record_image_contents(VkCommandBuffer commands);
  bool keeps_contents(std::uint32_t buffer) const;
  void record_step(VkCommandBuffer commands, std::size_t number) const;
  void record_downloads(VkCommandBuffer commands) const;
  void read_timings(RunResult& result) const;
  void hand_out(RunResult& result) const;
  bool store_tables() const;
  std::uint32_t query_count() const { return steps_.empty() ? 0 : 2 * (steps_.back().stretch + 1); }

  const Device& device_;
  const Machinery& machinery_;
  const Plan& plan_;
  const std::function<void(double)>& report_;
  RunResources resources_;
  std::vector<Step> steps_;
  double done_ = 0.0;         // of all work, submitted and waited for
  double executed_ms_ = 0.0;  // of submissions made while recording went on
};

RunResult Run::execute() {
  RunResult result;
  Stopwatch stopwatch;
  const auto lap = [&](const char* name) { result.host.push_back({name, stopwatch.lap()}); };
  choose_steps();
  compile();
  lap("pipelines");
  resources_.acquire(steps_);
  record();
  lap("record");
  result.host.back().milliseconds -= executed_ms_;
  submit();
  lap("execute");
  result.host.back().milliseconds += executed_ms_;
  resources_.remember(steps_);
  read_timings(result);
  hand_out(result);
  lap("readback");
  if (store_tables()) lap("storing tables");
  return result;
}

void Run::choose_steps() {
  const IsKept is_kept = [&](ResourceId id) { return resources_.is_kept(id); };
  std::vector<bool> runs = passes_to_run(plan_, is_kept);
  if (resources_.find_stored(runs)) runs = passes_to_run(plan_, is_kept);
  std::vector<Step> all;
  for (const PassDesc& pass : plan_.passes()) {
    // A skipped pass is matched too, so that a mistake in it shows in every run.
    const ShaderProgram& program = machinery_.pipelines.program(pass.shader);
    all.push_back({&pass, &program, match(plan_, pass, program.info, machinery_.teams)});
  }
  for (const Scheduled& next : schedule(plan_, runs)) {
    Step& step = all[next.pass];
    step.barrier = next.barrier;
    // A timestamp behind a pass waits for it, so passes that the device has at once are timed together.
    const bool alone = step.barrier || report_ || !machinery_.teams;
    step.stretch = steps_.empty() ? 0 : steps_.back().stretch + (alone ? 1 : 0);
    check_limits(plan_, step, device_);
    steps_.push_back(std::move(step));
  }
}

void Run::compile() {
  std::vector<PipelineCache::Request> requests;
  for (const Step& step : steps_) requests.push_back({step.program, step.matched.constants});
  const std::vector<VkPipeline> pipelines = machinery_.pipelines.pipelines(requests);
  for (std::size_t i = 0; i < steps_.size(); ++i) steps_[i].pipeline = pipelines[i];
}

double threads_of(const Step& step) {
  const Extent& grid = step.pass->grid;
  return static_cast<double>(grid.width) * grid.height * grid.depth;
}

void Run::submit() {
  machinery_.frame.submit_and_wait(report_ ? std::function<void()>([this] { report_(done_); }) : nullptr);
}

void Run::record() {
  VkCommandBuffer commands = machinery_.frame.begin(count_descriptors(steps_), query_count());
  record_start(commands);
  record_contents(commands);
  record_image_contents(commands);
  double all = 0.0;
  for (const Step& step : steps_) all += threads_of(step);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    Step& step = steps_[i];
    step.set = machinery_.frame.descriptor_set(step.program->set_layout.get());
    write_descriptors(device_, plan_, resources_, machinery_.sampler, step);
    record_step(commands, i);
    if (report_ && &step != &steps_.back()) {
      Stopwatch stopwatch;
      submit();
      done_ += threads_of(step) / all;
      commands = machinery_.frame.begin_rest();
      executed_ms_ += stopwatch.lap();
    }
  }
  record_downloads(commands);
}

// Gives new images their layout, and makes earlier runs' writes visible to this one.
void Run::record_start(VkCommandBuffer commands) const {
  if (query_count() > 0) vkCmdResetQueryPool(commands, machinery_.frame.timestamps(), 0, query_count());
  std::vector<VkImageMemoryBarrier> layouts;
  for (std::size_t i = 0; i < plan_.images().size(); ++i) {
    const Resource* image = resources_.image(i);
    if (image == nullptr || image->has_layout) continue;
    layouts.push_back({.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                       .srcAccessMask = 0,
                       .dstAccessMask = kShaderAccess | kTransferAccess,
                       .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
                       .newLayout = VK_IMAGE_LAYOUT_GENERAL,
                       .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                       .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                       .image = image->image->get(),
                       .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}});
  }
  memory_barrier(commands, {kCompute | kTransfer, VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT},
                 {kCompute | kTransfer, kShaderAccess | kTransferAccess}, layouts);
}

bool Run::keeps_contents(std::uint32_t buffer) const {
  const BufferDesc& desc = plan_.buffers()[buffer];
  const bool is_written = std::ranges::any_of(steps_, [&](const Step& step) { return step.writes(BufferId{buffer}); });
  const bool made_anew = desc.carried && (is_written || desc.has_contents());
  return resources_.buffer(buffer)->has_contents && !made_anew;
}

void Run::record_contents(VkCommandBuffer commands) {
  bool any = false;
  for (std::uint32_t i = 0; i < plan_.buffers().size(); ++i) {
    if (resources_.buffer(i) == nullptr || keeps_contents(i)) continue;
    const BufferDesc& desc = plan_.buffers()[i];
    const Buffer& buffer = *resources_.buffer(i)->buffer;
    const std::vector<std::byte> found = desc.contents_when_run ? desc.contents_when_run() : std::vector<std::byte>();
    const std::vector<std::uint32_t> stored = resources_.take_stored(i);
    const std::span<const std::byte> contents = !stored.empty()          ? std::as_bytes(std::span(stored))
                                                : desc.contents_when_run ? found
                                                                         : desc.contents;
    if (!contents.empty() && contents.size() != desc.bytes) {
      throw std::logic_error("buffer " + desc.name + " has " + std::to_string(contents.size()) +
                             " bytes of contents and is " + std::to_string(desc.bytes) + " long");
    }
    if (!contents.empty() && !buffer.mapped().empty()) {
      std::memcpy(buffer.mapped().data(), contents.data(), desc.bytes);
    } else if (!contents.empty()) {
      const VkBufferCopy region{.srcOffset = 0, .dstOffset = 0, .size = desc.bytes};
      vkCmdCopyBuffer(commands, resources_.upload(desc, contents).get(), buffer.get(), 1, &region);
      any = true;
    } else if (desc.zeroed) {
      vkCmdFillBuffer(commands, buffer.get(), 0, VK_WHOLE_SIZE, 0);
      any = true;
    }
  }
  if (any) {
    memory_barrier(commands, {kTransfer, VK_ACCESS_TRANSFER_WRITE_BIT},
                   {kCompute | kTransfer, kShaderAccess | VK_ACCESS_TRANSFER_READ_BIT});
  }
}

// The whole image, tightly packed in a buffer.
VkBufferImageCopy whole(const Extent& extent) {
  return {.bufferOffset = 0,
          .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
          .imageOffset = {0, 0, 0},
          .imageExtent = {extent.width, extent.height, extent.depth}};
}

void Run::record_image_contents(VkCommandBuffer commands) {
  bool any = false;
  for (std::uint32_t i = 0; i < plan_.images().size(); ++i) {
    const std::span<const std::uint32_t> words = resources_.contents(i);
    if (resources_.image(i) == nullptr || words.empty()) continue;
    const ImageDesc& image = plan_.images()[i];
    const BufferDesc upload{.name = image.name, .bytes = image.bytes()};
    const VkBufferImageCopy region = whole(image.extent);
    vkCmdCopyBufferToImage(commands, resources_.upload(upload, std::as_bytes(words)).get(),
                           resources_.image(i)->image->get(), VK_IMAGE_LAYOUT_GENERAL, 1, &region);
    any = true;
  }
  if (any)
    memory_barrier(commands, {kTransfer, VK_ACCESS_TRANSFER_WRITE_BIT},
                   {kCompute | kTransfer, kShaderAccess | VK_ACCESS_TRANSFER_READ_BIT});
}

void Run::record_step(VkCommandBuffer commands, std::size_t number) const {
  const Step& step = steps_[number];
  if (step.barrier) {
    memory_barrier(
        commands, {kCompute, VK_ACCESS_SHADER_WRITE_BIT},
        {kCompute | VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT, kShaderAccess | VK_ACCESS_INDIRECT_COMMAND_READ_BIT});
  }
  const VkPipelineLayout layout = step.program->layout.get();
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, step.pipeline);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &step.set, 0, nullptr);
  if (const auto& constants = step.pass->push_constants; !constants.empty()) {
    const auto bytes = static_cast<std::uint32_t>(constants.size() * sizeof(constants[0]));
    vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, bytes, constants.data());
  }
  const std::array<std::uint32_t, 3>& groups = step.matched.workgroups;
  const VkQueryPool timestamps = machinery_.frame.timestamps();
  if (number == 0 || steps_[number - 1].stretch != step.stretch) {
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, timestamps, 2 * step.stretch);
  }
  if (step.pass->groups) {
    const Resource& counts = *resources_.buffer(step.pass->groups->buffer.index);
    vkCmdDispatchIndirect(commands, counts.buffer->get(), step.pass->groups->offset);
  } else {
    vkCmdDispatch(commands, groups[0], groups[1], groups[2]);
  }
  if (number + 1 == steps_.size() || steps_[number + 1].stretch != step.stretch) {
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, timestamps, 2 * step.stretch + 1);
  }
}

void Run::record_downloads(VkCommandBuffer commands) const {
  memory_barrier(commands, {kCompute, VK_ACCESS_SHADER_WRITE_BIT},
                 {kTransfer | kHostStage, VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_HOST_READ_BIT});
  bool any = false;
  for (const Plan::Readback& readback : plan_.readbacks()) {
    const VkBufferImageCopy region = whole(plan_.images()[readback.image.index].extent);
    vkCmdCopyImageToBuffer(commands, resources_.at(readback.image).image->get(), VK_IMAGE_LAYOUT_GENERAL,
                           resources_.at(readback.buffer).buffer->get(), 1, &region);
    any = true;
  }
  for (std::uint32_t i = 0; i < plan_.images().size(); ++i) {
    if (resources_.store(i) == nullptr) continue;
    const VkBufferImageCopy region = whole(plan_.images()[i].extent);
    vkCmdCopyImageToBuffer(commands, resources_.image(i)->image->get(), VK_IMAGE_LAYOUT_GENERAL,
                           resources_.store(i)->buffer->get(), 1, &region);
    any = true;
  }
  for (std::size_t i = 0; i < plan_.buffers().size(); ++i) {
    if (resources_.download(i) == nullptr) continue;
    const VkBufferCopy region{.srcOffset = 0, .dstOffset = 0, .size = plan_.buffers()[i].bytes};
    vkCmdCopyBuffer(commands, resources_.buffer(i)->buffer->get(), resources_.download(i)->buffer->get(), 1, &region);
    any = true;
  }
  if (any) {
    memory_barrier(commands, {kTransfer, VK_ACCESS_TRANSFER_WRITE_BIT}, {kHostStage, VK_ACCESS_HOST_READ_BIT});
  }
}

void Run::read_timings(RunResult& result) const {
  const std::vector<std::uint64_t> ticks = machinery_.frame.read_timestamps(query_count());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    if (i > 0 && steps_[i - 1].stretch == step.stretch) {
      result.passes.back().name.append(kAtOnce).append(pass_name(*step.pass));
      continue;
    }
    // The counter may wrap within its valid bits.
    const std::size_t first = std::size_t{2} * step.stretch;
    const std::uint64_t elapsed = (ticks[first + 1] - ticks[first]) & device_.limits().timestamp_mask;
    const double nanoseconds = static_cast<double>(elapsed) * device_.limits().timestamp_nanoseconds;
    result.passes.push_back({pass_name(*step.pass), nanoseconds * 1e-6});
  }
}

void Run::hand_out(RunResult& result) const {
  result.buffers.resize(plan_.buffers().size());
  for (std::size_t i = 0; i < result.buffers.size(); ++i) {
    const BufferDesc& desc = plan_.buffers()[i];
    if (!desc.host_readable) continue;
    const Resource* download = resources_.download(i);
    const Resource* readable = download != nullptr ? download : resources_.buffer(i);
    result.buffers[i] = readable->buffer->mapped().first(desc.bytes);
  }
}

// Returns whether there were any.
bool Run::store_tables() const {
  bool any = false;
  for (std::uint32_t i = 0; i < plan_.images().size(); ++i) {
    if (resources_.store(i) == nullptr) continue;
    const ImageDesc& table = plan_.images()[i];
    std::vector<std::uint32_t> words(table.bytes() / sizeof(std::uint32_t));
    std::memcpy(words.data(), resources_.store(i)->buffer->mapped().data(), table.bytes());
    machinery_.tables.keep(table, words);
    any = true;
  }
  for (const Step& step : steps_) {
    for (const Binding& write : step.pass->writes) {
      const auto* id = std::get_if<BufferId>(&write.resource);
      if (id == nullptr || !machinery_.tables.takes(plan_.buffers()[id->index])) continue;
      const std::span<const std::byte> made = resources_.at(*id).buffer->mapped();
      if (made.empty()) continue;  // no processor's
      std::vector<std::uint32_t> words(made.size() / sizeof(std::uint32_t));
      std::memcpy(words.data(), made.data(), made.size());
      machinery_.tables.keep(plan_.buffers()[id->index], std::move(words));
      any = true;
    }
  }
  if (any) machinery_.tables.trim();
  return any;
}

}  // namespace

RunResult run_plan(const Machinery& machinery, const Plan& plan, const std::function<void(double)>& report) {
  return Run(machinery, plan, report).execute();
}

}  // namespace airlight
