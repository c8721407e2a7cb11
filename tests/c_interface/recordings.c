/* Recordings: what a plan says, rows in memory, files, progress, stops, refusals. */
#include <math.h>

#include "expect.h"

static void a_plan_says_what_it_makes(void) {
  sarsim_scene* scene = read_small_scene(NULL, 0);
  sarsim_plan* plan = plan_of(scene);
  const sarsim_plan_info info = info_of(plan);
  double times[64];
  double carriers[2];
  double ranges[200];
  double places[6];
  sarsim_problems* problems = NULL;
  EXPECT(info.rows == 64 && info.columns == 100);
  EXPECT(info.sample_rate_hz == 60e6 && info.bits == 8 && info.echoes == 64.0);
  EXPECT(strcmp(info.radar, "Radar1") == 0 && strcmp(info.processing, "raw") == 0);
  EXPECT(strcmp(info.format, "npy") == 0 && strcmp(info.file, "small.npy") == 0);
  EXPECT(info.engine[0] != 0 && info.engine_reason[0] != 0);
  EXPECT(info.seconds > 0.0 && info.memory_bytes > 0.0 && info.file_bytes > 64 * 100 * 8 && info.file_bytes < 64 * 100 * 8 + 256);
  EXPECT_STATUS(sarsim_plan_axis(plan, SARSIM_ROW_TIME_S, 0, 64, times, NULL), SARSIM_OK, NULL);
  EXPECT(times[0] == 0.0 && fabs(times[63] - 0.063) < 1e-12);
  EXPECT_STATUS(sarsim_plan_axis(plan, SARSIM_ROW_CARRIER_HZ, 62, 2, carriers, NULL), SARSIM_OK, NULL);
  EXPECT(carriers[0] == 10e9 && carriers[1] == 10e9);
  EXPECT_STATUS(sarsim_plan_axis(plan, SARSIM_COLUMN_RANGE_M, 0, 100, ranges, NULL), SARSIM_OK, NULL);
  EXPECT(fabs(ranges[0] - 950.0) < 3.0 && fabs(ranges[1] - ranges[0] - 299792458.0 / 120e6) < 1e-6);
  EXPECT_STATUS(sarsim_plan_axis(plan, SARSIM_ROW_POSITION_M, 3, 2, places, NULL), SARSIM_OK, NULL);
  EXPECT(places[0] == 0.0 && places[5] == 0.0);
  EXPECT(sarsim_plan_axis(plan, SARSIM_ROW_TIME_S, 60, 5, times, &problems) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_problems_count(problems) == 1);
  sarsim_problems_free(problems);
  EXPECT(sarsim_plan_axis(plan, SARSIM_COLUMN_RANGE_M, 101, 0, ranges, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_plan_axis(plan, 77, 0, 1, times, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_plan_new(scene, 2, NULL, &plan, &problems) == SARSIM_BAD_INPUT && plan == NULL);
  EXPECT(sarsim_problems_count(problems) == 1);
  sarsim_problems_free(problems);
  EXPECT(sarsim_plan_new(scene, 0, NULL, &plan, NULL) == SARSIM_BAD_ARGUMENT);
  sarsim_scene_free(scene);
}

/* The echo lies where the target is, any rows are those of the whole, and what lies beside them is left alone. */
static void rows_are_those_of_the_whole(void) {
  static float whole[64 * 200];
  static double exact[64 * 200];
  static float piece[7 * 200 + 2];
  sarsim_scene* scene = read_small_scene(NULL, 0);
  sarsim_plan* plan = plan_of(scene);
  sarsim_work work = SARSIM_INIT(sarsim_work);
  unsigned threads;
  size_t i;
  sarsim_scene_free(scene);
  EXPECT_STATUS(sarsim_record_float(plan, 0, 64, whole, NULL, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_record_double(plan, 0, 64, exact, NULL, NULL), SARSIM_OK, NULL);
  EXPECT(whole[0] == 0.0f && hypot(exact[2 * 40], exact[2 * 40 + 1]) > 0.0);
  for (i = 0; i < 64 * 200; ++i) EXPECT(whole[i] == (float)exact[i]);
  for (threads = 1; threads <= 8; threads *= 2) {
    work.threads = threads;
    memset(piece, 0x55, sizeof piece);
    EXPECT_STATUS(sarsim_record_float(plan, 50, 7, piece + 1, &work, NULL), SARSIM_OK, NULL);
    EXPECT(memcmp(piece + 1, whole + 50 * 200, 7 * 200 * sizeof(float)) == 0);
    EXPECT(memcmp(piece, piece + 7 * 200 + 1, sizeof(float)) == 0); /* Still 0x55. */
  }
  EXPECT_STATUS(sarsim_record_float(plan, 64, 0, NULL, NULL, NULL), SARSIM_OK, NULL);
  EXPECT(sarsim_record_float(plan, 60, 5, piece, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_record_float(plan, UINT64_MAX, 2, piece, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  sarsim_plan_free(plan);
}

struct seen {
  uint64_t last;
  uint64_t total;
  unsigned calls;
  sarsim_stop* stop; /* Requested at the first row, where there is one. */
};

static void look(void* user, const char* stage, uint64_t done, uint64_t total) {
  struct seen* seen = user;
  EXPECT(stage[0] != 0);
  EXPECT(done >= seen->last && done <= total);
  seen->last = done;
  seen->total = total;
  ++seen->calls;
  if (seen->stop != NULL && done > 0) sarsim_stop_request(seen->stop);
}

static void progress_is_told_and_work_stops(void) {
  static float samples[64 * 200];
  sarsim_scene* scene = read_small_scene(NULL, 0);
  sarsim_plan* plan = plan_of(scene);
  sarsim_work work = SARSIM_INIT(sarsim_work);
  struct seen seen = {0, 0, 0, NULL};
  sarsim_stop* stop = NULL;
  sarsim_problems* problems = NULL;
  FILE* file;
  work.progress = look;
  work.user = &seen;
  work.threads = 2;
  EXPECT_STATUS(sarsim_record_float(plan, 0, 64, samples, &work, NULL), SARSIM_OK, NULL);
  EXPECT(seen.last == 64 && seen.total == 64 && seen.calls > 1);

  EXPECT_STATUS(sarsim_stop_new(&stop, NULL), SARSIM_OK, NULL);
  work.stop = stop;
  work.threads = 1;
  memset(&seen, 0, sizeof seen);
  seen.stop = stop;
  EXPECT(sarsim_record_float(plan, 0, 64, samples, &work, &problems) == SARSIM_STOPPED);
  EXPECT(sarsim_problems_count(problems) == 1);
  sarsim_problems_free(problems);
  EXPECT(seen.last > 0 && seen.last < 64);

  /* It stays requested; no file and no beginning of one is left. */
  memset(&seen, 0, sizeof seen);
  EXPECT(sarsim_record_file(plan, "stopped.npy", NULL, &work, NULL, NULL) == SARSIM_STOPPED);
  file = fopen("stopped.npy", "rb");
  EXPECT(file == NULL);
  EXPECT(sarsim_scene_check(scene, &work, NULL) == SARSIM_STOPPED);
  sarsim_stop_free(stop);
  sarsim_plan_free(plan);
  sarsim_scene_free(scene);
}

static void files_are_not_replaced_unasked(void) {
  sarsim_scene* scene = read_small_scene(NULL, 0);
  sarsim_plan* plan = plan_of(scene);
  sarsim_file_options options = SARSIM_INIT(sarsim_file_options);
  sarsim_file_report report = SARSIM_INIT(sarsim_file_report);
  sarsim_problems* problems = NULL;
  char beginning[8] = {0};
  FILE* file;
  EXPECT_STATUS(sarsim_record_file(plan, "small.csv", NULL, NULL, &report, NULL), SARSIM_OK, NULL);
  EXPECT(report.maximum_v > 0.0 && report.lsb_v > 0.0 && report.bytes > 64 * 100 * 4);
  EXPECT(sarsim_record_file(plan, "small.csv", NULL, NULL, NULL, &problems) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_problems_count(problems) == 1);
  sarsim_problems_free(problems);
  options.replace = 1;
  options.format = "npy";
  EXPECT_STATUS(sarsim_record_file(plan, "small.csv", &options, NULL, NULL, NULL), SARSIM_OK, NULL);
  file = fopen("small.csv", "rb");
  EXPECT(file != NULL && fread(beginning, 1, 6, file) == 6 && memcmp(beginning, "\x93NUMPY", 6) == 0);
  fclose(file);
  options.format = "wav";
  EXPECT(sarsim_record_file(plan, "small.csv", &options, NULL, NULL, &problems) == SARSIM_BAD_INPUT);
  sarsim_problems_free(problems);
  EXPECT(sarsim_record_file(plan, "no/such/folder/a.npy", NULL, NULL, NULL, &problems) == SARSIM_FAILED);
  EXPECT(sarsim_problems_count(problems) == 1);
  sarsim_problems_free(problems);
  sarsim_plan_free(plan);
  sarsim_scene_free(scene);
}

int main(void) {
  a_plan_says_what_it_makes();
  rows_are_those_of_the_whole();
  progress_is_told_and_work_stops();
  files_are_not_replaced_unasked();
  return 0;
}
