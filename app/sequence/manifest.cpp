#include "app/sequence/manifest.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <span>

#include "app/cli/json_writer.h"
#include "core/base/clock.h"
#include "core/output/atomic_file.h"
#include "core/scene/angle.h"
#include "core/scene/json_text.h"
#include "core/scene/named_file.h"

namespace airlight::cli {
namespace {

constexpr double kMicro = 1e6;
constexpr std::string_view kFrameStart = "{\"frame\":";

std::int32_t micro_degrees(double radians) {
  return static_cast<std::int32_t>(std::lround(std::remainder(degrees_from_radians(radians), 360.0) * kMicro));
}

std::string hash_digits(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

std::uint64_t hash_number(const std::string& digits) {
  std::uint64_t hash = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), hash, 16);
  return hash;
}

}  // namespace

SequenceManifest::SequenceManifest(const SequenceJob& job)
    : job_(job), records_(sequence::shard_size(job.shard, sequence::frame_count(job.source))) {
  read_earlier();
  next_write_ = Clock::now() + std::chrono::seconds(5);
}

// Each frame is a line of its own, so that the file is never held whole. Other lines are skipped: the manifest is a
// report, and at worst its figures are wrong.
void SequenceManifest::read_earlier() {
  if (!named_file_problem(job_.manifest).empty()) {
    return;
  }
  std::ifstream file(job_.manifest, std::ios::binary);
  const long first = records_.empty() ? 0 : sequence::frame_number(job_.source, 0);
  for (std::array<char, 4096> line; file.getline(line.data(), line.size());) {  // a longer line is none of ours
    std::string text = line.data();
    if (!text.starts_with(kFrameStart)) {
      continue;
    }
    text.erase(text.find_last_not_of(",\r") + 1);
    const std::optional<PresetValue> parsed = try_parse_json_value(text, job_.manifest);
    const PresetValue* object = parsed ? &*parsed : nullptr;
    const auto number_of = [&](const char* key) {
      const auto* number = member_as<double>(object, key);
      return number == nullptr ? -1.0 : *number;
    };
    const auto* digits = member_as<std::string>(object, "hash");
    const double index = number_of("frame") - static_cast<double>(first) - static_cast<double>(job_.shard.index - 1);
    const double k = index / static_cast<double>(job_.shard.count);
    if (digits != nullptr && k >= 0.0 && k < static_cast<double>(records_.size()) && k == std::floor(k)) {
      Record& record = records_[static_cast<std::size_t>(k)];
      record.hash = hash_number(*digits);
      record.milliseconds = static_cast<float>(number_of("milliseconds"));
    }
  }
}

void SequenceManifest::add(std::size_t k, const std::string& hash, const Scene& scene, double milliseconds) {
  Record& record = records_.at(k);
  const std::uint64_t number = hash_number(hash);
  if (milliseconds >= 0.0 || record.hash != number) {
    record.milliseconds = static_cast<float>(milliseconds);
  }
  record.hash = number;
  record.elevation = micro_degrees(scene.sun.elevation);
  record.azimuth = micro_degrees(scene.sun.azimuth);
  whole_ += record.is_whole ? 0 : 1;
  record.is_whole = true;
}

std::string SequenceManifest::head() const {
  JsonWriter json;
  json.begin_object().key("airlight").value(AIRLIGHT_VERSION).key("preset").value(job_.preset.source);
  json.key("name").value(job_.scene.name).key("method").value(job_.scene.render.method);
  json.key("width").value(job_.scene.image.width).key("height").value(job_.scene.image.height);
  const auto* path = std::get_if<sequence::SunPath>(&job_.source);
  json.key("place");
  if (path != nullptr) {
    json.begin_object().key("latitude_deg").value(path->place.latitude_deg);
    json.key("longitude_deg").value(path->place.longitude_deg).key("altitude_km").value(path->place.altitude_km);
    json.key("time_zone").value(path->zone.name);
    json.key("refraction").value(path->refraction.has_value()).end_object();
  } else {
    json.null();
  }
  json.key("shard").value(std::to_string(job_.shard.index) + "/" + std::to_string(job_.shard.count));
  json.key("frames_in_all").value(sequence::frame_count(job_.source));
  json.key("frames_in_shard").value(records_.size()).key("frames_whole").value(whole_);
  json.key("complete").value(whole_ == records_.size()).end_object();
  std::string text = json.take();
  text.erase(text.rfind('}'));
  return text + ",\"frames\":[";
}

std::string SequenceManifest::line(std::size_t k) const {
  const Record& record = records_[k];
  const std::size_t index = sequence::shard_frame(job_.shard, k);
  const long number = sequence::frame_number(job_.source, index);
  const std::optional<sequence::FrameTime> time = sequence::frame_time(job_.source, index);
  const Targets files = files_of(job_, number);
  JsonWriter json;
  json.begin_object().key("frame").value(number).key("time").text_or_null(time ? iso_text(*time) : "");
  json.key("sun_elevation_deg").value(record.elevation / kMicro);
  json.key("sun_azimuth_deg").value((record.azimuth < 0 ? 360.0 : 0.0) + record.azimuth / kMicro);
  json.key("file").value(files.first()).key("png").text_or_null(files.png);
  json.key("hash").value(hash_digits(record.hash)).key("milliseconds");
  record.milliseconds < 0.0F ? json.null() : json.value(std::round(static_cast<double>(record.milliseconds) * 10) / 10);
  std::string text = json.end_object().take();
  text.pop_back();
  return text;
}

void SequenceManifest::write() {
  constexpr std::size_t kPiece = std::size_t{1} << 16U;
  const Clock::time_point start = Clock::now();
  std::string piece = head();
  bool first = true;
  bool closed = false;
  std::size_t k = 0;
  std::string handed_out;
  write_file(job_.manifest, [&] {
    while (piece.size() < kPiece && k < records_.size()) {
      if (records_[k].is_whole) {
        piece += (first ? "\n" : ",\n") + line(k);
        first = false;
      }
      ++k;
    }
    if (k == records_.size() && !closed) {
      piece += "\n]}\n";
      closed = true;
    }
    handed_out = std::exchange(piece, {});
    return std::as_bytes(std::span(handed_out));
  });
  constexpr auto kShortest = std::chrono::seconds(5);
  next_write_ = Clock::now() + std::max<Clock::duration>(kShortest, 100 * (Clock::now() - start));
}

void SequenceManifest::write_now_and_then() {
  if (Clock::now() >= next_write_) {
    write();
  }
}

}  // namespace airlight::cli
