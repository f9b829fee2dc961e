/* One reach with haptic retargeting. The user is simulated by the plugin (haptic_retargeting/person.h). */
#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/person.h>
#include <stdio.h>

#define CHECK(call) \
  if ((call) != HRT_OK) return fprintf(stderr, "%s\n", hrt_last_error()), 1

int main(void) {
  hrt_session session;
  hrt_person person; /* a simulated user, who feels the plate and moves the finger */
  hrt_target_config cylinder = hrt_target_config_init(), cup = cylinder;
  hrt_reach_config reach = hrt_reach_config_init();
  hrt_sample sample = hrt_sample_init();
  hrt_command command = hrt_command_init();
  hrt_reach_summary summary = hrt_reach_summary_init();
  hrt_person_state end = hrt_person_state_init();
  CHECK(hrt_session_create(HRT_VERSION, NULL, &session));       /* with the default configuration */
  cylinder.role = HRT_TARGET_REAL, cylinder.direction_deg = -5; /* where the hand is steered */
  CHECK(hrt_target_add(session, &cylinder, &reach.real_target));
  cup.role = HRT_TARGET_VIRTUAL, cup.direction_deg = 5; /* what the user reaches for */
  CHECK(hrt_target_add(session, &cup, &reach.virtual_target));
  CHECK(hrt_person_create(NULL, 1, &person));
  CHECK(hrt_person_begin(person, session, reach.virtual_target));
  CHECK(hrt_reach_begin(session, &reach));
  for (int frame = 0; frame < 900 && !(command.flags & HRT_COMMAND_ARRIVED); ++frame) { /* at most 10 s */
    /* with a real user, fill `sample` from your hand tracker instead of the next line: time, position, flags */
    CHECK(hrt_person_move(person, frame * INT64_C(11111111), command.plate_orientation_deg, &sample));
    CHECK(hrt_reach_update(session, &sample, &command)); /* turn the plate to command.plate_orientation_deg */
  }
  CHECK(hrt_reach_end(session, &summary)); /* position of the end, and estimates of the user */
  CHECK(hrt_person_get_state(person, &end));
  printf("The hand ended %.1f mm to the right of where it was felt.\n",
         1000 * (end.position_m[0] - end.felt_position_m[0]));
  hrt_person_destroy(person);
  hrt_session_destroy(session);
  return 0;
}
