#include "core/output/last_words.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <mutex>

#include "core/scene/printable.h"

namespace airlight {
namespace {

// Texts stand in fixed storage, since a signal handler may read at any time. The newest is published by its number, and
// a text is overwritten only after several newer ones.
constexpr std::size_t kLongest = 1024;
std::array<std::array<char, kLongest>, 8> last_texts;
std::atomic<unsigned> newest = 0;  // 0: none
static_assert(std::atomic<unsigned>::is_always_lock_free, "a signal handler reads it");

std::mutex writing;
unsigned whole_files = 0;
bool has_own_words = false;  // a command's own words are better than a count of whole files

void publish(const std::string& text) {
  const unsigned number = newest.load() + 1;
  std::array<char, kLongest>& place = last_texts[number % last_texts.size()];
  const std::size_t length = std::min(text.size(), kLongest - 1);
  std::memcpy(place.data(), text.data(), length);
  place[length] = '\0';
  newest.store(number);
}

void write_text(const char* text) {
  (void)!::write(STDERR_FILENO, text, std::strlen(text));
}

std::string files_line(const std::string& last) {
  const std::string name = printable(shortened(last, kLongest / 2));
  return whole_files == 1 ? name + " is whole, nothing else was written"
                          : std::to_string(whole_files) + " files are whole, " + name + " the last";
}

}  // namespace

const char* signal_name(int signal_number) noexcept {
  switch (signal_number) {
    case SIGINT:
      return "SIGINT";
    case SIGTERM:
      return "SIGTERM";
    case SIGHUP:
      return "SIGHUP";
    default:
      return "a signal";
  }
}

void remember_whole(const std::string& file) {
  const std::lock_guard lock(writing);
  ++whole_files;
  if (!has_own_words) {
    publish(files_line(file));
  }
}

void say_when_ended(const std::string& text) {
  const std::lock_guard lock(writing);
  has_own_words = true;
  publish(text);
}

void write_last_words(int signal_number) noexcept {
  const unsigned number = newest.load();
  const char* text = last_texts[number % last_texts.size()].data();
  // Clears a line of progress and the terminal's own ^C.
  write_text(::isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "");
  write_text("airlight: stopped by ");
  write_text(signal_name(signal_number));
  write_text(": ");
  write_text(number == 0 || *text == '\0' ? "no file was written" : text);
  write_text("\n");
}

}  // namespace airlight
