#pragma once

#include "workflow/image/image_fields.hpp"

/// The names of the workflows, as the commands use them.
namespace sarsim::cli {

using workflow::header_of;
using workflow::ImageOrigin;
using workflow::is_of_turning_target;
using workflow::read_header;

}  // namespace sarsim::cli
