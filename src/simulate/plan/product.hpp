#pragma once

#include <string>

#include "raster/table/sink.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::simulate {

/// What a recording is to its file and to whoever reads it.
/// @param script  text of the scene as understood
[[nodiscard]] raster::Product product_of(const Acquisition& acquisition, std::string script);

}  // namespace sarsim::simulate
