/*
 * The reach that every host's sample runs (plugin/bindings/README.md), in C: feeds the recorded samples to a
 * session of its own, and prints the hash of the commands that come out, which is the same on every host.
 *
 *   usage: reach RECORDING_CSV
 */
#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/study.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void check(hrt_result result) {
  if (result == HRT_OK) return;
  fprintf(stderr, "reach: %s\n", hrt_last_error());
  exit(1);
}

static void fail(const char* what) {
  fprintf(stderr, "reach: %s\n", what);
  exit(1);
}

/* FNV-1a of the commands, as hrt_replay_report::hash has it. */
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

/* The columns of the recording that are the samples', by name. */
enum { CALL, TIME, FLAGS, X, Y, Z, PLATE, COLUMNS };
static const char* const names[COLUMNS] = {"call",       "time_ns",    "sample_flags",      "sample_x_m",
                                           "sample_y_m", "sample_z_m", "measured_plate_deg"};
static int indices[COLUMNS];

/* Cuts a line into its cells; returns how many. */
static int split(char* line, char** cells, int capacity) {
  int count = 0;
  line[strcspn(line, "\r\n")] = '\0';
  for (char* cell = line; cell && count < capacity; ++count) {
    cells[count] = cell;
    cell = strchr(cell, ',');
    if (cell) *cell++ = '\0';
  }
  return count;
}

static void find_columns(char** header, int count) {
  for (int column = 0; column < COLUMNS; ++column) {
    indices[column] = -1;
    for (int i = 0; i < count; ++i)
      if (strcmp(header[i], names[column]) == 0) indices[column] = i;
    if (indices[column] < 0) fail("the recording lacks a column");
  }
}

/* An empty cell is 0, which is right for what `flags` do not name. */
static hrt_sample read_sample(char** cells) {
  hrt_sample sample = hrt_sample_init();
  sample.flags = (uint32_t)strtoul(cells[indices[FLAGS]], NULL, 10);
  sample.time_ns = strtoll(cells[indices[TIME]], NULL, 10);
  for (int i = 0; i < 3; ++i) sample.finger_position_m[i] = strtod(cells[indices[X + i]], NULL);
  sample.plate_orientation_deg = strtod(cells[indices[PLATE]], NULL);
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
  hrt_session session;
  hrt_reach_config reach = hrt_reach_config_init();
  hrt_command command = hrt_command_init();
  hrt_reach_summary summary = hrt_reach_summary_init();
  char line[2048];
  char* cells[64];
  int columns = 0;
  long updates = 0;
  FILE* file = argc == 2 ? fopen(argv[1], "r") : NULL;
  if (!file) fail("the argument is a recording that can be read");

  session = create_session();
  reach.real_target = add_target(session, HRT_TARGET_REAL, -5, "cylinder");
  reach.virtual_target = add_target(session, HRT_TARGET_VIRTUAL, 5, "cup");
  check(hrt_reach_begin(session, &reach));

  while (fgets(line, sizeof line, file)) {
    hrt_sample sample;
    int count;
    if (line[0] == '#') continue;
    count = split(line, cells, 64);
    if (columns == 0) find_columns(cells, columns = count);
    if (count != columns) fail("a row of the recording is cut off");
    if (strcmp(cells[indices[CALL]], "update") != 0) continue;
    sample = read_sample(cells);
    check(hrt_reach_update(session, &sample, &command));
    hash_command(&command);
    ++updates;
  }
  fclose(file);
  check(hrt_reach_end(session, &summary));
  check(hrt_session_destroy(session));

  printf("hash 0x%016" PRIx64 "\n", hash);
  printf("updates %ld, steps %d, of these predicted %d\n", updates,
         (int)(summary.counts.steps + summary.counts.predicted_steps), (int)summary.counts.predicted_steps);
  printf("ended %.2f deg beside the real target, felt error %.2f deg at most (simulated)\n", summary.miss_deg,
         summary.peak_felt_error_deg);
  return 0;
}
