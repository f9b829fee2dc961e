// Configurations of controllers for simulated reaches: uninformed, informed, and the paper's.
#pragma once

#include <span>

#include "core/retargeter_config.h"
#include "core/simulation/people.h"

namespace hrt {

/// Returns a controller for people with the dynamics of a usual plate and the prior of an unknown person.
RetargeterConfig people_controller(const Tuning& tuning = {});

/// Returns people_controller(tuning) with the declared latency and accuracy of the condition's tracker.
RetargeterConfig people_controller(const PersonCondition& condition, const Tuning& tuning = {});

/// Traits that an informed controller is given by default. README.md ("Limits") shows why the gain is not among them.
inline constexpr PersonState::Index informed_traits[] = {
    PersonState::weight,  PersonState::curve,      PersonState::bias,    PersonState::habit,
    PersonState::scatter, PersonState::log_wander, PersonState::log_rate};

/// Returns an informed controller, which is given the true dynamics of the plate, the true latency of the tracker, and
/// the true values of `traits` as far as its model can describe them.
RetargeterConfig informed_controller(const PersonCondition& condition,
                                     std::span<const PersonState::Index> traits = informed_traits,
                                     const Tuning& tuning = {});

/// Returns the paper's controller, with an assumed tactile weight of 0.15.
RetargeterConfig paper_controller();

}  // namespace hrt
