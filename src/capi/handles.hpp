#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "capi/sarsim.h"
#include "core/report/problem.hpp"
#include "core/task/observer.hpp"
#include "core/task/stop.hpp"
#include "core/text/csv.hpp"
#include "raster/table/raster.hpp"
#include "workflow/image/in_memory_image.hpp"
#include "workflow/image/named_axes.hpp"
#include "workflow/input/recording_input.hpp"
#include "workflow/input/sample_input.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/record/scene_plan.hpp"

/// A text in UTF-8.
struct sarsim_text {
  std::string text;
};

/// A list of problems and of what the command prints of each.
struct sarsim_problems {
  std::vector<sarsim::core::Problem> problems;
  std::vector<std::string> texts;
};

/// A stop request.
struct sarsim_stop {
  sarsim::core::StopFlag flag;
};

/// A scene as it was read and changed.
struct sarsim_scene {
  sarsim::workflow::SceneInput input;
};

/// A plan with what its strings and axes are.
struct sarsim_plan {
  sarsim::workflow::ScenePlan planned;
  std::size_t number = 1;  ///< Of the recording in its scene, from 1.
  sarsim::raster::Product product;
  std::string processing;
  std::string format;
  std::string file;
  std::string engine;
};

/// A table with the text that it was made of.
struct sarsim_table {
  std::string csv;
  sarsim::core::CsvTable table;
  std::vector<bool> numbers;  ///< Of each column, whether it holds numbers alone.
};

/// Samples of a file, of an image that was made, or in the caller's memory.
struct sarsim_raster {
  std::shared_ptr<const sarsim::raster::Raster> samples;
  std::vector<sarsim::workflow::NamedAxis> axes;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string format;
  std::string path;                                              ///< Of a file; else empty.
  sarsim::workflow::SampleArguments said;                        ///< Of a file that does not describe itself.
  std::shared_ptr<const sarsim::workflow::InMemoryImage> image;  ///< That was made here.
  const float* memory = nullptr;                                 ///< The caller's; it may be described further.
};

/// Whose echoes are worked on.
struct sarsim_source {
  sarsim::workflow::RecordingArguments input;
};

/// What work came to.
struct sarsim_result {
  std::string json = "{}\n";
  std::vector<sarsim_raster> rasters;
  std::vector<std::string> tables;  ///< As comma-separated values.
};
