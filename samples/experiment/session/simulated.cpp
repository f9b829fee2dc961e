#include "samples/experiment/session/simulated.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "samples/app/text/format.h"
#include "samples/experiment/design/draws.h"
#include "samples/experiment/session/library.h"

namespace hrt::experiment {
namespace {

constexpr std::int64_t frame_ns = 11'111'111, settle_ns = 300'000'000, limit_ns = 30'000'000'000;
constexpr double max_speed_deg_s = 400.0;
constexpr std::int64_t latency_ns = 30'000'000;
constexpr double notice_slope = 2.0;  // slope of the Weibull function in answer()

// Simulated person of core/simulation who is about to make the reach with the index `number`.
class Person {
 public:
  Person(const hrt_person_config& config, std::uint64_t seed, hrt_session session, hrt_target seen, unsigned number) {
    check(hrt_person_create(&config, seed, &person_));
    for (unsigned i = 0; i <= number; ++i) check(hrt_person_begin(person_, session, seen));
  }
  ~Person() { hrt_person_destroy(person_); }
  Person(const Person&) = delete;
  Person& operator=(const Person&) = delete;

  hrt_sample move(std::int64_t time_ns, double plate_deg) const {
    hrt_sample sample = hrt_sample_init();
    check(hrt_person_move(person_, time_ns, plate_deg, &sample));
    return sample;
  }
  hrt_person_state state() const {
    hrt_person_state state = hrt_person_state_init();
    check(hrt_person_get_state(person_, &state));
    return state;
  }
  void begin(hrt_session session, hrt_target seen) const { check(hrt_person_begin(person_, session, seen)); }

 private:
  hrt_person person_{};
};

// Returns a draw with mean 0 and SD 1; "skewed" is log-normal.
double deviate(const std::string& distribution, Stream& draw) {
  if (distribution == "uniform") return std::sqrt(12.0) * (draw.uniform() - 0.5);
  const double radius = std::sqrt(-2.0 * std::log(1.0 - draw.uniform()));
  const double normal = radius * std::cos(2.0 * std::numbers::pi * draw.uniform());
  if (distribution == "normal") return normal;
  constexpr double sd_log = 0.3;
  const double mean = std::exp(0.5 * sd_log * sd_log);
  return (std::exp(sd_log * normal) - mean) / (mean * std::sqrt(std::expm1(sd_log * sd_log)));
}

}  // namespace

// Draws the traits of the participant: mean and SD of the tactile weight as in core/simulation, bias uniform within 3
// degrees, duration of a reach 1 to 2 s, detection threshold 7 to 14 degrees.
SimulatedSubject::SimulatedSubject(const Design& design, unsigned participant, std::uint64_t seed)
    : design_(design), participant_(participant), seed_(seed) {
  Stream draw(Use::person, {seed, participant});
  constexpr double mean_weight = 0.21, sd_weight = 0.0519615, max_bias_deg = 3.0, low_s = 1.0, pace_s = 1.0;
  config_.tactile_weight = std::clamp(mean_weight + sd_weight * deviate(design.simulated.weights, draw), 0.02, 0.48);
  config_.bias_deg = max_bias_deg * (2.0 * draw.uniform() - 1.0);
  config_.duration_s = low_s + pace_s * draw.uniform();
  constexpr double usual_threshold_deg = 10.0;
  threshold_deg_ = usual_threshold_deg * std::exp2(draw.uniform() - 0.5);
  constexpr std::int64_t new_year_2000_ms = 946'684'800'000, day_ms = 86'400'000;
  now_ = {new_year_2000_ms + participant * day_ms, 0};
}

std::string SimulatedSubject::description() const {
  return format("simulated, seed %llu", static_cast<unsigned long long>(seed_));
}

void SimulatedSubject::plan(hrt_session_config& config) const {
  config.plate.max_speed_deg_s = max_speed_deg_s;
  config.plate.latency_ns = latency_ns;
}

void SimulatedSubject::pass(double seconds) {
  const auto ms = std::llround(1e3 * seconds);
  now_.utc_ms += ms;
  now_.monotonic_ns += ms * 1'000'000;
}

bool SimulatedSubject::consents() {
  pass(300.0);
  return true;
}

void SimulatedSubject::slide(hrt_session session, const hrt_setup_step& first, unsigned number, std::int64_t from_ns,
                             const std::function<std::optional<hrt_setup_step>(const hrt_sample&)>& use) {
  hrt_target_config config = hrt_target_config_init();
  config.role = HRT_TARGET_VIRTUAL;
  hrt_target ahead{};
  check(hrt_target_add(session, &config, &ahead));
  const Person person(config_, seed_ * 1000 + participant_, session, ahead, 2 * number);
  hrt_setup_step step = first;
  std::int64_t time_ns = from_ns;
  bool rested = false;
  for (std::optional<hrt_setup_step> next = first; next; rested = step.instruction == HRT_STEP_REST_AT_START) {
    step = *next;
    if (step.instruction == HRT_STEP_REST_AT_START && !rested) person.begin(session, ahead);
    time_ns += frame_ns;
    next = use(person.move(time_ns, step.plate_orientation_deg));
  }
  check(hrt_target_remove(session, ahead));
  pass(1e-9 * static_cast<double>(time_ns - from_ns));
}

std::vector<nlohmann::json> SimulatedSubject::fill_in(const Questionnaire& paper) {
  Stream draw(Use::answers, {seed_, participant_, static_cast<std::uint32_t>(paper.name.size()), 0, 0});
  std::vector<nlohmann::json> answers;
  for (std::size_t i = 0; i < paper.items.size(); ++i) {
    const unsigned drawn = paper.low + draw.below(paper.high - paper.low + 1);
    answers.push_back(paper.is_text ? nlohmann::json("simulated") : nlohmann::json(drawn));
  }
  pass(8.0 * static_cast<double>(answers.size()));
  return answers;
}

void SimulatedSubject::rest(double minutes) { pass(60.0 * minutes); }

ReachOutcome SimulatedSubject::reach(const ReachOrder& order) {
  const Person person(config_, seed_ * 1000 + participant_, order.session, order.virtual_target, order.number);
  Stream draw(Use::noise, place(order.number));
  const bool loses_finger = draw.uniform() < design_.simulated.invalid_share;
  hrt_reach_config config = hrt_reach_config_init();
  config.real_target = order.real_target;
  config.virtual_target = order.virtual_target;
  config.flags = HRT_REACH_PLATE_ORIENTATION;
  check(hrt_reach_begin(order.session, &config));
  ReachOutcome outcome;
  outcome.summary = hrt_reach_summary_init();
  outcome.is_truth = true;
  double plate_deg = 0.0;
  std::int64_t done_ns = 0, began_ns = 0;
  hrt_person_state state{};
  for (std::int64_t time_ns = 0; time_ns < limit_ns && !outcome.has_ended; time_ns += frame_ns) {
    hrt_sample sample = person.move(time_ns, plate_deg);
    state = person.state();
    // Drops the position of every other frame.
    if (loses_finger && time_ns / frame_ns % 2 == 1) sample.flags &= ~HRT_SAMPLE_PLATE_POSITION;
    hrt_command command = hrt_command_init();
    check(hrt_reach_update(order.session, &sample, &command));
    plate_deg = command.plate_orientation_deg;
    if (began_ns == 0 && command.bearing_deg != 0.0) began_ns = time_ns;
    if (!state.done)
      outcome.peak_felt_error_deg = std::max(outcome.peak_felt_error_deg, std::abs(state.felt_error_deg));
    if (state.done && done_ns == 0) done_ns = time_ns;
    outcome.has_ended = state.done && time_ns - done_ns >= settle_ns;
  }
  check(hrt_reach_end(order.session, &outcome.summary));
  std::copy(std::begin(state.position_m), std::end(state.position_m), outcome.end_m);
  outcome.duration_s = 1e-9 * static_cast<double>(done_ns - began_ns);
  pass(design_.trial_s);
  return outcome;
}

// The participant guesses with the probability lapse_share of the design. Otherwise, the probability of noticing the
// bend is a Weibull function of the largest perceived-direction error. A participant who notices it names the reach
// with this error: after one reach, the first answer. Otherwise the participant gives the last answer after one reach,
// and guesses after two.
unsigned SimulatedSubject::answer(const std::string&, const std::vector<std::string>& answers,
                                  const std::vector<double>& felt_deg, unsigned number) {
  Stream draw(Use::answers, place(number));
  const auto count = static_cast<unsigned>(answers.size());
  pass(2.0);
  if (draw.uniform() < design_.simulated.lapse_share) return draw.below(count);
  const auto largest = std::max_element(felt_deg.begin(), felt_deg.end());
  const bool notices = draw.uniform() < 1.0 - std::exp(-std::pow(*largest / threshold_deg_, notice_slope));
  if (notices) return static_cast<unsigned>(largest - felt_deg.begin());
  return felt_deg.size() == 1 ? count - 1 : draw.below(count);
}

}  // namespace hrt::experiment
