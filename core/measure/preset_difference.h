#pragma once
// Differences between the presets in two pictures, which most often explain the differences between the pictures.

#include <string>
#include <string_view>
#include <vector>

namespace airlight::measure {

struct KeyDifference {
  std::string pointer;  // RFC 6901, "/media/0/scattering_per_km/2"
  std::string a;        // JSON text of the value; empty where the key is absent
  std::string b;
};

// Every leaf that differs, in the order of the pointers. Throws InputError, naming neither file, when a text is not
// JSON.
std::vector<KeyDifference> preset_difference(std::string_view a, std::string_view b);

}  // namespace airlight::measure
