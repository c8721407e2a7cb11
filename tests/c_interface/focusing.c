/* Echoes become images: of a scene, of memory and of a file alike, measured against theory; options by name. */
#include <math.h>

#include "expect.h"

static sarsim_scene* sar_scene(const char* examples) {
  char path[4096];
  sarsim_scene* scene = NULL;
  sarsim_problems* problems = NULL;
  sarsim_status status;
  snprintf(path, sizeof path, "%s/sar_r.toml", examples);
  status = sarsim_scene_read_file(path, NULL, &scene, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  return scene;
}

/* Raster 0 of a result, and the result is freed. */
static sarsim_raster* image_of(sarsim_result* result) {
  sarsim_raster* image = NULL;
  EXPECT_STATUS(sarsim_result_raster(result, 0, &image, NULL), SARSIM_OK, NULL);
  sarsim_result_free(result);
  return image;
}

static sarsim_raster_info raster_info(const sarsim_raster* raster) {
  sarsim_raster_info info = SARSIM_INIT(sarsim_raster_info);
  EXPECT_STATUS(sarsim_raster_get_info(raster, &info, NULL), SARSIM_OK, NULL);
  return info;
}

static float* pixels_of(const sarsim_raster* image) {
  const sarsim_raster_info info = raster_info(image);
  float* pixels = malloc(2 * sizeof(float) * info.rows * info.columns);
  sarsim_problems* problems = NULL;
  const sarsim_status status = sarsim_raster_read_float(image, NULL, pixels, NULL, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  return pixels;
}

static size_t column_called(const sarsim_table* table, const char* name) {
  size_t column = 0;
  while (column < sarsim_table_columns(table) && strcmp(sarsim_table_name(table, column), name) != 0) ++column;
  EXPECT(column < sarsim_table_columns(table));
  return column;
}

static void numbers_called(const sarsim_table* table, const char* name, double* values) {
  EXPECT_STATUS(sarsim_table_numbers(table, column_called(table, name), values, NULL), SARSIM_OK, NULL);
}

static sarsim_result* focused(const sarsim_source* source, const char* const* options, size_t count) {
  sarsim_result* result = NULL;
  sarsim_problems* problems = NULL;
  const sarsim_status status = sarsim_focus(source, options, count, NULL, &result, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  return result;
}

/* The targets of an image, every one found where theory has it. */
static void expect_targets(const sarsim_raster* image, size_t targets) {
  sarsim_result* result = NULL;
  sarsim_table* table = NULL;
  sarsim_problems* problems = NULL;
  double found[64];
  double azimuth[64];
  double amplitude[64];
  const sarsim_status status = sarsim_measure(image, NULL, 0, NULL, &result, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  EXPECT(strstr(sarsim_result_json(result), "\"found_targets\"") != NULL);
  EXPECT(sarsim_result_table_count(result) == 1);
  EXPECT_STATUS(sarsim_result_table(result, 0, &table, NULL), SARSIM_OK, NULL);
  sarsim_result_free(result);
  EXPECT(sarsim_table_rows(table) == targets && targets <= 64);
  numbers_called(table, "found", found);
  numbers_called(table, "azimuth_error_m", azimuth);
  numbers_called(table, "amplitude_error_db", amplitude);
  for (size_t i = 0; i < targets; ++i)
    EXPECT(found[i] == 1.0 && fabs(azimuth[i]) < 0.05 && fabs(amplitude[i]) < 0.2);
  sarsim_table_free(table);
}

static void expect_axis(const sarsim_raster* image, size_t index, const char* name, int of_columns, uint64_t count) {
  sarsim_axis_info axis = SARSIM_INIT(sarsim_axis_info);
  double ends[2];
  EXPECT_STATUS(sarsim_raster_axis_info(image, index, &axis, NULL), SARSIM_OK, NULL);
  EXPECT(strcmp(axis.name, name) == 0 && strcmp(axis.unit, "m") == 0);
  EXPECT(axis.of_columns == of_columns && axis.count == count);
  EXPECT_STATUS(sarsim_raster_axis(image, index, 0, 1, &ends[0], NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_raster_axis(image, index, count - 1, 1, &ends[1], NULL), SARSIM_OK, NULL);
  EXPECT(ends[1] > ends[0]);
  EXPECT_STATUS(sarsim_raster_axis(image, index, count, 1, ends, NULL), SARSIM_BAD_ARGUMENT, NULL);
}

/* A recording in memory becomes an image, bit for bit the one of its file. */
static sarsim_raster* expect_same_of_memory_and_file(const sarsim_scene* scene) {
  const char* const options[] = {"window=hann", "algorithm=omega-k"};
  sarsim_plan* plan = plan_of(scene);
  const sarsim_plan_info info = info_of(plan);
  float* samples = malloc(2 * sizeof(float) * info.rows * info.columns);
  sarsim_file_options replace = SARSIM_INIT(sarsim_file_options);
  sarsim_source* source = NULL;
  sarsim_source* file = NULL;
  EXPECT_STATUS(sarsim_record_float(plan, 0, info.rows, samples, NULL, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_source_floats(plan, samples, &source, NULL), SARSIM_OK, NULL);
  sarsim_raster* image = image_of(focused(source, options, 2));
  const sarsim_raster_info shape = raster_info(image);
  EXPECT(shape.value == SARSIM_COMPLEX && shape.rows > 100 && shape.columns > 100 && shape.counts == 0);
  expect_axis(image, 0, "azimuth_m", 0, shape.rows);
  expect_axis(image, 1, "slant_range_m", 1, shape.columns);
  EXPECT(strcmp(sarsim_raster_attribute(image, "algorithm"), "omega-k") == 0);
  EXPECT(sarsim_raster_attribute(image, "nothing") == NULL);

  replace.replace = 1;
  EXPECT_STATUS(sarsim_record_file(plan, "focusing.h5", &replace, NULL, NULL, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_source_file("focusing.h5", &file, NULL), SARSIM_OK, NULL);
  sarsim_raster* of_file = image_of(focused(file, options, 2));
  float* a = pixels_of(image);
  float* b = pixels_of(of_file);
  EXPECT(memcmp(a, b, 2 * sizeof(float) * shape.rows * shape.columns) == 0);
  free(a);
  free(b);
  sarsim_raster_free(of_file);
  sarsim_source_free(file);
  sarsim_source_free(source);
  sarsim_plan_free(plan);
  free(samples);
  remove("focusing.h5");
  return image;
}

/* An image in memory is written as the one that is written at once. */
static void expect_written(const sarsim_raster* image) {
  const char* const force[] = {"force"};
  sarsim_raster* again = NULL;
  sarsim_problems* problems = NULL;
  sarsim_status status = sarsim_raster_write(image, "focusing.img", force, 1, NULL, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  status = sarsim_raster_write(image, "focusing.img", NULL, 0, NULL, &problems);
  EXPECT_STATUS(status, SARSIM_BAD_INPUT, problems);
  status = sarsim_raster_open("focusing.img", NULL, 0, NULL, &again, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  const sarsim_raster_info shape = raster_info(again);
  EXPECT(strcmp(shape.format, "envi") == 0 && strcmp(shape.path, "focusing.img") == 0);
  expect_axis(again, 0, "azimuth_m", 0, shape.rows);
  float* a = pixels_of(image);
  float* b = pixels_of(again);
  EXPECT(memcmp(a, b, 2 * sizeof(float) * shape.rows * shape.columns) == 0);
  free(a);
  free(b);
  sarsim_raster_free(again);
  remove("focusing.img");
  remove("focusing.hdr");
}

/* A window is a part of the whole. */
static void expect_windows(const sarsim_raster* image) {
  const sarsim_raster_info shape = raster_info(image);
  sarsim_window window = SARSIM_INIT(sarsim_window);
  float few[2 * 3 * 4];
  double doubles[2 * 3 * 4];
  float* all = pixels_of(image);
  window.first_row = 5;
  window.rows = 3;
  window.first_column = 7;
  window.columns = 4;
  EXPECT_STATUS(sarsim_raster_read_double(image, &window, doubles, NULL, NULL), SARSIM_OK, NULL);
  for (int i = 0; i < 24; ++i)
    EXPECT(doubles[i] == (double)all[2 * ((5 + i / 8) * shape.columns + 7) + i % 8]);
  window.row_step = 2;
  window.column_step = 3;
  EXPECT_STATUS(sarsim_raster_read_float(image, &window, few, NULL, NULL), SARSIM_OK, NULL);
  for (int i = 0; i < 12; ++i)
    EXPECT(few[2 * i] == all[2 * ((5 + 2 * (i / 4)) * shape.columns + 7 + 3 * (i % 4))]);
  EXPECT_STATUS(sarsim_raster_read_double(image, &window, doubles, NULL, NULL), SARSIM_BAD_ARGUMENT, NULL);
  window.first_row = shape.rows;
  EXPECT_STATUS(sarsim_raster_read_float(image, &window, few, NULL, NULL), SARSIM_BAD_ARGUMENT, NULL);
  window.first_row = UINT64_MAX;
  window.rows = UINT64_MAX;
  EXPECT_STATUS(sarsim_raster_read_float(image, &window, few, NULL, NULL), SARSIM_BAD_ARGUMENT, NULL);
  free(all);
}

/* Everything that is wrong with options comes as a list. */
static void expect_refused_options(const sarsim_source* source) {
  const char* const unknown[] = {"windov=hann"};
  const char* const wrong[] = {"window=hahn"};
  const char* const no_value[] = {"window"};
  const char* const null_word[] = {NULL};
  sarsim_result* result = NULL;
  sarsim_problems* problems = NULL;
  sarsim_problem problem = SARSIM_INIT(sarsim_problem);
  EXPECT(sarsim_focus(source, unknown, 1, NULL, &result, &problems) == SARSIM_BAD_INPUT && result == NULL);
  EXPECT_STATUS(sarsim_problems_get(problems, 0, &problem), SARSIM_OK, NULL);
  EXPECT(strstr(problem.text, "windov") != NULL && strstr(problem.text, "--window") != NULL);
  sarsim_problems_free(problems);
  EXPECT(sarsim_focus(source, wrong, 1, NULL, &result, NULL) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_focus(source, no_value, 1, NULL, &result, NULL) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_focus(source, null_word, 1, NULL, &result, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_focus(source, NULL, 1, NULL, &result, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_focus(NULL, NULL, 0, NULL, &result, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_focus(source, NULL, 0, NULL, NULL, NULL) == SARSIM_BAD_ARGUMENT);
}

static void expect_theory(const sarsim_source* source, size_t targets) {
  sarsim_result* result = NULL;
  sarsim_table* table = NULL;
  sarsim_problems* problems = NULL;
  double width[64];
  const sarsim_status status = sarsim_theory(source, NULL, 0, NULL, &result, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  EXPECT_STATUS(sarsim_result_table(result, 0, &table, NULL), SARSIM_OK, NULL);
  sarsim_result_free(result);
  EXPECT(sarsim_table_rows(table) == targets);
  EXPECT(sarsim_table_is_number(table, 0));
  numbers_called(table, "range_width_m", width);
  /* 0.886 c/(2 B) of a chirp of 100 MHz, widened by the ripples of its spectrum. */
  EXPECT(width[0] > 1.25 && width[0] < 1.4);
  sarsim_table_free(table);
}

/* Work that is stopped leaves nothing. */
static void expect_stopped(const sarsim_source* source) {
  sarsim_stop* stop = NULL;
  sarsim_result* result = NULL;
  sarsim_work work = SARSIM_INIT(sarsim_work);
  EXPECT_STATUS(sarsim_stop_new(&stop, NULL), SARSIM_OK, NULL);
  sarsim_stop_request(stop);
  work.stop = stop;
  EXPECT(sarsim_focus(source, NULL, 0, &work, &result, NULL) == SARSIM_STOPPED && result == NULL);
  sarsim_stop_free(stop);
}

/* A sweep of a scene in memory makes and measures its images there. */
static void a_sweep_measures_its_images(sarsim_scene* scene) {
  const char* const options[] = {"set=Radar1.bandwidth=80MHz,100MHz", "discard", "force", "focus", "measure", "out=focusing-sweep"};
  sarsim_result* result = NULL;
  sarsim_table* table = NULL;
  sarsim_problems* problems = NULL;
  double width[2];
  const sarsim_status status = sarsim_sweep(scene, options, 6, NULL, &result, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  EXPECT_STATUS(sarsim_result_table(result, 0, &table, NULL), SARSIM_OK, NULL);
  EXPECT(sarsim_table_rows(table) == 2);
  numbers_called(table, "found", width);
  EXPECT(width[0] == 24.0 && width[1] == 24.0);
  sarsim_table_free(table);
  sarsim_result_free(result);
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  sarsim_scene* scene = sar_scene(argv[1]);
  sarsim_source* source = NULL;
  size_t targets = 0;
  EXPECT_STATUS(sarsim_scene_count(scene, "target", &targets, NULL), SARSIM_OK, NULL);
  sarsim_raster* image = expect_same_of_memory_and_file(scene);
  expect_targets(image, targets);
  expect_written(image);
  expect_windows(image);
  EXPECT_STATUS(sarsim_source_scene(scene, 0, &source, NULL), SARSIM_OK, NULL);
  a_sweep_measures_its_images(scene);
  sarsim_scene_free(scene);
  expect_theory(source, targets);
  expect_refused_options(source);
  expect_stopped(source);
  sarsim_source_free(source);
  sarsim_raster_free(image);
  return 0;
}
