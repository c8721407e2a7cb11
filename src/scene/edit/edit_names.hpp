#pragma once

#include <string>
#include <vector>

#include "scene/edit/edit.hpp"

/// Names in edits: making free ones, and keeping what refers to an object referring to it.
namespace sarsim::scene {

/// The names that platforms or radars of a scene have.
[[nodiscard]] std::vector<std::string> names_of(const Scene& scene, ObjectKind kind);

/// `wanted` where no other object has it, ignoring case, else its beginning with the first free number from 2: "Ship2".
/// The initial name of platforms, where taken, begins "Platform".
[[nodiscard]] std::string free_name(const std::vector<std::string>& taken, const std::string& wanted);

/// The same for names of output files, whose ending stays: "sim2.bin".
[[nodiscard]] std::string free_file_name(const std::vector<std::string>& taken, const std::string& wanted);

/// The files that the simulations and geometry tables of a scene are to make.
[[nodiscard]] std::vector<std::string> file_names_of(const Scene& scene);

/// Adds to an edit what keeps references as they are: each object that the edit leaves alone and whose platform or
/// radar it renames, or whose reference a new name would draw to another, is given the whole name.
/// @param edit  its insertions are at the ends of the lists
void keep_references(const Scene& scene, Edit& edit);

}  // namespace sarsim::scene
