#pragma once

#include <filesystem>

#include "core/task/stop.hpp"
#include "picture/live/live_request.hpp"

namespace sarsim::picture {

/// Makes what a live image shows with all its samples, as its command would, into a file whose format the name says.
/// @throws core::InvalidRequest with why it cannot be done, core::Interrupted, and like the sinks
void write_live_product(const LiveRequest& request, const std::filesystem::path& file, const core::StopFlag* stop);

}  // namespace sarsim::picture
