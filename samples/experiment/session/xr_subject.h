// A participant in a session through OpenXR: a person, who gets requests by terminal and voice, with an experimenter
// who presses keys; or the simulated user of the mock runtime, with the answers and the clock of SimulatedSubject.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "samples/app/finger/touch_frame.h"
#include "samples/app/person/keyboard.h"
#include "samples/app/person/prompt.h"
#include "samples/app/run/options.h"
#include "samples/app/run/reach.h"
#include "samples/app/run/registration.h"
#include "samples/experiment/live/live.h"
#include "samples/experiment/session/simulated.h"

namespace hrt::experiment {

class XrSubject : public Subject {
 public:
  /// Uses these options: scene, plugin, hands, finger, plate, speak_with, person, time_limit_s, runtime_limit and seed.
  /// `live`: page that displays the session, or null. Throws app::Failure, app::XrFailure and Refusal.
  XrSubject(const Design& design, unsigned participant, const app::Options& options, Live* live);
  /// Waits until all sentences have been spoken, for at most 30 s.
  ~XrSubject() override;
  XrSubject(const XrSubject&) = delete;
  XrSubject& operator=(const XrSubject&) = delete;

  Now now() override;
  void continue_after(const Now& last) override;
  std::string boot() const override;
  std::string description() const override;
  std::string plate() const override { return plate_->description(); }
  void plan(hrt_session_config& config) const override;
  std::optional<hrt_setup_config> marks() const override;
  std::string registered(const hrt_session_config& found) override;
  std::optional<double> verify(const std::string& registration) override;
  Key key() override;
  void say(const std::string& text) override { prompt_.say(text); }
  /// Reads keys between frames. A stop key stops the plate immediately; all other effects of keys follow at the next
  /// frame. Disk calls it at each step, since several syncs of the disk would delay a stop too long.
  void between_frames();
  /// Speaks a sentence without printing it.
  void speak(const std::string& text) { prompt_.speak(text); }
  void show(const nlohmann::json& facts) override;
  std::string note() override;
  bool consents() override;
  void slide(hrt_session session, const hrt_setup_step& step, unsigned number, std::int64_t from_ns,
             const std::function<std::optional<hrt_setup_step>(const hrt_sample&)>& use) override;
  std::vector<nlohmann::json> fill_in(const Questionnaire& paper) override;
  void rest(double minutes) override;
  ReachOutcome reach(const ReachOrder& order) override;
  unsigned answer(const std::string& question, const std::vector<std::string>& answers,
                  const std::vector<double>& felt_deg, unsigned number) override;

 private:
  void note_plate_pose();
  void stop_plate();
  std::optional<char> next_key();
  std::optional<char> keyboard_or_page();
  void handle_keys(XrTime time);
  XrTime frame() { return next_frame(context_); }
  void expect_keys(const std::string& keys, bool text = false);
  void show_keys();
  char wait_for_key(const std::string& allowed);
  std::string typed(const std::string& keys);
  unsigned typed_number(unsigned low, unsigned high);
  void turn_to_zero();

  const Design& design_;
  app::Options options_;
  std::optional<SimulatedSubject> simulated_;
  Live* live_;
  app::Prompt prompt_;
  app::Keyboard keyboard_;
  app::Plugin plugin_;
  app::TargetSet targets_;
  app::SpaceMotion spaces_;
  std::optional<app::TouchFrame> touch_;  // nullopt: the runtime tracks the hand
  app::XrRuntime runtime_;
  app::XrHeadlessSession session_;
  std::optional<app::Simulation> simulation_;
  std::unique_ptr<app::Plate> plate_;
  app::RunContext context_;
  std::vector<app::Mark> marks_;
  std::optional<app::RegisteredPlate> placed_;
  std::optional<Live::Clock::time_point> registered_;  // time at which the plate's pose was last set or checked
  Key pressed_ = Key::none;                            // last key that key() has not returned yet
  std::optional<char> typed_;                          // last key that answered a request
  std::string expected_keys_;                          // keys that answer the present request
  std::string buffered_keys_;                          // keys that were read between frames
  std::optional<std::string> note_;                    // text of the note that is being typed
  std::vector<std::string> notes_;                     // finished notes that are not in the journal yet
  char to_confirm_ = '\0';                             // key to be pressed a second time for confirmation
  bool is_text_ = false, is_typing_ = false, is_stopped_ = false;
};

}  // namespace hrt::experiment
