#pragma once

#include "scene/language/object_reader.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene::language {

/// Reads a path of type `line`, a start [m] at time 0 and a velocity [m/s], as the two points that make it; does
/// nothing for other paths.
void read_line_path(ObjectReader& reader, ObjectText& text, Platform& platform);

}  // namespace sarsim::scene::language
