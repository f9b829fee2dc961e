// Exit codes of hrt-reach.
#pragma once

#include <stdexcept>
#include <string>

namespace hrt::app {

// Name, number, and what --help says.
// clang-format off
#define HRT_EXIT_CODES(X)                                                                             \
  X(success,         0, "every reach with a feasible gap ended at its target")                        \
  X(target_missed,   1, "a reach missed; or a calibration reached its limit of slides (its profile was written)") \
  X(usage,           2, "the command line is wrong")                                                  \
  X(plugin,          3, "the plugin cannot be opened, or refused a call")                             \
  X(scene,           4, "the scene cannot be loaded, or has no such target")                          \
  X(no_runtime,      5, "no OpenXR runtime (XR_RUNTIME_JSON names its manifest), or one that does not start") \
  X(runtime_lacks,   6, "the runtime has no headless sessions or no hand tracking")                   \
  X(runtime_failed,  7, "the runtime failed, was lost too often, ended the session, or kept it from running") \
  X(no_hand,         8, "a reach did not begin or end in time (the other reaches are in the summary), or a set-up was not done") \
  X(plate,           9, "the plate's device failed")                                                  \
  X(output,         10, "a file, or the standard output, cannot be written")                          \
  X(runtime_blocked, 11, "the runtime did not return from a call in time")                            \
  X(registration,   12, "the touches do not fit the plate's marks, or the plate's pose is unknown")   \
  X(calibration,    13, "the slides of a calibration do not determine the user; nothing was written") \
  X(tracker,        14, "the touch frame cannot be opened, or is gone")                                 \
  X(internal,       70, "anything else")                                                              \
  X(interrupted,   130, "interrupted (Ctrl-C, SIGTERM, SIGHUP)")
// clang-format on

enum class ExitCode : int {
#define HRT_EXIT_CODE(name, number, words) name = number,
  HRT_EXIT_CODES(HRT_EXIT_CODE)
#undef HRT_EXIT_CODE
};

/// Ends the program with one sentence on stderr and an exit code of its own.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace hrt::app
