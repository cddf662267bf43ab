#pragma once
// Plain values to the bytes of a buffer, and back.

#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/plan/plan.h"

namespace airlight {

// The bytes of a vector, an array or a span.
template <class Values>
std::vector<std::byte> bytes_of(const Values& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {bytes.begin(), bytes.end()};
}

// The bytes of one structure.
template <class T>
std::vector<std::byte> bytes_of_one(const T& value) {
  return bytes_of(std::span(&value, 1));
}

template <class T>
std::vector<T> values_of(std::span<const std::byte> bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) {
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  }
  return values;
}

// A buffer with these contents.
inline BufferDesc filled_buffer(std::string name, std::vector<std::byte> contents, std::string key = {}) {
  const std::size_t size = contents.size();
  return {.name = std::move(name), .bytes = size, .contents = std::move(contents), .key = std::move(key)};
}

}  // namespace airlight
