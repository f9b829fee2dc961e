// The files of a run: the plugin's recording and the picture of the reaches.
#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "samples/reach/base/plugin.h"
#include "samples/reach/output/svg_plot.h"

namespace hrt::reach {

/// Opens the files at once, so that a wrong name is known before the first reach. All throw Failure
/// (ExitCode::output).
class RunFiles {
 public:
  /// An empty name: no such file. `targets` outlives this.
  RunFiles(const Plugin& plugin, const TargetSet& targets, std::filesystem::path record,
           std::filesystem::path plot);

  void add(const TargetPair& pair, const ReachResult& result);
  /// Closes both. `note` stands below the picture. For the second time it does nothing.
  void finish(const std::string& note);

 private:
  void stop_recording();
  void write_plot(const std::string& note);
  [[noreturn]] void fail_to_plot() const;

  const Plugin& plugin_;
  const TargetSet& targets_;
  std::filesystem::path record_;
  std::filesystem::path plot_;
  std::ofstream picture_;
  std::vector<PlottedReach> plotted_;
};

}  // namespace hrt::reach
