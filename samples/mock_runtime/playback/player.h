// Gives an application in one session what a recorded one was given: what has a time, by the nearest one;
// frames and times of the machine's clock, in order; events, after the same calls and as many frames.
#pragma once

#include <map>
#include <memory>

#include "samples/mock_runtime/playback/recording.h"

namespace hrt::mock {

class Player {
 public:
  /// Session `number`, from 1; beyond the last one, that one again.
  Player(std::shared_ptr<const Recording> recording, std::uint64_t number);

  /// The application changes the session's state. False if the recorded one did not do so at this point: its
  /// further events do not come then, and the session behaves by itself.
  bool follow(StateCall call);
  /// False if the recorded session's events give no state at all, nor do any come later.
  bool has_states() const { return has_states_; }
  /// The events that have come by now, with this session's handle.
  std::vector<XrEventDataBuffer> take_events(XrSession session);

  /// When the next frame begins: `now` for the first, later ones as far from it as they were. Nothing if no
  /// frames are recorded.
  std::optional<XrTime> next_frame_start(XrTime now);
  /// The next frame; after the last recorded one, further ones at its pace.
  RecordedFrame next_frame();
  /// The next time of the machine's clock; nothing if there is none.
  std::optional<XrTime> next_converted();

  const std::optional<std::vector<XrReferenceSpaceType>>& spaces() const { return session_.spaces; }

  RecordedJoints joints(XrHandEXT hand, const SpaceName& base, XrTime time);
  RecordedLocation location(const SpaceName& space, const SpaceName& base, XrTime time);
  RecordedViews views(const SpaceName& base, XrTime time);
  std::optional<double> plate_deg(XrTime time);
  std::optional<RecordedTruth> truth(XrHandEXT hand);

 private:
  // Where a stream was last read, and for which time.
  struct Cursor {
    XrTime asked;
    std::ptrdiff_t index;  // of what was given for the same time
  };
  XrDuration pace() const;  // of further frames
  template <typename Value>
  const Value& read(const Stream<Value>& stream, XrTime time);
  template <typename Map>
  auto read_of(const Map& streams, const typename Map::key_type& key, XrTime time);
  /// Of a space that was recorded; the count of spaces for another one.
  std::size_t number_of(const SpaceName& space) const;

  std::shared_ptr<const Recording> recording_;
  const RecordedSession& session_;
  std::map<const void*, Cursor> cursors_;
  bool has_states_ = false;
  bool followed_ = true;
  std::size_t calls_ = 0;
  std::size_t frames_since_ = 0;
  std::size_t events_ = 0;
  std::size_t frames_ = 0;
  std::size_t converted_ = 0;
  RecordedFrame last_frame_{};
  std::optional<XrTime> began_;  // the first frame, by this runtime's clock
  XrTime present_ = 0;
};

}  // namespace hrt::mock
