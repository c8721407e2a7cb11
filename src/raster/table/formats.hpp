#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/task/stop.hpp"
#include "raster/table/stored_array.hpp"
#include "scene/model/format_values.hpp"
#include "scene/model/recording.hpp"

namespace sarsim::core {
class InputFile;
}

namespace sarsim::raster {

enum class Integrity;
struct FormatWriter;
struct OpenedRaster;
struct RasterHints;

/// How the numbers of a text make samples and rows.
enum class TextStyle {
  none,      ///< No text.
  lines,     ///< "I Q" in a line of its own, an empty line behind each row.
  commas,    ///< "I,Q,I,Q" in a line for each row.
  brackets,  ///< "(I,Q) (I,Q)" in a line for each row.
};

/// Where a format stands in the lists that people choose from, from 1; 0 where it is not offered.
struct FormatPlaces {
  int saved = 0;      ///< Recordings that are saved from a picture.
  int exported = 0;   ///< Selections that are exported.
  int described = 0;  ///< Files that are opened and do not describe themselves.
  int image = 0;      ///< Extensions of images in the help of commands.
};

/// All there is to know of a kind of file: one row of the table of formats (raster/format/formats.cpp). Whoever needs
/// to know something of a format asks its row; nobody compares formats by name. A new format is a row there, the file
/// with its reader and writer and, for recordings, its name in scripts (`scene::FileFormat`).
struct Format {
  /// The format of recordings that scripts name; nothing for what only images are stored as.
  std::optional<scene::FileFormat> recording = std::nullopt;
  std::string_view word;         ///< Keyword in scripts, "HDF5"; in lower case the word of commands and reports.
  std::string_view name;         ///< For people, in lists: "Sarsim BINARY", "NumPy".
  std::string_view title;        ///< For people, of a file: "Sarsim BINARY", "NumPy array".
  std::string_view choice = {};  ///< For people who choose how a recording is saved: "ASCII: I Q in lines".
  /// With their points, the usual one first; empty at the end.
  std::array<std::string_view, 6> extensions = {};
  std::string_view signature = {};  ///< Bytes that every file begins with; empty where there are none.
  TextStyle text = TextStyle::none;
  bool script_like = false;     ///< Its extensions are also those of scripts and other texts.
  bool spreadsheet = false;     ///< Programs for tables read it.
  bool needs_bits = true;       ///< How counts are stored depends on the A/D bits.
  bool carries_axes = false;    ///< Times, carriers and ranges stand in the file.
  bool carries_script = false;  ///< The script stands in the file.
  bool envi_header = false;     ///< An ENVI header beside the file makes it an image with axes.
  bool picture = false;         ///< Levels and colours made for the eye.
  bool folder = false;          ///< It is a folder of files.
  bool datasets = false;        ///< A file of it has datasets with names, one of which may be asked for.
  bool by_hand = false;         ///< Somebody says how it is stored: it does not say itself what its numbers are.
  /// The files that an output of that name becomes, where they are several: all of them, or none is there.
  std::vector<std::filesystem::path> (*in_files)(const std::filesystem::path& path) = nullptr;
  FormatPlaces places = {};
  /// The most bytes of a sample of so many A/D bits, where nothing else is asked for; exact but for text.
  double (*max_sample_bytes)(int bits) = nullptr;
  /// Opens a file of it (raster/format/format_reader.hpp). What has to be looked through asks for a stop.
  OpenedRaster (*open)(core::InputFile file, const Format& format, const RasterHints& hints, Integrity integrity,
                       const core::StopFlag* stop) = nullptr;
  /// Opens a folder of it, where it is one.
  OpenedRaster (*open_folder)(const std::filesystem::path& folder, const Format& format, const RasterHints& hints,
                              Integrity integrity, const core::StopFlag* stop) = nullptr;
  const FormatWriter* writer = nullptr;  ///< Null where no sink writes it.
  /// Where the arrays of a file of it stand; null where its numbers are no arrays.
  StoredArrays (*arrays)(const core::InputFile& file, const RasterHints& hints) = nullptr;

  /// Whether it is text, whose size is only estimated and whose rows have no places of their own.
  [[nodiscard]] bool is_text() const { return text != TextStyle::none; }
};

/// All rows: first the formats of recordings in the order of scene::FileFormat, then ENVI, pictures, SICD and files
/// that are described by hand.
[[nodiscard]] std::span<const Format> formats();

/// The row of a format of recordings.
[[nodiscard]] const Format& format_of(scene::FileFormat format);
/// The row of flat images with an ENVI header.
[[nodiscard]] const Format& envi_format();
/// The row of Sun rasters.
[[nodiscard]] const Format& sun_raster_format();
/// The row of complex images with their place on the Earth.
[[nodiscard]] const Format& sicd_format();
/// The row of files that a RawLayout describes.
[[nodiscard]] const Format& custom_format();

/// The formats of recordings, in the order of scene::FileFormat.
[[nodiscard]] std::span<const Format> recording_formats();
/// The formats that a list offers, in its order.
[[nodiscard]] std::vector<const Format*> offered_formats(int FormatPlaces::*place);
/// The words of all formats of recordings: "ascii, binary, bracket, hdf5, csv, npy, zarr or sigmf".
[[nodiscard]] std::string format_words();
/// The extensions of images that are no ENVI images: ".npy, .h5, .csv, .asc, .bin, .brk".
/// @param without_spreadsheets  leave out those that become tables of their own
[[nodiscard]] std::string image_extensions(bool without_spreadsheets = false);
/// The files that an output becomes: that of its name, but for formats of several files.
/// @param format  null for none of the table
[[nodiscard]] std::vector<std::filesystem::path> files_of(const Format* format, const std::filesystem::path& path);
/// The word of a format in commands and reports: "hdf5", "envi".
[[nodiscard]] std::string word_of(const Format& format);

/// The usual extension of a format, with its point: ".asc", ".bin", ".brk", ".h5", ".csv", ".npy", ".zarr".
[[nodiscard]] std::string_view extension_of(scene::FileFormat format);

/// The keyword of a format in scripts: "ASCII", "BINARY", "BRACKET", "HDF5", "CSV", "NPY", "ZARR", "SIGMF".
[[nodiscard]] std::string_view name_of(scene::FileFormat format);

/// The format that a keyword means, ignoring case; nothing for another word.
[[nodiscard]] std::optional<scene::FileFormat> format_from_name(std::string_view name);

/// The format that the extension of a path means, ignoring case (the usual ones, and .txt, .hdf5, .hdf, .he5); nothing
/// for another one.
[[nodiscard]] std::optional<scene::FileFormat> format_from_path(const std::filesystem::path& path);
/// The same of all rows, those of images and pictures too.
[[nodiscard]] const Format* row_from_path(const std::filesystem::path& path);

/// Whether a file of that format holds counts of the converter: HDF5, NPY and Zarr hold volts unless counts are asked
/// for.
[[nodiscard]] constexpr bool holds_counts(scene::FileFormat format, bool counts_asked = false) {
  return counts_asked || scene::values_of(format) == scene::SampleValues::counts;
}

/// What a file of an expected size needs at least: the size of text is an estimate from above.
[[nodiscard]] double min_bytes(scene::FileFormat format, double expected_bytes);

}  // namespace sarsim::raster
