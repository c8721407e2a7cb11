#pragma once

#include <filesystem>
#include <optional>

#include "core/report/problem.hpp"
#include "core/task/stop.hpp"
#include "raster/format/sinks.hpp"
#include "scene/model/scene.hpp"
#include "workflow/record/save_estimate.hpp"

namespace sarsim::workflow {

/// Where the LSB of the converter comes from.
enum class LsbChoice {
  estimated,  ///< From the largest magnitude in the picture; where that is unknown, from the whole recording.
  measured,   ///< From the largest magnitude of the whole recording, which is computed twice.
  given,
};

/// What a file holds where its format can hold either; the others hold counts.
enum class SampleChoice {
  volts,    ///< Not quantised, in single precision.
  counts,   ///< Of the converter.
  doubles,  ///< Volts in double precision.
};

/// Where the settings of a window go (thesis 4.5.2).
enum class SaveTarget { disk, script, both };

/// What is chosen before the data of a window are saved.
struct SaveChoice {
  scene::Simulation
      recording;  ///< Radar, window, processing, sampling, bits and format; its LSB counts where it is given.
  LsbChoice lsb = LsbChoice::estimated;
  SampleChoice samples = SampleChoice::volts;
  SaveTarget target = SaveTarget::disk;
  std::filesystem::path file;

  friend bool operator==(const SaveChoice&, const SaveChoice&) = default;
};

/// The simulation that a choice comes to: with its LSB (0: from the whole recording) and the base name of its file, as
/// it is stored and run.
/// @param largest_v  largest magnitude in the picture; 0: unknown
[[nodiscard]] scene::Simulation chosen_simulation(const SaveChoice& choice, double largest_v);

/// What its file will hold, whatever else is chosen.
[[nodiscard]] SampleChoice chosen_samples(const SaveChoice& choice);

/// How its file is to be written.
/// @param replace  an existing file may be replaced
[[nodiscard]] raster::SinkOptions sink_options_of(const SaveChoice& choice, bool replace);

/// A scene with one more simulation, its last.
[[nodiscard]] scene::Scene with_simulation(scene::Scene scene, const scene::Simulation& simulation);

/// A file name whose extension is the usual one of a format: replaced where it is that of another format, added where
/// there is none, left as it is otherwise.
[[nodiscard]] std::filesystem::path following_format(std::filesystem::path file, scene::FileFormat format);

/// The first of "sim1", "sim2", ... with the extension of a format that no simulation of a scene has and no file of the
/// folder.
[[nodiscard]] std::filesystem::path free_file(const scene::Scene& scene, const std::filesystem::path& folder,
                                              scene::FileFormat format);

/// What saving takes, or why it cannot be.
struct SaveForecast {
  core::Problems problems;  ///< Errors only.
  std::optional<SaveEstimate> estimate;
};
/// Plans a choice as its run will. An LSB that only the whole recording gives doubles the time where the file holds
/// counts.
/// @param threads  that will compute, at least 1
[[nodiscard]] SaveForecast forecast(const scene::Scene& scene, const SaveChoice& choice, double largest_v,
                                    unsigned threads, const core::StopFlag* stop = nullptr);

}  // namespace sarsim::workflow
