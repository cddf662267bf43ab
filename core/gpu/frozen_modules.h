#pragma once
// Source of a pipeline's frozen module: the program itself, the user's folder, or the optimiser.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/gpu/embedded_shaders.h"
#include "core/gpu/kept_files.h"
#include "core/gpu/match.h"

namespace airlight {

// Names a shader's module, the values of its constants and the optimiser's version.
Digest module_key(std::string_view spirv_digest, std::span<const ConstantValue> constants);

class FrozenModules {
 public:
  explicit FrozenModules(std::filesystem::path folder) : cache_(std::move(folder), ".module") {}

  // A module's words, either the program's or owned here.
  class Words {
   public:
    explicit Words(std::span<const std::uint32_t> embedded) : words_(embedded) {}
    explicit Words(std::vector<std::uint32_t> owned) : owned_(std::move(owned)), words_(owned_) {}
    Words(Words&&) = default;
    Words& operator=(Words&&) = delete;
    std::span<const std::uint32_t> get() const { return words_; }

   private:
    std::vector<std::uint32_t> owned_;
    std::span<const std::uint32_t> words_;
  };

  // May be called from any thread. `made`: whether the optimiser had to make the module.
  Words get(const EmbeddedShader& shader, std::span<const ConstantValue> constants, bool& made) const;
  // To be called after modules were made.
  void trim() const { cache_.trim(); }

 private:
  KeptFiles cache_;
};

}  // namespace airlight
