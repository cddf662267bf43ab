#pragma once
// Where a scene keeps the value of a rule: in a member of a structure of scene.h, its owner. Section::fill() reads and
// to_json() writes all members of an owner by a loop over the rules. In a scene angles are radians and lengths km: what
// a rule has in "degrees" or "m" is converted.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/member.h"

namespace airlight {

class Section;
struct Rule;
struct SpectralValue;

struct Member {
  const void* owner = nullptr;  // its type, see owner_id(); null: no loop reads or writes the value
  void (*take)(const Section& section, std::string_view key, void* owner) = nullptr;
  std::string (*json)(const Rule& rule, const void* owner) = nullptr;  // empty: the value is not written
};

// Read the value of `key`, the rule's default where it is absent.
void take(const Section& section, std::string_view key, double& out);
void take(const Section& section, std::string_view key, int& out);
void take(const Section& section, std::string_view key, bool& out);
void take(const Section& section, std::string_view key, std::string& out);
void take(const Section& section, std::string_view key, std::array<double, 2>& out);
void take(const Section& section, std::string_view key, SpectralValue& out);
// None where the value is absent and the rule has no default.
void take(const Section& section, std::string_view key, std::optional<double>& out);
void take_choice(const Section& section, std::string_view key, std::size_t& out);

template <class Enum>
requires std::is_enum_v<Enum>
void take(const Section& section, std::string_view key, Enum& out) {
  std::size_t index = 0;
  take_choice(section, key, index);
  out = static_cast<Enum>(index);
}

// The values as a preset has them.
std::string json_of(const Rule& rule, double value);
std::string json_of(const Rule& rule, int value);
std::string json_of(const Rule& rule, bool value);
std::string json_of(const Rule& rule, const std::string& value);
std::string json_of(const Rule& rule, const std::array<double, 2>& value);
std::string json_of(const SpectralValue& value);
inline std::string json_of(const Rule& /*rule*/, const SpectralValue& value) {
  return json_of(value);
}
std::string json_of(const Rule& rule, const std::optional<double>& value);
std::string json_of_choice(const Rule& rule, std::size_t index);

template <class Enum>
requires std::is_enum_v<Enum> std::string json_of(const Rule& rule, Enum value) {
  return json_of_choice(rule, static_cast<std::size_t>(value));
}

// Whether the value is written only where it is not what a new owner has.
bool is_quiet(const Rule& rule);

template <class Owner>
inline constexpr char kOwnerTag = 0;

template <class Owner>
constexpr const void* owner_id() {
  return &kOwnerTag<Owner>;
}

template <class Owner, class T>
Owner owner_of(MemberOf<Owner, T> pointer);

template <auto pointer>
constexpr Member member() {
  if constexpr (std::is_null_pointer_v<decltype(pointer)>) {
    return {};
  } else {
    using Owner = decltype(owner_of(pointer));
    return {.owner = owner_id<Owner>(),
            .take = [](const Section& section, std::string_view key,
                       void* owner) { airlight::take(section, key, static_cast<Owner*>(owner)->*pointer); },
            .json =
                [](const Rule& rule, const void* owner) {
                  const auto& value = static_cast<const Owner*>(owner)->*pointer;
                  return is_quiet(rule) && value == Owner{}.*pointer ? std::string() : json_of(rule, value);
                }};
  }
}

}  // namespace airlight
