#include "core/render/table_reads.h"

#include <utility>

#include "core/plan/bytes.h"
#include "core/post/host_post.h"

namespace airlight {

TableReads::TableReads(Plan& plan, const Sky& sky, bool dump) : dump_(dump) {
  const auto add = [&](ImageId table, bool sound) {
    reads_.push_back({plan.images()[table.index], plan.add_readback(table), sound});
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
    RadianceImage table{static_cast<int>(image.extent.width), static_cast<int>(image.extent.height),
                        values_of<float>(result.contents(read.contents))};
    if (read.sound) {
      statistics.push_back({image.name, table_statistics(table)});
    }
    if (dump_) {
      dumps.push_back({image.name, table.width, table.height, std::move(table.rgba),
                       image.text ? image.text() : TableText{}, image.channels});
    }
  }
}

}  // namespace airlight
