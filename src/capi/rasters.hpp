#pragma once

#include <string>

#include "capi/handles.hpp"
#include "core/task/observer.hpp"

namespace sarsim::capi {

/// A file of samples or an image as a raster; `observer` hears its remarks.
[[nodiscard]] sarsim_raster raster_of_file(const std::string& path, const workflow::SampleArguments& said,
                                           const core::Observer& observer);

/// An image that was made and not written.
[[nodiscard]] sarsim_raster raster_of_image(workflow::InMemoryImage image);

}  // namespace sarsim::capi
