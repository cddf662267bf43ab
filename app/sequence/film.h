#pragma once
// A film of 8-bit pictures, made by ffmpeg in a process of its own.

#include <sys/types.h>

#include <string>

#include "core/output/png.h"

namespace airlight::cli {

// Throws InputError: the name ends neither in .mp4 nor in .gif, the file cannot be written, ffmpeg is not on PATH.
void require_film(const std::string& file, const std::string& option);

// Removes files that killed runs have left of this film.
void remove_abandoned_film(const std::string& file) noexcept;

class Film {
 public:
  // The film appears under its name when finish() returns, otherwise not at all. `colours`: of the pictures, written to
  // an .mp4; absent: not written.
  Film(const std::string& file, int width, int height, int frames_a_second, const std::optional<ColourCode>& colours);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  // Adds a picture of that size, 8 bits. Throws RunError with ffmpeg's message when ffmpeg has failed.
  void add(const PixelImage& picture);
  void finish();

 private:
  [[noreturn]] void fail();
  bool wait();

  std::string file_;
  std::string temporary_;
  std::string messages_;  // a file with ffmpeg's messages
  int input_ = -1;
  pid_t process_ = -1;
};

}  // namespace airlight::cli
