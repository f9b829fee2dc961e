#include <csignal>
#include <cstdlib>
#include <iostream>

#include "samples/reach/application.h"
#include "samples/reach/exit_code.h"
#include "samples/reach/interrupt.h"
#include "samples/reach/options.h"
#include "samples/reach/xr/check.h"

int main(int argc, char** argv) {
  using hrt::reach::ExitCode;
  hrt::reach::Options options;
  hrt::reach::note_interrupts();
  std::signal(SIGPIPE, SIG_IGN);  // a closed output is noticed where it is written
  // Set this variable to keep the loader's own report of a failure.
  setenv("XR_LOADER_DEBUG", "none", 0);
  try {
    if (const std::optional<int> code = hrt::reach::parse_command_line(argc, argv, options)) return *code;
    return static_cast<int>(hrt::reach::run(options));
  } catch (const hrt::reach::Failure& failure) {
    std::cerr << "hrt-reach: " << failure.what() << "\n";
    // A thread is inside the runtime, whose library must not be closed under it.
    if (failure.code() == ExitCode::runtime_blocked) {
      std::cout.flush();
      std::_Exit(static_cast<int>(failure.code()));
    }
    return static_cast<int>(failure.code());
  } catch (const hrt::reach::XrFailure& failure) {
    std::cerr << "hrt-reach: the OpenXR runtime failed: " << failure.what() << "\n";
    return static_cast<int>(ExitCode::runtime_failed);
  } catch (const std::exception& error) {
    std::cerr << "hrt-reach: " << error.what() << "\n";
    return static_cast<int>(ExitCode::internal);
  }
}
