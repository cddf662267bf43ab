#pragma once
// The list of a sequence's frames as JSON, kept up to date while they are rendered.

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "app/sequence/job.h"

namespace airlight::cli {

class SequenceManifest {
 public:
  // Takes the frames' times over from an earlier manifest of that name.
  explicit SequenceManifest(const SequenceJob& job);

  // Notes that the k-th frame of the shard is whole on disk. `milliseconds`: from its scene to its files; below 0: it
  // already existed, and the earlier manifest's figure is kept if that has the same hash.
  void add(std::size_t k, const std::string& hash, const Scene& scene, double milliseconds);

  // Writes the file, whole or not at all. Called often, it writes only now and then: at most a hundredth of the time.
  void write_now_and_then();
  void write();

 private:
  // A sequence takes only these 24 bytes of memory for each frame.
  struct Record {
    std::uint64_t hash = 0;
    std::int32_t elevation = 0;  // millionths of a degree
    std::int32_t azimuth = 0;
    float milliseconds = -1.0F;  // below 0: unknown
    bool is_whole = false;
  };
  void read_earlier();
  std::string head() const;
  std::string line(std::size_t k) const;

  const SequenceJob& job_;
  std::vector<Record> records_;
  std::size_t whole_ = 0;
  std::chrono::steady_clock::time_point next_write_;
};

}  // namespace airlight::cli
