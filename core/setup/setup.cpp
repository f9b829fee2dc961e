#include "core/setup/setup.h"

#include <algorithm>

namespace hrt {
namespace {

constexpr std::uint32_t slide_parts_of_setup = setup_calibration | setup_retest;
constexpr std::uint32_t touch_parts = setup_fingertip | setup_registration | setup_check;
constexpr std::uint32_t need_plate = setup_guides | slide_parts_of_setup;
// Capacity per slide: 4 s at 250 Hz on average.
constexpr std::size_t samples_a_slide = 1000;
// Plate angles of slides (planned_share()). Beyond 0.8 of the default range, a person with a usual tactile weight would
// slide along the ridges.
constexpr std::array<double, first_slides> fractions{-0.4, 0.8,  0.0, -0.8, 0.4, -0.6, 0.2, -0.2,
                                                     0.6,  -0.7, 0.3, -0.3, 0.7, -0.5, 0.5, -0.1};

Eigen::Vector3d place_of(const PlatePoint& point) { return {point.right_mm, 0.0, -point.away_mm}; }

}  // namespace

double planned_share(int i) {
  const double share = fractions[static_cast<std::size_t>(i % first_slides)];
  return i / first_slides % 2 == 0 ? share : -share;
}

Setup::Setup(const SetupConfig& config)
    : config_(config),
      left_(config.parts),
      guided_(config.start, config.guides, config.guide_count),
      plate_orientation_deg_(config.plate_orientation_deg) {
  if (left_ & slide_parts_of_setup)
    slides_.emplace(config.max_slides, samples_a_slide * static_cast<std::size_t>(config.max_slides));
  begin_part();
}

SetupPart Setup::part() const { return static_cast<SetupPart>(left_ & (~left_ + 1)); }  // the lowest bit

void Setup::begin_part() {
  const int per_mark = config_.mark_count * config_.touches_per_mark;
  touches_.begin(has_part(setup_fingertip) ? finger_attitudes : has_part(setup_registration) ? per_mark : 1);
  guided_.restart();
  if (has_part(slide_parts_of_setup)) {
    if (slides_->count() < wanted_slides_) next_slide();
  } else if (has_part(touch_parts | setup_guides)) {
    plate_orientation_deg_ = 0.0;  // marks and guides are defined at this plate orientation
  }
}

void Setup::next_slide() {
  const double middle_deg = 0.5 * (config_.lower_plate_deg + config_.upper_plate_deg);
  const double half_deg = 0.5 * (config_.upper_plate_deg - config_.lower_plate_deg);
  plate_orientation_deg_ = middle_deg + half_deg * planned_share(slides_->count());
  slides_->begin(plate_orientation_deg_);
  watch_.begin(config_.start, config_.slide_distance_mm, plate_orientation_deg_);
}

bool Setup::slides_are_full() const { return wanted_slides_ >= config_.max_slides || slides_->full(); }

bool Setup::finish_is_due() const {
  if (left_ == 0) return true;
  if (has_part(touch_parts)) return touches_.complete();
  if (has_part(setup_guides)) return guided_.complete();
  return slides_->count() >= wanted_slides_ || slides_->full();
}

void Setup::close() {
  left_ &= ~part();
  problem_ = SetupProblem::none;
  reason_.set("");
  rejected_ = 0;
  wanted_slides_ = first_slides;
  begin_part();
}

void Setup::drop(SetupProblem problem, std::string_view reason) {
  last_drop_ = {.part = part(), .problem = problem, .observed = observed(), .reason = {}};
  last_drop_.reason.set(reason);
  // Slides and guides require a pose of the plate; guides also require that its check, if requested, succeeds.
  std::uint32_t need_it = 0;
  if (has_part(setup_registration)) need_it = need_plate;
  if (has_part(setup_check)) need_it = setup_guides;
  const std::uint32_t gone = part() | (left_ & need_it);
  dropped_ |= gone;
  left_ &= ~gone | part();
  close();
}

SetupDrop Setup::last_drop() const {
  return {last_drop_.part, last_drop_.problem, last_drop_.observed, last_drop_.reason.view()};
}

void Setup::repeat(SetupProblem problem, std::string_view reason) {
  const bool wants_slides = has_part(slide_parts_of_setup);
  if (!wants_slides && ++rejected_ == max_rejected_fits) return drop(problem, reason);
  problem_ = problem;
  reason_.set(reason);
  if (wants_slides) wanted_slides_ = std::min(wanted_slides_ + more_slides, config_.max_slides);
  begin_part();
}

bool Setup::can_show(const SetupSample& sample) const {
  if (has_part(setup_fingertip)) return !sample.in_plate && sample.joint_rotation;
  if (has_part(setup_registration | setup_check)) return !sample.in_plate;
  return true;
}

void Setup::update(const SetupSample& sample) {
  if (finish_is_due()) return;
  while (config_.only_possible && left_ != 0 && sample.tracked_mm && !can_show(sample)) close();
  if (left_ == 0) return;
  const SetupPart current = part();
  const int before = done();
  progress_.observe(sample);
  if (has_part(touch_parts)) {
    touches_.observe(sample);
    if (touches_.count() > before && !touches_.complete()) problem_ = SetupProblem::none;
  } else if (has_part(setup_guides)) {
    guided_.observe(sample);
    if (guided_.has_begun() || guided_.problem() != SetupProblem::none) problem_ = guided_.problem();
    if (guided_.failed() == max_failed_slides) drop(guided_.problem(), "");
  } else {
    slide(sample);
  }
  if (part() != current || done() != before) progress_.restart();
}

void Setup::slide(const SetupSample& sample) {
  const bool kept = watch_.observe(sample);
  const bool sliding = watch_.phase() == SlideWatch::Phase::slide;
  if (watch_.is_first() || (!kept && !sliding)) slides_->drop();
  if (kept) slides_->add(sample.on_plate);
  if (!watch_.has_left()) slides_->shorten_rest();
  if (sliding || watch_.problem() != SetupProblem::none) problem_ = watch_.problem();
  if (watch_.failed() == max_failed_slides || watch_.plate_is_stuck()) return drop(watch_.problem(), "");
  if (watch_.phase() != SlideWatch::Phase::done) return;
  slides_->end();
  problem_ = SetupProblem::none;
  if (!finish_is_due()) next_slide();
}

int Setup::done() const {
  if (has_part(slide_parts_of_setup)) return slides_->count();
  return has_part(setup_guides) ? guided_.done() : touches_.count();
}

void Setup::describe_slide(SetupStep* step) const {
  step->of = wanted_slides_;
  step->place_mm = place_of(config_.start);
  if (watch_.phase() == SlideWatch::Phase::rest_at_start) {
    step->instruction = Instruction::rest_at_start;
  } else if (watch_.phase() == SlideWatch::Phase::slide) {
    step->instruction = Instruction::slide;
    step->place_mm = place_of(point_ahead(config_.start, 0.0, config_.slide_distance_mm));
  }
}

void Setup::describe_guide(SetupStep* step) const {
  step->number = guided_.object();
  step->of = guided_.of();
  step->place_mm = place_of(guided_.next());
  step->instruction = guided_.has_begun() ? Instruction::slide : Instruction::rest_at_start;
}

Observed Setup::observed() const {
  if (!watch_.wrong_way_deg() && !progress_.may_be_stuck()) return {};
  if (left_ == 0 || finish_is_due()) return {};
  if (has_part(touch_parts)) return progress_.observed({}, {});
  if (has_part(setup_guides)) return progress_.observed(guided_.next(), {});
  if (watch_.wrong_way_deg()) return {Observed::Kind::wrong_way, *watch_.wrong_way_deg(), 0.0};
  if (watch_.phase() == SlideWatch::Phase::plate_turns) return progress_.observed({}, plate_orientation_deg_);
  return watch_.phase() == SlideWatch::Phase::slide ? progress_.observed({}, {})
                                                    : progress_.observed(config_.start, {});
}

SetupStep Setup::step() const {
  SetupStep step{.part = part(),
                 .instruction = Instruction::wait,
                 .problem = problem_,
                 .number = touches_.count(),
                 .done = done(),
                 .of = touches_.wanted(),
                 .place_mm = Eigen::Vector3d::Zero(),
                 .plate_orientation_deg = plate_orientation_deg_,
                 .observed = observed(),
                 .reason = reason_.view()};
  if (has_part(slide_parts_of_setup)) {
    describe_slide(&step);
  } else if (has_part(setup_guides)) {
    describe_guide(&step);
  } else if (left_ != 0) {
    const int mark = has_part(setup_fingertip) ? 0
                     : has_part(setup_check)   ? config_.check_mark
                                               : touches_.count() % config_.mark_count;
    if (!has_part(setup_fingertip)) step.number = mark;
    step.place_mm = config_.marks_mm[static_cast<std::size_t>(mark)];
    step.instruction = touches_.holding() ? Instruction::hold_still : Instruction::touch_mark;
    if (touches_.lost()) step.problem = SetupProblem::lost;
  }
  if (finish_is_due()) step.instruction = Instruction::finish;
  return step;
}

}  // namespace hrt
