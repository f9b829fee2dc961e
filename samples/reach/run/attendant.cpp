#include "samples/reach/run/attendant.h"

#include "samples/reach/base/interrupt.h"
#include "samples/reach/run/sighting.h"

namespace hrt::reach {

void Attendant::attend(XrTime time) {
  if (stage_.session.recentrings() != recentrings_) {
    recentrings_ = stage_.session.recentrings();
    prompt_.say("The runtime moved its space, as when the view is recentred. The plate keeps its place in the room.");
  }
  while (const std::optional<char> key = prompt_.key()) obey(*key, time);
}

void Attendant::obey(char key, XrTime time) {
  switch (key) {
    case 'r':
      return prompt_.repeat();
    case 'w':
      return say_where(time);
    case 'h':
    case '?':
      return prompt_.say(keys_in_words);
    case 'q':
      throw Interrupted();
    case 'n':
    case 'b':
      if (in_reaches_) throw OtherReach(key == 'b');
      return prompt_.say("That key is for reaches.");
    default:
      return;
  }
}

void Attendant::say_where(XrTime time) {
  Sightings now(stage_.targets.start_m);
  for (const Hand hand : {Hand::left, Hand::right}) now.see(hand, locate(stage_, hand, time));
  prompt_.say(now.where(stage_, is_placed_));
}

}  // namespace hrt::reach
