#pragma once
// Tables as EXR files that describe their texels.

#include <filesystem>
#include <optional>
#include <string>

#include "core/output/provenance.h"
#include "core/plan/table_text.h"

namespace airlight {

// A table of four floats a texel as a float EXR. The attributes are `airlight:quantity`, `airlight:unit`, for each axis
// `airlight:axis:ALONG` ("NAME [UNIT]: MAPPING", a line each where several axes share one direction),
// `airlight:constants`, `airlight:decode` and, where the channels are not the preset's, `airlight:channels`.
struct Table {
  int width = 0;
  int height = 0;
  const float* rgba = nullptr;
  TableText text;
  std::string channels;
};
void write_table_exr(const std::filesystem::path& file, const Table& table,
                     const std::optional<Provenance>& provenance);

}  // namespace airlight
