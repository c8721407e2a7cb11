#pragma once

#include "scene/model/scene.hpp"
#include "scene/script/script_lines.hpp"

/// One `write_command` for each command of the language: adds its lines.
namespace sarsim::scene::script {

void write_command(ScriptLines& lines, const Platform& platform);
void write_command(ScriptLines& lines, const Surface& surface);
void write_command(ScriptLines& lines, const Target& target);
void write_command(ScriptLines& lines, const Cloud& cloud);
void write_command(ScriptLines& lines, const Radar& radar);
void write_command(ScriptLines& lines, const Simulation& simulation);
void write_command(ScriptLines& lines, const GeometryTable& table);
/// Only what differs from the initial values; nothing where nothing does.
void write_command(ScriptLines& lines, const RunOptions& options);

}  // namespace sarsim::scene::script
