#include "samples/reach/output/run_files.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include "samples/reach/base/exit_code.h"

namespace hrt::reach {

RunFiles::RunFiles(const Plugin& plugin, const TargetSet& targets, std::filesystem::path record,
                   std::filesystem::path plot)
    : plugin_(plugin), targets_(targets), record_(std::move(record)), plot_(std::move(plot)) {
  if (!plot_.empty()) {
    picture_.open(plot_);
    if (!picture_) fail_to_plot();
  }
  if (!record_.empty() && plugin.hrt_recording_start(targets.session, record_.c_str()) != HRT_OK)
    throw Failure(ExitCode::output, plugin.hrt_last_error());
}

void RunFiles::add(const TargetPair& pair, const ReachResult& result) {
  if (picture_.is_open() && plotted_.size() <= max_plotted) plotted_.push_back({pair, result});
}

void RunFiles::finish(const std::string& note) {
  write_plot(note);
  stop_recording();
}

void RunFiles::stop_recording() {
  const std::filesystem::path record = std::exchange(record_, {});
  if (record.empty()) return;
  hrt_recording_status status{.struct_size = sizeof status};
  plugin_.check(plugin_.hrt_recording_stop(targets_.session, &status));
  if (status.rows_lost > 0 || status.system_error != 0)
    throw Failure(ExitCode::output, record.string() + " is not complete: " +
                                        std::to_string(status.rows_lost) + " rows could not be written");
}

void RunFiles::write_plot(const std::string& note) {
  if (!picture_.is_open()) return;
  picture_ << svg_of(plotted_, targets_, note) << std::flush;
  if (!picture_) fail_to_plot();
  picture_.close();
}

void RunFiles::fail_to_plot() const {
  throw Failure(ExitCode::output, plot_.string() + " cannot be written: " + std::strerror(errno));
}

}  // namespace hrt::reach
