#pragma once

#include "scene/model/scene.hpp"
#include "scene/script/field_reader.hpp"

/// One function for each command of the language: reads its parameters, adds what they describe to the scene (also
/// where they hold mistakes, so that what refers to it is not blamed too) and leaves the next command to be taken.
namespace sarsim::scene::script {

void read_platform(Reading& reading, const Token& command, Scene& scene);
void read_target(Reading& reading, const Token& command, Scene& scene);
void read_cloud(Reading& reading, const Token& command, Scene& scene);
void read_surface(Reading& reading, const Token& command, Scene& scene);
void read_radar(Reading& reading, const Token& command, Scene& scene);
void read_simulation(Reading& reading, const Token& command, Scene& scene);
void read_geometry(Reading& reading, const Token& command, Scene& scene);
void read_options(Reading& reading, const Token& command, Scene& scene);

}  // namespace sarsim::scene::script
