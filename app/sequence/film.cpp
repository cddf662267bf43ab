#include "app/sequence/film.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/process.h"
#include "core/base/error.h"
#include "core/base/file_descriptor.h"
#include "core/base/radiance_image.h"
#include "core/output/atomic_file.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = ".part-";
constexpr const char* kMessages = ".txt";

bool is_on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    if (::access((fs::path(rest.substr(0, end)) / program).c_str(), X_OK) == 0) {
      return true;
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

// ffmpeg's names of the code points.
std::string primaries_name(int code) {
  return code == 9 ? "bt2020" : code == 12 ? "smpte432" : "bt709";
}
std::string transfer_name(int code) {
  return code == 13 ? "iec61966-2-1" : code == 16 ? "smpte2084" : code == 18 ? "arib-std-b67" : "bt709";
}

// Converts from RGB by the matrix that the stream names, not by ffmpeg's guess; narrow range, as players expect. The
// frames carry the names, since FFmpeg 7 takes them from there and not from options of the output.
std::vector<std::string> mp4_arguments(const std::optional<ColourCode>& colours) {
  const bool wide = colours && colours->primaries == 9;
  std::string filters =
      "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=" + std::string(wide ? "bt2020" : "bt709") +
      ":out_range=tv,setparams=range=tv:colorspace=" + (wide ? "bt2020nc" : "bt709");
  if (colours) {
    filters +=
        ":color_primaries=" + primaries_name(colours->primaries) + ":color_trc=" + transfer_name(colours->transfer);
  }
  return {"-vf",      filters,   "-c:v",      "libx264",    "-crf", "18",
          "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",   "mp4"};
}

std::vector<std::string> arguments(const std::string& file, const std::string& target, int width, int height,
                                   int frames_a_second, const std::optional<ColourCode>& colours) {
  std::vector<std::string> words = {"ffmpeg",
                                    "-hide_banner",
                                    "-nostdin",
                                    "-loglevel",
                                    "error",
                                    "-y",
                                    "-f",
                                    "rawvideo",
                                    "-pixel_format",
                                    "rgb24",
                                    "-video_size",
                                    std::to_string(width) + "x" + std::to_string(height),
                                    "-framerate",
                                    std::to_string(frames_a_second),
                                    "-i",
                                    "pipe:0"};
  const std::vector<std::string> mp4 = mp4_arguments(colours);
  const std::vector<std::string> gif = {"-filter_complex", "[0:v]split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f",
                                        "gif"};
  const std::vector<std::string>& format = fs::path(file).extension() == ".gif" ? gif : mp4;
  words.insert(words.end(), format.begin(), format.end());
  words.push_back("file:" + target);
  return words;
}

}  // namespace

void require_film(const std::string& file, const std::string& option) {
  const std::string ending = fs::path(file).extension();
  if (ending != ".mp4" && ending != ".gif") {
    throw InputError(option + ": '" + file + "' ends neither in .mp4 nor in .gif");
  }
  require_writable(file);
  if (!is_on_path("ffmpeg")) {
    throw InputError(option + ": ffmpeg is not installed (Debian: apt-get install ffmpeg); leave " +
                     option.substr(option.rfind(' ') + 1) +
                     " out now, and give it once ffmpeg is there: whole frames are kept");
  }
}

void remove_abandoned_film(const std::string& file) noexcept {
  try {
    const fs::path path(file);
    const std::string start = path.filename().string() + kMark;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(path.has_parent_path() ? path.parent_path() : fs::path("."))) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with(start) || !name.ends_with(kMessages)) {
        continue;
      }
      const FileDescriptor messages(::open(entry.path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
      if (messages && ::flock(messages.get(), LOCK_EX | LOCK_NB) == 0) {
        const std::string text = entry.path().string();
        ::unlink(text.substr(0, text.size() - std::strlen(kMessages)).c_str());
        ::unlink(text.c_str());
      }
    }
  } catch (const std::exception&) {
    return;  // the folder cannot be read, or changed meanwhile
  }
}

Film::Film(const std::string& file, int width, int height, int frames_a_second,
           const std::optional<ColourCode>& colours)
    : file_(file), temporary_(file + kMark + std::to_string(::getpid())), messages_(temporary_ + kMessages) {
  const FileDescriptor messages(::open(messages_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  std::array<int, 2> ends{};
  if (!messages || ::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw RunError(file + ": cannot start ffmpeg: " + std::strerror(errno));
  }
  const FileDescriptor output(ends[0]);
  input_ = ends[1];
  // ffmpeg holds the lock for its life, which tells remove_abandoned_film() that it is at work.
  (void)::flock(messages.get(), LOCK_EX | LOCK_NB);
  // We handle Ctrl-C, and remove what ffmpeg has written so far.
  process_ = start_process(arguments(file, temporary_, width, height, frames_a_second, colours),
                           {.input = output.get(), .output = messages.get(), .errors = messages.get(), .apart = true});
  if (process_ == 0) {
    throw RunError(file + ": cannot start ffmpeg: it is not installed");
  }
}

Film::~Film() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    wait();
  }
  ::unlink(temporary_.c_str());
  ::unlink(messages_.c_str());
}

void Film::add(const PixelImage& picture) {
  const std::vector<std::uint8_t> opaque = picture.channels == 4 ? rgb_of(picture.bytes) : picture.bytes;
  if (!write_all(input_, std::as_bytes(std::span(opaque)))) {
    fail();
  }
}

void Film::finish() {
  ::close(std::exchange(input_, -1));
  if (!wait() || ::rename(temporary_.c_str(), file_.c_str()) != 0) {
    fail();
  }
}

// True when ffmpeg ended successfully.
bool Film::wait() {
  if (input_ >= 0) {
    ::close(std::exchange(input_, -1));
  }
  const pid_t process = std::exchange(process_, -1);
  return process > 0 && exit_code_of(process) == 0;
}

void Film::fail() {
  wait();
  std::ifstream said(messages_);
  std::string line;
  std::getline(said, line);
  throw RunError(file_ + ": ffmpeg could not make it: " + (line.empty() ? "it ended without a word" : line));
}

}  // namespace airlight::cli
