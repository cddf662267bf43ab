#pragma once
// The limit that the user's shell puts on the process's memory.

#include <sys/resource.h>

#include <optional>
#include <string>

namespace airlight {

// MiB of addresses that the process may take (ulimit -v); none where there is no limit.
inline std::optional<unsigned long long> memory_limit() {
  struct rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
    return std::nullopt;
  }
  return limit.rlim_cur >> 20U;
}

// "; the limit on memory is 300 MiB (ulimit -v): raise it"; empty where there is none. Continues a message on memory.
inline std::string memory_limit_words() {
  const auto limit = memory_limit();
  return limit ? "; the limit on memory is " + std::to_string(*limit) + " MiB (ulimit -v): raise it" : std::string();
}

}  // namespace airlight
