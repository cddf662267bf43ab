#pragma once
// Values that take long to make and that depend on a text alone, kept in a folder of the user's from one start to the
// next (kept_files.h). A later start of the same build of the program reads them back bit for bit. A first start reads
// what the build's renders left (driver_code.h).

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace airlight {

// From now on this process keeps values in the folder; in none at first, and where it is empty.
void keep_values_in(const std::filesystem::path& folder);

// The words of this key, made where they are not kept. `key` says all that they depend on. Any thread may ask.
std::vector<std::uint32_t> kept_words(const std::string& key, const std::function<std::vector<std::uint32_t>()>& make);

// Likewise of floats.
std::vector<float> kept_floats(const std::string& key, const std::function<std::vector<float>()>& make);

// Words with each run of equal ones as one: clear air and the inside of clouds are such runs.
std::vector<std::uint32_t> packed(std::span<const std::uint32_t> words);
// Its inverse; empty where the words are no such.
std::vector<std::uint32_t> unpacked(std::span<const std::uint32_t> words);

}  // namespace airlight
