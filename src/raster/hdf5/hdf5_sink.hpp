#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "core/os/output_file.hpp"
#include "raster/format/encoder.hpp"
#include "raster/hdf5/hdf5_library.hpp"
#include "raster/hdf5/hdf5_output.hpp"
#include "raster/table/described_product.hpp"
#include "raster/table/row_order.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// Writes a product as HDF5 (docs/formats/samples.md): what `describe` says of it, and `/samples`, with scales that
/// name the dimensions. Contiguous datasets of known size; rows and their axes are written as they come. No time
/// stamps, and a fixed version of the format: the same input gives the same bytes.
class Hdf5Sink final : public Sink {
 public:
  /// Begins the file; an existing one is refused unless `replace`.
  /// @param option_words  of the product's options, each a root attribute
  Hdf5Sink(const std::filesystem::path& path, const Product& product, const FileAttributes& option_words,
           const Encoding& encoding, bool replace);
  ~Hdf5Sink() override;

  [[nodiscard]] bool wants_counts() const override { return encoding_.counts; }
  [[nodiscard]] std::vector<std::byte> encode(const Block& block) const override {
    return encode_array(encoding_, block);
  }
  void append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) override;
  /// Instead of `append`, for rows whose samples somebody else writes: only their axes.
  void append_axes(std::size_t first_row, std::size_t rows);
  void finish(const RunReport& report) override;

  /// Where the samples begin in the file.
  [[nodiscard]] std::uint64_t samples_offset() const;

 private:
  void expect(bool done) const;
  void create_file();
  void create_sample_type();
  void create_arrays();
  void write_columns();
  void write_row_axes(std::size_t end, std::size_t min_rows);

  std::size_t rows_;
  std::size_t columns_;
  DescribedProduct described_;
  Encoding encoding_;
  core::OutputFile file_;
  RowOrder order_;
  std::size_t axes_written_ = 0;  // Rows whose axes are in the file.
  Hdf5Output output_;
  Hdf5Handle hdf5_;
  Hdf5Handle sample_type_;
  Hdf5Handle samples_;
  std::vector<Hdf5Handle> arrays_;  // Of the description; those of words are closed already.
};

}  // namespace sarsim::raster
