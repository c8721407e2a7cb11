#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/task/observer.hpp"
#include "scene/model/scene.hpp"
#include "simulate/plan/plan.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/record/part_choice.hpp"
#include "workflow/record/record_report.hpp"
#include "workflow/record/team.hpp"

namespace sarsim::workflow {

/// Which products of a scene are to be made, and how.
struct RecordRequest {
  std::string script;                 ///< File with the scene; also the scene's name in messages.
  std::optional<scene::Scene> scene;  ///< Instead of reading the file.
  SceneOverrides overrides;
  std::vector<std::string> products;   ///< Numbers of simulations from 1, or output names; empty: all products.
  std::filesystem::path folder = ".";  ///< Of the products, or the file of the only recording: `run_output`.
  unsigned threads = 0;                ///< 0: one per core, which processes of one machine share.
  simulate::Engine engine = simulate::Engine::automatic;
  std::string simd;         ///< Instruction set; empty: the best there is.
  bool force = false;       ///< Replace files that exist.
  bool keep_paths = false;  ///< Keep the folders of output names.
  bool counts = false;      ///< Counts of the converter instead of volts in HDF5 and NPY.
  bool header = false;      ///< A header line in CSV.
  bool doubles = false;     ///< Volts of HDF5 and NPY in double precision.
  bool discard = false;     ///< Compute and encode everything, write nothing.
  bool strict = false;      ///< Warnings are mistakes, too.
  PartChoice part;
  Team* team = nullptr;  ///< Processes that make it together, all of which call `record`; none: this one alone.
};

/// Makes products of a scene: reads, checks and surveys it, names the outputs, sees that they are free and that the
/// disk has room, and makes one after the other in the scene's order. Each file appears when it is complete.
///
/// Before the first pulse the observer gets what is worth knowing and a line on each recording. The bytes of products
/// depend neither on threads nor on parts and processes.
/// @throws core::InvalidRequest for mistakes in the request or the scene, before or while it is carried out
/// @throws core::Interrupted when stopped; core::DeferredSignal where what is done was kept
[[nodiscard]] RecordReport record(const RecordRequest& request, const core::Observer& observer,
                                  const RecordEvents& events = {});

}  // namespace sarsim::workflow
