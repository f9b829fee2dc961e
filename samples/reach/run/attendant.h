// Attends to the person in every frame: keys, and what the runtime does to the plate's place.
#pragma once

#include <exception>

#include "samples/reach/person/prompt.h"
#include "samples/reach/run/stage.h"

namespace hrt::reach {

/// Thrown out of a reach: the person wants another one.
struct OtherReach : std::exception {
  explicit OtherReach(bool previous) : is_previous(previous) {}
  const char* what() const noexcept override { return "another reach is wanted"; }
  bool is_previous;  ///< else the next
};

/// Of one session.
class Attendant {
 public:
  Attendant(Prompt& prompt, const Stage& stage) : prompt_(prompt), stage_(stage) {}

  /// From now on the fingers' places on the plate are known, and reaches can be left out or repeated.
  void plate_is_placed() { is_placed_ = true; }
  void reaches_begin() { in_reaches_ = true; }

  /// Obeys the keys that were pressed. Throws OtherReach, and Interrupted for the key that stops.
  void attend(XrTime time);

 private:
  void obey(char key, XrTime time);
  void say_where(XrTime time);

  Prompt& prompt_;
  const Stage& stage_;
  bool is_placed_ = false;
  bool in_reaches_ = false;
  int recentrings_ = 0;
};

}  // namespace hrt::reach
