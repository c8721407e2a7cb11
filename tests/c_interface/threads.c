/* Eight threads record different scenes at once, several times, and get the bytes that each scene gives alone. One thread
 * is stopped from another. Images of one source are made and measured by several threads. */
#include <pthread.h>
#include <time.h>

#include "expect.h"

enum { threads = 8, rows = 64, numbers = 64 * 200 };

static float alone[threads][numbers];
static float together[threads][numbers];

/* Scene number `index`: of a target of its own, read, changed, planned and recorded. */
static void record_scene(int index, float* samples) {
  char word[32];
  const char* let[1];
  sarsim_scene* scene;
  sarsim_plan* plan;
  sarsim_work work = SARSIM_INIT(sarsim_work);
  snprintf(word, sizeof word, "far=%d", 1000 + 10 * index);
  let[0] = word;
  scene = read_small_scene(let, 1);
  snprintf(word, sizeof word, "%d MHz", 20 + index);
  EXPECT_STATUS(sarsim_scene_set(scene, "Radar1.bandwidth", word, NULL), SARSIM_OK, NULL);
  EXPECT(sarsim_scene_set(scene, "Radar1.nothing", word, NULL) == SARSIM_BAD_INPUT);
  plan = plan_of(scene);
  sarsim_scene_free(scene);
  work.threads = 1 + (unsigned)index % 3;
  EXPECT_STATUS(sarsim_record_float(plan, 0, rows, samples, &work, NULL), SARSIM_OK, NULL);
  snprintf(word, sizeof word, "%d.h5", index);
  {
    sarsim_file_options options = SARSIM_INIT(sarsim_file_options);
    options.replace = 1;
    EXPECT_STATUS(sarsim_record_file(plan, word, &options, &work, NULL, NULL), SARSIM_OK, NULL);
  }
  sarsim_plan_free(plan);
}

static void* record_again(void* number) {
  const int index = *(const int*)number;
  int turn;
  for (turn = 0; turn < 5; ++turn) {
    memset(together[index], 0, sizeof together[index]);
    record_scene(index, together[index]);
    EXPECT(memcmp(together[index], alone[index], sizeof alone[index]) == 0);
  }
  return NULL;
}

/* Records one plan until it is stopped. */
struct endless {
  const sarsim_plan* plan;
  sarsim_stop* stop;
};

static void* record_until_stopped(void* user) {
  const struct endless* endless = user;
  sarsim_work work = SARSIM_INIT(sarsim_work);
  float* samples = malloc(numbers * sizeof(float));
  sarsim_status status = SARSIM_OK;
  EXPECT(samples != NULL);
  work.stop = endless->stop;
  work.threads = 2;
  while (status == SARSIM_OK) {
    status = sarsim_record_float(endless->plan, 0, rows, samples, &work, NULL);
    if (status == SARSIM_OK) EXPECT(memcmp(samples, alone[0], sizeof alone[0]) == 0);
  }
  EXPECT(status == SARSIM_STOPPED);
  free(samples);
  return NULL;
}

/* What many threads work on at once: nobody changes it. */
struct shared {
  const sarsim_source* source;
  const sarsim_raster* image; /* Of the source, focused by one thread alone. */
  const float* pixels;        /* Its own. */
  uint64_t count;             /* Of their numbers. */
  char table[100000];         /* What measuring it gives. */
};

static sarsim_raster* focused(const sarsim_source* source, unsigned workers) {
  sarsim_work work = SARSIM_INIT(sarsim_work);
  sarsim_result* result = NULL;
  sarsim_raster* image = NULL;
  work.threads = workers;
  EXPECT_STATUS(sarsim_focus(source, NULL, 0, &work, &result, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_result_raster(result, 0, &image, NULL), SARSIM_OK, NULL);
  sarsim_result_free(result);
  return image;
}

static void measured(const sarsim_raster* image, char* csv, size_t size) {
  sarsim_result* result = NULL;
  sarsim_table* table = NULL;
  EXPECT_STATUS(sarsim_measure(image, NULL, 0, NULL, &result, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_result_table(result, 0, &table, NULL), SARSIM_OK, NULL);
  EXPECT(strlen(sarsim_table_csv(table)) < size);
  strcpy(csv, sarsim_table_csv(table));
  sarsim_table_free(table);
  sarsim_result_free(result);
}

static void* focus_again(void* user) {
  const struct shared* shared = user;
  sarsim_raster* image = focused(shared->source, 2);
  float* pixels = malloc(shared->count * sizeof(float));
  char* csv = malloc(sizeof shared->table);
  EXPECT(pixels != NULL && csv != NULL);
  EXPECT_STATUS(sarsim_raster_read_float(image, NULL, pixels, NULL, NULL), SARSIM_OK, NULL);
  EXPECT(memcmp(pixels, shared->pixels, shared->count * sizeof(float)) == 0);
  sarsim_raster_free(image);
  measured(shared->image, csv, sizeof shared->table);
  EXPECT(strcmp(csv, shared->table) == 0);
  free(csv);
  free(pixels);
  return NULL;
}

/* Four threads focus one source and measure one image. */
static void images_are_made_at_once(const char* examples) {
  enum { few = 4 };
  static struct shared shared;
  char path[4096];
  pthread_t workers[few];
  sarsim_scene* scene = NULL;
  sarsim_source* source = NULL;
  sarsim_raster_info info = SARSIM_INIT(sarsim_raster_info);
  float* pixels;
  int i;
  snprintf(path, sizeof path, "%s/sar_r.toml", examples);
  EXPECT_STATUS(sarsim_scene_read_file(path, NULL, &scene, NULL), SARSIM_OK, NULL);
  EXPECT_STATUS(sarsim_source_scene(scene, 1, &source, NULL), SARSIM_OK, NULL);
  sarsim_scene_free(scene);
  sarsim_raster* image = focused(source, 1);
  EXPECT_STATUS(sarsim_raster_get_info(image, &info, NULL), SARSIM_OK, NULL);
  shared.count = 2 * info.rows * info.columns;
  pixels = malloc(shared.count * sizeof(float));
  EXPECT(pixels != NULL);
  EXPECT_STATUS(sarsim_raster_read_float(image, NULL, pixels, NULL, NULL), SARSIM_OK, NULL);
  shared.source = source;
  shared.image = image;
  shared.pixels = pixels;
  measured(image, shared.table, sizeof shared.table);
  for (i = 0; i < few; ++i) EXPECT(pthread_create(&workers[i], NULL, focus_again, &shared) == 0);
  for (i = 0; i < few; ++i) EXPECT(pthread_join(workers[i], NULL) == 0);
  free(pixels);
  sarsim_raster_free(image);
  sarsim_source_free(source);
}

int main(int argc, char** argv) {
  pthread_t workers[threads];
  int number[threads];
  struct endless endless = {NULL, NULL};
  sarsim_scene* scene;
  sarsim_plan* plan;
  int i;
  if (argc != 2) return 2;
  for (i = 0; i < threads; ++i) {
    record_scene(i, alone[i]);
    if (i > 0) EXPECT(memcmp(alone[i], alone[i - 1], sizeof alone[i]) != 0);
  }
  for (i = 0; i < threads; ++i) {
    number[i] = i;
    EXPECT(pthread_create(&workers[i], NULL, record_again, &number[i]) == 0);
  }
  for (i = 0; i < threads; ++i) EXPECT(pthread_join(workers[i], NULL) == 0);

  /* One plan by many threads at once, all of them stopped from here. */
  scene = read_small_scene(NULL, 0);
  EXPECT_STATUS(sarsim_scene_set(scene, "Radar1.bandwidth", "20 MHz", NULL), SARSIM_OK, NULL);
  plan = plan_of(scene);
  endless.plan = plan;
  EXPECT_STATUS(sarsim_stop_new(&endless.stop, NULL), SARSIM_OK, NULL);
  for (i = 0; i < threads; ++i) EXPECT(pthread_create(&workers[i], NULL, record_until_stopped, &endless) == 0);
  {
    const struct timespec short_while = {0, 200000000};
    nanosleep(&short_while, NULL);
  }
  sarsim_stop_request(endless.stop);
  for (i = 0; i < threads; ++i) EXPECT(pthread_join(workers[i], NULL) == 0);
  sarsim_stop_free(endless.stop);
  sarsim_plan_free(plan);
  sarsim_scene_free(scene);
  images_are_made_at_once(argv[1]);
  return 0;
}
