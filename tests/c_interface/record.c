/* Makes a recording of a scene.
 *
 *   c_record SCENE NUMBER FILE FORMAT    as a file of that format
 *   c_record SCENE NUMBER FILE float     in memory, some rows at a time, and from there as bare numbers
 *   c_record SCENE NUMBER FILE double    the same in double precision
 */
#include "expect.h"

static void write_numbers(const sarsim_plan* plan, const char* path, int doubles) {
  const sarsim_plan_info info = info_of(plan);
  const size_t number_bytes = doubles ? sizeof(double) : sizeof(float);
  const size_t row_numbers = 2 * (size_t)info.columns;
  unsigned char* samples = malloc(info.rows * row_numbers * number_bytes);
  sarsim_work work = SARSIM_INIT(sarsim_work);
  FILE* file = fopen(path, "wb");
  uint64_t first;
  EXPECT(samples != NULL && file != NULL);
  work.threads = 3;
  for (first = 0; first < info.rows; first += 17) {
    const uint64_t count = info.rows - first < 17 ? info.rows - first : 17;
    void* rows = samples + first * row_numbers * number_bytes;
    sarsim_problems* problems = NULL;
    const sarsim_status status = doubles ? sarsim_record_double(plan, first, count, rows, &work, &problems)
                                         : sarsim_record_float(plan, first, count, rows, &work, &problems);
    EXPECT_STATUS(status, SARSIM_OK, problems);
  }
  EXPECT(fwrite(samples, row_numbers * number_bytes, info.rows, file) == info.rows);
  EXPECT(fclose(file) == 0);
  free(samples);
}

static void write_file(const sarsim_plan* plan, const char* path, const char* format) {
  sarsim_file_options options = SARSIM_INIT(sarsim_file_options);
  sarsim_file_report report = SARSIM_INIT(sarsim_file_report);
  sarsim_problems* problems = NULL;
  sarsim_status status;
  options.format = format;
  status = sarsim_record_file(plan, path, &options, NULL, &report, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  EXPECT(report.bytes > 0.0 && report.maximum_v > 0.0);
}

int main(int argc, char** argv) {
  sarsim_scene* scene = NULL;
  sarsim_plan* plan = NULL;
  sarsim_problems* problems = NULL;
  sarsim_status status;
  EXPECT(argc == 5);
  status = sarsim_scene_read_file(argv[1], NULL, &scene, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  problems = NULL;
  status = sarsim_plan_new(scene, (size_t)atoi(argv[2]), NULL, &plan, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  sarsim_scene_free(scene); /* A plan keeps what it needs. */
  if (strcmp(argv[4], "float") == 0)
    write_numbers(plan, argv[3], 0);
  else if (strcmp(argv[4], "double") == 0)
    write_numbers(plan, argv[3], 1);
  else
    write_file(plan, argv[3], argv[4]);
  sarsim_plan_free(plan);
  return 0;
}
