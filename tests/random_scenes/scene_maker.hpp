#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "scene/model/scene.hpp"
#include "scene/script/data_file.hpp"

namespace sarsim::test {

/// A scene that uses the whole language and is small enough to be simulated in some milliseconds: a few platforms that
/// rest, fly and shake, up to 25 targets and a surface or two, one or two radars, one or two recordings of at most a
/// few hundred samples in a few rows, sometimes a geometry table. The targets stand about the middle of the window, so
/// that there is something to record. The same seed gives the same scene. Now and then `check` or `survey` refuses one.
[[nodiscard]] scene::Scene random_scene(std::uint64_t seed);

/// Visits every user-defined function of a scene: the block that describes it, its parts, and the name of its file.
using FunctionVisitor = std::function<void(const scene::FunctionBlock& block,
                                           std::span<const core::SampledFunction> parts, const std::string& file)>;
void visit_functions(const scene::Scene& scene, const FunctionVisitor& visit);

/// Puts the points of all functions into the script.
void keep_inline(scene::Scene& scene);

/// Finds the data files that a scene names, as if they had been written beside its script.
[[nodiscard]] scene::DataFileLoader loader_of(const scene::Scene& scene);

/// The same script in words that the writer does not use: other names of keywords, options that are the default, no
/// capitals in keywords.
[[nodiscard]] std::string spelled_otherwise(const std::string& script);

}  // namespace sarsim::test
