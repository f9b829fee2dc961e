/*
 * The reach that every host's sample runs (plugin/bindings/README.md), in C: passes a scripted finger to a new session
 * and prints the hash of the resulting commands, which is the same on every host.
 *
 *   usage: reach [RECORDING_CSV]    also records the calls in RECORDING_CSV
 */
#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/person.h>
#include <haptic_retargeting/recording.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void check(hrt_result result) {
  if (result == HRT_OK) return;
  fprintf(stderr, "reach: %s\n", hrt_last_error());
  exit(1);
}

/* FNV-1a hash of the commands, as in hrt_replay_report::hash. */
static uint64_t hash = UINT64_C(0xcbf29ce484222325);

static void hash_word(uint64_t word) {
  for (int byte = 0; byte < 8; ++byte) hash = (hash ^ (word >> (8 * byte) & 0xff)) * UINT64_C(0x100000001b3);
}

static void hash_number(double number) {
  uint64_t bits;
  memcpy(&bits, &number, sizeof bits);
  hash_word(bits);
}

static void hash_command(const hrt_command* command) {
#define HASH_WHOLE(name) hash_word((uint64_t)command->name);
#define HASH_NUMBER(name) hash_number(command->name);
  HRT_HASHED_FIELDS(HASH_WHOLE, HASH_NUMBER)
}

static int64_t noise(void) {
  static int64_t seed = 7;
  seed = seed * 16807 % 2147483647;
  return seed % 1001 - 500;
}

/* Returns sample `i`, from 1. Coordinates are constants or quotients of integers: the same doubles on every host. */
static hrt_sample scripted(int64_t i, double plate_deg) {
  const int64_t moved = i < 10 ? 0 : i > 130 ? 120 : i - 10, distance_um = moved * moved * (180 - moved) * 25 / 216;
  const int64_t right_um = distance_um * 87 / 1000;
  const int lost = i % 40 == 7 || (i > 40 && i <= 52), lifted = i > 65 && i <= 75;
  hrt_sample sample = hrt_sample_init();
  sample.flags =
      HRT_SAMPLE_PLATE_ORIENTATION | (lost ? 0 : HRT_SAMPLE_PLATE_POSITION) | (lifted ? HRT_SAMPLE_LIFTED : 0);
  sample.time_ns = 20000000 * i + 400 * noise();
  sample.finger_position_m[0] = (double)(right_um + noise()) / 1e6;
  sample.finger_position_m[1] = lifted ? 0.03 : 0.002;
  sample.finger_position_m[2] = (double)(50000 - distance_um + noise()) / 1e6;
  sample.plate_orientation_deg = plate_deg;
  return sample;
}

static hrt_session create_session(void) {
  hrt_session_config config = hrt_session_config_init();
  hrt_session session;
  config.paper.horizon = 20;
  config.guidance = HRT_GUIDANCE_ARRIVAL;
  config.adaptation = HRT_ADAPTATION_REACH;
  config.plate.max_speed_deg_s = 200;
  config.plate.max_acceleration_deg_s2 = 20000;
  config.plate.latency_ns = 30000000;
  config.plate.lower_stop_deg = -360;
  config.plate.upper_stop_deg = 360;
  check(hrt_session_create(HRT_VERSION, &config, &session));
  return session;
}

static hrt_target add_target(hrt_session session, uint32_t role, double direction_deg, const char* name) {
  hrt_target_config config = hrt_target_config_init();
  hrt_target target;
  config.role = role;
  config.direction_deg = direction_deg;
  snprintf(config.name, sizeof config.name, "%s", name);
  check(hrt_target_add(session, &config, &target));
  return target;
}

int main(int argc, char** argv) {
  hrt_session session = create_session();
  hrt_reach_config reach = hrt_reach_config_init();
  hrt_command command = hrt_command_init();
  hrt_reach_summary summary = hrt_reach_summary_init();
  if (argc > 1) check(hrt_recording_start(session, argv[1]));
  reach.real_target = add_target(session, HRT_TARGET_REAL, -5, "cylinder");
  reach.virtual_target = add_target(session, HRT_TARGET_VIRTUAL, 5, "cup");
  check(hrt_reach_begin(session, &reach));
  for (int i = 1; i <= 170; ++i) {
    const hrt_sample sample = scripted(i, command.plate_orientation_deg);
    if (i > 105 && i <= 108) continue; /* frames that the host drops */
    check(hrt_reach_update(session, &sample, &command));
    hash_command(&command);
  }
  check(hrt_reach_end(session, &summary));
  check(hrt_session_destroy(session));

  printf("hash 0x%016" PRIx64 "\n", hash);
  printf("samples %d, of these dropped %d\n", (int)summary.counts.samples, (int)summary.counts.dropped_samples);
  printf("ended %.2f deg from the real target, perceived-direction error up to %.2f deg (scripted)\n", summary.miss_deg,
         summary.peak_felt_error_deg);
  return 0;
}
