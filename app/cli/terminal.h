#pragma once
// Standard output and standard error: colour only on a terminal, and no failure when a pipe is closed.

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>

namespace airlight::cli {

// True when the stream is a terminal, NO_COLOR is unset or empty and TERM is not "dumb".
bool colour_on_stdout();
bool colour_on_stderr();

bool stdout_is_terminal();

// Columns for text on standard output: the terminal's, 40 to 120; 80 where it goes elsewhere.
std::size_t line_width();

// Writes to standard output: requested results, which another program may read.
void print(std::string_view text);

// Flushes what was printed so far, for a reader that waits for each line.
void flush_stdout();

// Writes one or more lines to standard error, each prefixed with the tool's name. Control characters from names of
// files or foreign texts are escaped, and overlong messages are cut.
void complain(std::string_view lines);

// Writes an error's message: one line, however many line breaks names in it have, or the several lines of an
// InputError.
void complain(const std::exception& error);

// Writes to standard error without a prefix: progress, timings, notes for people.
void tell(std::string_view text);

// A write to a closed pipe fails instead of killing the process, so that files being written are finished or removed.
void ignore_broken_pipes();

// Flushes standard output. Throws RunError when something printed was lost, except into a pipe whose reader left.
void finish_stdout();

}  // namespace airlight::cli
