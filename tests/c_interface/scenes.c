/* Scenes: read, asked, changed, written, checked, explained. Argument: the folder of the examples. */
#include "expect.h"

static sarsim_text* value_of(const sarsim_scene* scene, const char* field) {
  sarsim_text* value = NULL;
  sarsim_problems* problems = NULL;
  const sarsim_status status = sarsim_scene_get(scene, field, &value, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  return value;
}

static void expect_value(const sarsim_scene* scene, const char* field, const char* expected) {
  sarsim_text* value = value_of(scene, field);
  if (strcmp(sarsim_text_chars(value), expected) != 0)
    fprintf(stderr, "%s is '%s', not '%s'\n", field, sarsim_text_chars(value), expected);
  EXPECT(strcmp(sarsim_text_chars(value), expected) == 0);
  EXPECT(sarsim_text_length(value) == strlen(expected));
  sarsim_text_free(value);
}

static void fields_have_the_names_of_set(void) {
  static const char* const let[] = {"far=1100"};
  sarsim_scene* scene = read_small_scene(NULL, 0);
  sarsim_scene* copy = NULL;
  sarsim_problems* problems = NULL;
  sarsim_problem problem = SARSIM_INIT(sarsim_problem);
  expect_value(scene, "Radar1.bandwidth", "50 MHz");
  expect_value(scene, "Target1.position.y", "1 km");
  EXPECT_STATUS(sarsim_scene_copy(scene, &copy, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_scene_set(scene, "Radar1.bandwidth", "0.025 GHz", NULL), SARSIM_OK, NULL);
  expect_value(scene, "Radar1.bandwidth", "25 MHz");
  expect_value(copy, "Radar1.bandwidth", "50 MHz");
  sarsim_scene_free(copy);

  /* A number that was probably meant in the unit of the scene is taken, with a remark. */
  EXPECT(sarsim_scene_set(scene, "Radar1.bandwidth", "25", &problems) == SARSIM_OK);
  EXPECT(sarsim_problems_count(problems) == 1);
  EXPECT(sarsim_problems_get(problems, 0, &problem) == SARSIM_OK && problem.severity == SARSIM_WARNING);
  sarsim_problems_free(problems);
  EXPECT_STATUS(sarsim_scene_set(scene, "Radar1.bandwidth", "25 MHz", NULL), SARSIM_OK, NULL);

  EXPECT(sarsim_scene_set(scene, "Radar1.bandwith", "1 MHz", &problems) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_problems_get(problems, 0, &problem) == SARSIM_OK && strstr(problem.message, "bandwidth") != NULL);
  sarsim_problems_free(problems);
  EXPECT(sarsim_scene_set(scene, "Radar1.bandwidth", "wide", &problems) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_problems_get(problems, 0, &problem) == SARSIM_OK && strstr(problem.message, "wide") != NULL);
  sarsim_problems_free(problems);
  expect_value(scene, "Radar1.bandwidth", "25 MHz");
  sarsim_scene_free(scene);

  scene = read_small_scene(let, 1);
  expect_value(scene, "Target1.position.y", "1.1 km");
  sarsim_scene_free(scene);
}

static void objects_are_counted_and_named(void) {
  sarsim_scene* scene = read_small_scene(NULL, 0);
  sarsim_text* name = NULL;
  size_t count = 0;
  EXPECT_STATUS(sarsim_scene_count(scene, "radar", &count, NULL), SARSIM_OK, NULL);
  EXPECT(count == 1);
  EXPECT_STATUS(sarsim_scene_count(scene, "surface", &count, NULL), SARSIM_OK, NULL);
  EXPECT(count == 0);
  EXPECT(sarsim_scene_count(scene, "submarine", &count, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT_STATUS(sarsim_scene_name(scene, "radar", 0, &name, NULL), SARSIM_OK, NULL);
  EXPECT(strcmp(sarsim_text_chars(name), "Radar1") == 0);
  sarsim_text_free(name);
  EXPECT(sarsim_scene_name(scene, "radar", 1, &name, NULL) == SARSIM_BAD_ARGUMENT && name == NULL);
  sarsim_scene_free(scene);
}

/* What is written is read as the same scene, in either language. */
static void texts_come_back(void) {
  static const sarsim_language languages[] = {SARSIM_FORMAT_2, SARSIM_SCRIPT};
  sarsim_scene* scene = read_small_scene(NULL, 0);
  size_t i;
  for (i = 0; i < 2; ++i) {
    sarsim_text* text = NULL;
    sarsim_text* again = NULL;
    sarsim_scene* back = NULL;
    sarsim_problems* problems = NULL;
    sarsim_status status;
    EXPECT_STATUS(sarsim_scene_text(scene, languages[i], &text, NULL), SARSIM_OK, NULL);
    status = sarsim_scene_read_text(sarsim_text_chars(text), sarsim_text_length(text), NULL, NULL, &back, &problems);
    EXPECT_STATUS(status, SARSIM_OK, problems);
    expect_value(back, "Radar1.bandwidth", "50 MHz");
    EXPECT_STATUS(sarsim_scene_text(back, languages[i], &again, NULL), SARSIM_OK, NULL);
    EXPECT(strcmp(sarsim_text_chars(text), sarsim_text_chars(again)) == 0);
    sarsim_text_free(text);
    sarsim_text_free(again);
    sarsim_scene_free(back);
  }
  sarsim_scene_free(scene);
}

/* All mistakes at once, each with its place. */
static void mistakes_have_places(void) {
  static const char broken[] = "format = \"sarsim 2\"\n[[radar]]\nname = 3\nbandwith = 4\n";
  sarsim_scene* scene = (sarsim_scene*)(void*)&scene;
  sarsim_problems* problems = NULL;
  sarsim_problem problem = SARSIM_INIT(sarsim_problem);
  size_t lines = 0;
  size_t i;
  EXPECT(sarsim_scene_read_text(broken, strlen(broken), "broken.toml", NULL, &scene, &problems) == SARSIM_BAD_INPUT);
  EXPECT(scene == NULL);
  for (i = 0; i < sarsim_problems_count(problems); ++i) {
    EXPECT(sarsim_problems_get(problems, i, &problem) == SARSIM_OK);
    if (strcmp(problem.file, "broken.toml") != 0 || problem.column == 0) continue;
    EXPECT(strncmp(problem.text, "broken.toml:", 12) == 0);
    lines |= (size_t)1 << problem.line;
  }
  EXPECT((lines & 8) != 0 && (lines & 16) != 0);
  sarsim_problems_free(problems);
}

static void a_check_says_what_a_run_would(void) {
  sarsim_scene* scene = read_small_scene(NULL, 0);
  sarsim_problems* problems = NULL;
  sarsim_problem problem = SARSIM_INIT(sarsim_problem);
  sarsim_status status = sarsim_scene_check(scene, NULL, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  EXPECT_STATUS(sarsim_scene_set(scene, "Radar1.platform", "Nowhere", NULL), SARSIM_OK, NULL);
  EXPECT(sarsim_scene_check(scene, NULL, &problems) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_problems_get(problems, 0, &problem) == SARSIM_OK);
  EXPECT(strcmp(problem.object, "radar") == 0 && problem.object_index == 0 && strcmp(problem.field, "platform") == 0);
  EXPECT(strcmp(problem.file, "small.toml") == 0 && problem.line == 10);
  sarsim_problems_free(problems);
  sarsim_scene_free(scene);
}

static void words_are_explained(void) {
  sarsim_text* text = NULL;
  sarsim_problems* problems = NULL;
  EXPECT_STATUS(sarsim_explain("radar.pulse.width", SARSIM_WORDS, &text, NULL), SARSIM_OK, NULL);
  EXPECT(strstr(sarsim_text_chars(text), "radar.pulse.width") != NULL);
  sarsim_text_free(text);
  EXPECT_STATUS(sarsim_explain("radar.pulse.width", SARSIM_JSON, &text, NULL), SARSIM_OK, NULL);
  EXPECT(sarsim_text_chars(text)[0] == '{');
  sarsim_text_free(text);
  EXPECT(sarsim_explain("radar.pulse.wdth", SARSIM_WORDS, &text, &problems) == SARSIM_BAD_INPUT && text == NULL);
  EXPECT(sarsim_problems_count(problems) == 1);
  sarsim_problems_free(problems);
}

/* Both languages from files, with a file beside the scene. */
static void files_are_read(const char* examples) {
  static const char* const names[] = {"sar_r.toml", "sar_r.scr", "satellite.toml", "helicopter.toml"};
  char path[4096];
  size_t i;
  for (i = 0; i < sizeof names / sizeof names[0]; ++i) {
    sarsim_scene* scene = NULL;
    sarsim_problems* problems = NULL;
    sarsim_status status;
    size_t recordings = 0;
    snprintf(path, sizeof path, "%s/%s", examples, names[i]);
    status = sarsim_scene_read_file(path, NULL, &scene, &problems);
    EXPECT_STATUS(status, SARSIM_OK, problems);
    EXPECT_STATUS(sarsim_scene_count(scene, "simulation", &recordings, NULL), SARSIM_OK, NULL);
    EXPECT(recordings > 0);
    problems = NULL;
    status = sarsim_scene_check(scene, NULL, &problems);
    EXPECT_STATUS(status, SARSIM_OK, problems);
    sarsim_scene_free(scene);
  }
}

static size_t times_said(const sarsim_problems* problems, const char* words) {
  sarsim_problem problem = SARSIM_INIT(sarsim_problem);
  size_t times = 0;
  size_t i;
  for (i = 0; i < sarsim_problems_count(problems); ++i) {
    EXPECT(sarsim_problems_get(problems, i, &problem) == SARSIM_OK);
    if (strstr(problem.message, words) != NULL) times += problem.count;
  }
  return times;
}

/* By reading, by a check, once each; and no longer where the file is not named any more. */
static void files_are_warned_of(void) {
  static const char points[] = "[[target]]\npositions = { file = \"scenes_points.csv\" }\n";
  static const char warning[] = "cross-sections are negative";
  char text[2048];
  sarsim_scene* scene = NULL;
  sarsim_problems* problems = NULL;
  FILE* file = fopen("scenes_points.csv", "w");
  EXPECT(file != NULL);
  fputs("x,y,z,rcs\n0,1000,0,1\n5,1000,0,-1\n", file);
  EXPECT(fclose(file) == 0);
  snprintf(text, sizeof text, "%s%s", small_scene, points);
  EXPECT(sarsim_scene_read_text(text, strlen(text), "small.toml", NULL, &scene, &problems) == SARSIM_OK);
  EXPECT(times_said(problems, warning) == 1);
  sarsim_problems_free(problems);
  problems = NULL;
  EXPECT(sarsim_scene_check(scene, NULL, &problems) == SARSIM_OK);
  EXPECT(times_said(problems, warning) == 1);
  sarsim_problems_free(problems);
  file = fopen("scenes_points.csv", "w");
  EXPECT(file != NULL);
  fputs("x,y,z,rcs\n0,1000,0,1\n5,1000,0,1\n", file);
  EXPECT(fclose(file) == 0);
  problems = NULL;
  EXPECT(sarsim_scene_check(scene, NULL, &problems) == SARSIM_OK);
  EXPECT(times_said(problems, warning) == 0);
  sarsim_problems_free(problems);
  remove("scenes_points.csv");
  sarsim_scene_free(scene);
  /* The file need not be there to be named. */
  EXPECT(sarsim_scene_read_text(text, strlen(text), "small.toml", NULL, &scene, &problems) == SARSIM_OK);
  sarsim_problems_free(problems);
  sarsim_scene_free(scene);
}

int main(int argc, char** argv) {
  EXPECT(argc == 2);
  fields_have_the_names_of_set();
  objects_are_counted_and_named();
  texts_come_back();
  mistakes_have_places();
  a_check_says_what_a_run_would();
  words_are_explained();
  files_are_warned_of();
  files_are_read(argv[1]);
  return 0;
}
