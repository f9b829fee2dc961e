// Exit codes of hrt-reach, which are also the kinds of failures in samples/app.
#pragma once

#include <stdexcept>
#include <string>

namespace hrt::app {

// Name, number, and description in --help.
// clang-format off
#define HRT_EXIT_CODES(X)                                                                             \
  X(success,         0, "every reach with a feasible gap ended at its target, or calibration or measurement succeeded") \
  X(target_missed,   1, "a reach missed its target, or a calibration reached its limit of slides (and wrote its profile)") \
  X(usage,           2, "the command line is wrong") \
  X(plugin,          3, "the plugin cannot be opened, the profile is invalid, or another call of the plugin failed") \
  X(scene,           4, "the scene cannot be loaded, lacks a virtual target (--target), or start or marks do not suit a set-up") \
  X(no_runtime,      5, "there is no OpenXR runtime (XR_RUNTIME_JSON names its manifest), or it does not start") \
  X(runtime_lacks,   6, "the runtime has no headless sessions, no hand tracking or no headset") \
  X(runtime_failed,  7, "the runtime failed, was lost too often, ended the session, or did not start or stop it in time") \
  X(no_hand,         8, "a reach did not begin or end in time, or a set-up was not completed") \
  X(plate,           9, "the plate cannot be opened or simulated, or it failed") \
  X(output,         10, "a file, or the standard output, cannot be written") \
  X(runtime_blocked, 11, "the runtime did not return from a call in time") \
  X(registration,   12, "touches do not fit, the pose of the plate is unknown, or a file of marks or poses is invalid") \
  X(calibration,    13, "the slides of a calibration do not determine the user's parameters; nothing was written") \
  X(tracker,        14, "the touch frame cannot be opened or used, or was unplugged") \
  X(internal,       70, "any other error") \
  X(interrupted,   130, "interrupted (Ctrl-C, SIGTERM, SIGHUP)")
// clang-format on

enum class ExitCode : int {
#define HRT_EXIT_CODE(name, number, words) name = number,
  HRT_EXIT_CODES(HRT_EXIT_CODE)
#undef HRT_EXIT_CODE
};

/// Error that ends the program, unless a caller handles it. hrt-reach prints its sentence and returns its exit code.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace hrt::app
