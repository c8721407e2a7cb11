#pragma once

#include <string>

#include "simulate/plan/acquisition.hpp"
#include "simulate/plan/sink.hpp"

namespace sarsim::simulate {

/// What a recording is to its file and to whoever reads it.
/// @param script  text of the scene as understood
[[nodiscard]] Product product_of(const Acquisition& acquisition, std::string script);

}  // namespace sarsim::simulate
