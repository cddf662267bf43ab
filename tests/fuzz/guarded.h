#pragma once
// What a case may throw, as its outcome.

#include <sys/resource.h>

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "app/composite/order.h"
#include "core/base/error.h"
#include "core/scene/printable.h"
#include "tests/fuzz/cases.h"
#include "tests/fuzz/random.h"

namespace airlight::fuzz {

// Of this process so far.
inline double processor_seconds() {
  struct rusage used = {};
  ::getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

// Why a message is none for people; empty: it is.
std::string fault_of_message(const std::string& message);

// Runs something that may throw errors meant for people. It returns the fault that it finds.
template <class Work>
Outcome guarded(Work work) {
  Outcome outcome;
  try {
    outcome.fault = work();
  } catch (const InputError& error) {
    outcome.refused = true;
    outcome.message = error.what();
    outcome.fault = fault_of_message(error.has_lines ? error.what() : printable(error.what()));
  } catch (const RunError& error) {
    outcome.refused = true;
    outcome.message = error.what();
  } catch (const std::exception& error) {
    outcome.fault = std::string("an exception that nobody expects: ") + error.what();
  }
  return outcome;
}

// Adds the outcome of a part of a case.
void add(Outcome& outcome, const Outcome& part);

// The fault of what `composite` writes by this order into a file of the folder.
std::string fault_of_composite(cli::CompositeOrder order, const std::filesystem::path& folder);

// Changes some bytes, most of them among the first.
void change_bytes(Random& random, std::vector<char>& bytes);

}  // namespace airlight::fuzz
