#pragma once

#include "core/task/parallel.hpp"
#include "raster/parts/journal.hpp"
#include "raster/parts/stored_product.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// Everything that decides the bytes of a recording: what parts that belong together have in common.
/// @param simulation  its number in the scene, from 0
[[nodiscard]] raster::Identity identity_of(const scene::Scene& scene, std::size_t simulation,
                                           const raster::StoredProduct& stored, const core::WorkControl& control = {});

}  // namespace sarsim::workflow
