#pragma once
// Reads one object of a preset by the table of rules. An absent value gets its default. A wrong value is reported and
// gets the default too, so that reading continues and finds the next problem.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/scene/preset.h"
#include "core/scene/problems.h"
#include "core/scene/rules.h"
#include "core/scene/scene.h"
#include "core/scene/value_reader.h"

namespace airlight {

class CurveReader;

class Section {
 public:
  // `curves`: collects those of the preset. `value`: the object, or null where the preset has none. `context`: the
  // nearest existing value, for messages. `prefix`: the rules' name of the object, e.g. "media[]"; "" is the preset
  // itself.
  Section(Problems& problems, CurveReader& curves, const PresetValue* value, const PresetValue& context,
          std::string pointer, std::string prefix);

  Section child(std::string_view key) const;
  // An element of the array `key`, an object.
  Section element(std::string_view key, const PresetArray& array, std::size_t index) const;

  // Reports every key without a rule here, with the nearest that has one.
  void refuse_unknown_keys() const;
  // From here on, of the rules for particular choices only those of `choice` apply; reports keys of the other choices.
  void choose(std::string_view choice);

  // Reads all keys here that rules keep in members of an Owner; of the rules for particular choices those of
  // choose()'s.
  template <class Owner>
  void fill(Owner& owner) const {
    fill(&owner, owner_id<Owner>());
  }

  double number(std::string_view key) const;
  int integer(std::string_view key) const;
  bool boolean(std::string_view key) const;
  std::string text(std::string_view key) const;
  Spectrum spectrum(std::string_view key) const;
  std::array<double, 2> pair(std::string_view key) const;
  // The array `key`; null, with a report, where it is no array or its length is outside its rule. `things`: its
  // elements.
  const PresetArray* list(std::string_view key, const PresetValue& value, std::string_view things) const;
  // The index of the choice in the rule's list; none when it is required and missing, or unknown.
  std::optional<std::size_t> choice(std::string_view key) const;

  const PresetValue* find(std::string_view key) const;
  const PresetObject* object() const { return object_; }
  const PresetValue& context() const { return *context_; }
  std::string pointer_to(std::string_view key) const;
  Problems& problems() const { return problems_; }
  CurveReader& curves() const { return curves_; }
  const Rule& rule(std::string_view key) const;
  // The value of `key`; reports a required key that is missing.
  const PresetValue* value_of(std::string_view key) const;
  Site site(std::string_view key, const PresetValue& value) const;
  void complain(std::string_view key, const PresetValue& value, std::string_view message) const;

 private:
  void fill(void* owner, const void* id) const;
  const Rule* find_rule(std::string_view key) const;
  template <class T>
  T read(std::string_view key, T fallback, void (*reader)(const Site&, T&)) const;

  Problems& problems_;
  CurveReader& curves_;
  const PresetValue* context_;
  const PresetObject* object_ = nullptr;
  std::string pointer_;
  std::string prefix_;
  std::string choice_;
  bool broken_ = false;  // it exists but is no object: reported once, and its keys do not count as missing
};

}  // namespace airlight
