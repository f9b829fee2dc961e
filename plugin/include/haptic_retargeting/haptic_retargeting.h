/*
 * Haptic retargeting by touch: a ridged plate under the finger turns so that the hand arrives at a real
 * target while the user perceives that it moves to a virtual one. This header has the calls of a frame loop.
 * The others have one concept each: host.h, gap.h, scene.h, profile.h, setup.h, person.h, recording.h, plate.h.
 */
#ifndef HAPTIC_RETARGETING_H
#define HAPTIC_RETARGETING_H

#include "base.h"
#include "init.h"
#include "reach.h"
#include "session.h"
#include "target.h"

#endif
