#pragma once
// A list of compute passes as plain data: no Vulkan types, nothing opened, testable without a device.

#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/plan/table_text.h"

namespace airlight {

struct Extent {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t depth = 1;  // > 1: a 3-D image
};

// Four floats a texel, of 32 bits or of 16. A `key` says all that the contents depend on. With a key the executor keeps
// the contents for later plans and skips passes that would only make them again (see passes_to_run).
struct ImageDesc {
  std::string name = {};
  Extent extent = {};
  std::string key = {};
  // Stored in 16 bits, which a GPU's samplers filter several times as fast; a processor would have to widen them and
  // keeps 32. The host cannot read such an image.
  bool half = false;
  // Of each texel's four floats the device keeps the first 1, 2 or all; fewer than 4 of an image in halves alone.
  std::uint32_t components = 4;
  bool shared = false;  // by all scenes and lights, so that its key gets no suffix; see Plan::shared_image
  bool stored = false;  // in a file of the user's, with a key that later starts of the program may ask for again
  // What an image of 32 bits starts with, tightly packed; empty: undefined. It is called when a pass that reads it
  // runs.
  std::function<std::vector<std::byte>()> contents_when_run = {};
  // For a table that may be written to a file; empty: of no use outside the plan. It is a function, since most plans do
  // not ask for the text.
  std::function<TableText()> text = {};
  std::string channels = {};  // meaning of red, green and blue, where not the scene's channels; set by Plan::add_image
  std::size_t bytes() const;  // tightly packed
};

struct BufferDesc {
  std::string name = {};
  std::size_t bytes = 0;
  bool host_readable = false;
  std::vector<std::byte> contents = {};  // empty: starts as zeros; else exactly `bytes` long
  std::string key = {};
  // With a key: kept, but made anew by every plan that has a pass for it. A later plan without such a pass reads what
  // is there.
  bool carried = false;
  bool scratch = false;  // its contents at the end are of no use: no pass runs for it alone
  bool zeroed = true;    // false: starts undefined, for a buffer that its pass writes whole (33 MB of zeros cost ms)
  // A key under which a processor's later starts find the contents in a file of the user's: elsewhere making them takes
  // less time than reading. They are not kept from plan to plan, as with `key`.
  std::string stored = {};
  std::uint32_t slice = 1;  // of what is stored: so many words farther on a value often stands once more
  // Replaces `contents` where they take long to compute. It is called when a pass that reads them runs, since most
  // plans are never run.
  std::function<std::vector<std::byte>()> contents_when_run = {};
  bool has_contents() const { return !contents.empty() || contents_when_run; }
};

struct ImageId {
  std::uint32_t index = 0;
  auto operator<=>(const ImageId&) const = default;
};
struct BufferId {
  std::uint32_t index = 0;
  auto operator<=>(const BufferId&) const = default;
};
using ResourceId = std::variant<ImageId, BufferId>;

// Parts into which passes may agree to divide what they touch (Binding::parts).
inline constexpr std::size_t kBindingParts = 4;
inline constexpr std::uint32_t kAllParts = (1U << kBindingParts) - 1;

struct Binding {
  std::string name;  // as the shader spells it
  ResourceId resource;
  std::uint32_t parts = kAllParts;  // bits: those that the pass touches; one that touches others need not wait for it
};

struct Specialization {
  std::string name;  // as the shader spells the constant
  std::uint32_t value = 0;
};

// The word of a push constant that the shader declares as float.
constexpr std::uint32_t push_constant(double value) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

struct GroupCount {
  BufferId buffer;
  std::uint32_t offset = 0;  // bytes, a multiple of 4
};

struct PassDesc {
  std::string name = {};    // for timings and errors; the shader's name when empty
  std::string shader = {};  // file name in shaders/passes without .comp
  std::vector<Binding> reads = {};
  std::vector<Binding> writes = {};  // a resource that is both read and written stands here only
  Extent grid = {};                  // threads; workgroups are rounded up
  std::vector<std::uint32_t> push_constants = {};
  std::vector<Specialization> specialization = {};
  // Number of threads that share a point of the grid, where the grid is too small to fill a device other than a
  // processor. There the grid is so many times as wide, and the shader's constant kTeam is that number. Elsewhere kTeam
  // is 1.
  std::uint32_t team = 1;
  // Predicted cost of one thread in steps of `march` at one pixel, each about 20 ns of one core of a software device.
  // On hardware the ratios are much the same, since both spend their time on fetches and steps. Measured by `airlight
  // chart`.
  double cost = 1.0;
  // Where an earlier pass finds how many workgroups there are to run: at this byte of a buffer that the pass reads
  // stand three uint. The grid then counts for limits and costs alone.
  std::optional<GroupCount> groups = {};
  std::uint32_t scene = 0;  // which of the plan's scenes its uniform block holds; set by Plan::add_pass
};

// Alignment of a storage buffer's range that every device supports.
inline constexpr std::size_t kSceneTablesAlignment = 256;

constexpr std::size_t scene_tables_offset(std::size_t block_bytes) {
  return (block_bytes + kSceneTablesAlignment - 1) / kSceneTablesAlignment * kSceneTablesAlignment;
}

class Plan {
 public:
  // The bytes of the one uniform block, `scene` in every shader that declares it, and behind it, from the next multiple
  // of kSceneTablesAlignment on, those of the storage buffer `scene_tables`.
  std::vector<std::byte> scene_data;

  // From here on added passes read another scene, of as many bytes, and whatever is added gets the suffix to name and
  // key. `channels`: ImageDesc::channels of what is added.
  void begin_scene(std::vector<std::byte> data, std::string suffix, std::string channels);
  // Returns to the light's first scene.
  void end_scene();
  // Replaces the light's first scene.
  void put_scene(std::vector<std::byte> data);
  // From here on added passes belong to another light: they read a first scene of their own, and what is added gets
  // the light's suffix, to its name and, unless it is `stored` and so the same by any light, to its key.
  void begin_light(std::vector<std::byte> data, std::string suffix);
  void end_light();
  // From here on whatever is added gets this behind its name, but not its key: a thing of which the plan has several.
  // Empty: nothing.
  void tell_apart(std::string name);
  // The table that an earlier light has already had added under this key.
  std::optional<ImageId> table_of(const std::string& key) const;
  // The shared image that has already been added under this key, by whatever scene.
  std::optional<ImageId> shared_image(const std::string& key) const;
  // The scene that the pass reads.
  const std::vector<std::byte>& scene_of(const PassDesc& pass) const;
  std::size_t scene_count() const { return 1 + more_scenes_.size(); }
  const std::vector<std::byte>& scene(std::size_t index) const;

  ImageId add_image(ImageDesc desc);
  BufferId add_buffer(BufferDesc desc);
  // Adds one buffer for all scenes of the light. A second call with this name returns the first buffer, whose contents
  // are equal.
  BufferId add_shared_buffer(BufferDesc desc);
  // Likewise one buffer for the current scene.
  BufferId add_buffer_once(BufferDesc desc);
  // The host can read the buffer's contents after the run.
  void make_readable(BufferId buffer) { buffers_.at(buffer.index).host_readable = true; }
  void add_pass(PassDesc desc);
  // Copies an image to a new host-readable buffer after the last pass, tightly packed, rows from the top.
  BufferId add_readback(ImageId image);

  const std::vector<ImageDesc>& images() const { return images_; }
  const std::vector<BufferDesc>& buffers() const { return buffers_; }
  const std::vector<PassDesc>& passes() const { return passes_; }
  struct Readback {
    ImageId image;
    BufferId buffer;
  };
  const std::vector<Readback>& readbacks() const { return readbacks_; }

 private:
  std::vector<std::vector<std::byte>> more_scenes_;
  std::uint32_t current_scene_ = 0;
  std::uint32_t first_scene_ = 0;  // of the light
  std::string light_;
  std::string suffix_;
  std::string apart_;
  std::string channels_;
  std::vector<ImageDesc> images_;
  std::vector<BufferDesc> buffers_;
  std::vector<PassDesc> passes_;
  std::vector<Readback> readbacks_;
};

// "image transmittance", for messages.
std::string describe(const Plan& plan, ResourceId id);

// The pass's name; its shader's where it has none.
const std::string& pass_name(const PassDesc& pass);

// Throws std::logic_error naming pass and resource: a resource read before any pass writes it (without contents or a
// key), a resource both read and written in one pass, an empty grid, an unknown id, a repeated name.
void check(const Plan& plan);

// Tells whether a kept resource already has what its key promises.
using IsKept = std::function<bool(ResourceId)>;

// One flag a pass: false where the pass would only make what is kept, or what only such passes read. A kept resource
// that some pass must write after all is made from its first writer on.
std::vector<bool> passes_to_run(const Plan& plan, const IsKept& is_kept);

// A pass that runs, by its number, and whether a memory barrier stands before it.
struct Scheduled {
  std::size_t pass = 0;
  bool barrier = false;
  bool operator==(const Scheduled&) const = default;
};

// The passes that run, level by level, with a barrier between levels: no pass of a level touches what another of them
// writes, so that a device with room for several has them at once. Each is as late as what later ones need allows, next
// to what they also wait for. Within a level they are in the plan's order.
std::vector<Scheduled> schedule(const Plan& plan, const std::vector<bool>& runs);

}  // namespace airlight
