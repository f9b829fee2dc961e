#include "samples/experiment/session/led.h"

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
    "Keys: s or Escape STOP THE PLATE, x the reach does not count, b a break, n a note, u twice unblind, q twice "
    "leave, to be resumed, r what was asked, h these keys.";
constexpr char erase = 0x7f, escape = 0x1b;

// Appends a key to a typed text. Returns true at the end of the text.
bool edit(std::string& text, char key) {
  if (key == '\n' || key == '\r') {
    std::cerr << "\n";
    return true;
  }
  if (key == erase && !text.empty()) {
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xc0U) == 0x80U) text.pop_back();
    text.pop_back();  // up to the first byte of a UTF-8 character
    std::cerr << "\b \b";
  } else if (static_cast<unsigned char>(key) >= ' ' && key != erase) {
    std::cerr << (text += key).back();
  }
  return false;
}

constexpr XrDuration home_limit_ns = 3'000'000'000;
constexpr double home_deg = 2.0, no_way_m = 1e-3;

std::int64_t clock_ns(clockid_t clock) {
  std::timespec time{};
  clock_gettime(clock, &time);
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

}  // namespace

LedSubject::LedSubject(const Design& design, unsigned participant, const app::Options& options, Live* live)
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
      stage_{.plugin = plugin_,
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
             .attend =
                 [this](XrTime time) {
                   attend(time);
                   if (live_ != nullptr) live_->frame(stage_, time, registered_);
                 },
             .touch = touch_ ? &*touch_ : nullptr},
      marks_(marks_of(targets_)) {
  if (simulation_ && !options_.person) {
    stage_.simulation = &*simulation_;
    stand_in_.emplace(design, participant, options.seed);
  } else if (!keyboard_.is_there()) {
    throw Refusal("a person needs an experimenter at a terminal: the standard input is not a terminal");
  } else {
    prompt_.say(keys_text);
  }
  await("");
  if (stand_in_ || touch_) {
    session_.place_plate(session_.floor_space(), targets_.plate_pose);
    take_place();
  }
}

LedSubject::~LedSubject() {
  prompt_.finish();
  plugin_.hrt_session_destroy(targets_.session);
}

void LedSubject::stop_plate() {
  try {
    plate_->stop(0);
  } catch (const std::exception&) {
    // The session has failed; the program ends with the first error.
  }
}

void LedSubject::between_frames() {
  while (const std::optional<char> key = keyboard_or_page()) {
    early_ += *key;
    const bool begins_note = early_.find('n') != std::string::npos && awaited_.find('n') == std::string::npos;
    if (*key == escape || (*key == 's' && !is_typing_ && !note_ && !begins_note)) stop_plate();
  }
}

void LedSubject::take_place() {
  if (simulation_) simulation_->place_plate(session_.plate_space(), targets_.plate_radius_m);
  registered_ = Live::Clock::now();
}

std::optional<hrt_setup_config> LedSubject::marks() const {
  return stand_in_ || touch_ ? std::nullopt : std::optional(config_of(marks_));
}

std::string LedSubject::registered(const hrt_session_config& found) {
  placed_ = {session_.steady_space(), marks_.front(), found};
  place_plate(stage_, *placed_);
  take_place();
  return registration_text(*placed_, session_);
}

std::optional<double> LedSubject::verify(const std::string& registration) {
  try {
    placed_ = app::parse_registration(registration, "what is to be checked");
    const double off_m = check_plate(stage_, *placed_);
    take_place();
    return off_m;
  } catch (const app::Failure& failure) {
    if (failure.code() != app::ExitCode::registration) throw;
    prompt_.say(failure.what());
    placed_.reset();  // also removes the skin offset of the old registration
    return std::nullopt;
  }
}

Now LedSubject::now() {
  if (stand_in_) return stand_in_->now();
  return {clock_ns(CLOCK_REALTIME) / 1'000'000, clock_ns(CLOCK_BOOTTIME)};
}

void LedSubject::continue_after(const Now& last) {
  if (stand_in_) stand_in_->continue_after(last);
}

std::string LedSubject::boot() const {
  if (stand_in_) return stand_in_->boot();
  std::string id;
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), id);
  return id;
}

std::string LedSubject::description() const {
  return (stand_in_ ? stand_in_->description() + ", by " : "a person, by ") +
         (touch_ ? touch_->description() : runtime_.name());
}

void LedSubject::plan(hrt_session_config& config) const {
  std::copy(targets_.start_m.begin(), targets_.start_m.end(), config.start_position_m);
  config.plate.radius_m = targets_.plate_radius_m;
  config.lift_height_m = app::lifted_height_m;
  if (touch_) touch_->configure(config.tracker);
  if (placed_) put_registration(*placed_, config);
  if (const hrt_plate_report* report = plate_->report()) hrt_session_config_from_plate(&config, report);
}

// Called in every frame and state. Stops the plate before any other key is handled; while a text is typed, only
// Escape stops.
void LedSubject::attend(XrTime time) {
  while (const std::optional<char> key = next_key()) {
    if (note_ && *key != escape) {
      if (!edit(*note_, *key)) continue;
      notes_.push_back(*std::exchange(note_, std::nullopt));
      show_keys();
      continue;
    }
    if (is_typing_ ? *key != escape : awaited_.find(*key) != std::string::npos) {
      typed_ = key;
      return;
    }
    const char confirmed = std::exchange(to_confirm_, '\0');
    if ((*key == 'q' || *key == 'u') && *key != confirmed) {
      to_confirm_ = *key;
      prompt_.say(*key == 'q' ? "Press q again to leave the session."
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
        if (awaited_.empty()) throw Ended("refused by the experimenter");
        break;
      case 'q':
        pressed_ = Key::leave;
        throw Ended("the experimenter leaves");
      case 'b':
        pressed_ = Key::rest;
        break;
      case 'n':
        note_.emplace();
        prompt_.say("A note, and Enter:");
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

void LedSubject::await(const std::string& keys, bool text) {
  typed_.reset();
  awaited_ = keys;
  is_text_ = text;
  is_typing_ = text && keys.empty();
  show_keys();
}

void LedSubject::show_keys() {
  const bool types = is_typing_ || note_;
  std::string all = types ? std::string{escape} : "sxbnuq";
  std::erase_if(all, [&](char key) { return awaited_.find(key) != std::string::npos; });
  const bool text = is_text_ || note_;
  show({{"keys", text ? all : all + awaited_}, {"is_typing", text}});
}

std::optional<char> LedSubject::next_key() {
  if (early_.empty()) return keyboard_or_page();
  const char key = early_.front();
  early_.erase(0, 1);
  return key;
}

std::optional<char> LedSubject::keyboard_or_page() {
  const std::optional<char> key = keyboard_.key();
  return key || live_ == nullptr ? key : live_->key();
}

void LedSubject::show(const nlohmann::json& facts) {
  if (live_ == nullptr) return;
  live_->facts.update(facts);
  live_->show();
}

Key LedSubject::key() {
  await("");  // cancel the request of the interrupted task
  const Key pressed = std::exchange(pressed_, Key::none);
  if (pressed == Key::stop_plate) is_stopped_ = true;
  if (pressed == Key::rest) rest(0.0);
  if (pressed == Key::none && !notes_.empty()) return Key::note;
  if (pressed != Key::none || !is_stopped_) return pressed;
  prompt_.ask("The plate is stopped. Space continues, q leaves.");
  await_key(" ");
  is_stopped_ = false;
  return key();
}

// Frames continue, so the plate remains controlled.
char LedSubject::await_key(const std::string& allowed) {
  await(allowed);
  while (!typed_) frame();
  const char key = *typed_;
  await("");
  return key;
}

// `keys`: allowed characters in addition to Enter and backspace; empty: all except Escape.
std::string LedSubject::typed(const std::string& keys) {
  await(keys.empty() ? keys : keys + "\r\n" + erase, true);
  std::string text;
  for (;; frame()) {
    const std::optional<char> key = std::exchange(typed_, std::nullopt);
    if (key && edit(text, *key)) break;
  }
  await("");
  return text;
}

unsigned LedSubject::typed_number(unsigned low, unsigned high) {
  for (;;) {
    const std::optional<double> number = number_in(typed("0123456789"), low, high);
    if (number && *number == std::floor(*number)) return static_cast<unsigned>(*number);
    prompt_.say(format("A whole number from %u to %u, and Enter.", low, high));
  }
}

std::string LedSubject::note() {
  const std::string text = notes_.front();
  notes_.erase(notes_.begin());
  return text;
}

bool LedSubject::consents() {
  if (stand_in_) return stand_in_->consents();
  prompt_.ask("Has the participant read the information and given consent? y or n");
  return await_key("yn") == 'y';
}

std::vector<nlohmann::json> LedSubject::fill_in(const Questionnaire& paper) {
  if (stand_in_) return stand_in_->fill_in(paper);
  std::vector<nlohmann::json> answers;
  for (const std::string& item : paper.items) {
    prompt_.ask(paper.name + ": " + item +
                (paper.is_text ? " (text, and Enter)" : format(" (%u to %u, and Enter)", paper.low, paper.high)));
    if (paper.is_text)
      answers.emplace_back(typed(""));
    else
      answers.emplace_back(typed_number(paper.low, paper.high));
    if (!paper.is_text) prompt_.speak(answers.back().dump());
  }
  return answers;
}

void LedSubject::rest(double minutes) {
  if (stand_in_) return stand_in_->rest(minutes);
  const std::int64_t until_ns = now().monotonic_ns + static_cast<std::int64_t>(6e10 * minutes);
  prompt_.ask(format("A break of %g minutes. Space continues after it.", minutes));
  while (await_key(" ") == ' ' && now().monotonic_ns < until_ns) prompt_.say("Not yet.");
}

unsigned LedSubject::answer(const std::string& question, const std::vector<std::string>& answers,
                            const std::vector<double>& felt_deg, unsigned number) {
  if (stand_in_) return stand_in_->answer(question, answers, felt_deg, number);
  std::string text = question, keys;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    keys += static_cast<char>('1' + i);
    text += format(" %zu ", i + 1) + answers[i] + (i + 1 < answers.size() ? "," : ".");
  }
  prompt_.ask(text);
  return static_cast<unsigned>(await_key(keys) - '1');
}

void LedSubject::slide(hrt_session, const hrt_setup_step& first, unsigned, std::int64_t from_ns,
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
      if (stage_.simulation != nullptr && (slides || next->instruction == HRT_STEP_REST_AT_START))
        instruct(stage_, options_.hands.front(), 0.0,
                 slides ? app::distance_along_plate_m(goal_m, targets_.start_m) : no_way_m);
    }
    step = *next;
    plate_->command(time, step.plate_orientation_deg);
    const XrTime at = from_ns + (time - began) + 1;
    const std::optional<double> plate_deg = plate_->orientation_deg(time);
    const app::Hand hand = options_.hands.front();
    next = use(in_world ? world_sample_of(at, session_.locate(hand, time), plate_deg)
                        : sample_of(at, locate(stage_, hand, time), plate_deg));
  }
}

void LedSubject::home() {
  XrTime time = frame();
  plate_->command(time, 0.0);
  for (const XrTime limit = time + home_limit_ns; time < limit; time = frame()) {
    const std::optional<double> at_deg = plate_->orientation_deg(time);
    if (!at_deg || std::abs(std::remainder(*at_deg, 180.0)) < home_deg) return;
  }
  throw app::Failure(app::ExitCode::plate, "the plate did not come home");
}

ReachOutcome LedSubject::reach(const ReachOrder& order) {
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
    stage_.on_frame = nullptr;
    felt_deg_.reset();
  });
  try {
    home();
    if (stage_.simulation != nullptr) simulation_->seed(options_.seed, order.number);
    std::optional<XrTime> moved;
    std::optional<app::Moment> last;
    stage_.on_frame = [&](const app::TargetPair&, const app::Moment& moment) {
      if (live_ != nullptr) live_->moment(stage_, pair, moment, !last);
      last = moment;
      felt_deg_ = moment.felt_direction_deg;
      if (!moved && app::distance_along_plate_m(moment.position_m, targets_.start_m) > app::start_radius_m / 2)
        moved = moment.time;
    };
    const app::ReachResult result = run_reach(stage_, pair);
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
  if (stand_in_) stand_in_->pass(design_.trial_s);
  return outcome;
}

}  // namespace hrt::experiment
