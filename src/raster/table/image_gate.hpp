#pragma once

#include <string>

#include "core/report/problem.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::raster {

/// Whether Sarsim computes with this speed of light: that of nature, or the one of 1998 (the classic profile).
[[nodiscard]] bool is_light_speed(double speed_mps);
/// These, for messages.
inline constexpr const char* light_speeds = "299792458, or 299792500 of the classic profile";

/// Judges what a file of samples says of an image that Sarsim focused: that its plane is known, steps, carrier and
/// speed are above 0, the speed of light is one (`is_light_speed`), its frame is one, and that its axes are the places
/// that first place and step give. Nothing of files that are no such image.
/// @param axes  those of the file; null where it has none, or more than are looked at
/// @param path  of the file, for the problems
/// @return errors, and a warning for each axis that contradicts the rest
[[nodiscard]] core::Problems problems_of_image(const RasterInfo& info, const RasterAxes* axes, const std::string& path);

}  // namespace sarsim::raster
