#include <csignal>
#include <cstdlib>
#include <iostream>

#include "samples/reach/application.h"
#include "samples/reach/base/exit_code.h"
#include "samples/reach/base/interrupt.h"
#include "samples/reach/run/options.h"
#include "samples/reach/xr/check.h"

namespace hrt::reach {
namespace {

int run_from(int argc, char** argv) {
  Options options;
  try {
    if (const std::optional<int> code = parse_command_line(argc, argv, options)) return *code;
    watch_runtime(options.runtime_limit);
    return static_cast<int>(run(options));
  } catch (const Failure& failure) {
    std::cerr << "hrt-reach: " << failure.what() << "\n";
    return static_cast<int>(failure.code());
  } catch (const XrFailure& failure) {
    std::cerr << "hrt-reach: the OpenXR runtime failed: " << failure.what() << "\n";
    return static_cast<int>(ExitCode::runtime_failed);
  } catch (const std::exception& error) {
    std::cerr << "hrt-reach: " << error.what() << "\n";
    return static_cast<int>(ExitCode::internal);
  }
}

}  // namespace
}  // namespace hrt::reach

int main(int argc, char** argv) {
  hrt::reach::note_interrupts();
  std::signal(SIGPIPE, SIG_IGN);  // a closed output is noticed where it is written
  // Set this variable to keep the loader's own report of a failure.
  setenv("XR_LOADER_DEBUG", "none", 0);
  const int code = hrt::reach::run_from(argc, argv);
  hrt::reach::expect_exit(code);
  return code;
}
