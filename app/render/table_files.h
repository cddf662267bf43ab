#pragma once
// Tables on disk: the numbers as EXR with named axes, and a picture of each for people.

#include <filesystem>
#include <string>
#include <vector>

#include "core/output/provenance.h"
#include "core/render/render.h"

namespace airlight::cli {

// Throws InputError unless the folder exists and can be written, or can be made in a folder that exists.
void require_folder(const std::filesystem::path& folder);

// Makes the folder unless it is there. Throws InputError as above. A folder that it made goes with it if nothing was
// written there.
class MadeFolder {
 public:
  explicit MadeFolder(const std::filesystem::path& folder);
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

 private:
  std::filesystem::path folder_;
  bool made_ = false;
};

// DIR/NAME.exr and DIR/NAME.png of each table; makes the folder if need be. Returns the files written.
std::vector<std::string> write_tables(const std::filesystem::path& folder, const std::vector<TableDump>& tables,
                                      const Provenance& provenance);

}  // namespace airlight::cli
