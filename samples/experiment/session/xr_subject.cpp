#include "samples/experiment/session/xr_subject.h"

#include <haptic_retargeting/plate.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iostream>

#include "samples/app/base/exit_code.h"
#include "samples/app/base/interrupt.h"
#include "samples/app/base/scope_exit.h"
#include "samples/app/run/make_plate.h"
#include "samples/app/run/set_up.h"
#include "samples/app/text/format.h"

namespace hrt::experiment {
namespace {

constexpr const char* keys_text =
    "Keys: S or Escape stops the plate; X marks the reach as invalid; B begins a break after this step; N begins a "
    "note; U pressed twice marks you as unblinded; R repeats the last request; H lists the keys; Q pressed twice "
    "quits, and the session can be resumed.";
constexpr char erase = 0x7f, escape = 0x1b;

// Applies a key to a typed text. Returns true if the key is Enter, which ends the text.
bool edit(std::string& text, char key) {
  if (key == '\n' || key == '\r') {
    std::cerr << "\n";
    return true;
  }
  if (key == erase && !text.empty()) {
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xc0U) == 0x80U) text.pop_back();
    text.pop_back();  // the loop keeps the first byte of a UTF-8 character
    std::cerr << "\b \b";
  } else if (static_cast<unsigned char>(key) >= ' ' && key != erase) {
    std::cerr << (text += key).back();
  }
  return false;
}

constexpr XrDuration zero_limit_ns = 3'000'000'000;
constexpr double zero_tolerance_deg = 2.0;
constexpr double no_path_m = 1e-3;  // path length of a simulated participant who is to stay at the start

std::int64_t clock_ns(clockid_t clock) {
  std::timespec time{};
  clock_gettime(clock, &time);
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

}  // namespace

XrSubject::XrSubject(const Design& design, unsigned participant, const app::Options& options, Live* live)
    : design_(design),
      options_(options),
      live_(live),
      prompt_(
          options.speak_with, [this](const std::string& text) { show({{"says", text}}); }, design.texts),
      plugin_(options.plugin),
      targets_(load_targets(plugin_, options.scene, hrt_session_config_init())),
      touch_(options.finger.empty() ? std::nullopt : std::optional<app::TouchFrame>(options.finger)),
      runtime_({XR_HRTX_RIDGED_PLATE_EXTENSION_NAME, app::local_floor_extension}),
      session_(runtime_, spaces_, options.runtime_limit),
      context_{.plugin = plugin_,
               .targets = targets_,
               .session = session_,
               .simulation = nullptr,
               .plate = *[&]() -> app::Plate* {
                 if (runtime_.enabled(XR_HRTX_RIDGED_PLATE_EXTENSION_NAME)) simulation_.emplace(runtime_, session_);
                 plate_ = make_plate(options_.plate, simulation_ ? &*simulation_ : nullptr, session_, runtime_.name());
                 return plate_.get();
               }(),
               .hands = options.hands,
               .time_limit_ns = static_cast<XrDuration>(options.time_limit_s * 1e9),
               .on_frame = {},
               .tell_user = [this](const std::string& what) { prompt_.ask(what); },
               .hint = [this](const std::string& what) { prompt_.hint(what); },
               .handle_keys =
                   [this](XrTime time) {
                     handle_keys(time);
                     if (live_ != nullptr) live_->frame(context_, time, registered_);
                   },
               .touch = touch_ ? &*touch_ : nullptr},
      marks_(marks_of(targets_)) {
  if (simulation_ && !options_.person) {
    context_.simulation = &*simulation_;
    simulated_.emplace(design, participant, options.seed);
  } else if (!options_.person) {
    throw Refusal("the OpenXR runtime " + runtime_.name() +
                  " does not simulate a participant (--simulated); use the mock runtime");
  } else if (!keyboard_.has_terminal()) {
    throw Refusal(
        "standard input is not a terminal, which the experimenter needs for the keys; run in a terminal, or simulate "
        "the participant (--simulated SEED, with the mock runtime)");
  } else {
    prompt_.say(keys_text);
  }
  expect_keys("");
  if (simulated_ || touch_) {
    session_.place_plate(session_.floor_space(), targets_.plate_pose);
    note_plate_pose();
  }
}

XrSubject::~XrSubject() {
  prompt_.finish();
  plugin_.hrt_session_destroy(targets_.session);
}

void XrSubject::stop_plate() {
  try {
    plate_->stop(0);
  } catch (const std::exception&) {
    // The next frame handles the key again, and reports the failure.
  }
}

void XrSubject::between_frames() {
  while (const std::optional<char> key = keyboard_or_page()) {
    buffered_keys_ += *key;
    const bool begins_note =
        buffered_keys_.find('n') != std::string::npos && expected_keys_.find('n') == std::string::npos;
    if (*key == escape || (*key == 's' && !is_typing_ && !note_ && !begins_note)) stop_plate();
  }
}

void XrSubject::note_plate_pose() {
  if (simulation_) simulation_->place_plate(session_.plate_space(), targets_.plate_radius_m);
  registered_ = Live::Clock::now();
}

std::optional<hrt_setup_config> XrSubject::marks() const {
  return simulated_ || touch_ ? std::nullopt : std::optional(config_of(marks_));
}

std::string XrSubject::registered(const hrt_session_config& found) {
  placed_ = {session_.steady_space(), marks_.front(), found};
  place_plate(context_, *placed_);
  note_plate_pose();
  return registration_text(*placed_, session_);
}

std::optional<double> XrSubject::verify(const std::string& registration) {
  try {
    placed_ = app::parse_registration(registration, "the registration in the journal");
    const double off_m = check_plate(context_, *placed_);
    note_plate_pose();
    return off_m;
  } catch (const app::Failure& failure) {
    if (failure.code() != app::ExitCode::registration) throw;
    prompt_.say(failure.what());
    placed_.reset();  // also removes the skin offset of the old registration
    return std::nullopt;
  }
}

Now XrSubject::now() {
  if (simulated_) return simulated_->now();
  return {clock_ns(CLOCK_REALTIME) / 1'000'000, clock_ns(CLOCK_BOOTTIME)};
}

void XrSubject::continue_after(const Now& last) {
  if (simulated_) simulated_->continue_after(last);
}

std::string XrSubject::boot() const {
  if (simulated_) return simulated_->boot();
  std::string id;
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), id);
  return id;
}

std::string XrSubject::description() const {
  return (simulated_ ? simulated_->description() + ", by " : "a person, by ") +
         (touch_ ? touch_->description() : runtime_.name());
}

void XrSubject::plan(hrt_session_config& config) const {
  std::copy(targets_.start_m.begin(), targets_.start_m.end(), config.start_position_m);
  config.plate.radius_m = targets_.plate_radius_m;
  config.lift_height_m = app::lifted_height_m;
  if (touch_) touch_->configure(config.tracker);
  if (placed_) put_registration(*placed_, config);
  if (const hrt_plate_report* report = plate_->report()) hrt_session_config_from_plate(&config, report);
}

// Called in every frame. While a text is typed, all keys except Escape are its characters.
void XrSubject::handle_keys(XrTime time) {
  while (const std::optional<char> key = next_key()) {
    if (note_ && *key != escape) {
      if (!edit(*note_, *key)) continue;
      notes_.push_back(*std::exchange(note_, std::nullopt));
      show_keys();
      continue;
    }
    if (is_typing_ ? *key != escape : expected_keys_.find(*key) != std::string::npos) {
      typed_ = key;
      return;
    }
    const char confirmed = std::exchange(to_confirm_, '\0');
    if ((*key == 'q' || *key == 'u') && *key != confirmed) {
      to_confirm_ = *key;
      prompt_.say(*key == 'q' ? "Press q again to quit the session."
                              : "Press u again to record that you are unblinded.");
      continue;
    }
    switch (*key) {
      case 's':
      case escape:
        plate_->stop(time);
        if (note_) notes_.push_back(*std::exchange(note_, std::nullopt));
        pressed_ = Key::stop_plate;
        throw Ended("the plate was stopped");
      case 'x':
        if (expected_keys_.empty()) throw Ended("marked as invalid by the experimenter");
        break;
      case 'q':
        pressed_ = Key::leave;
        throw Ended("the experimenter quit");
      case 'b':
        pressed_ = Key::rest;
        break;
      case 'n':
        note_.emplace();
        prompt_.say("Type a note, then press Enter:");
        show_keys();
        break;
      case 'u':
        pressed_ = Key::unblind;
        break;
      case 'r':
        prompt_.repeat();
        break;
      case 'h':
        prompt_.say(keys_text);
        break;
      default:
        break;
    }
  }
}

void XrSubject::expect_keys(const std::string& keys, bool text) {
  typed_.reset();
  expected_keys_ = keys;
  is_text_ = text;
  is_typing_ = text && keys.empty();
  show_keys();
}

void XrSubject::show_keys() {
  const bool types = is_typing_ || note_;
  std::string all = types ? std::string{escape} : "sxbnuq";
  std::erase_if(all, [&](char key) { return expected_keys_.find(key) != std::string::npos; });
  const bool text = is_text_ || note_;
  show({{"keys", text ? all : all + expected_keys_}, {"is_typing", text}});
}

std::optional<char> XrSubject::next_key() {
  if (buffered_keys_.empty()) return keyboard_or_page();
  const char key = buffered_keys_.front();
  buffered_keys_.erase(0, 1);
  return key;
}

std::optional<char> XrSubject::keyboard_or_page() {
  const std::optional<char> key = keyboard_.key();
  return key || live_ == nullptr ? key : live_->key();
}

void XrSubject::show(const nlohmann::json& facts) {
  if (live_ == nullptr) return;
  live_->facts.update(facts);
  live_->show();
}

Key XrSubject::key() {
  expect_keys("");  // cancel the request of the interrupted task
  const Key pressed = std::exchange(pressed_, Key::none);
  if (pressed == Key::stop_plate) is_stopped_ = true;
  if (pressed == Key::rest) rest(0.0);
  if (pressed == Key::none && !notes_.empty()) return Key::note;
  if (pressed != Key::none || !is_stopped_) return pressed;
  prompt_.ask("The plate is stopped. Press space to continue, or q twice to quit.");
  wait_for_key(" ");
  is_stopped_ = false;
  return key();
}

// Waits for one of the allowed keys. Frames continue meanwhile, so that the plate remains controlled.
char XrSubject::wait_for_key(const std::string& allowed) {
  expect_keys(allowed);
  while (!typed_) frame();
  const char key = *typed_;
  expect_keys("");
  return key;
}

// Returns a typed line. `keys`: allowed characters in addition to Enter and backspace; empty: all except control
// characters.
std::string XrSubject::typed(const std::string& keys) {
  expect_keys(keys.empty() ? keys : keys + "\r\n" + erase, true);
  std::string text;
  for (;; frame()) {
    const std::optional<char> key = std::exchange(typed_, std::nullopt);
    if (key && edit(text, *key)) break;
  }
  expect_keys("");
  return text;
}

unsigned XrSubject::typed_number(unsigned low, unsigned high) {
  for (;;) {
    const std::optional<double> number = number_in(typed("0123456789"), low, high);
    if (number && *number == std::floor(*number)) return static_cast<unsigned>(*number);
    prompt_.say(format("Please type a whole number from %u to %u, then press Enter.", low, high));
  }
}

std::string XrSubject::note() {
  const std::string text = notes_.front();
  notes_.erase(notes_.begin());
  return text;
}

bool XrSubject::consents() {
  if (simulated_) return simulated_->consents();
  prompt_.ask("Did the participant read the information and give consent? Press y for yes, n for no.");
  return wait_for_key("yn") == 'y';
}

std::vector<nlohmann::json> XrSubject::fill_in(const Questionnaire& paper) {
  if (simulated_) return simulated_->fill_in(paper);
  std::vector<nlohmann::json> answers;
  for (const std::string& item : paper.items) {
    const std::string how = paper.is_text
                                ? "type the answer, then press Enter"
                                : format("type a number from %u to %u, then press Enter", paper.low, paper.high);
    // A text in brackets is displayed only: `how` is spoken with the first item.
    prompt_.ask(paper.name + ": " + item + (answers.empty() ? " (" + how + ")" : " [" + how + "]"));
    if (paper.is_text)
      answers.emplace_back(typed(""));
    else
      answers.emplace_back(typed_number(paper.low, paper.high));
    if (!paper.is_text) prompt_.speak(answers.back().dump());
  }
  return answers;
}

void XrSubject::rest(double minutes) {
  if (simulated_) return simulated_->rest(minutes);
  const std::int64_t until_ns = now().monotonic_ns + static_cast<std::int64_t>(6e10 * minutes);
  prompt_.ask(minutes > 0.0 ? format("Please take a break of at least %g min. After that, press space.", minutes)
                            : "Please take a break. Press space to continue.");
  while (wait_for_key(" ") == ' ' && now().monotonic_ns < until_ns) prompt_.say("The break is not over yet.");
}

unsigned XrSubject::answer(const std::string& question, const std::vector<std::string>& answers,
                           const std::vector<double>& felt_deg, unsigned number) {
  if (simulated_) return simulated_->answer(question, answers, felt_deg, number);
  std::string text = question + " Press", keys;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    keys += static_cast<char>('1' + i);
    text += format(" %zu for ", i + 1) + answers[i] + (i + 1 < answers.size() ? "," : ".");
  }
  prompt_.ask(text);
  return static_cast<unsigned>(wait_for_key(keys) - '1');
}

void XrSubject::slide(hrt_session, const hrt_setup_step& first, unsigned, std::int64_t from_ns,
                      const std::function<std::optional<hrt_setup_step>(const hrt_sample&)>& use) {
  std::optional<hrt_setup_step> next = first;
  hrt_setup_step step{.instruction = UINT32_MAX};
  const bool in_world = first.part == HRT_SETUP_REGISTRATION;
  if (in_world) session_.place_plate(session_.steady_space(), app::world);
  const XrTime began = frame();
  for (XrTime time = began; next; time = frame()) {
    if (app::is_new_instruction(step, *next) && next->text[0] != '\0' && next->instruction != HRT_STEP_FINISH) {
      prompt_.ask(app::request_of(*next, names_of(marks_)));
      const bool slides = next->instruction == HRT_STEP_SLIDE;
      const app::Point goal_m{next->place_m[0], 0.0, next->place_m[2]};
      if (context_.simulation != nullptr && (slides || next->instruction == HRT_STEP_REST_AT_START))
        instruct(context_, options_.hands.front(), 0.0,
                 slides ? app::distance_along_plate_m(goal_m, targets_.start_m) : no_path_m);
    }
    step = *next;
    plate_->command(time, step.plate_orientation_deg);
    const XrTime at = from_ns + (time - began) + 1;
    const std::optional<double> plate_deg = plate_->orientation_deg(time);
    const app::Hand hand = options_.hands.front();
    next = use(in_world ? world_sample_of(at, session_.locate(hand, time), plate_deg)
                        : sample_of(at, locate(context_, hand, time), plate_deg));
  }
}

void XrSubject::turn_to_zero() {
  XrTime time = frame();
  plate_->command(time, 0.0);
  for (const XrTime limit = time + zero_limit_ns; time < limit; time = frame()) {
    const std::optional<double> at_deg = plate_->orientation_deg(time);
    if (!at_deg || std::abs(std::remainder(*at_deg, 180.0)) < zero_tolerance_deg) return;
  }
  const std::optional<double> last_deg = plate_->orientation_deg(time);
  throw app::Failure(app::ExitCode::plate,
                     format("the plate did not turn to 0 degrees within 3 s (last reported orientation: %.1f degrees); "
                            "check the power supply, and that the plate turns freely, then run again",
                            last_deg.value_or(0.0)));
}

ReachOutcome XrSubject::reach(const ReachOrder& order) {
  ReachOutcome outcome{.summary = {.counts = {.samples = 0}}};
  const auto at = [&](double direction_deg) {
    constexpr double rad_per_deg = 0.017453292519943295;
    return app::Point{targets_.start_m[0] - order.distance_m * std::sin(direction_deg * rad_per_deg), 0.0,
                      targets_.start_m[2] - order.distance_m * std::cos(direction_deg * rad_per_deg)};
  };
  const app::TargetPair pair{"the target",         "the real target", order.virtual_deg,     order.real_deg,
                             order.distance_m,     order.radius_m,    at(order.virtual_deg), at(order.real_deg),
                             order.virtual_target, order.real_target};
  const hrt_session own = std::exchange(targets_.session, order.session);
  const app::ScopeExit of_own([&] {
    targets_.session = own;
    context_.on_frame = nullptr;
  });
  try {
    turn_to_zero();
    if (context_.simulation != nullptr) simulation_->seed(options_.seed, order.number);
    std::optional<XrTime> moved;
    std::optional<app::Moment> last;
    context_.on_frame = [&](const app::TargetPair&, const app::Moment& moment) {
      if (live_ != nullptr) live_->moment(context_, pair, moment, !last);
      last = moment;
      if (!moved && app::distance_along_plate_m(moment.position_m, targets_.start_m) > app::start_radius_m / 2)
        moved = moment.time;
    };
    const app::ReachResult result = run_reach(context_, pair);
    outcome.has_ended = true;
    std::copy(last->position_m.begin(), last->position_m.end(), outcome.end_m);
    outcome.duration_s = moved ? 1e-9 * static_cast<double>(last->time - *moved) : 0.0;
    outcome.peak_felt_error_deg = result.peak_felt_error_deg;
    outcome.is_truth = result.is_truth;
    outcome.summary = result.summary;
    outcome.summary.counts.samples = result.frames;  // without the samples after the finger's lift
    outcome.summary.counts.dropped_samples = result.dropouts;
  } catch (const Ended& ended) {
    outcome.problem = ended.what();
  } catch (const app::Failure& failure) {
    if (failure.code() != app::ExitCode::no_hand) throw;
    outcome.problem = failure.what();
  }
  if (simulated_) simulated_->pass(design_.trial_s);
  return outcome;
}

}  // namespace hrt::experiment
