/* Handles give back what they took: the memory of the process does not grow over hundreds of them. */
#include <unistd.h>

#include "expect.h"

/* Memory that the process holds; 0 where the system does not say. */
static double resident_bytes(void) {
  long all = 0;
  long resident = 0;
  FILE* file = fopen("/proc/self/statm", "r");
  if (file == NULL) return 0.0;
  if (fscanf(file, "%ld %ld", &all, &resident) != 2) resident = 0;
  fclose(file);
  return (double)resident * (double)sysconf(_SC_PAGESIZE);
}

/* One of each, used and freed; some calls are refused, so that lists of problems are made as well. */
static void use_everything(const sarsim_scene* read) {
  static float samples[2 * 64 * 100];
  static const double points[6] = {0.0, 1000.0, 0.0, 5.0, 1010.0, 0.0};
  const char* const maps[] = {"interval=16", "cfar=none"};
  const char* const wrong[] = {"interval=none", "unknown"};
  sarsim_scene* scene = NULL;
  sarsim_source* source = NULL;
  sarsim_result* result = NULL;
  sarsim_raster* raster = NULL;
  sarsim_text* text = NULL;
  sarsim_stop* stop = NULL;
  sarsim_problems* problems = NULL;
  EXPECT_STATUS(sarsim_scene_copy(read, &scene, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_scene_add_targets(scene, "Earth", 2, points, NULL, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_scene_add_cloud(scene, "Earth", "points.npy", 2, points, NULL, NULL), SARSIM_OK, NULL);
  EXPECT(sarsim_scene_set(scene, "Radar1.bandwidht", "1 MHz", &problems) == SARSIM_BAD_INPUT);
  sarsim_problems_free(problems);
  EXPECT_STATUS(sarsim_scene_text(scene, SARSIM_FORMAT_2, &text, NULL), SARSIM_OK, NULL);
  sarsim_text_free(text);
  sarsim_plan* plan = plan_of(scene);
  EXPECT_STATUS(sarsim_record_float(plan, 0, 64, samples, NULL, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_source_floats(plan, samples, &source, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_doppler(source, maps, 2, NULL, &result, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_result_raster(result, 0, &raster, NULL), SARSIM_OK, NULL);
  sarsim_result_free(result);
  EXPECT(sarsim_doppler(source, wrong, 2, NULL, &result, &problems) == SARSIM_BAD_INPUT && result == NULL);
  sarsim_problems_free(problems);
  EXPECT_STATUS(sarsim_stop_new(&stop, NULL), SARSIM_OK, NULL);
  sarsim_stop_free(stop);
  sarsim_raster_free(raster);
  sarsim_source_free(source);
  sarsim_plan_free(plan);
  sarsim_scene_free(scene);
}

int main(void) {
  enum { before = 50, rounds = 200 };
  sarsim_scene* scene = read_small_scene(NULL, 0);
  for (int i = 0; i < before; ++i) use_everything(scene);
  const double held = resident_bytes();
  for (int i = 0; i < rounds; ++i) use_everything(scene);
  const double grown = resident_bytes() - held;
#ifndef __SANITIZE_ADDRESS__ /* It keeps freed memory aside. */
#ifndef __SANITIZE_THREAD__
  if (grown > 2e6) fprintf(stderr, "%d rounds took %.0f bytes for good\n", rounds, grown);
  EXPECT(grown <= 2e6);
#endif
#endif
  (void)grown;
  sarsim_scene_free(scene);
  return 0;
}
