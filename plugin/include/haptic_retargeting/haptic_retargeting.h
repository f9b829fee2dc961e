/*
 * Haptic retargeting by touch: a ridged plate under the finger turns so that the hand arrives at a real target
 * while the user perceives a motion to a virtual target. This header has the calls of a frame loop. Each other header
 * has one concept: host.h, gap.h, scene.h, profile.h, setup.h, person.h, recording.h, plate.h.
 *
 * Example: one reach. A simulated person replaces the tracked finger and the plate.
 *
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *   #include <haptic_retargeting/person.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     hrt_session session;
 *     hrt_person person;
 *     hrt_target_config cylinder = hrt_target_config_init(), cup = cylinder;
 *     hrt_reach_config reach = hrt_reach_config_init();
 *     hrt_sample sample = hrt_sample_init();
 *     hrt_command command = hrt_command_init();
 *     hrt_reach_summary summary = hrt_reach_summary_init();
 *     cylinder.role = HRT_TARGET_REAL, cylinder.direction_deg = -5; // 5 degrees to the right
 *     cup.role = HRT_TARGET_VIRTUAL, cup.direction_deg = 5;
 *     int failed = hrt_session_create(HRT_VERSION, NULL, &session) ||
 *                  hrt_target_add(session, &cylinder, &reach.real_target) ||
 *                  hrt_target_add(session, &cup, &reach.virtual_target) ||
 *                  hrt_person_create(NULL, 1, &person) ||
 *                  hrt_person_begin(person, session, reach.virtual_target) || hrt_reach_begin(session, &reach);
 *     for (int frame = 0; !failed && frame < 900 && !(command.flags & HRT_COMMAND_ARRIVED); ++frame) {
 *       const int64_t time_ns = frame * INT64_C(11111111);
 *       failed = hrt_person_move(person, time_ns, command.plate_orientation_deg, &sample) ||
 *                hrt_reach_update(session, &sample, &command);
 *     }
 *     failed = failed || hrt_reach_end(session, &summary);
 *     if (failed) puts(hrt_last_error());
 *     else printf("The finger ended %.1f degrees from the real target.\n", summary.miss_deg);
 *     return failed;
 *   }
 */
#ifndef HAPTIC_RETARGETING_H
#define HAPTIC_RETARGETING_H

#include "base.h"
#include "init.h"
#include "reach.h"
#include "session.h"
#include "target.h"

#endif
