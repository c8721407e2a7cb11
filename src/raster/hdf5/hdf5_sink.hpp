#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "core/os/output_file.hpp"
#include "raster/format/encoder.hpp"
#include "raster/hdf5/hdf5_library.hpp"
#include "raster/hdf5/hdf5_output.hpp"
#include "raster/table/product_attributes.hpp"
#include "raster/table/row_order.hpp"
#include "simulate/plan/sink.hpp"

namespace sarsim::raster {

class Hdf5Scales;

/// Writes a recording as HDF5 (docs/formats/samples.md): root attributes, `/samples`, `/pulse_time_s`, `/carrier_hz`,
/// `/slant_range_m` and the poses of the radar's platform, but for what is not known, with scales that name their
/// dimensions. Contiguous datasets of known
/// size; rows and their axes are written as they come. No time stamps, and a fixed version of the format: the same
/// input gives the same bytes.
class Hdf5Sink final : public simulate::Sink {
 public:
  /// Begins the file; an existing one is refused unless `replace`.
  /// @param option_words  of the product's options, each a root attribute
  Hdf5Sink(const std::filesystem::path& path, const simulate::Product& product, FileAttributes option_words,
           const Encoding& encoding, bool replace);
  ~Hdf5Sink() override;

  [[nodiscard]] bool wants_counts() const override { return encoding_.counts; }
  [[nodiscard]] std::vector<std::byte> encode(const simulate::Block& block) const override {
    return encode_array(encoding_, block);
  }
  void append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) override;
  /// Instead of `append`, for rows whose samples somebody else writes: only their axes.
  void append_axes(std::size_t first_row, std::size_t rows);
  void finish(const simulate::RunReport& report) override;

  /// Where the samples begin in the file.
  [[nodiscard]] std::uint64_t samples_offset() const;

 private:
  void expect(bool done) const;
  void create_file();
  void create_sample_type();
  void create_datasets();
  void create_axis(const std::string& name, const std::function<double(std::size_t)>& axis,
                   std::span<const hsize_t> size, Hdf5Handle& dataset);
  [[nodiscard]] std::string add_scale(Hdf5Scales& scales, const Hdf5Handle& axis, const std::string& name,
                                      const std::string& word, std::size_t length) const;
  void create_map();
  void create_poses(Hdf5Scales& scales, const std::string& rows);
  void write_attributes();
  void write_column_axis();
  void write_row_axes(std::size_t end, std::size_t least_rows);

  simulate::Product product_;
  FileAttributes option_words_;
  Encoding encoding_;
  core::OutputFile file_;
  RowOrder order_;
  std::size_t axes_written_ = 0;  // Rows whose axes are in the file.
  Hdf5Output output_;
  Hdf5Handle hdf5_;
  Hdf5Handle sample_type_;
  Hdf5Handle samples_;
  Hdf5Handle pulse_time_;
  Hdf5Handle carrier_;
  std::array<Hdf5Handle, 3> pose_;  // Position, velocity, rotation.
  Hdf5Handle slant_range_;          // Of images the axis of their columns.
  Hdf5Handle image_rows_;
};

}  // namespace sarsim::raster
