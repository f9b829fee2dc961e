// What was seen of the fingers while something was awaited of them, in words that help.
#pragma once

#include <array>
#include <string>

#include "samples/app/run/stage.h"

namespace hrt::app {

/// Both hands' index fingertips since it was made.
class Sightings {
 public:
  explicit Sightings(const Point& start_m) : start_m_(start_m) {}

  void see(Hand hand, const Fingertip& tip);

  /// Why no finger rested at the start, and what to do.
  std::string why_not_begun(const Stage& stage) const;
  /// Why a reach did not end, and what to do.
  std::string why_not_ended(const Stage& stage, const TargetPair& pair) const;
  /// Why no finger came to rest on a mark, and what to do.
  std::string why_no_touch(const Stage& stage) const;
  /// Where the finger is now: of the hands in use, the first that is tracked. Without a place of the plate:
  /// whether.
  std::string where(const Stage& stage, bool plate_is_placed = true) const;

 private:
  struct Seen {
    int frames = 0;
    int tracked = 0;
    bool tracked_now = false;
    Point last_m{};
    double nearest_m = 0.0;   // to the start, along the plate
    double farthest_m = 0.0;  // from it
  };

  const Seen& of(Hand hand) const { return seen_[static_cast<std::size_t>(hand)]; }
  Hand best_of(const Stage& stage) const;
  std::string tracked_in_words(Hand hand) const;
  std::string not_tracked(const Stage& stage) const;
  std::string place_in_words(const Stage& stage, const Point& tip_m) const;

  Point start_m_;
  std::array<Seen, 2> seen_;
};

/// Waits until one of the hands rests its fingertip at the start; returns that hand. Throws Failure
/// (ExitCode::no_hand) after the stage's time limit.
Hand await_finger_at_start(Stage& stage);

}  // namespace hrt::app
