/* Arguments that are none: null pointers, and numbers below 0 that an unsigned type makes huge. Nothing crashes, nothing
   is made, and the status is that of a mistake of the program. */
#include <stdint.h>

#include "expect.h"

/* A call that refuses its arguments and says why. */
#define REFUSED(call)                                         \
  do {                                                        \
    sarsim_problems* problems = NULL;                         \
    EXPECT((call) == SARSIM_BAD_ARGUMENT);                    \
    EXPECT(sarsim_problems_count(problems) == 1);             \
    sarsim_problems_free(problems);                           \
  } while (0)

static const size_t negative = (size_t)-1;
static const double points[6] = {0.0, 1000.0, 0.0, 5.0, 1010.0, 0.0};

static void scenes(sarsim_scene* scene) {
  sarsim_scene* made = NULL;
  sarsim_text* text = NULL;
  size_t count = 0;
  double number = 0.0;
  const char* const let[] = {"far=1"};
  sarsim_scene_options options = SARSIM_INIT(sarsim_scene_options);
  REFUSED(sarsim_scene_read_text("x", negative, "x", NULL, &made, &problems));
  REFUSED(sarsim_scene_read_text(NULL, 1, "x", NULL, &made, &problems));
  REFUSED(sarsim_scene_read_text("x", 1, "x", NULL, NULL, &problems));
  REFUSED(sarsim_scene_read_file(NULL, NULL, &made, &problems));
  options.let = let;
  options.let_count = negative;
  REFUSED(sarsim_scene_read_text("x", 1, "x", &options, &made, &problems));
  options.let = NULL;
  options.let_count = 1;
  REFUSED(sarsim_scene_read_text("x", 1, "x", &options, &made, &problems));
  EXPECT(made == NULL);
  REFUSED(sarsim_scene_copy(NULL, &made, &problems));
  REFUSED(sarsim_scene_copy(scene, NULL, &problems));
  REFUSED(sarsim_scene_text(NULL, SARSIM_FORMAT_2, &text, &problems));
  REFUSED(sarsim_scene_text(scene, (sarsim_language)7, &text, &problems));
  REFUSED(sarsim_scene_add_targets(scene, "Earth", negative, points, NULL, &problems));
  REFUSED(sarsim_scene_add_targets(scene, "Earth", negative / 3, points, NULL, &problems));
  REFUSED(sarsim_scene_add_targets(scene, "Earth", 2, NULL, NULL, &problems));
  REFUSED(sarsim_scene_add_targets(scene, NULL, 2, points, NULL, &problems));
  REFUSED(sarsim_scene_add_cloud(scene, "Earth", "c.npy", negative, points, NULL, &problems));
  REFUSED(sarsim_scene_add_cloud(scene, "Earth", NULL, 2, points, NULL, &problems));
  REFUSED(sarsim_scene_set_points(scene, "Radar1.pulse_iq", negative, 2, points, points, NULL, &problems));
  REFUSED(sarsim_scene_set_points(scene, "Radar1.pulse_iq", 2, 0, points, points, NULL, &problems));
  REFUSED(sarsim_scene_set_points(scene, "Radar1.pulse_iq", 2, 2, points, NULL, NULL, &problems));
  REFUSED(sarsim_scene_remove(scene, "target", negative, &problems));
  REFUSED(sarsim_scene_remove(scene, "nothing", 0, &problems));
  REFUSED(sarsim_scene_remove(scene, NULL, 0, &problems));
  REFUSED(sarsim_scene_name(scene, "target", negative, &text, &problems));
  REFUSED(sarsim_scene_fields(scene, "target", negative, &text, &problems));
  REFUSED(sarsim_scene_get(scene, NULL, &text, &problems));
  REFUSED(sarsim_scene_set(scene, "Radar1.power", NULL, &problems));
  REFUSED(sarsim_scene_get_number(scene, "Radar1.power", NULL, &problems));
  REFUSED(sarsim_scene_get_number(NULL, "Radar1.power", &number, &problems));
  REFUSED(sarsim_scene_count(scene, NULL, &count, &problems));
  REFUSED(sarsim_explain(NULL, SARSIM_WORDS, &text, &problems));
  REFUSED(sarsim_options("nothing", SARSIM_WORDS, &text, &problems));
  EXPECT(text == NULL);
  EXPECT_STATUS(sarsim_scene_count(scene, "target", &count, NULL), SARSIM_OK, NULL);
  EXPECT(count == 1);
}

static void recordings(const sarsim_scene* scene) {
  static float samples[2 * 64 * 100];
  double values[64];
  sarsim_plan* plan = plan_of(scene);
  sarsim_plan* none = NULL;
  sarsim_source* source = NULL;
  sarsim_result* result = NULL;
  sarsim_work work = SARSIM_INIT(sarsim_work);
  const char* const words[] = {"interval=16", NULL};
  REFUSED(sarsim_plan_new(scene, 0, NULL, &none, &problems));
  work.threads = (unsigned)-1;
  REFUSED(sarsim_plan_new(scene, 1, &work, &none, &problems));
  REFUSED(sarsim_scene_check(scene, &work, &problems));
  REFUSED(sarsim_record_float(plan, 0, 64, samples, &work, &problems));
  REFUSED(sarsim_record_float(plan, (uint64_t)-1, 1, samples, NULL, &problems));
  REFUSED(sarsim_record_float(plan, 0, (uint64_t)-1, samples, NULL, &problems));
  REFUSED(sarsim_record_float(plan, 1, (uint64_t)-1, samples, NULL, &problems));
  REFUSED(sarsim_record_float(plan, 0, 64, NULL, NULL, &problems));
  REFUSED(sarsim_record_rows(plan, 0, 64, 0, NULL, NULL, NULL, &problems));
  REFUSED(sarsim_record_file(plan, NULL, NULL, NULL, NULL, &problems));
  REFUSED(sarsim_plan_axis(plan, SARSIM_ROW_TIME_S, 0, 65, values, &problems));
  REFUSED(sarsim_plan_axis(plan, (sarsim_axis)77, 0, 1, values, &problems));
  REFUSED(sarsim_plan_axis(plan, SARSIM_ROW_TIME_S, 0, 1, NULL, &problems));
  EXPECT_STATUS(sarsim_source_floats(plan, samples, &source, NULL), SARSIM_OK, NULL);
  REFUSED(sarsim_doppler(source, words, negative, NULL, &result, &problems));
  REFUSED(sarsim_doppler(source, words, 2, NULL, &result, &problems));
  REFUSED(sarsim_doppler(source, NULL, 1, NULL, &result, &problems));
  REFUSED(sarsim_doppler(source, words, 1, &work, &result, &problems));
  REFUSED(sarsim_doppler(NULL, NULL, 0, NULL, &result, &problems));
  REFUSED(sarsim_doppler(source, words, 1, NULL, NULL, &problems));
  work.struct_size = 3;
  REFUSED(sarsim_doppler(source, words, 1, &work, &result, &problems));
  EXPECT(none == NULL && result == NULL);
  sarsim_source_free(source);
  sarsim_plan_free(plan);
}

static void rasters(void) {
  static const float samples[12] = {0.0F};
  float back[12];
  sarsim_raster* raster = NULL;
  sarsim_raster* none = NULL;
  sarsim_raster_info info = SARSIM_INIT(sarsim_raster_info);
  sarsim_axis_info axis = SARSIM_INIT(sarsim_axis_info);
  sarsim_window window = SARSIM_INIT(sarsim_window);
  REFUSED(sarsim_raster_of_floats(samples, 0, 3, 1, &none, &problems));
  REFUSED(sarsim_raster_of_floats(samples, (uint64_t)-2, 3, 1, &none, &problems));
  REFUSED(sarsim_raster_of_floats(samples, UINT64_C(1) << 32, UINT64_C(1) << 32, 1, &none, &problems));
  REFUSED(sarsim_raster_open(NULL, NULL, 0, NULL, &none, &problems));
  EXPECT(none == NULL);
  EXPECT_STATUS(sarsim_raster_of_floats(samples, 2, 3, 1, &raster, NULL), SARSIM_OK, NULL);
  REFUSED(sarsim_raster_set_axis(raster, "pulse_time_s", points, (uint64_t)-1, &problems));
  REFUSED(sarsim_raster_set_axis(raster, "pulse_time_s", NULL, 2, &problems));
  REFUSED(sarsim_raster_set_axis(raster, NULL, points, 2, &problems));
  REFUSED(sarsim_raster_set_attribute(raster, "radar", NULL, &problems));
  REFUSED(sarsim_raster_get_info(NULL, &info, &problems));
  REFUSED(sarsim_raster_axis_info(raster, negative, &axis, &problems));
  REFUSED(sarsim_raster_read_float(raster, NULL, NULL, NULL, &problems));
  window.rows = (uint64_t)-1;
  REFUSED(sarsim_raster_read_float(raster, &window, back, NULL, &problems));
  window.rows = 1;
  window.first_row = (uint64_t)-1;
  REFUSED(sarsim_raster_read_float(raster, &window, back, NULL, &problems));
  /* Steps beyond everything leave the first row. */
  window.first_row = 0;
  window.row_step = UINT64_MAX;
  window.columns = 3;
  window.column_step = 1;
  EXPECT_STATUS(sarsim_raster_read_float(raster, &window, back, NULL, NULL), SARSIM_OK, NULL);
  REFUSED(sarsim_raster_write(raster, NULL, NULL, 0, NULL, &problems));
  sarsim_raster_free(raster);
}

int main(void) {
  sarsim_scene* scene = read_small_scene(NULL, 0);
  scenes(scene);
  recordings(scene);
  rasters();
  sarsim_scene_free(scene);
  return 0;
}
