#pragma once

#include "workflow/image/image_script.hpp"

/// The names of the workflows, as the commands use them.
namespace sarsim::cli {

using workflow::add_way_back;
using workflow::way_back;
using workflow::WayBack;

}  // namespace sarsim::cli
