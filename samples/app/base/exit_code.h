// Exit codes of hrt-reach.
#pragma once

#include <stdexcept>
#include <string>

namespace hrt::app {

enum class ExitCode : int {
  success = 0,           ///< the fingertip ended inside every target that can be held
  target_missed = 1,     ///< it ended outside of one; or a calibration ran out of slides, and was written
  usage = 2,             ///< the command line
  plugin = 3,            ///< the plugin cannot be opened, or refused a call
  scene = 4,             ///< the scene cannot be loaded, or has no such target
  no_runtime = 5,        ///< no OpenXR runtime answers
  runtime_lacks = 6,     ///< the runtime has no hand tracking, or no headless session
  runtime_failed = 7,    ///< the runtime failed, was lost too often, ended the session or kept it from running
  no_hand = 8,           ///< no fingertip came to the start, or a reach did not end, in time
  plate = 9,             ///< the plate's device failed
  output = 10,           ///< a file, or the standard output, cannot be written
  runtime_blocked = 11,  ///< a call into the runtime did not return in time
  registration = 12,     ///< the touches do not fit the plate's marks, or where the plate is is unknown
  calibration = 13,      ///< the slides do not determine the user; nothing was written
  internal = 70,         ///< a defect of hrt-reach, or no memory
  interrupted = 130,     ///< by SIGINT, SIGTERM or SIGHUP
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
