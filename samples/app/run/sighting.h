// Record of the tracked fingers during a wait, and messages that explain why the wait failed.
#pragma once

#include <array>
#include <string>

#include "samples/app/run/stage.h"

namespace hrt::app {

/// Record of both hands' index fingertips since construction.
class Sightings {
 public:
  explicit Sightings(const Point& start_m) : start_m_(start_m) {}

  void see(Hand hand, const Fingertip& tip);

  /// Message: why no finger rested at the start, and what to do.
  std::string why_not_begun(const Stage& stage) const;
  /// Message: why a reach did not end, and what to do.
  std::string why_not_ended(const Stage& stage, const TargetPair& pair) const;
  /// Message: why no finger came to rest on a mark, and what to do.
  std::string why_no_touch(const Stage& stage) const;
  /// Message: present position of the first tracked finger of the hands in use. If the plate is not placed yet, only
  /// whether it is tracked.
  std::string where(const Stage& stage, bool plate_is_placed = true) const;

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
  Hand best_of(const Stage& stage) const;
  std::string tracked_in_words(Hand hand) const;
  std::string not_tracked(const Stage& stage) const;
  std::string place_in_words(const Stage& stage, const Point& tip_m) const;

  Point start_m_;
  std::array<Seen, 2> seen_;
};

/// Waits until one of the hands rests its fingertip at the start, and returns that hand. Throws Failure
/// (ExitCode::no_hand) after the stage's time limit.
Hand await_finger_at_start(Stage& stage);

}  // namespace hrt::app
