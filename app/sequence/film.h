#pragma once
// A film of 8-bit pictures, made by ffmpeg in a process of its own.

#include <sys/types.h>

#include <string>

#include "core/output/png.h"

namespace airlight::cli {

// Throws InputError: the name ends neither in .mp4 nor in .gif, the place cannot be written, ffmpeg is not on PATH.
void require_film(const std::string& file, const std::string& option);

// What killed runs have left of this film.
void remove_abandoned_film(const std::string& file) noexcept;

class Film {
 public:
  // The film appears under its name when finish() returns, and not at all otherwise. `colours`: of the pictures, as an
  // .mp4 says them; nothing leaves them unsaid.
  Film(const std::string& file, int width, int height, int frames_a_second, const std::optional<ColourCode>& colours);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  // A picture of that size, 8 bits. Throws RunError when ffmpeg has given up, with what it says.
  void add(const PixelImage& picture);
  void finish();

 private:
  [[noreturn]] void fail();
  bool wait();

  std::string file_;
  std::string temporary_;
  std::string messages_;  // a file that holds what ffmpeg says
  int input_ = -1;
  pid_t process_ = -1;
};

}  // namespace airlight::cli
