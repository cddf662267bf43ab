#include "core/render/table_reads.h"

#include <cstring>

namespace airlight {

TableReads::TableReads(Plan& plan, const Sky& sky, bool dump) {
  const auto add = [&](ImageId table, bool sound) {
    Read read{plan.images()[table.index], {}, {}};
    if (sound) {
      read.rows = add_table_statistics(plan, table);
    }
    if (dump) {
      read.contents = plan.add_readback(table);
    }
    reads_.push_back(std::move(read));
  };
  for (const ImageId table : sky.tables) {
    add(table, true);
  }
  for (const ImageId table : sky.more_tables) {
    if (dump) {
      add(table, false);
    }
  }
}

void TableReads::take(const RunResult& result, std::vector<NamedStatistics>& statistics,
                      std::vector<TableDump>& dumps) const {
  for (const Read& read : reads_) {
    const ImageDesc& image = read.image;
    if (read.rows) {
      statistics.push_back({image.name, summarize(result.contents(*read.rows), image.extent.width)});
    }
    if (read.contents) {
      const std::span<const std::byte> bytes = result.contents(*read.contents);
      std::vector<float> rgba(bytes.size() / sizeof(float));
      std::memcpy(rgba.data(), bytes.data(), bytes.size());
      dumps.push_back({image.name, static_cast<int>(image.extent.width), static_cast<int>(image.extent.height),
                       std::move(rgba), image.text ? image.text() : TableText{}, image.channels});
    }
  }
}

}  // namespace airlight
