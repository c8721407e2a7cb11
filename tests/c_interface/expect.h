/* What the C tests have in common: checks that say where they failed, and a small scene. */
#pragma once

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sarsim.h"

/* Ends the program where a condition does not hold. */
#define EXPECT(condition) expect_that((condition) != 0, #condition, __FILE__, __LINE__)
/* Ends it where a call does not end with the status, and prints what is wrong. Frees the list. */
#define EXPECT_STATUS(status, expected, problems) expect_status(status, expected, problems, __FILE__, __LINE__)

static inline void expect_that(int holds, const char* condition, const char* file, int line) {
  if (holds) return;
  fprintf(stderr, "%s:%d: does not hold: %s\n", file, line, condition);
  exit(1);
}

static inline void expect_status(sarsim_status status, sarsim_status expected, sarsim_problems* problems, const char* file,
                          int line) {
  if (status != expected) {
    fprintf(stderr, "%s:%d: %s instead of %s\n", file, line, sarsim_status_word(status), sarsim_status_word(expected));
    for (size_t i = 0; i < sarsim_problems_count(problems); ++i) {
      sarsim_problem problem = SARSIM_INIT(sarsim_problem);
      if (sarsim_problems_get(problems, i, &problem) == SARSIM_OK) fprintf(stderr, "%s\n", problem.text);
    }
    exit(1);
  }
  sarsim_problems_free(problems);
}

/* A radar that looks at one target; 64 rows of 100 samples. */
static const char small_scene[] =
    "format = \"sarsim 2\"\n"
    "[let]\n"
    "far = 1000\n"
    "[[platform]]\n"
    "name = \"Plane\"\n"
    "[[target]]\n"
    "position = [0, \"far\", 0]\n"
    "[[radar]]\n"
    "name = \"Radar1\"\n"
    "platform = \"Plane\"\n"
    "pulse = { type = \"chirp\", bandwidth = \"50 MHz\", width = \"1 us\" }\n"
    "repetition = \"1 kHz\"\n"
    "carrier = \"10 GHz\"\n"
    "power = \"1 kW\"\n"
    "[[recording]]\n"
    "radar = \"Radar1\"\n"
    "file = \"small.npy\"\n"
    "format = \"npy\"\n"
    "range = [\"950 m\", \"1200 m\"]\n"
    "time = [\"0 s\", \"63.5 ms\"]\n"
    "sample_rate = \"60 MHz\"\n";

/* It, with as many values of [let] as are given. */
static inline sarsim_scene* read_small_scene(const char* const* let, size_t count) {
  sarsim_scene_options options = SARSIM_INIT(sarsim_scene_options);
  sarsim_scene* scene = NULL;
  sarsim_problems* problems = NULL;
  sarsim_status status;
  options.let = let;
  options.let_count = count;
  status = sarsim_scene_read_text(small_scene, strlen(small_scene), "small.toml", &options, &scene, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  return scene;
}

/* Its plan. */
static inline sarsim_plan* plan_of(const sarsim_scene* scene) {
  sarsim_plan* plan = NULL;
  sarsim_problems* problems = NULL;
  const sarsim_status status = sarsim_plan_new(scene, 1, NULL, &plan, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  return plan;
}

static inline sarsim_plan_info info_of(const sarsim_plan* plan) {
  sarsim_plan_info info = SARSIM_INIT(sarsim_plan_info);
  EXPECT_STATUS(sarsim_plan_get_info(plan, &info, NULL), SARSIM_OK, NULL);
  return info;
}
