#include "app/commands/gnuplot.h"

#include <functional>
#include <optional>

#include "app/cli/process.h"
#include "core/error.h"

namespace airlight::cli {

std::vector<std::string> plot(const std::string& command, const std::filesystem::path& folder,
                              const std::string& script, const std::string& prefix,
                              const std::vector<std::string>& endings) {
  namespace fs = std::filesystem;
  const std::string part = "plot-" + std::to_string(std::hash<std::string>{}(folder.string())) + ".part" + prefix;
  const std::optional<ProcessResult> run = run_process(folder, {"gnuplot", "-e", "out='" + part + "'", script});
  if (!run) {
    throw RunError(command +
                   ": there is no gnuplot on this machine, so no picture is drawn; on Debian install it with 'apt-get "
                   "install gnuplot-nox', then run 'gnuplot " +
                   script + "' in " + folder.string());
  }
  std::vector<std::string> written;
  for (const std::string& ending : endings) {
    std::error_code error;
    if (run->exit_code == 0) {
      const fs::path file = folder / (prefix + ending);
      fs::rename(folder / (part + ending), file, error);
      if (!error) {
        written.push_back(file.string());
      }
    }
    fs::remove(folder / (part + ending), error);
  }
  if (written.size() != endings.size()) {
    const std::string said = run->errors.substr(0, run->errors.find_last_not_of(" \n") + 1);
    throw RunError(command + ": gnuplot could not draw " + (folder / script).string() + ": " +
                   (said.empty() ? "it wrote no picture" : said.substr(said.find_last_of('\n') + 1)));
  }
  return written;
}

}  // namespace airlight::cli
