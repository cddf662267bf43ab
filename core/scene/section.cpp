#include "core/scene/section.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <vector>

#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/json_text.h"

namespace airlight {
namespace {

double default_number(const Rule& rule) {
  return number_from<double>(rule.default_text).value_or(0.0);
}

// The key of the object `prefix` that a rule belongs to: "phase" for "media[].phase.g" in "media[]"; empty: none.
std::string_view key_in(const Rule& rule, std::string_view prefix) {
  const std::string_view path = path_within(rule, prefix);
  return path.substr(0, path.find_first_of(".["));
}

std::vector<std::string> known_keys(std::string_view prefix) {
  std::set<std::string> keys;
  for (const Rule& rule : rules()) {
    if (const std::string_view key = key_in(rule, prefix); !key.empty()) {
      keys.emplace(key);
    }
  }
  return {keys.begin(), keys.end()};
}

// Other places of a key with this name: "/sun/elevation_deg" for one written a level too high.
std::string place_elsewhere(std::string_view key) {
  for (const Rule& rule : rules()) {
    if (rule.key.ends_with("." + std::string(key))) {
      return std::string(rule.key);
    }
  }
  return {};
}

}  // namespace

Section::Section(Problems& problems, CurveReader& curves, const PresetValue* value, const PresetValue& context,
                 std::string pointer, std::string prefix)
    : problems_(problems),
      curves_(curves),
      context_(value != nullptr ? value : &context),
      pointer_(std::move(pointer)),
      prefix_(std::move(prefix)) {
  if (value == nullptr) {
    return;
  }
  object_ = std::get_if<PresetObject>(&value->data);
  if (object_ == nullptr) {
    broken_ = true;
    problems_.add(*value, pointer_, quoted(*value) + " is not an object; expected {...}");
  }
}

Section Section::child(std::string_view key) const {
  const std::string prefix = prefix_.empty() ? std::string(key) : prefix_ + "." + std::string(key);
  Section section(problems_, curves_, find(key), *context_, pointer_to(key), prefix);
  section.broken_ = section.broken_ || broken_;
  return section;
}

Section Section::element(std::string_view key, const PresetArray& array, std::size_t index) const {
  return {problems_,
          curves_,
          &array[index],
          *context_,
          pointer_below(pointer_to(key), std::to_string(index)),
          (prefix_.empty() ? std::string(key) : prefix_ + "." + std::string(key)) + "[]"};
}

void Section::fill(void* owner, const void* id) const {
  bool any = false;
  for (const Rule& rule : rules()) {
    if (const std::string_view key = held_key(rule, prefix_, id, choice_); !key.empty()) {
      rule.member.take(*this, key, owner);
      any = true;
    }
  }
  if (!any) {
    throw std::logic_error("no rule of " + prefix_ + " has a member of this type");
  }
}

void Section::refuse_unknown_keys() const {
  if (object_ == nullptr) {
    return;
  }
  constexpr int kMostLookedUp = 100;  // a search for each of a million keys takes minutes
  int looked_up = 0;
  const std::vector<std::string> known = known_keys(prefix_);
  for (const auto& [key, value] : *object_) {
    if (std::ranges::find(known, key) != known.end()) {
      continue;
    }
    if (++looked_up > kMostLookedUp) {
      complain(key, value, "unknown key");
      continue;
    }
    std::string message = "unknown key" + did_you_mean(key, known);
    if (message.ends_with('?')) {
      complain(key, value, message);
      continue;
    }
    if (const std::string elsewhere = place_elsewhere(key); !elsewhere.empty()) {
      message += "; did you mean " + elsewhere + "?";
    } else {
      message += "; expected one of " + joined(known);
    }
    complain(key, value, message);
  }
}

void Section::choose(std::string_view choice) {
  choice_ = choice;
  if (object_ == nullptr) {
    return;
  }
  for (const auto& [key, value] : *object_) {
    if (find_rule(key) != nullptr) {
      continue;
    }
    const std::string name = prefix_.empty() ? key : prefix_ + "." + key;
    std::string others;
    for (const Rule& rule : rules()) {
      if (rule.key == name) {
        for (const std::string_view other : rule.only_for) {
          others += (others.empty() ? "" : ", ") + std::string(other);
        }
      }
    }
    if (!others.empty()) {
      complain(key, value, "not a key of " + json_string(choice) + "; it belongs to " + others + ": remove it");
    }
  }
}

const Rule* Section::find_rule(std::string_view key) const {
  const std::string name = prefix_.empty() ? std::string(key) : prefix_ + "." + std::string(key);
  const auto found = std::ranges::find_if(
      rules(), [&](const Rule& candidate) { return candidate.key == name && holds_for(candidate, choice_); });
  return found == rules().end() ? nullptr : &*found;
}

const Rule& Section::rule(std::string_view key) const {
  const Rule* found = find_rule(key);
  if (found == nullptr) {
    throw std::logic_error("no rule for " + prefix_ + "." + std::string(key));
  }
  return *found;
}

const PresetValue* Section::find(std::string_view key) const {
  if (object_ == nullptr) {
    return nullptr;
  }
  const auto found = object_->find(key);
  return found == object_->end() ? nullptr : &found->second;
}

std::string Section::pointer_to(std::string_view key) const {
  return pointer_below(pointer_, key);
}

Site Section::site(std::string_view key, const PresetValue& value) const {
  return {problems_, value, pointer_to(key), rule(key)};
}

void Section::complain(std::string_view key, const PresetValue& value, std::string_view message) const {
  problems_.add(value, pointer_to(key), message);
}

const PresetValue* Section::value_of(std::string_view key) const {
  const PresetValue* value = find(key);
  const Rule& expected = rule(key);
  if (value == nullptr && expected.required && !broken_) {
    const std::string owner = choice_.empty() || expected.only_for.empty() ? "" : " for " + json_string(choice_);
    problems_.add(*context_, pointer_to(key), "missing" + owner + "; expected " + expectation(expected));
  }
  return value;
}

template <class T>
T Section::read(std::string_view key, T fallback, void (*reader)(const Site&, T&)) const {
  if (const PresetValue* value = value_of(key)) {
    reader(site(key, *value), fallback);
  }
  return fallback;
}

double Section::number(std::string_view key) const {
  return read(key, default_number(rule(key)), read_number);
}

int Section::integer(std::string_view key) const {
  return read(key, static_cast<int>(default_number(rule(key))), read_integer);
}

bool Section::boolean(std::string_view key) const {
  return read(key, rule(key).default_text == "true", read_boolean);
}

std::string Section::text(std::string_view key) const {
  return read(key, std::string(rule(key).default_text), read_text);
}

Spectrum Section::spectrum(std::string_view key) const {
  const double fallback = default_number(rule(key));
  return read(key, Spectrum{fallback, fallback, fallback}, read_spectrum);
}

std::array<double, 2> Section::pair(std::string_view key) const {
  const double fallback = default_number(rule(key));
  return read(key, std::array<double, 2>{fallback, fallback}, read_pair);
}

const PresetArray* Section::list(std::string_view key, const PresetValue& value, std::string_view things) const {
  const auto* array = std::get_if<PresetArray>(&value.data);
  if (array != nullptr && rule(key).range.contains(static_cast<double>(array->size()))) {
    return array;
  }
  complain(key, value,
           quoted(value) + " is no list of " + std::string(things) + "; expected " + expectation(rule(key)));
  return nullptr;
}

std::optional<std::size_t> Section::choice(std::string_view key) const {
  const std::span<const std::string_view> choices = rule(key).choices;
  const auto fallback = static_cast<std::size_t>(std::ranges::find(choices, rule(key).default_text) - choices.begin());
  const PresetValue* value = value_of(key);
  if (value == nullptr) {
    return fallback < choices.size() ? std::optional(fallback) : std::nullopt;
  }
  std::size_t result = 0;
  return read_choice(site(key, *value), result) ? std::optional(result) : std::nullopt;
}

}  // namespace airlight
