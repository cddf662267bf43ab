#include "app/sequence/report.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "app/cli/json_writer.h"
#include "app/cli/stopwatch.h"
#include "app/cli/terminal.h"
#include "core/base/clock.h"

namespace airlight::cli {
namespace {

bool can_redraw() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::strcmp(terminal, "dumb") != 0;
}

std::string length_text(double seconds) {
  char text[64];
  if (seconds < 99.5) {
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  } else if (seconds < 5940.0) {
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60.0);
  } else {
    std::snprintf(text, sizeof text, "%.1f h", seconds / 3600.0);
  }
  return text;
}

std::string frame_line(const FrameReport& frame, std::size_t done, std::size_t frames) {
  char text[160];
  std::snprintf(text, sizeof text, ": sun %.2f degrees high at azimuth %.2f, %.0f ms", frame.elevation_deg,
                frame.azimuth_deg, frame.render_ms + frame.encode_ms);
  const std::string time =
      frame.time ? " " + sequence::clock_text(frame.time->utc, frame.time->offset_seconds) : std::string();
  return "[" + std::to_string(done) + "/" + std::to_string(frames) + "] " + frame.files.first() + time + text + "\n";
}

std::string frame_json(const FrameReport& frame) {
  JsonWriter json;
  json.begin_object()
      .key("frame")
      .value(frame.number)
      .key("time")
      .text_or_null(frame.time ? iso_text(*frame.time) : "");
  json.key("sun_elevation_deg").value(frame.elevation_deg).key("sun_azimuth_deg").value(frame.azimuth_deg);
  json.key("file").value(frame.files.first()).key("png").text_or_null(frame.files.png);
  json.key("hash").value(frame.hash).key("status").value(frame.rendered ? "rendered" : "kept");
  if (frame.rendered) {
    json.key("render_milliseconds").value(frame.render_ms).key("encode_milliseconds").value(frame.encode_ms);
  }
  return json.end_object().take();
}

std::string totals_json(const SequenceTotals& totals, const SequenceJob& job, const std::string& stopped) {
  JsonWriter json;
  json.begin_object().key("frames").value(totals.frames).key("rendered").value(totals.rendered);
  json.key("kept").value(totals.kept).key("complete").value(totals.rendered + totals.kept == totals.frames);
  json.key("stopped_by").text_or_null(stopped);
  json.key("manifest").value(job.manifest).key("seconds").value(totals.seconds);
  json.key("render_seconds").value(totals.render_ms / 1000.0).key("encode_seconds").value(totals.encode_ms / 1000.0);
  return json.key("peak_resident_mib").value(peak_resident_mib()).end_object().take();
}

}  // namespace

std::string progress_text(std::size_t done, std::size_t frames, double frames_a_second, int width) {
  const double share = frames == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(frames);
  const int filled = static_cast<int>(width * share);
  std::string text = "[" + std::string(static_cast<std::size_t>(filled), '#') +
                     std::string(static_cast<std::size_t>(width - filled), ' ') + "]";
  char numbers[128];
  std::snprintf(numbers, sizeof numbers, " %3.0f %%, %zu of %zu frames", std::floor(100.0 * share), done, frames);
  text += numbers;
  if (frames_a_second > 0.0) {
    const double left = static_cast<double>(frames - done) / frames_a_second;
    std::snprintf(numbers, sizeof numbers, frames_a_second >= 1.0 ? ", %.1f a second" : ", %.2f a second",
                  frames_a_second);
    text += numbers + (", " + length_text(left) + " left");
  }
  return text;
}

SequenceReport::SequenceReport(const SequenceJob& job) : job_(job), bar_(!job.quiet && can_redraw()) {
  totals_.frames = sequence::shard_size(job.shard, sequence::frame_count(job.source));
}

void SequenceReport::frame(const FrameReport& frame) {
  const std::lock_guard lock(mutex_);
  (frame.rendered ? totals_.rendered : totals_.kept) += 1;
  totals_.render_ms += frame.render_ms;
  totals_.encode_ms += frame.encode_ms;
  if (job_.json) {
    print(frame_json(frame));
    flush_stdout();
  }
  if (bar_) {
    draw_bar();
  } else if (!job_.quiet && !job_.json && frame.rendered) {
    tell(frame_line(frame, totals_.rendered + totals_.kept, totals_.frames));
  }
}

void SequenceReport::warn(long frame_number, const std::string& kind, const std::vector<std::string>& warnings) {
  if (warnings.empty()) {
    return;
  }
  const std::lock_guard lock(mutex_);
  if (++warned_[kind] == 1 && !job_.quiet) {
    clear_bar();
    for (const std::string& warning : warnings) {
      complain("warning: frame " + std::to_string(frame_number) + ": " + warning);
    }
  }
}

void SequenceReport::took_floats(long frame_number, const std::string& why) {
  const std::lock_guard lock(mutex_);
  if (++full_floats_ == 1 && !job_.quiet) {
    clear_bar();
    complain("note: frame " + std::to_string(frame_number) + " and all like it have 32-bit floats: " + why +
             "; --half forces 16 bits, --float gives every frame 32");
  }
}

SequenceTotals SequenceReport::totals() const {
  const std::lock_guard lock(mutex_);
  SequenceTotals totals = totals_;
  totals.seconds = seconds_since(start_);
  return totals;
}

void SequenceReport::end(const std::string& stopped) {
  const SequenceTotals totals = this->totals();
  const std::lock_guard lock(mutex_);
  clear_bar();
  if (job_.json) {
    print(totals_json(totals, job_, stopped));
  }
  if (job_.quiet) {
    return;
  }
  if (full_floats_ > 1) {
    complain("note: " + std::to_string(full_floats_) + " frames have 32-bit floats");
  }
  for (const auto& [kind, frames] : warned_) {
    if (frames > 1) {
      complain("warning: " + std::to_string(frames) + " frames " + kind);
    }
  }
  if (job_.json) {
    return;
  }
  char numbers[160];
  std::snprintf(numbers, sizeof numbers, "%zu frames rendered, %zu kept of %zu, %.1f s", totals.rendered, totals.kept,
                totals.frames, totals.seconds);
  std::string text = numbers;
  if (totals.rendered > 0) {
    const double each = 1.0 / static_cast<double>(totals.rendered);
    std::snprintf(numbers, sizeof numbers, ": %.2f s a frame (render %.0f ms, encode and write %.0f ms beside it)",
                  totals.seconds * each, totals.render_ms * each, totals.encode_ms * each);
    text += numbers;
  }
  tell(text + "\n" + job_.manifest + "\n");
}

// The rate counts rendered frames only: kept frames take no time and would make it too high.
void SequenceReport::draw_bar() {
  constexpr auto kInterval = std::chrono::milliseconds(100);
  constexpr int kWidth = 30;
  const Clock::time_point now = Clock::now();
  const std::size_t done = totals_.rendered + totals_.kept;
  if (now - last_draw_ < kInterval && done != totals_.frames) {
    return;
  }
  const double spent = std::chrono::duration<double>(now - start_).count();
  tell("\r" + progress_text(done, totals_.frames, static_cast<double>(totals_.rendered) / spent, kWidth) + "\033[K");
  last_draw_ = now;
  drawn_ = true;
}

void SequenceReport::clear_bar() {
  if (drawn_) {
    tell("\r\033[K");
    drawn_ = false;
  }
}

}  // namespace airlight::cli
