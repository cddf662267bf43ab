#pragma once
// Plain values to the bytes of a buffer, and back.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/huge_pages.h"
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

// The values that the bytes hold. The bytes need no alignment.
template <class T>
std::vector<T> values_of(std::span<const std::byte> bytes) {
  const std::size_t count = bytes.size() / sizeof(T);
  std::vector<T> values;
  values.reserve(count);
  prefer_huge_pages(values.data(), count * sizeof(T));
  if (reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(T) == 0) {
    const T* first = reinterpret_cast<const T*>(bytes.data());
    values.assign(first, first + count);  // written once: resize() would first fill it with zeros
  } else {
    values.resize(count);
    std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  }
  return values;
}

// A buffer with these contents.
inline BufferDesc filled_buffer(std::string name, std::vector<std::byte> contents, std::string key = {}) {
  const std::size_t size = contents.size();
  return {.name = std::move(name), .bytes = size, .contents = std::move(contents), .key = std::move(key)};
}

}  // namespace airlight
