#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "raster/hdf5/hdf5_library.hpp"

namespace sarsim::raster {

/// Writes one value of a type of the library as an attribute that is not there yet; false where the library fails.
bool write_attribute(hid_t object, const char* name, hid_t type, const void* value);
/// The same of a UTF-8 text of variable length.
bool write_attribute(hid_t object, const char* name, const std::string& text);
/// The same of a number.
bool write_attribute(hid_t object, const char* name, double value);
/// The same of a whole number.
bool write_attribute(hid_t object, const char* name, std::int32_t value);
/// The same.
bool write_attribute(hid_t object, const char* name, std::uint64_t value);
/// Writes another number into an attribute that is there.
bool replace_attribute(hid_t object, const char* name, double value);

/// The type of texts of variable length, UTF-8.
[[nodiscard]] Hdf5Handle text_type();

/// Begins a dataset that stands in the file in one piece, without time stamps; its bytes are there at once, but hold
/// anything until they are written.
[[nodiscard]] Hdf5Handle create_dataset(hid_t file, const char* name, hid_t type, std::span<const hsize_t> sizes);
/// The same whose bytes are there when they are written; until then it reads as zeros.
[[nodiscard]] Hdf5Handle create_late_dataset(hid_t file, const char* name, hid_t type, std::span<const hsize_t> sizes);

}  // namespace sarsim::raster
