#pragma once
// What a running sequence tells: a bar on a terminal, a line a frame elsewhere, JSON lines for machines.

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/sequence/job.h"

namespace airlight::cli {

struct FrameReport {
  long number = 0;
  std::optional<sequence::FrameTime> time;
  double elevation_deg = 0.0;
  double azimuth_deg = 0.0;
  Targets files;
  std::string hash;
  bool rendered = false;  // else it was there already
  double render_ms = 0.0;
  double encode_ms = 0.0;  // and writing
};

struct SequenceTotals {
  std::size_t frames = 0;  // of the shard
  std::size_t rendered = 0;
  std::size_t kept = 0;
  double render_ms = 0.0;  // summed over frames: what the device and its thread took
  double encode_ms = 0.0;  // what the threads that encode and write took
  double seconds = 0.0;
};

// "[###       ]  31 %, 90 of 288 frames, 3.4 a second, 58 s left"; the rate and what follows only where it is known.
std::string progress_text(std::size_t done, std::size_t frames, double frames_a_second, int width);

// Safe to call from several threads.
class SequenceReport {
 public:
  explicit SequenceReport(const SequenceJob& job);

  void frame(const FrameReport& frame);
  // Warnings of one kind about a frame, perhaps none: told of the first frame that has them, and at the end of how many
  // more do. `kind` finishes "warning: 12 frames ".
  void warn(long frame_number, const std::string& kind, const std::vector<std::string>& warnings);
  // A frame whose EXR has 32 bits because halves would lose something; told the first time.
  void took_floats(long frame_number, const std::string& why);
  SequenceTotals totals() const;
  // The bar goes, the last line comes. `stopped`: a signal's name; empty: all is done.
  void end(const std::string& stopped);

 private:
  void draw_bar();
  void clear_bar();

  const SequenceJob& job_;
  const bool bar_;  // a terminal that can redraw a line
  mutable std::mutex mutex_;
  SequenceTotals totals_;
  std::map<std::string, std::size_t> warned_;  // frames, by kind
  std::size_t full_floats_ = 0;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_draw_;
};

}  // namespace airlight::cli
