/* Scenes put together, rows to a callback, rasters of memory, and the work that makes maps, profiles and tables. */
#include <math.h>

#include "expect.h"

/* What a callback was given. */
struct taken {
  const float* expected;
  uint64_t columns;
  uint64_t next;
  unsigned calls;
  unsigned last; /* Ends the work at this call. */
};

static int take_rows(void* user, uint64_t first, uint64_t count, const float* samples) {
  struct taken* taken = user;
  EXPECT(first == taken->next && count > 0);
  EXPECT(memcmp(samples, taken->expected + 2 * first * taken->columns, 2 * sizeof(float) * count * taken->columns) == 0);
  taken->next += count;
  return ++taken->calls == taken->last;
}

static void rows_come_in_blocks(void) {
  sarsim_scene* scene = read_small_scene(NULL, 0);
  sarsim_plan* plan = plan_of(scene);
  static float whole[2 * 64 * 100];
  struct taken taken = {whole, 100, 0, 0, 0};
  EXPECT_STATUS(sarsim_record_float(plan, 0, 64, whole, NULL, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_record_rows(plan, 0, 64, 5, take_rows, &taken, NULL, NULL), SARSIM_OK, NULL);
  EXPECT(taken.next == 64 && taken.calls == 13);
  taken.next = 10;
  taken.calls = 0;
  EXPECT_STATUS(sarsim_record_rows(plan, 10, 20, 0, take_rows, &taken, NULL, NULL), SARSIM_OK, NULL);
  EXPECT(taken.next == 30 && taken.calls == 1);
  taken.next = taken.calls = 0;
  taken.last = 2;
  EXPECT_STATUS(sarsim_record_rows(plan, 0, 64, 8, take_rows, &taken, NULL, NULL), SARSIM_STOPPED, NULL);
  EXPECT(taken.next == 16);
  EXPECT_STATUS(sarsim_record_rows(plan, 0, 65, 8, take_rows, &taken, NULL, NULL), SARSIM_BAD_ARGUMENT, NULL);
  EXPECT_STATUS(sarsim_record_rows(plan, 0, 64, 8, NULL, NULL, NULL, NULL), SARSIM_BAD_ARGUMENT, NULL);
  sarsim_plan_free(plan);
  sarsim_scene_free(scene);
}

static void set(sarsim_scene* scene, const char* field, const char* value) {
  sarsim_problems* problems = NULL;
  const sarsim_status status = sarsim_scene_set(scene, field, value, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
}

static double number(const sarsim_scene* scene, const char* field) {
  sarsim_problems* problems = NULL;
  double value = 0.0;
  const sarsim_status status = sarsim_scene_get_number(scene, field, &value, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  return value;
}

/* The small scene, made of calls alone. */
static sarsim_scene* built_scene(void) {
  sarsim_scene* scene = NULL;
  size_t index = 99;
  static const double place[3] = {0.0, 1000.0, 0.0};
  EXPECT_STATUS(sarsim_scene_new("built.toml", &scene, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_scene_add(scene, "platform", "Plane", &index, NULL), SARSIM_OK, NULL);
  EXPECT(index == 0);
  EXPECT_STATUS(sarsim_scene_add_targets(scene, "Earth", 1, place, NULL, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_scene_add(scene, "radar", "Radar1", NULL, NULL), SARSIM_OK, NULL);
  set(scene, "Radar1.platform", "Plane");
  set(scene, "Radar1.pulse", "chirp");
  EXPECT_STATUS(sarsim_scene_set_number(scene, "Radar1.pulse_width", 1e-6, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_scene_set_number(scene, "Radar1.carrier", 10e9, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_scene_add(scene, "simulation", "small.npy", NULL, NULL), SARSIM_OK, NULL);
  set(scene, "Simulation1.radar", "Radar1");
  set(scene, "Simulation1.format", "npy");
  set(scene, "Simulation1.range_start", "950 m");
  set(scene, "Simulation1.range_end", "1200 m");
  set(scene, "Simulation1.time_end", "63.5 ms");
  set(scene, "Simulation1.sample_rate", "60 MHz");
  return scene;
}

static void a_scene_of_calls_is_that_of_the_text(void) {
  sarsim_scene* read = read_small_scene(NULL, 0);
  sarsim_scene* scene = built_scene();
  sarsim_plan* plans[2];
  static float samples[2][2 * 64 * 100];
  EXPECT(number(scene, "Radar1.bandwidth") == 50e6);
  EXPECT(number(scene, "Radar1.carrier") == 10e9);
  EXPECT(number(scene, "Target1.position.y") == 1000.0);
  plans[0] = plan_of(read);
  plans[1] = plan_of(scene);
  for (int i = 0; i < 2; ++i)
    EXPECT_STATUS(sarsim_record_float(plans[i], 0, 64, samples[i], NULL, NULL), SARSIM_OK, NULL);
  EXPECT(memcmp(samples[0], samples[1], sizeof samples[0]) == 0);
  for (int i = 0; i < 2; ++i) sarsim_plan_free(plans[i]);
  sarsim_scene_free(read);
  sarsim_scene_free(scene);
}

static size_t count_of(const sarsim_scene* scene, const char* kind) {
  size_t count = 0;
  EXPECT_STATUS(sarsim_scene_count(scene, kind, &count, NULL), SARSIM_OK, NULL);
  return count;
}

static void objects_come_and_go(void) {
  sarsim_scene* scene = built_scene();
  sarsim_problems* problems = NULL;
  size_t index = 0;
  EXPECT(sarsim_scene_add(scene, "radar", "Radar1", &index, &problems) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_problems_count(problems) == 1);
  sarsim_problems_free(problems);
  EXPECT_STATUS(sarsim_scene_add(scene, "platform", NULL, &index, NULL), SARSIM_OK, NULL);
  EXPECT(index == 1 && count_of(scene, "platform") == 2);
  EXPECT(sarsim_scene_add(scene, "plattform", NULL, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_scene_remove(scene, "platform", 2, NULL) == SARSIM_BAD_ARGUMENT);
  /* With the platform goes its radar, and with that the recording. */
  EXPECT_STATUS(sarsim_scene_remove(scene, "platform", 0, NULL), SARSIM_OK, NULL);
  EXPECT(count_of(scene, "radar") == 0 && count_of(scene, "simulation") == 0 && count_of(scene, "target") == 1);
  sarsim_scene_free(scene);
}

static void numbers_have_the_unit_that_is_named(void) {
  sarsim_scene* scene = built_scene();
  sarsim_text* text = NULL;
  double value = 0.0;
  EXPECT_STATUS(sarsim_scene_set_number(scene, "Radar1.beam_azimuth", 12.3456789012345, NULL), SARSIM_OK, NULL);
  EXPECT(number(scene, "Radar1.beam_azimuth") == 12.3456789012345); /* Degrees, exactly. */
  EXPECT(number(scene, "seed") == 1.0);
  EXPECT(number(scene, "Radar1.same_antenna") == 1.0);
  EXPECT(sarsim_scene_get_number(scene, "Radar1.pulse", &value, NULL) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_scene_set_number(scene, "Radar1.pulse", 1.0, NULL) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_scene_set_number(scene, "Radar1.bandwidht", 1.0, NULL) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_scene_set_number(scene, "Radar1.pulse_width", NAN, NULL) == SARSIM_BAD_INPUT);
  EXPECT_STATUS(sarsim_scene_fields(scene, "radar", 0, &text, NULL), SARSIM_OK, NULL);
  EXPECT(strstr(sarsim_text_chars(text), "\"name\": \"Radar1.beam_azimuth\"") != NULL);
  EXPECT(strstr(sarsim_text_chars(text), "\"unit\": \"deg\"") != NULL);
  EXPECT(strstr(sarsim_text_chars(text), "\"number\": 12.3456789012345") != NULL);
  sarsim_text_free(text);
  EXPECT_STATUS(sarsim_scene_fields(scene, "options", 0, &text, NULL), SARSIM_OK, NULL);
  EXPECT(strstr(sarsim_text_chars(text), "\"name\": \"seed\"") != NULL);
  sarsim_text_free(text);
  EXPECT(sarsim_scene_fields(scene, "radar", 1, &text, NULL) == SARSIM_BAD_ARGUMENT && text == NULL);
  EXPECT_STATUS(sarsim_schema(&text, NULL), SARSIM_OK, NULL);
  EXPECT(strstr(sarsim_text_chars(text), "\"name\": \"bandwidth\"") != NULL);
  sarsim_text_free(text);
  sarsim_scene_free(scene);
}

/* A pulse and a track by points. */
static void functions_come_from_arrays(void) {
  sarsim_scene* scene = built_scene();
  sarsim_text* text = NULL;
  static const double x[3] = {0.0, 0.5, 1.0};
  static const double iq[6] = {1.0, 0.5, 0.25, 0.0, 0.1, 0.2};
  static const double time[2] = {-1.0, 1.0};
  static const double track[6] = {-100.0, 100.0, 0.0, 0.0, 50.0, 50.0};
  static const double backwards[2] = {1.0, -1.0};
  set(scene, "Radar1.pulse", "user");
  EXPECT_STATUS(sarsim_scene_set_points(scene, "Radar1.pulse_iq", 3, 2, x, iq, "linear", NULL), SARSIM_OK, NULL);
  EXPECT(sarsim_scene_set_points(scene, "Plane.trajectory_m", 2, 3, time, track, NULL, NULL) == SARSIM_BAD_INPUT);
  set(scene, "Plane.path", "trajectory");
  EXPECT_STATUS(sarsim_scene_set_points(scene, "Plane.trajectory_m", 2, 3, time, track, "linear", NULL), SARSIM_OK, NULL);
  EXPECT(sarsim_scene_set_points(scene, "Plane.trajectory_m", 2, 3, backwards, track, NULL, NULL) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_scene_set_points(scene, "Plane.trajectory_m", 2, 2, time, track, NULL, NULL) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_scene_set_points(scene, "Plane.trajectory_m", 2, 3, time, track, "spline", NULL) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_scene_set_points(scene, "Plane.trajectory_m", 2, 0, time, track, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_scene_set_points(scene, "Plane.name", 2, 3, time, track, NULL, NULL) == SARSIM_BAD_INPUT);
  EXPECT_STATUS(sarsim_scene_text(scene, SARSIM_FORMAT_2, &text, NULL), SARSIM_OK, NULL);
  EXPECT(strstr(sarsim_text_chars(text), "0.25") != NULL && strstr(sarsim_text_chars(text), "-100") != NULL);
  sarsim_text_free(text);
  sarsim_plan* plan = plan_of(scene);
  double places[6];
  EXPECT_STATUS(sarsim_plan_axis(plan, SARSIM_ROW_POSITION_M, 0, 2, places, NULL), SARSIM_OK, NULL);
  EXPECT(fabs(places[0]) < 1e-9 && fabs(places[3] - 0.1) < 1e-9 && places[2] == 50.0);
  sarsim_plan_free(plan);
  sarsim_scene_free(scene);
}

/* A million points, as targets and as a cloud; of a few, the same echoes either way. */
static void many_points_in_one_call(void) {
  enum { many = 1000000, few = 50 };
  double* positions = malloc(3 * sizeof(double) * many);
  double* rcs = malloc(sizeof(double) * many);
  sarsim_scene* scenes[2];
  static float samples[2][2 * 64 * 100];
  double difference = 0.0, power = 0.0;
  for (size_t i = 0; i < many; ++i) {
    positions[3 * i] = (double)(i % 1000) - 500.0;
    positions[3 * i + 1] = 1000.0 + (double)(i % 97);
    positions[3 * i + 2] = 0.0;
    rcs[i] = 1.0 + (double)(i % 7);
  }
  for (int k = 0; k < 2; ++k) {
    scenes[k] = built_scene();
    EXPECT_STATUS(sarsim_scene_remove(scenes[k], "target", 0, NULL), SARSIM_OK, NULL);
  }
  EXPECT_STATUS(sarsim_scene_add_targets(scenes[0], "Earth", few, positions, rcs, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_scene_add_cloud(scenes[1], "Earth", "few.npy", few, positions, rcs, NULL), SARSIM_OK, NULL);
  for (int k = 0; k < 2; ++k) {
    sarsim_plan* plan = plan_of(scenes[k]);
    EXPECT_STATUS(sarsim_record_float(plan, 0, 64, samples[k], NULL, NULL), SARSIM_OK, NULL);
    sarsim_plan_free(plan);
  }
  for (int i = 0; i < 2 * 64 * 100; ++i) {
    difference += pow(samples[0][i] - samples[1][i], 2);
    power += pow(samples[0][i], 2);
  }
  EXPECT(power > 0.0 && difference < 1e-12 * power);
  EXPECT_STATUS(sarsim_scene_add_targets(scenes[0], "Earth", many, positions, rcs, NULL), SARSIM_OK, NULL);
  EXPECT(count_of(scenes[0], "target") == many + few);
  EXPECT_STATUS(sarsim_scene_add_cloud(scenes[1], "Earth", "many.npy", many, positions, NULL, NULL), SARSIM_OK, NULL);
  EXPECT(count_of(scenes[1], "cloud") == 2);
  positions[4] = NAN;
  EXPECT_STATUS(sarsim_scene_add_cloud(scenes[1], "Earth", "bad.npy", 2, positions, NULL, NULL), SARSIM_BAD_INPUT, NULL);
  EXPECT_STATUS(sarsim_scene_add_cloud(scenes[1], "Earth", "no.npy", 0, positions, NULL, NULL), SARSIM_BAD_INPUT, NULL);
  EXPECT_STATUS(sarsim_scene_add_targets(scenes[1], "Earth", SIZE_MAX, positions, NULL, NULL), SARSIM_BAD_ARGUMENT, NULL);
  for (int k = 0; k < 2; ++k) sarsim_scene_free(scenes[k]);
  free(positions);
  free(rcs);
}

/* A file that is tried first is left when that is no longer wanted. */
static void expect_open_stopped(const char* path) {
  sarsim_stop* stop = NULL;
  sarsim_raster* raster = NULL;
  sarsim_work work = SARSIM_INIT(sarsim_work);
  EXPECT_STATUS(sarsim_stop_new(&stop, NULL), SARSIM_OK, NULL);
  sarsim_stop_request(stop);
  work.stop = stop;
  EXPECT(sarsim_raster_open(path, NULL, 0, &work, &raster, NULL) == SARSIM_STOPPED && raster == NULL);
  sarsim_stop_free(stop);
}

/* The caller's memory becomes a file with its axes, and comes back. */
static void memory_becomes_files(void) {
  static const float samples[2 * 6] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  static const double times[2] = {0.5, 0.75};
  static const double carriers[2] = {1e9, 1e9};
  static const double ranges[3] = {100.0, 101.5, 103.0};
  const char* const force[] = {"force"};
  sarsim_raster* raster = NULL;
  sarsim_raster* again = NULL;
  sarsim_problems* problems = NULL;
  sarsim_raster_info info = SARSIM_INIT(sarsim_raster_info);
  sarsim_axis_info axis = SARSIM_INIT(sarsim_axis_info);
  float back[2 * 6];
  double values[3];
  sarsim_status status;
  EXPECT_STATUS(sarsim_raster_of_floats(samples, 2, 3, 1, &raster, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_raster_set_axis(raster, "pulse_time_s", times, 2, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_raster_set_axis(raster, "carrier_hz", carriers, 2, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_raster_set_axis(raster, "slant_range_m", ranges, 3, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_raster_set_axis(raster, "slant_range_m", ranges, 2, NULL), SARSIM_BAD_INPUT, NULL);
  EXPECT_STATUS(sarsim_raster_set_axis(raster, "colour", ranges, 3, NULL), SARSIM_BAD_INPUT, NULL);
  EXPECT_STATUS(sarsim_raster_set_attribute(raster, "sample_rate_hz", "1e8", NULL), SARSIM_OK, NULL);
  status = sarsim_raster_write(raster, "working.h5", force, 1, NULL, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  status = sarsim_raster_open("working.h5", NULL, 0, NULL, &again, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  EXPECT_STATUS(sarsim_raster_get_info(again, &info, NULL), SARSIM_OK, NULL);
  EXPECT(info.rows == 2 && info.columns == 3 && info.value == SARSIM_COMPLEX && info.sample_rate_hz == 1e8);
  EXPECT(strcmp(info.format, "hdf5") == 0 && info.axes == 3);
  EXPECT_STATUS(sarsim_raster_read_float(again, NULL, back, NULL, NULL), SARSIM_OK, NULL);
  EXPECT(memcmp(back, samples, sizeof back) == 0);
  EXPECT_STATUS(sarsim_raster_axis_info(again, 2, &axis, NULL), SARSIM_OK, NULL);
  EXPECT(strcmp(axis.name, "slant_range_m") == 0 && axis.of_columns == 1 && axis.count == 3);
  EXPECT_STATUS(sarsim_raster_axis(again, 2, 0, 3, values, NULL), SARSIM_OK, NULL);
  EXPECT(memcmp(values, ranges, sizeof values) == 0);
  EXPECT(sarsim_raster_set_axis(again, "pulse_time_s", times, 2, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_raster_axis_info(again, 3, &axis, NULL) == SARSIM_BAD_ARGUMENT);
  sarsim_raster_free(again);
  sarsim_raster_free(raster);
  expect_open_stopped("working.h5");
  remove("working.h5");
  EXPECT(sarsim_raster_open("missing.h5", NULL, 0, NULL, &again, NULL) == SARSIM_BAD_INPUT && again == NULL);
  EXPECT(sarsim_raster_of_floats(samples, 2, UINT64_MAX / 2, 1, &again, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_raster_of_floats(NULL, 2, 3, 1, &again, NULL) == SARSIM_BAD_ARGUMENT);
}

typedef sarsim_status (*work_on_echoes)(const sarsim_source*, const char* const*, size_t, const sarsim_work*,
                                        sarsim_result**, sarsim_problems**);

/* A result with a report, as many tables, and at least as many rasters of which something can be read. */
static sarsim_result* result_of(work_on_echoes function, const sarsim_source* source, const char* const* options,
                                size_t count, size_t tables, size_t rasters) {
  sarsim_result* result = NULL;
  sarsim_problems* problems = NULL;
  const sarsim_status status = function(source, options, count, NULL, &result, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  EXPECT(sarsim_result_json(result)[0] == '{');
  EXPECT(sarsim_result_table_count(result) == tables && sarsim_result_raster_count(result) == rasters);
  for (size_t i = 0; i < rasters; ++i) {
    sarsim_raster* raster = NULL;
    sarsim_window window = SARSIM_INIT(sarsim_window);
    sarsim_raster_info info = SARSIM_INIT(sarsim_raster_info);
    float one[2];
    EXPECT_STATUS(sarsim_result_raster(result, i, &raster, NULL), SARSIM_OK, NULL);
    EXPECT_STATUS(sarsim_raster_get_info(raster, &info, NULL), SARSIM_OK, NULL);
    EXPECT(info.rows > 1 && info.columns > 1 && info.attributes > 3);
    window.rows = window.columns = 1;
    EXPECT_STATUS(sarsim_raster_read_float(raster, &window, one, NULL, NULL), SARSIM_OK, NULL);
    EXPECT(isfinite(one[0]) && isfinite(one[1]));
    sarsim_raster_free(raster);
  }
  return result;
}

static sarsim_source* source_of(const char* examples, const char* name) {
  char path[4096];
  sarsim_scene* scene = NULL;
  sarsim_source* source = NULL;
  sarsim_problems* problems = NULL;
  snprintf(path, sizeof path, "%s/%s", examples, name);
  sarsim_status status = sarsim_scene_read_file(path, NULL, &scene, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  status = sarsim_source_scene(scene, 0, &source, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  sarsim_scene_free(scene);
  return source;
}

static void all_work_is_done_in_memory(const char* examples) {
  sarsim_source* ship = source_of(examples, "turning_ship.toml");
  sarsim_source* stepped = source_of(examples, "stepped_aircraft.toml");
  sarsim_source* search = source_of(examples, "search_radar.toml");
  const char* const profile_options[] = {"group=bursts"};
  const char* const search_options[] = {"pixel=100"};
  const char* const doppler_options[] = {"interval=16"};
  const char* const geometry_options[] = {"radar=Radar1", "start=0", "end=0.01"};
  sarsim_table* table = NULL;
  sarsim_result_free(result_of(sarsim_isar, ship, NULL, 0, 0, 1));
  sarsim_result_free(result_of(sarsim_profiles, stepped, profile_options, 1, 1, 1));
  sarsim_result_free(result_of(sarsim_doppler, search, doppler_options, 1, 1, 1));
  sarsim_result* found = result_of(sarsim_search, search, search_options, 1, 1, 1);
  EXPECT_STATUS(sarsim_result_table(found, 0, &table, NULL), SARSIM_OK, NULL);
  EXPECT(strcmp(sarsim_table_name(table, 3), "range_m") == 0 && sarsim_table_rows(table) > 0);
  EXPECT(atof(sarsim_table_text(table, 0, 3)) > 0.0 && sarsim_table_text(table, 0, 99)[0] == 0);
  sarsim_table_free(table);
  EXPECT(sarsim_result_table(found, 1, &table, NULL) == SARSIM_BAD_ARGUMENT && table == NULL);
  sarsim_result_free(found);
  sarsim_result* places = result_of(sarsim_geometry, search, geometry_options, 3, 1, 0);
  EXPECT_STATUS(sarsim_result_table(places, 0, &table, NULL), SARSIM_OK, NULL);
  EXPECT(strcmp(sarsim_table_name(table, 1), "time_s") == 0 && sarsim_table_rows(table) > 1);
  sarsim_table_free(table);
  sarsim_result_free(places);
  sarsim_source_free(ship);
  sarsim_source_free(stepped);
  sarsim_source_free(search);
}

/* A sweep of a scene that is in no file. */
static void a_scene_is_swept(void) {
  const char* const options[] = {"set=seed=1..3", "set=Radar1.power=1kW,2kW", "discard", "force", "out=working-sweep"};
  sarsim_scene* scene = built_scene();
  sarsim_result* result = NULL;
  sarsim_table* table = NULL;
  sarsim_problems* problems = NULL;
  const sarsim_status status = sarsim_sweep(scene, options, 5, NULL, &result, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  EXPECT_STATUS(sarsim_result_table(result, 0, &table, NULL), SARSIM_OK, NULL);
  EXPECT(sarsim_table_rows(table) == 6);
  EXPECT(strstr(sarsim_table_csv(table), "done") != NULL && strstr(sarsim_result_json(result), "\"variations\"") != NULL);
  sarsim_table_free(table);
  sarsim_result_free(result);
  sarsim_scene_free(scene);
}

/* What --with names are options of the work that follows, not of the sweep. */
static void a_sweep_hands_options_on(void) {
  const char* const options[] = {"set=seed=1..3", "discard", "focus", "with=--widnow hann", "out=working-sweep"};
  sarsim_scene* scene = built_scene();
  sarsim_result* result = NULL;
  sarsim_problems* problems = NULL;
  sarsim_problem problem = SARSIM_INIT(sarsim_problem);
  EXPECT(sarsim_sweep(scene, options, 5, NULL, &result, &problems) == SARSIM_BAD_INPUT && result == NULL);
  EXPECT_STATUS(sarsim_problems_get(problems, 0, &problem), SARSIM_OK, NULL);
  EXPECT(strstr(problem.text, "did you mean '--window'?") != NULL);
  sarsim_problems_free(problems);
  sarsim_scene_free(scene);
}

/* What a sweep is asked for while it goes on, by somebody else who wants the same. */
static void sweep_at_the_same_time(void* user, const char* stage, uint64_t done, uint64_t total) {
  sarsim_status* const seen = user;
  const char* const options[] = {"set=seed=1..3", "discard", "force", "out=working-sweep-held"};
  sarsim_scene* scene;
  sarsim_result* result = NULL;
  (void)stage, (void)done, (void)total;
  if (*seen != SARSIM_OK) return;
  scene = built_scene();
  *seen = sarsim_sweep(scene, options, 4, NULL, &result, NULL);
  sarsim_result_free(result);
  sarsim_scene_free(scene);
}

static void a_sweep_that_somebody_makes_may_be_tried_again(void) {
  const char* const options[] = {"set=seed=1..3", "discard", "force", "out=working-sweep-held"};
  sarsim_status seen = SARSIM_OK;
  sarsim_work work = SARSIM_INIT(sarsim_work);
  sarsim_scene* scene = built_scene();
  sarsim_result* result = NULL;
  work.progress = sweep_at_the_same_time;
  work.user = &seen;
  EXPECT_STATUS(sarsim_sweep(scene, options, 4, &work, &result, NULL), SARSIM_OK, NULL);
  EXPECT(seen == SARSIM_TRY_AGAIN);
  EXPECT(strcmp(sarsim_status_word(seen), "try again") == 0);
  sarsim_result_free(result);
  sarsim_scene_free(scene);
}

static void options_are_listed(void) {
  static const char* const all[] = {"focus",   "profiles", "isar",  "doppler", "search", "measure",
                                    "geometry", "theory",   "sweep", "raster",  "write",  "export"};
  sarsim_text* text = NULL;
  for (size_t i = 0; i < sizeof all / sizeof all[0]; ++i)
    for (int style = SARSIM_WORDS; style <= SARSIM_JSON; ++style) {
      EXPECT_STATUS(sarsim_options(all[i], style, &text, NULL), SARSIM_OK, NULL);
      EXPECT(sarsim_text_length(text) > 100);
      sarsim_text_free(text);
    }
  for (int i = 0; i < 2; ++i) {
    EXPECT_STATUS(sarsim_options(i == 0 ? "write" : "sweep", SARSIM_WORDS, &text, NULL), SARSIM_OK, NULL);
    EXPECT(strstr(sarsim_text_chars(text), "converter counts instead of volts in HDF5, NPY, Zarr and SigMF") != NULL);
    sarsim_text_free(text);
  }
  EXPECT(sarsim_options("focussing", SARSIM_JSON, &text, NULL) == SARSIM_BAD_ARGUMENT && text == NULL);
  EXPECT(sarsim_options("focus", 7, &text, NULL) == SARSIM_BAD_ARGUMENT);
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  rows_come_in_blocks();
  a_scene_of_calls_is_that_of_the_text();
  objects_come_and_go();
  numbers_have_the_unit_that_is_named();
  functions_come_from_arrays();
  many_points_in_one_call();
  memory_becomes_files();
  all_work_is_done_in_memory(argv[1]);
  a_scene_is_swept();
  a_sweep_hands_options_on();
  a_sweep_that_somebody_makes_may_be_tried_again();
  options_are_listed();
  return 0;
}
