#pragma once

#include "scene/model/scene.hpp"
#include "scene/script/script_lines.hpp"

/// One function for each command of the language: adds its lines.
namespace sarsim::scene::script {

void write_platform(ScriptLines& lines, const Platform& platform);
void write_surface(ScriptLines& lines, const Surface& surface);
void write_target(ScriptLines& lines, const Target& target);
void write_radar(ScriptLines& lines, const Radar& radar);
void write_simulation(ScriptLines& lines, const Simulation& simulation);
void write_geometry(ScriptLines& lines, const GeometryTable& table);
/// Only what differs from the initial values; nothing where nothing does.
void write_options(ScriptLines& lines, const RunOptions& options);

}  // namespace sarsim::scene::script
