#pragma once

#include "workflow/image/image_writer.hpp"

/// The names of the workflows, as the commands use them.
namespace sarsim::cli {

using workflow::ImageContent;
using workflow::ImageWriter;
using workflow::needs_largest;

}  // namespace sarsim::cli
