#pragma once
// The images and buffers of one run of one plan, taken from the cache.

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "core/gpu/resource_cache.h"
#include "core/gpu/step.h"
#include "core/gpu/stored_tables.h"
#include "core/plan/plan.h"

namespace airlight {

class RunResources {
 public:
  RunResources(const Device& device, ResourceCache& cache, const StoredTables& tables, const Plan& plan);

  // Whether a resource with a key holds what the key promises. All are looked up once, before anything is allocated, so
  // that no resource of this plan is freed for another of the same plan.
  bool is_kept(ResourceId id) const { return held_.contains(id); }
  // Looks up what these passes would write and an earlier start of the program may have stored (BufferDesc::stored).
  // Returns whether there is any.
  bool find_stored(const std::vector<bool>& runs);

  // Allocates what the steps and the host need. Throws std::logic_error when a kept resource is read that nobody has
  // made, RunError when the device is out of memory.
  void acquire(std::span<const Step> steps);

  Resource& at(ResourceId id) const;
  // Null where the run does not use it.
  Resource* image(std::size_t index) const { return images_[index]; }
  Resource* buffer(std::size_t index) const { return buffers_[index]; }
  // The host-readable copy of a buffer that the host cannot read directly; null where it can, or need not.
  Resource* download(std::size_t index) const { return downloads_[index]; }
  // What an image starts with, from the plan or an earlier start of the program; empty where there is nothing or the
  // image is here already.
  std::span<const std::uint32_t> contents(std::uint32_t image) const;
  // Likewise what a buffer starts with from an earlier start of the program; it is handed over, being large.
  std::vector<std::uint32_t> take_stored(std::uint32_t buffer);
  // The host-readable copy of an image that the steps make and later starts may ask for; null for other images.
  Resource* store(std::size_t image) const { return stores_[image]; }
  // The buffer of one of the plan's scenes; null when the scene is empty.
  const Resource* scene(std::size_t index) const { return scenes_[index]; }
  // A buffer for this run that the host fills with the contents of `of`.
  const Buffer& upload(const BufferDesc& of, std::span<const std::byte> contents);

  // To be called at the end of the run: marks what it made as present.
  void remember(std::span<const Step> steps);

 private:
  Resource& acquire(ResourceId id);
  void acquire_for_host();
  void fill_images();
  void acquire_for_storing(std::span<const Step> steps);
  void write_scenes();
  const std::string& key(ResourceId id) const;
  bool has_contents(ResourceId id) const;
  void check_kept_are_made(std::span<const Step> steps) const;

  const Plan& plan_;
  ResourceCache& cache_;
  const StoredTables& tables_;
  // One kind of memory for all buffers that shaders see, so that a kept one is found whatever else a plan says of it.
  MemoryPlace buffer_place_;
  std::set<ResourceId> held_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> contents_;  // by image
  std::map<std::uint32_t, std::vector<std::uint32_t>> stored_;    // by buffer
  std::vector<Resource*> images_;
  std::vector<Resource*> buffers_;
  std::vector<Resource*> downloads_;
  std::vector<Resource*> stores_;
  std::vector<Resource*> scenes_;
};

}  // namespace airlight
