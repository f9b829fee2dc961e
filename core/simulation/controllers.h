// Controllers as people meet them: without knowledge of the person, with all of it, and the paper's.
#pragma once

#include "core/retargeter_config.h"
#include "core/simulation/people.h"

namespace hrt {

/// A controller for people that knows what the usual plate and tracker can do, and nothing of the person.
RetargeterConfig people_controller();

/// The same, with the tracker's declared latency.
RetargeterConfig people_controller(const PersonCondition& condition);

/// A controller for people with plate, tracker and person known, as far as its model describes them.
RetargeterConfig informed_controller(const PersonCondition& condition);

/// The paper's, with w_T assumed 0.15.
RetargeterConfig paper_controller();

}  // namespace hrt
