#pragma once
// Reads a picture's tables back: statistics of those that must be sound, and the whole of all that are dumped.

#include <string>
#include <vector>

#include "core/gpu/executor.h"
#include "core/plan/plan.h"
#include "core/post/post.h"
#include "core/render/sky.h"

namespace airlight {

struct TableDump {
  std::string name;
  int width = 0;
  int height = 0;
  std::vector<float> rgba;  // row by row, first row first
  TableText text;
  std::string channels;  // as ImageDesc::channels
};

struct NamedStatistics {
  std::string name;  // of a table; or "picture"
  Statistics statistics;
};

class TableReads {
 public:
  TableReads(Plan& plan, const Sky& sky, bool dump);

  // To be called after a run of that plan.
  void take(const RunResult& result, std::vector<NamedStatistics>& statistics, std::vector<TableDump>& dumps) const;

 private:
  struct Read {
    ImageDesc image;
    BufferId contents;
    bool sound = false;  // must be sound
  };
  bool dump_;
  std::vector<Read> reads_;
};

}  // namespace airlight
