#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// The script of a scene: the layout of the 1998 programs (a value in 20 columns, then a comment), commands in the
/// order platforms, surfaces, targets, radars, simulations, geometry tables, options; docs/formats/script.md.
///
/// Reading it gives an equal scene, bit for bit, as long as the scene says nothing that a script cannot: numbers are
/// finite and within the limits of the language, names are not empty and hold no line ends or other control
/// characters, and members that the chosen alternatives make meaningless have their initial values. A function with a
/// `file` is written as that name; its data are `write_data_file`'s. The text is the same for any number of threads; a
/// requested stop throws Interrupted.
[[nodiscard]] std::string write_script(const Scene& scene, const core::WorkControl& control = {});

/// The same text in pieces, in their order, on the calling thread: for texts that nobody keeps.
void write_script(const Scene& scene, const core::WorkControl& control,
                  const std::function<void(std::string_view)>& take);

}  // namespace sarsim::scene
