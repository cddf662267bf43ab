#include "app/sequence/film.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/output/atomic_file.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

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

std::vector<std::string> arguments(const std::string& file, const std::string& target, int width, int height,
                                   int frames_a_second) {
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
  const std::vector<std::string> mp4 = {"-vf",       "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                        "-c:v",      "libx264",
                                        "-crf",      "18",
                                        "-pix_fmt",  "yuv420p",
                                        "-movflags", "+faststart",
                                        "-f",        "mp4"};
  const std::vector<std::string> gif = {"-filter_complex", "[0:v]split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f",
                                        "gif"};
  const std::vector<std::string>& format = fs::path(file).extension() == ".gif" ? gif : mp4;
  words.insert(words.end(), format.begin(), format.end());
  words.push_back("file:" + target);
  return words;
}

// Between fork and exec of a process with threads nothing may be allocated.
[[noreturn]] void become(char* const* words, int input, int messages) {
  ::setpgid(0, 0);  // Ctrl-C is ours to handle: what ffmpeg has made so far is removed
  ::dup2(input, STDIN_FILENO);
  ::dup2(messages, STDOUT_FILENO);
  ::dup2(messages, STDERR_FILENO);
  std::signal(SIGPIPE, SIG_DFL);
  ::execvp(words[0], words);
  ::_exit(127);
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

Film::Film(const std::string& file, int width, int height, int frames_a_second)
    : file_(file), temporary_(file + ".part-" + std::to_string(::getpid())), messages_(temporary_ + ".txt") {
  std::array<int, 2> ends{};
  const int messages = ::open(messages_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (messages < 0 || ::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw RunError(file + ": cannot start ffmpeg: " + std::strerror(errno));
  }
  std::vector<std::string> words = arguments(file, temporary_, width, height, frames_a_second);
  std::vector<char*> argv;
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    become(argv.data(), ends[0], messages);
  }
  ::close(ends[0]);
  ::close(messages);
  input_ = ends[1];
  if (process_ < 0) {
    throw RunError(file + ": cannot start ffmpeg: " + std::strerror(errno));
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
  std::vector<std::uint8_t> rgb;
  const std::uint8_t* at = picture.bytes.data();
  std::size_t left = picture.bytes.size();
  if (picture.channels == 4) {
    for (std::size_t i = 0; i < picture.bytes.size(); i += 4) {
      rgb.insert(rgb.end(), at + i, at + i + 3);
    }
    at = rgb.data();
    left = rgb.size();
  }
  while (left > 0) {
    const ssize_t count = ::write(input_, at, left);
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count < 0) {
      fail();
    }
    at += count;
    left -= static_cast<std::size_t>(count);
  }
}

void Film::finish() {
  ::close(std::exchange(input_, -1));
  if (!wait() || ::rename(temporary_.c_str(), file_.c_str()) != 0) {
    fail();
  }
}

// True when ffmpeg has come to a good end.
bool Film::wait() {
  if (input_ >= 0) {
    ::close(std::exchange(input_, -1));
  }
  int status = -1;
  const pid_t process = std::exchange(process_, -1);
  while (process > 0 && ::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void Film::fail() {
  wait();
  std::ifstream said(messages_);
  std::string line;
  std::getline(said, line);
  throw RunError(file_ + ": ffmpeg could not make it: " + (line.empty() ? "it ended without a word" : line));
}

}  // namespace airlight::cli
