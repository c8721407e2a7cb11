#include "raster/table/formats.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "core/text/number_text.hpp"

namespace sarsim {

namespace {

struct Row {
  FileFormat format;
  std::string_view name;
  std::string_view extension;
};

constexpr std::array<Row, 6> rows{{
    {FileFormat::ascii, "ASCII", ".asc"},
    {FileFormat::binary, "BINARY", ".bin"},
    {FileFormat::bracket, "BRACKET", ".brk"},
    {FileFormat::hdf5, "HDF5", ".h5"},
    {FileFormat::csv, "CSV", ".csv"},
    {FileFormat::npy, "NPY", ".npy"},
}};

struct Alias {
  FileFormat format;
  std::string_view extension;
};

constexpr std::array<Alias, 4> aliases{{
    {FileFormat::ascii, ".txt"},
    {FileFormat::hdf5, ".hdf5"},
    {FileFormat::hdf5, ".hdf"},
    {FileFormat::hdf5, ".he5"},
}};

const Row& row_of(FileFormat format) {
  return *std::ranges::find(rows, format, &Row::format);  // Every format stands in the table.
}

}  // namespace

std::string_view extension_of(FileFormat format) { return row_of(format).extension; }

std::string_view name_of(FileFormat format) { return row_of(format).name; }

std::optional<FileFormat> format_from_name(std::string_view name) {
  for (const Row& row : rows)
    if (equal_ignoring_case(row.name, name)) return row.format;
  return std::nullopt;
}

std::optional<FileFormat> format_from_path(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  for (const Row& row : rows)
    if (equal_ignoring_case(row.extension, extension)) return row.format;
  for (const Alias& alias : aliases)
    if (equal_ignoring_case(alias.extension, extension)) return alias.format;
  return std::nullopt;
}

}  // namespace sarsim
