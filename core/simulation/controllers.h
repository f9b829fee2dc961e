// Controllers as people meet them: without knowledge of the person, with some of it, and the paper's.
#pragma once

#include <span>

#include "core/retargeter_config.h"
#include "core/simulation/people.h"

namespace hrt {

/// A controller for people that knows what the usual plate and tracker can do, and nothing of the person.
RetargeterConfig people_controller(const Tuning& tuning = {});

/// The same, with the tracker's declared latency.
RetargeterConfig people_controller(const PersonCondition& condition, const Tuning& tuning = {});

/// Traits that an informed controller is given. The gain and the fading of touch are parameters of the
/// model: using those of a simulated person costs more reaches than it gains.
inline constexpr PersonState::Index telling_traits[] = {
    PersonState::weight,  PersonState::curve,      PersonState::bias,    PersonState::habit,
    PersonState::scatter, PersonState::log_wander, PersonState::log_rate};

/// A controller for people with plate and tracker known, and these traits of the person as far as its model
/// describes them.
RetargeterConfig informed_controller(const PersonCondition& condition,
                                     std::span<const PersonState::Index> traits = telling_traits,
                                     const Tuning& tuning = {});

/// The paper's, with w_T assumed 0.15.
RetargeterConfig paper_controller();

}  // namespace hrt
