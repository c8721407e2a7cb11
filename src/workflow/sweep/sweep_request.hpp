#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/script/field_places.hpp"
#include "simulate/plan/engine.hpp"
#include "workflow/input/recording_input.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/sweep/post_processing.hpp"
#include "workflow/sweep/sweep_axes.hpp"

namespace sarsim::workflow {

/// A share of a sweep: number `index` of `count`, from 0.
struct SweepPart {
  std::size_t index = 0;
  std::size_t count = 1;
};

/// What varies, and what is made of it.
struct SweepRequest {
  scene::Scene scene;                          ///< As read; values that vary may be wrong in it.
  std::string script;                          ///< Its file, as tables and messages name it; follow-ups read it.
  SceneOverrides overrides;                    ///< That `scene` was read with, for follow-ups.
  std::shared_ptr<const HeldScene> held{};     ///< The scene, where it is in no file: follow-ups work on it.
  scene::LetNames names;                       ///< Of its [let].
  scene::FieldPlaces places;                   ///< Where its values stand, for problems.
  std::vector<std::filesystem::path> sources;  ///< Script and data files, which no output may replace.
  SweepValues values;                          ///< What varies.
  std::vector<std::string> products;           ///< Those that are made, see `chosen_products`; none: all.
  PostProcessing post_processing;              ///< What is made of each recording besides.
  std::optional<scene::FileFormat> format;     ///< Set where all of `scene` were given it: names follow it.
  std::string folder = ".";                    ///< Of all files; made when missing.
  std::string table;                           ///< Stem of tables and journal; empty: "sweep".
  SweepPart part;                              ///< Only every `count`th variation, from the one at `index`.
  simulate::Engine engine = simulate::Engine::automatic;
  unsigned threads = 0;  ///< Of all variations together; 0: one per core.
  unsigned jobs = 0;     ///< Variations at a time; 0: as many as there are threads.
  bool counts = false;   ///< As in SinkOptions.
  bool header = false;   ///< As in SinkOptions.
  bool discard = false;  ///< Compute and encode everything, write the tables alone.
  bool force = false;    ///< Replace existing files.
  bool resume = false;   ///< Leave out what an earlier sweep completed.
  bool strict = false;   ///< A warning refuses the sweep, too.
};

}  // namespace sarsim::workflow
