#include "raster/table/formats.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/format/format_writer.hpp"
#include "raster/format/sigmf.hpp"
#include "raster/sicd/nitf.hpp"

namespace sarsim::raster {

namespace {

// Digits of the largest signed count, and of the largest one with the offset.
double signed_digits(int bits) { return std::floor((bits - 1) * std::log10(2.0)) + 1.0; }
double offset_digits(int bits) { return std::floor(bits * std::log10(2.0)) + 1.0; }

double volts_bytes(int) { return 8.0; }

constexpr std::size_t recording_count = scene::format_values.size();

constexpr std::array<Format, recording_count + 5> table{
    {{.recording = scene::FileFormat::ascii,
      .word = "ASCII",
      .name = "Sarsim ASCII",
      .title = "Sarsim ASCII",
      .choice = "ASCII: I Q in lines",
      .extensions = {".asc", ".txt"},
      .text = TextStyle::lines,
      .script_like = true,
      .needs_bits = false,
      .places = {.saved = 2, .exported = 5, .described = 2, .image = 5},
      .max_sample_bytes = [](int bits) { return 2.0 * (signed_digits(bits) + 2.0); },
      .open = open_text,
      .writer = &ascii_writer},
     {.recording = scene::FileFormat::binary,
      .word = "BINARY",
      .name = "Sarsim BINARY",
      .title = "Sarsim BINARY",
      .choice = "Binary",
      .extensions = {".bin"},
      .places = {.saved = 1, .exported = 4, .described = 1, .image = 6},
      .max_sample_bytes = [](int bits) { return 2.0 * ((bits + 7) / 8); },
      .open = open_binary,
      .writer = &binary_writer,
      .arrays = arrays_of_binary},
     {.recording = scene::FileFormat::bracket,
      .word = "BRACKET",
      .name = "Sarsim BRACKET",
      .title = "Sarsim BRACKET",
      .choice = "Brackets: (I,Q)",
      .extensions = {".brk"},
      .text = TextStyle::brackets,
      .needs_bits = false,
      .places = {.saved = 4, .exported = 6, .described = 3, .image = 7},
      .max_sample_bytes = [](int bits) { return 2.0 * (signed_digits(bits) + 1.0) + 4.0; },
      .open = open_text,
      .writer = &bracket_writer},
     {.recording = scene::FileFormat::hdf5,
      .word = "HDF5",
      .name = "HDF5",
      .title = "HDF5",
      .choice = "HDF5: volts with axes and script",
      .extensions = {".h5", ".hdf5", ".hdf", ".he5"},
      .signature = "\x89HDF\r\n\x1a\n",
      .carries_axes = true,
      .carries_script = true,
      .datasets = true,
      .places = {.saved = 6, .exported = 1, .image = 2},
      .max_sample_bytes = volts_bytes,
      .open = open_hdf5_file,
      .writer = &hdf5_file_writer,
      .arrays = arrays_of_hdf5},
     {.recording = scene::FileFormat::csv,
      .word = "CSV",
      .name = "CSV",
      .title = "CSV text",
      .choice = "CSV: I,Q",
      .extensions = {".csv"},
      .text = TextStyle::commas,
      .spreadsheet = true,
      .places = {.saved = 3, .exported = 3, .described = 4, .image = 4},
      .max_sample_bytes = [](int bits) { return 2.0 * (offset_digits(bits) + 1.0); },
      .open = open_text,
      .writer = &csv_writer},
     {.recording = scene::FileFormat::npy,
      .word = "NPY",
      .name = "NumPy",
      .title = "NumPy array",
      .choice = "NPY: volts for NumPy",
      .extensions = {".npy"},
      .signature = "\x93NUMPY",
      .envi_header = true,
      .places = {.saved = 5, .exported = 2, .image = 1},
      .max_sample_bytes = volts_bytes,
      .open = open_npy,
      .writer = &npy_writer,
      .arrays = arrays_of_npy},
     {.recording = scene::FileFormat::zarr,
      .word = "ZARR",
      .name = "Zarr",
      .title = "Zarr store",
      .choice = "Zarr: volts with axes and script",
      .extensions = {".zarr"},
      .carries_axes = true,
      .carries_script = true,
      .folder = true,
      .places = {.saved = 7, .image = 3},
      .max_sample_bytes = volts_bytes,
      .open = open_zarr_file,
      .open_folder = open_zarr,
      .writer = &zarr_writer},
     {.recording = scene::FileFormat::sigmf,
      .word = "SIGMF",
      .name = "SigMF",
      .title = "SigMF recording",
      .choice = "SigMF: volts with captures",
      .extensions = {".sigmf-meta", ".sigmf-data"},
      .carries_axes = true,
      .carries_script = true,
      .in_files = sigmf_files,
      .places = {.saved = 8},
      .max_sample_bytes = volts_bytes,
      .open = open_sigmf,
      .writer = &sigmf_writer,
      .arrays = arrays_of_sigmf},
     {.word = "ENVI",
      .name = "ENVI",
      .title = "ENVI image",
      .extensions = {".img"},
      .envi_header = true,
      .open = open_envi,
      .arrays = arrays_of_envi},
     {.word = "SUN",
      .name = "Sun raster",
      .title = "Sun raster",
      .extensions = {".ras", ".sun"},
      .signature = "\x59\xa6\x6a\x95",
      .picture = true,
      .open = open_sun},
     {.word = "SICD",
      .name = "SICD",
      .title = "SICD image",
      .extensions = {".nitf", ".ntf", ".sicd"},
      .signature = nitf_begin,
      .open = open_sicd},
     {.word = "CPHD",
      .name = "CPHD",
      .title = "CPHD phase history",
      .extensions = {".cphd"},
      .signature = "CPHD/",
      .open = open_cphd},
     {.word = "CUSTOM",
      .name = "Custom",
      .title = "custom",
      .extensions = {".raw", ".dat", ".cpx", ".im8", ".cf32", ".c64"},
      .by_hand = true,
      .open = open_custom}}};

bool has_extension(const Format& row, const std::string& extension) {
  return std::ranges::any_of(row.extensions, [&](std::string_view known) {
    return !known.empty() && core::equal_ignoring_case(known, extension);
  });
}

}  // namespace

std::span<const Format> formats() { return table; }

std::span<const Format> recording_formats() { return std::span(table).first(recording_count); }

const Format& format_of(scene::FileFormat format) {
  return *std::ranges::find(table, std::optional(format), &Format::recording);  // Every format stands in the table.
}

const Format& envi_format() { return table[recording_count]; }
const Format& sun_raster_format() { return table[recording_count + 1]; }
const Format& sicd_format() { return table[recording_count + 2]; }
const Format& custom_format() { return table[recording_count + 4]; }

std::vector<const Format*> offered_formats(int FormatPlaces::*place) {
  std::vector<const Format*> offered;
  for (const Format& row : table)
    if (row.places.*place > 0) offered.push_back(&row);
  std::ranges::sort(offered, {}, [place](const Format* row) { return row->places.*place; });
  return offered;
}

std::string format_words() {
  std::string words;
  for (const Format& row : recording_formats())
    words += (&row == table.data() ? "" : &row == &table[recording_count - 1] ? " or " : ", ") + word_of(row);
  return words;
}

std::string image_extensions(bool without_spreadsheets) {
  std::string extensions;
  for (const Format* row : offered_formats(&FormatPlaces::image))
    if (!without_spreadsheets || !row->spreadsheet)
      extensions += fmt::format("{}{}", extensions.empty() ? "" : ", ", row->extensions.front());
  return extensions;
}

std::vector<std::filesystem::path> files_of(const Format* format, const std::filesystem::path& path) {
  return format == nullptr || format->in_files == nullptr ? std::vector{path} : format->in_files(path);
}

std::string word_of(const Format& format) {
  std::string word(format.word);
  for (char& c : word)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return word;
}

std::string_view extension_of(scene::FileFormat format) { return format_of(format).extensions.front(); }

std::string_view name_of(scene::FileFormat format) { return format_of(format).word; }

std::optional<scene::FileFormat> format_from_name(std::string_view name) {
  for (const Format& row : recording_formats())
    if (core::equal_ignoring_case(row.word, name)) return row.recording;
  return std::nullopt;
}

const Format* row_from_path(const std::filesystem::path& path) {
  // A shell puts a slash behind the name of a folder.
  const std::string extension = (path.has_filename() ? path : path.parent_path()).extension().string();
  const auto found = std::ranges::find_if(table, [&](const Format& row) { return has_extension(row, extension); });
  return found == table.end() ? nullptr : &*found;
}

std::optional<scene::FileFormat> format_from_path(const std::filesystem::path& path) {
  const Format* const row = row_from_path(path);
  return row == nullptr ? std::nullopt : row->recording;
}

double min_bytes(scene::FileFormat format, double expected_bytes) {
  constexpr double min_part_of_text = 0.4;
  return format_of(format).is_text() ? min_part_of_text * expected_bytes : expected_bytes;
}

}  // namespace sarsim::raster
