/*
 * Haptic retargeting by touch: a ridged plate under the finger turns so that the hand arrives at a real
 * target while the user feels that it goes to a virtual one. This header includes all others.
 */
#ifndef HAPTIC_RETARGETING_H
#define HAPTIC_RETARGETING_H

#include "authority.h"
#include "base.h"
#include "calibration.h"
#include "host.h"
#include "init.h"
#include "profile.h"
#include "reach.h"
#include "recording.h"
#include "registration.h"
#include "scene.h"
#include "session.h"
#include "study.h"
#include "target.h"

#endif
