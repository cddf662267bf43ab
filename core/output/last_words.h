#pragma once
// The message of a run that a signal ends: which of its work is whole.

#include <string>

namespace airlight {

// Notes a whole file of this run; write_file() and FileInProgress call it.
void remember_whole(const std::string& file);

// Replaces the list of whole files by this text from now on: "3 of 8 maps are whole; the same command goes on from
// there".
void say_when_ended(const std::string& text);

// "SIGINT". Async-signal-safe.
const char* signal_name(int signal_number) noexcept;

// "airlight: stopped by SIGINT: ..." to standard error. Async-signal-safe.
void write_last_words(int signal_number) noexcept;

}  // namespace airlight
