#pragma once
// Reports on a running sequence: a bar on a terminal, otherwise a line for each frame, JSON lines for machines.

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
  bool rendered = false;  // false: it already existed
  double render_ms = 0.0;
  double encode_ms = 0.0;  // includes writing
};

struct SequenceTotals {
  std::size_t frames = 0;  // of the shard
  std::size_t rendered = 0;
  std::size_t kept = 0;
  double render_ms = 0.0;  // summed over frames: time of the device and its thread
  double encode_ms = 0.0;  // time of the threads that encode and write
  double seconds = 0.0;
};

// "[###       ]  31 %, 90 of 288 frames, 3.4 a second, 58 s left"; the rate and the rest only where it is known.
std::string progress_text(std::size_t done, std::size_t frames, double frames_a_second, int width);

// Safe to call from several threads.
class SequenceReport {
 public:
  explicit SequenceReport(const SequenceJob& job);

  void frame(const FrameReport& frame);
  // Warnings of one kind about a frame, perhaps none. They are printed for the first frame that has them; at the end
  // follows the number of further frames. `kind` completes "warning: 12 frames ".
  void warn(long frame_number, const std::string& kind, const std::vector<std::string>& warnings);
  // Notes a frame whose EXR has 32 bits because halves would lose something; printed for the first such frame.
  void took_floats(long frame_number, const std::string& why);
  SequenceTotals totals() const;
  // Removes the bar and prints the last line. `stopped`: a signal's name; empty: all is done.
  void end(const std::string& stopped);

 private:
  void draw_bar();
  void clear_bar();

  const SequenceJob& job_;
  const bool bar_;  // a terminal that can redraw a line
  mutable std::mutex mutex_;
  SequenceTotals totals_;
  std::map<std::string, std::size_t> warned_;  // number of frames, by kind
  std::size_t full_floats_ = 0;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_draw_;
};

}  // namespace airlight::cli
