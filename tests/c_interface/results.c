/* Versions, texts, problems, structures of other sizes, arguments that are missing. */
#include "expect.h"

/* Every function survives NULL, and says which argument it is. */
static void null_is_a_bad_argument(void) {
  sarsim_problems* problems = NULL;
  sarsim_problem problem = SARSIM_INIT(sarsim_problem);
  sarsim_scene* scene = NULL;
  size_t count = 7;
  EXPECT(sarsim_scene_read_file(NULL, NULL, &scene, &problems) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_problems_count(problems) == 1);
  EXPECT(sarsim_problems_get(problems, 0, &problem) == SARSIM_OK);
  EXPECT(problem.severity == SARSIM_ERROR && problem.count == 1);
  EXPECT(strcmp(problem.message, "sarsim_scene_read_file: path is NULL") == 0);
  EXPECT(problem.file[0] == 0 && problem.line == 0 && problem.object[0] == 0);
  EXPECT(sarsim_problems_get(problems, 1, &problem) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_problems_get(problems, 0, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_problems_get(NULL, 0, &problem) == SARSIM_BAD_ARGUMENT);
  sarsim_problems_free(problems);

  EXPECT(sarsim_scene_read_file("x", NULL, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_scene_read_text(NULL, 3, NULL, NULL, &scene, NULL) == SARSIM_BAD_ARGUMENT && scene == NULL);
  EXPECT(sarsim_scene_copy(NULL, &scene, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_scene_text(NULL, SARSIM_FORMAT_2, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_scene_check(NULL, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_scene_count(NULL, "target", &count, NULL) == SARSIM_BAD_ARGUMENT && count == 7);
  EXPECT(sarsim_scene_name(NULL, "target", 0, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_scene_get(NULL, "seed", NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_scene_set(NULL, "seed", "1", NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_explain(NULL, SARSIM_WORDS, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_plan_new(NULL, 1, NULL, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_plan_get_info(NULL, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_plan_axis(NULL, SARSIM_ROW_TIME_S, 0, 0, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_record_float(NULL, 0, 0, NULL, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_record_double(NULL, 0, 0, NULL, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_record_file(NULL, "x.npy", NULL, NULL, NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_stop_new(NULL, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(sarsim_problems_count(NULL) == 0);
  EXPECT(sarsim_text_length(NULL) == 0 && sarsim_text_chars(NULL)[0] == 0);
  sarsim_text_free(NULL);
  sarsim_problems_free(NULL);
  sarsim_stop_free(NULL);
  sarsim_stop_request(NULL);
  sarsim_scene_free(NULL);
  sarsim_plan_free(NULL);
}

/* A program that was compiled with a later header, and one with an earlier one. */
static void structures_may_be_of_another_size(void) {
  struct {
    sarsim_scene_options known;
    double later;
  } larger;
  struct {
    size_t struct_size;
    sarsim_severity severity;
  } smaller = {sizeof smaller, 99};
  struct {
    sarsim_problem known;
    size_t later;
  } told;
  sarsim_problems* problems = NULL;
  sarsim_scene* scene = NULL;
  sarsim_scene_options unset;

  memset(&larger, 0, sizeof larger);
  larger.known.struct_size = sizeof larger;
  EXPECT_STATUS(sarsim_scene_read_text(small_scene, strlen(small_scene), NULL, &larger.known, &scene, NULL), SARSIM_OK, NULL);
  sarsim_scene_free(scene);
  larger.later = 1.0;
  EXPECT(sarsim_scene_read_text(small_scene, strlen(small_scene), NULL, &larger.known, &scene, NULL) == SARSIM_BAD_ARGUMENT);
  EXPECT(scene == NULL);
  memset(&unset, 0, sizeof unset);
  EXPECT(sarsim_scene_read_text(small_scene, strlen(small_scene), NULL, &unset, &scene, NULL) == SARSIM_BAD_ARGUMENT);

  EXPECT(sarsim_scene_read_text("format = 1", 10, NULL, NULL, &scene, &problems) == SARSIM_BAD_INPUT);
  EXPECT(sarsim_problems_get(problems, 0, (sarsim_problem*)(void*)&smaller) == SARSIM_OK);
  EXPECT(smaller.severity == SARSIM_ERROR);
  memset(&told, 0xff, sizeof told);
  told.known.struct_size = sizeof told;
  EXPECT(sarsim_problems_get(problems, 0, &told.known) == SARSIM_OK);
  EXPECT(told.later == 0 && told.known.struct_size == sizeof told && told.known.line == 1);
  sarsim_problems_free(problems);
}

int main(void) {
  EXPECT(sarsim_abi_version() == SARSIM_ABI_VERSION);
  EXPECT(strchr(sarsim_version(), '.') != NULL);
  EXPECT(strcmp(sarsim_status_word(SARSIM_OK), "ok") == 0);
  EXPECT(strcmp(sarsim_status_word(SARSIM_STOPPED), "stopped") == 0);
  EXPECT(strcmp(sarsim_status_word(4711), "unknown status") == 0);
  null_is_a_bad_argument();
  structures_may_be_of_another_size();
  return 0;
}
