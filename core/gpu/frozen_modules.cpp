#include "core/gpu/frozen_modules.h"

#include "core/gpu/ready_modules.h"
#include "core/gpu/specialize.h"

namespace airlight {

Digest module_key(std::string_view spirv_digest, std::span<const ConstantValue> constants) {
  std::string text = specializer_version() + "\n" + std::string(spirv_digest);
  for (const ConstantValue& constant : constants) {
    text += "\n" + std::to_string(constant.id) + "=" + std::to_string(constant.value);
  }
  return sha256(std::as_bytes(std::span(text)));
}

FrozenModules::Words FrozenModules::get(const EmbeddedShader& shader, std::span<const ConstantValue> constants,
                                        bool& made) const {
  made = false;
  const Digest key = module_key(shader.digest, constants);
  for (const ReadyModule& ready : ready_modules()) {
    if (ready.key == key) return Words(ready.spirv);
  }
  if (std::vector<std::uint32_t> kept = cache_.find(key); !kept.empty()) return Words(std::move(kept));
  std::vector<std::uint32_t> words = specialize(shader.name, shader.spirv, constants);
  cache_.keep(key, words);
  made = true;
  return Words(std::move(words));
}

}  // namespace airlight
