#include "raster/table/formats.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "core/text/number_text.hpp"

namespace sarsim::raster {

namespace {

struct Row {
  scene::FileFormat format;
  std::string_view name;
  std::string_view extension;
};

constexpr std::array<Row, 6> rows{{
    {scene::FileFormat::ascii, "ASCII", ".asc"},
    {scene::FileFormat::binary, "BINARY", ".bin"},
    {scene::FileFormat::bracket, "BRACKET", ".brk"},
    {scene::FileFormat::hdf5, "HDF5", ".h5"},
    {scene::FileFormat::csv, "CSV", ".csv"},
    {scene::FileFormat::npy, "NPY", ".npy"},
}};

struct Alias {
  scene::FileFormat format;
  std::string_view extension;
};

constexpr std::array<Alias, 4> aliases{{
    {scene::FileFormat::ascii, ".txt"},
    {scene::FileFormat::hdf5, ".hdf5"},
    {scene::FileFormat::hdf5, ".hdf"},
    {scene::FileFormat::hdf5, ".he5"},
}};

const Row& row_of(scene::FileFormat format) {
  return *std::ranges::find(rows, format, &Row::format);  // Every format stands in the table.
}

}  // namespace

std::string_view extension_of(scene::FileFormat format) { return row_of(format).extension; }

std::string_view name_of(scene::FileFormat format) { return row_of(format).name; }

std::optional<scene::FileFormat> format_from_name(std::string_view name) {
  for (const Row& row : rows)
    if (core::equal_ignoring_case(row.name, name)) return row.format;
  return std::nullopt;
}

std::optional<scene::FileFormat> format_from_path(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  for (const Row& row : rows)
    if (core::equal_ignoring_case(row.extension, extension)) return row.format;
  for (const Alias& alias : aliases)
    if (core::equal_ignoring_case(alias.extension, extension)) return alias.format;
  return std::nullopt;
}

}  // namespace sarsim::raster
