#include "core/setup/setup_fit.h"

#include <utility>
#include <variant>
#include <vector>

namespace hrt {
namespace {

// Of touches of marks that go round.
std::vector<MarkTouch> mark_touches(const Setup& setup) {
  std::vector<MarkTouch> touches;
  for (int i = 0; i < setup.touches().count(); ++i)
    touches.push_back({setup.config().marks_mm[static_cast<std::size_t>(i % setup.config().mark_count)],
                       setup.touches()[i].touched_mm});
  return touches;
}

SetupProblem fit_fingertip_of(const Setup& setup, SetupFit* fit) {
  std::vector<TurnedTouch> touches;
  for (int i = 0; i < setup.touches().count(); ++i)
    touches.push_back({setup.touches()[i].joint_rotation, setup.touches()[i].touched_mm});
  const FingertipOffset found = fit_fingertip(setup.config().registration, touches);
  if (!found.known) return SetupProblem::undetermined;
  fit->fingertip = found;
  return SetupProblem::none;
}

SetupProblem fit_registration_of(const Setup& setup, SetupFit* fit) {
  const Registration found = fit_registration(setup.config().registration, mark_touches(setup));
  if (found.verdict == RegistrationVerdict::upside_down) return SetupProblem::upside_down;
  if (found.verdict != RegistrationVerdict::holds) return SetupProblem::disagrees;
  fit->registration = found;
  return SetupProblem::none;
}

// One touch that disagrees may be a bad one: the second decides.
SetupProblem check_of(const Setup& setup, const Registration& registered, SetupFit* fit) {
  const SetupConfig& config = setup.config();
  const RegistrationCheck found = check_registration(
      registered, {config.marks_mm[static_cast<std::size_t>(config.check_mark)], setup.touches()[0].touched_mm});
  if (!found.holds && setup.step().problem != SetupProblem::disagrees) return SetupProblem::disagrees;
  fit->check = found;
  return SetupProblem::none;
}

SetupProblem calibrate_of(const Setup& setup, SetupFit* fit) {
  auto found = calibrate(setup.slides().trials());
  if (auto* calibration = std::get_if<Calibration>(&found)) {
    const Interval& weight = calibration->tactile_weight;
    const bool enough = weight.known && weight.upper - weight.lower <= setup.config().enough_weight_width;
    if (enough || setup.slides_are_full()) fit->calibration = std::move(*calibration);
  }
  return fit->calibration || setup.slides_are_full() ? SetupProblem::none : SetupProblem::undetermined;
}

}  // namespace

SetupFit finish_part(Setup* setup, const Registration& registered) {
  SetupFit fit;
  fit.part = setup->part();
  const MarkTouches& touches = setup->touches();
  if (touches.count() > 0) fit.touched_ns = touches[touches.count() - 1].time_ns;
  switch (fit.part) {
    case setup_fingertip:
      fit.problem = fit_fingertip_of(*setup, &fit);
      break;
    case setup_registration:
      fit.problem = fit_registration_of(*setup, &fit);
      break;
    case setup_check:
      fit.problem = check_of(*setup, registered, &fit);
      break;
    case setup_guides:
      fit.guided = setup->guided().fit();
      if (!fit.guided) fit.problem = SetupProblem::disagrees;
      break;
    case setup_calibration:
    case setup_retest:
      fit.slides = setup->slides().count();
      fit.problem = calibrate_of(*setup, &fit);
      break;
  }
  // Along guides of a plate that is elsewhere there is nothing to be seen.
  if (fit.check && !fit.check->holds) setup->leave_out(setup_guides);
  if (fit.problem == SetupProblem::none)
    setup->close();
  else
    setup->repeat(fit.problem);
  return fit;
}

}  // namespace hrt
