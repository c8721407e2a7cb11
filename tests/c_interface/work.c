/* Does some work on a scene in memory, and writes what it came to afterwards: usage:
 * work WORK SCENE IMAGE TABLE [OPTION...] */
#include <stdio.h>
#include <string.h>

#include "expect.h"

typedef sarsim_status (*work_on_echoes)(const sarsim_source*, const char* const*, size_t, const sarsim_work*,
                                        sarsim_result**, sarsim_problems**);

static work_on_echoes work_called(const char* name) {
  static const struct {
    const char* name;
    work_on_echoes function;
  } all[] = {{"focus", sarsim_focus},     {"profiles", sarsim_profiles}, {"isar", sarsim_isar},
             {"doppler", sarsim_doppler}, {"search", sarsim_search},     {"geometry", sarsim_geometry},
             {"export", sarsim_export}};
  for (size_t i = 0; i < sizeof all / sizeof all[0]; ++i)
    if (strcmp(all[i].name, name) == 0) return all[i].function;
  fprintf(stderr, "there is no work '%s'\n", name);
  exit(2);
}

static void write_table(const sarsim_result* result, const char* path) {
  sarsim_table* table = NULL;
  FILE* file = fopen(path, "wb");
  EXPECT(file != NULL);
  EXPECT_STATUS(sarsim_result_table(result, 0, &table, NULL), SARSIM_OK, NULL);
  EXPECT(fputs(sarsim_table_csv(table), file) >= 0);
  EXPECT(fclose(file) == 0);
  sarsim_table_free(table);
}

int main(int argc, char** argv) {
  sarsim_scene* scene = NULL;
  sarsim_source* source = NULL;
  sarsim_result* result = NULL;
  sarsim_raster* raster = NULL;
  sarsim_problems* problems = NULL;
  sarsim_status status;
  if (argc < 5) return 2;
  status = sarsim_scene_read_file(argv[2], NULL, &scene, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  EXPECT_STATUS(sarsim_source_scene(scene, 0, &source, NULL), SARSIM_OK, NULL);
  sarsim_scene_free(scene);
  status = work_called(argv[1])(source, (const char* const*)argv + 5, (size_t)argc - 5, NULL, &result, &problems);
  EXPECT_STATUS(status, SARSIM_OK, problems);
  sarsim_source_free(source);
  if (sarsim_result_raster_count(result) > 0) {
    EXPECT_STATUS(sarsim_result_raster(result, 0, &raster, NULL), SARSIM_OK, NULL);
    status = sarsim_raster_write(raster, argv[3], NULL, 0, NULL, &problems);
    EXPECT_STATUS(status, SARSIM_OK, problems);
    sarsim_raster_free(raster);
  }
  if (sarsim_result_table_count(result) > 0) write_table(result, argv[4]);
  sarsim_result_free(result);
  return 0;
}
