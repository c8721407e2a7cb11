#pragma once

#include <filesystem>
#include <string>

#include "core/report/problem.hpp"
#include "scene/script/reader.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::workflow {

/// Which scene becomes a text in which language.
struct ConvertSceneRequest {
  std::string input;
  std::string output;
  SceneOverrides overrides;
  bool force = false;  ///< Replace the output where it exists.
};

/// A scene as a text in a language.
/// @param everything  in format 2, defaults stand as comments
/// @throws core::InvalidRequest with the place of everything that the language cannot say
[[nodiscard]] std::string scene_text(const SceneInput& input, scene::Language language, bool everything = false);

/// Writes a scene in the language that the name of the output asks for. Comments of the input are not kept.
/// @returns remarks on the input and on what the new file does differently
/// @throws core::InvalidRequest where the input holds errors, or says what the other language cannot
[[nodiscard]] core::Problems convert_scene(const ConvertSceneRequest& request, const core::WorkControl& control = {});

}  // namespace sarsim::workflow
