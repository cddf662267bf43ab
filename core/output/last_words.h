#pragma once
// What a run says when a signal ends it: which of its work is whole.

#include <string>

namespace airlight {

// A file of this run that is whole: write_file() and FileInProgress tell.
void remember_whole(const std::string& file);

// Said in place of those, from now on: "3 of 8 maps are whole; the same command goes on from there".
void say_when_ended(const std::string& text);

// "SIGINT". Async-signal-safe.
const char* signal_name(int signal_number) noexcept;

// "airlight: stopped by SIGINT: ..." to standard error. Async-signal-safe.
void write_last_words(int signal_number) noexcept;

}  // namespace airlight
