#include "core/render/table_reads.h"

#include "core/plan/bytes.h"

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
      dumps.push_back({image.name, static_cast<int>(image.extent.width), static_cast<int>(image.extent.height),
                       values_of<float>(result.contents(*read.contents)), image.text ? image.text() : TableText{},
                       image.channels});
    }
  }
}

}  // namespace airlight
