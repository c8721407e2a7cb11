#pragma once

#include "cli/command/image_fields.hpp"
#include "workflow/image/image_output.hpp"

/// The names of the workflows, as the commands use them.
namespace sarsim::cli {

using workflow::files_of_image;
using workflow::is_envi;
using workflow::magnitude_path;
using workflow::write_image;

}  // namespace sarsim::cli
