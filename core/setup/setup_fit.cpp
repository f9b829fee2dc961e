#include "core/setup/setup_fit.h"

#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "core/math/decimal.h"

namespace hrt {
namespace {

// If the spreads of touches and marks differ by more than this factor, positions are in another unit.
constexpr double max_unit_ratio = 3.0;

void reject(SetupProblem problem, std::string reason, SetupFit* fit) {
  fit->problem = problem;
  fit->reason = std::move(reason);
}

std::vector<MarkTouch> mark_touches(const Setup& setup) {
  std::vector<MarkTouch> touches;
  for (int i = 0; i < setup.touches().count(); ++i)
    touches.push_back({setup.config().marks_mm[static_cast<std::size_t>(i % setup.config().mark_count)],
                       setup.touches()[i].touched_mm});
  return touches;
}

void fit_fingertip_of(const Setup& setup, SetupFit* fit) {
  std::vector<TurnedTouch> touches;
  for (int i = 0; i < setup.touches().count(); ++i)
    touches.push_back({setup.touches()[i].joint_rotation, setup.touches()[i].touched_mm});
  const FingertipOffset found = fit_fingertip(setup.config().registration, touches);
  if (found.known)
    fit->fingertip = found;
  else
    reject(SetupProblem::undetermined,
           "tilt the finger more: the SD of the tip's offset is " + decimal(found.sd_mm.maxCoeff(), 0) +
               " mm; allowed: below 5 mm",
           fit);
}

// Root mean square distance from the mean.
double spread_mm(const std::vector<MarkTouch>& touches, Eigen::Vector3d MarkTouch::* point) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const MarkTouch& touch : touches) mean += touch.*point / static_cast<double>(touches.size());
  double square_mm2 = 0.0;
  for (const MarkTouch& touch : touches) square_mm2 += (touch.*point - mean).squaredNorm();
  return std::sqrt(square_mm2 / static_cast<double>(touches.size()));
}

void fit_registration_of(const Setup& setup, SetupFit* fit) {
  std::vector<MarkTouch> touches = mark_touches(setup);
  const RegistrationConfig& config = setup.config().registration;
  const Registration found = fit_registration(config, touches);
  if (found.verdict == RegistrationVerdict::accepted) {
    fit->registration = found;
    return;
  }
  const double scale = spread_mm(touches, &MarkTouch::touched_mm) / spread_mm(touches, &MarkTouch::mark_mm);
  for (MarkTouch& touch : touches) touch.touched_mm.x() = -touch.touched_mm.x();
  const RegistrationVerdict mirrored = fit_registration(config, touches).verdict;
  if (found.verdict == RegistrationVerdict::upside_down || mirrored == RegistrationVerdict::accepted ||
      mirrored == RegistrationVerdict::upside_down)
    reject(SetupProblem::upside_down,
           "marks were confused, or an axis is mirrored: x must point to the right, y up and z towards the user", fit);
  else if (!(scale > 1.0 / max_unit_ratio && scale < max_unit_ratio))
    reject(SetupProblem::disagrees,
           "the touches are " + decimal(scale, 3) + " times as far apart as their marks: positions must be in metres",
           fit);
  else
    reject(SetupProblem::disagrees,
           "the touches are " + decimal(found.residual_mm, 0) + " mm from their marks (root mean square)", fit);
}

// The first touch that disagrees may be a mistake of the user: the check fails only if a second touch disagrees too.
void check_of(const Setup& setup, const Registration& registered, SetupFit* fit) {
  const SetupConfig& config = setup.config();
  const RegistrationCheck found = check_registration(
      registered, {config.marks_mm[static_cast<std::size_t>(config.check_mark)], setup.touches()[0].touched_mm});
  const std::string reason = "the touch is " + decimal(found.distance_mm, 1) +
                             " mm from where the mark should be; up to " + decimal(found.allowed_mm, 1) +
                             " mm is allowed";
  if (!found.holds && setup.step().problem != SetupProblem::disagrees)
    return reject(SetupProblem::disagrees, reason, fit);
  fit->check = found;
  fit->reason = reason;
}

void take_calibration(const Setup& setup, std::variant<Calibration, CalibrationRefusal> found, SetupFit* fit) {
  bool enough = false;
  if (const auto* refusal = std::get_if<CalibrationRefusal>(&found)) {
    fit->reason = refusal->reason;
  } else {
    auto& calibration = std::get<Calibration>(found);
    const Interval& weight = calibration.tactile_weight;
    const double needed = setup.config().enough_weight_width;
    enough = weight.known && weight.upper - weight.lower <= needed;
    const std::vector<std::string> advice = calibration.advice();
    fit->reason = !advice.empty()
                      ? advice.front()
                      : "the 95 % interval of the tactile weight is " + decimal(weight.upper - weight.lower, 3) +
                            " wide; up to " + decimal(needed, 3) + " is enough";
    if (enough || setup.slides_are_full()) fit->calibration = std::move(calibration);
  }
  if (!enough && !setup.slides_are_full()) fit->problem = SetupProblem::undetermined;
}

}  // namespace

PartFit::PartFit(const Setup& setup, Registration registered) : setup_(setup), registered_(std::move(registered)) {
  fit_.part = setup.part();
  const MarkTouches& touches = setup.touches();
  if (touches.count() > 0) fit_.touched_ns = touches[touches.count() - 1].time_ns;
}

bool PartFit::step() {
  switch (fit_.part) {
    case setup_fingertip:
      fit_fingertip_of(setup_, &fit_);
      return true;
    case setup_registration:
      fit_registration_of(setup_, &fit_);
      return true;
    case setup_check:
      check_of(setup_, registered_, &fit_);
      return true;
    case setup_guides:
      fit_.guided = setup_.guided().fit();
      if (!fit_.guided)
        reject(SetupProblem::disagrees, "slides along the same guide, or along different guides, disagree", &fit_);
      return true;
    case setup_calibration:
    case setup_retest:
      break;
  }
  if (!calibration_) {
    fit_.slides = setup_.slides().count();
    calibration_.emplace(setup_.slides().trials(), 0.0);
    return false;
  }
  if (!calibration_->step()) return false;
  take_calibration(setup_, calibration_->result(), &fit_);
  return true;
}

void move_on(const SetupFit& fit, bool found, Setup* setup) {
  if (fit.problem != SetupProblem::none)
    setup->repeat(fit.problem, fit.reason);
  else if (found)
    setup->close();
  else
    setup->drop(fit.check ? SetupProblem::disagrees : SetupProblem::undetermined, fit.reason);
}

}  // namespace hrt
