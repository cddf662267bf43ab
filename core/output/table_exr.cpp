#include "core/output/table_exr.h"

#include <utility>
#include <vector>

#include "core/output/exr.h"

namespace airlight {

void write_table_exr(const std::filesystem::path& file, const Table& table,
                     const std::optional<Provenance>& provenance) {
  ExrOptions options;
  options.half = false;
  options.provenance = provenance;
  const TableText& text = table.text;
  options.strings = {{"airlight:quantity", text.quantity}, {"airlight:unit", text.unit}};
  for (const TableAxis& axis : text.axes) {
    std::string& lines = options.strings["airlight:axis:" + axis.along];
    lines += (lines.empty() ? "" : "\n") + axis.name + " [" + axis.unit + "]: " + axis.mapping;
  }
  for (const auto& [key, lines] : {std::pair{"airlight:constants", &text.constants},
                                   {"airlight:decode", &text.decode},
                                   {"airlight:channels", &table.channels}}) {
    if (!lines->empty()) {
      options.strings[key] = *lines;
    }
  }
  std::vector<ExrChannel> channels;
  for (std::size_t c = 0; c < 4; ++c) {
    channels.push_back({std::string(1, "RGBA"[c]), table.rgba + c, 4});
  }
  write_exr(file, table.width, table.height, channels, options);
}

}  // namespace airlight
