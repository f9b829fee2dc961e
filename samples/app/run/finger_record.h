#pragma once

#include <array>
#include <string>

#include "samples/app/run/run_context.h"

namespace hrt::app {

/// Records the tracked fingers while the program waits for the user, and explains to the user why a wait failed.
class FingerRecord {
 public:
  explicit FingerRecord(const Point& start_m) : start_m_(start_m) {}

  void add(Hand hand, const Fingertip& tip);

  // ---- Texts for the user.

  /// Why no finger rested at the start, and what to do.
  std::string why_not_begun(const RunContext& context) const;
  /// Why a reach did not end, and what to do.
  std::string why_not_ended(const RunContext& context, const TargetPair& pair) const;
  /// Why no finger came to rest on a mark, and what to do.
  std::string why_no_touch(const RunContext& context) const;
  /// Position of the first tracked finger of the hands in use. If `plate_is_placed` is false, because the plate's pose
  /// is unknown, the text only says whether a finger is tracked.
  std::string where(const RunContext& context, bool plate_is_placed = true) const;

 private:
  struct Seen {
    int frames = 0;
    int tracked = 0;
    bool tracked_now = false;
    Point last_m{};
    double nearest_m = 0.0;   // smallest distance to the start, along the plate
    double farthest_m = 0.0;  // largest distance to the start
  };

  const Seen& of(Hand hand) const { return seen_[static_cast<std::size_t>(hand)]; }
  Hand best_of(const RunContext& context) const;
  std::string tracked_in_words(const RunContext& context, Hand hand) const;
  std::string not_tracked(const RunContext& context) const;
  std::string position_in_words(const RunContext& context, const Point& tip_m) const;

  Point start_m_;
  std::array<Seen, 2> seen_;
};

/// Waits until the fingertip of a hand has been at the start for settle_ns (0.3 s), and returns this hand. Throws
/// Failure (ExitCode::no_hand) after the time limit of the context.
Hand await_finger_at_start(RunContext& context);

}  // namespace hrt::app
