#include <algorithm>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "raster/format/format_reader.hpp"
#include "raster/format/format_writer.hpp"
#include "raster/format/load_hdf5.hpp"
#include "raster/table/file_problem.hpp"
#include "scene/schema/option_words.hpp"

namespace sarsim::raster {

namespace {

// About how many bytes an HDF5 file needs beside the samples.
double hdf5_overhead_bytes(const Product& product) {
  constexpr double structure = 11500.0;      // Superblock, object headers, the heaps that hold texts and references.
  constexpr double pose_structure = 1900.0;  // Three datasets, what they mean and their axes.
  constexpr double pose = 72.0;
  const auto rows = static_cast<double>(product.rows);
  return structure + static_cast<double>(product.script.size()) + 16.0 * rows +
         8.0 * static_cast<double>(product.columns) + (product.row_pose ? pose_structure + pose * rows : 0.0);
}

// A link or a pipe of this name would lead what is written elsewhere.
const std::filesystem::path& free_name(const std::filesystem::path& scratch) {
  std::error_code ignored;
  std::filesystem::remove(scratch, ignored);
  return scratch;
}

// A whole HDF5 file but for its samples, for as long as it is needed.
class Hdf5Frame {
 public:
  Hdf5Frame(const std::filesystem::path& path, const Product& product, const Encoding& encoding,
            const RunReport& report)
      : path_(free_name(path)),
        places_(hdf5_module(path).row_places(path, product, scene::option_words(product.options), encoding)),
        rows_(product.rows) {
    hdf5_module(path).write_frame(path, product, scene::option_words(product.options), encoding, report);
  }
  Hdf5Frame(const Hdf5Frame&) = delete;
  Hdf5Frame& operator=(const Hdf5Frame&) = delete;
  ~Hdf5Frame() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  void copy_to(core::RawFile& file) const {
    const core::RawFile frame(path_, core::RawFile::Mode::read);
    file.resize(frame.size());
    copy(frame, file, 0, places_.first_byte);
    copy(frame, file, places_.of(rows_), frame.size());
  }

 private:
  static void copy(const core::RawFile& from, core::RawFile& to, std::uint64_t begin, std::uint64_t end) {
    std::vector<std::byte> bytes;
    while (begin < end) {
      bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(end - begin, std::uint64_t{1} << 20U)));
      if (!from.read_at(begin, bytes)) throw std::runtime_error("cannot read " + from.path().string());
      to.write_at(begin, bytes);
      begin += bytes.size();
    }
  }

  std::filesystem::path path_;
  RowPlaces places_;
  std::size_t rows_;
};

double hdf5_bytes(const Product& product, const Encoding& encoding, bool) {
  const double samples = static_cast<double>(product.rows) * static_cast<double>(product.columns);
  return samples * 2.0 * static_cast<double>(array_component_bytes(encoding)) + hdf5_overhead_bytes(product);
}

std::unique_ptr<Sink> hdf5_sink(const std::filesystem::path& path, const Product& product, const Encoding& encoding,
                                bool replace) {
  return hdf5_module(path).make_sink(path, product, scene::option_words(product.options), encoding, replace);
}

RowPlaces hdf5_places(const std::filesystem::path& scratch, const Product& product, const Encoding& encoding) {
  return hdf5_module(scratch).row_places(free_name(scratch), product, scene::option_words(product.options), encoding);
}

void write_hdf5(core::RawFile& file, const std::filesystem::path& scratch, const Product& product,
                const Encoding& encoding, const RunReport& report) {
  const Hdf5Frame frame(scratch, product, encoding, report);
  frame.copy_to(file);
}

}  // namespace

OpenedRaster open_hdf5_file(core::InputFile file, const Format&, const RasterHints& hints, Integrity integrity,
                            const core::StopFlag* stop) {
  constexpr std::size_t longest_row = std::size_t{1} << 26;  // A whole row is read at a time: 1 GB.
  const std::filesystem::path path = file.path();
  RasterHints known = hints;
  if (integrity == Integrity::partial) known.rows = 0;
  OpenedRaster opened = hdf5_module(path).open(path, file.size(), known, stop);
  if (integrity == Integrity::partial && opened.raster && opened.raster->columns() > longest_row) {
    opened.problems.push_back(file_problem(path.string(), "the rows are too long to be shown",
                                           fmt::format("{} samples", opened.raster->columns()),
                                           fmt::format("at most {}", longest_row), "convert the file to NPY"));
    opened.raster.reset();
  }
  return opened;
}

StoredArrays arrays_of_hdf5(const core::InputFile& file, const RasterHints& hints) {
  return hdf5_module(file.path()).arrays(file.path(), file.size(), hints.dataset);
}

const FormatWriter hdf5_file_writer{.encode = encode_array,
                                    .component_bytes = array_component_bytes,
                                    .expected_bytes = hdf5_bytes,
                                    .make_sink = hdf5_sink,
                                    .row_places = hdf5_places,
                                    .write_frame = write_hdf5};

}  // namespace sarsim::raster
