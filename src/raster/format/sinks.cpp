#include "raster/format/sinks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "raster/format/encoder.hpp"
#include "raster/format/load_hdf5.hpp"
#include "raster/format/npy_header.hpp"
#include "raster/table/count_range.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/row_order.hpp"

namespace sarsim::raster {

namespace {

Encoding encoding_of(const simulate::Product& product, const SinkOptions& options) {
  if (product.bits < 1 || product.bits > 64)
    throw std::invalid_argument(fmt::format("{} A/D bits are outside 1 to 64", product.bits));
  const bool either = options.format == scene::FileFormat::hdf5 || options.format == scene::FileFormat::npy;
  return {options.format, options.counts || !either, product.bits, product.options.profile == scene::Profile::classic};
}

std::string npy_header_of(const simulate::Product& product, const Encoding& encoding) {
  const std::array<std::size_t, 3> shape{product.rows, product.columns, 2};
  if (!encoding.counts) return npy_header_text("<c8", std::span(shape).first(2));
  return npy_header_text(component_bytes(encoding) == 8 ? "<i8" : "<i4", shape);
}

// What stands before the first row.
std::string preamble(const simulate::Product& product, const Encoding& encoding, bool header) {
  if (encoding.format == scene::FileFormat::npy) return npy_header_of(product, encoding);
  if (encoding.format == scene::FileFormat::csv && header) return csv_header(product.columns);
  return {};
}

// The formats whose files are their rows one after the other.
class StreamSink final : public simulate::Sink {
 public:
  StreamSink(const std::filesystem::path& path, const simulate::Product& product, const SinkOptions& options)
      : encoding_(encoding_of(product, options)), file_(path, options.replace), order_(product.rows) {
    const std::string begin = preamble(product, encoding_, options.header);
    file_.write(std::as_bytes(std::span(begin)));
  }

  [[nodiscard]] bool wants_counts() const override { return encoding_.counts; }
  [[nodiscard]] std::vector<std::byte> encode(const simulate::Block& block) const override {
    return encode_rows(encoding_, block);
  }
  void append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) override {
    order_.expect(first_row, rows);
    file_.write(bytes);
    order_.take(rows);
  }
  void finish(const simulate::RunReport&) override {
    order_.expect_all();
    file_.commit();
  }

 private:
  Encoding encoding_;
  core::OutputFile file_;
  RowOrder order_;
};

class DiscardingSink final : public simulate::Sink {
 public:
  DiscardingSink(const simulate::Product& product, const SinkOptions& options)
      : encoding_(encoding_of(product, options)), order_(product.rows) {}

  [[nodiscard]] bool wants_counts() const override { return encoding_.counts; }
  [[nodiscard]] std::vector<std::byte> encode(const simulate::Block& block) const override {
    return encode_rows(encoding_, block);
  }
  void append(std::span<const std::byte>, std::size_t first_row, std::size_t rows) override {
    order_.expect(first_row, rows);
    order_.take(rows);
  }
  void finish(const simulate::RunReport&) override { order_.expect_all(); }

 private:
  Encoding encoding_;
  RowOrder order_;
};

// Mean number of digits of the whole numbers 0 to `highest`.
double mean_digits(double highest) {
  double digits = 1.0;
  for (double power = 10.0; power <= highest; power *= 10.0) digits += (highest + 1.0 - power) / (highest + 1.0);
  return digits;
}

double expected_text_bytes(const simulate::Product& product, const Encoding& encoding) {
  const double samples = static_cast<double>(product.rows) * static_cast<double>(product.columns);
  const double rows = static_cast<double>(product.rows);
  const double offset = static_cast<double>(CountRange{encoding.bits}.offset());
  const double with_sign = mean_digits(offset + 1.0) + offset / (2.0 * offset + 2.0);
  switch (encoding.format) {
    case scene::FileFormat::ascii: return samples * (2.0 * with_sign + 2.0) + rows;
    case scene::FileFormat::bracket: return samples * (2.0 * with_sign + 4.0) + rows;
    default: return samples * (2.0 * mean_digits(2.0 * offset + 1.0) + 2.0);
  }
}

// About how many bytes an HDF5 file needs beside the samples.
double hdf5_overhead_bytes(const simulate::Product& product) {
  constexpr double structure = 8150.0;  // Superblock, object headers, the heap that holds the texts.
  return structure + static_cast<double>(product.script.size()) + 16.0 * static_cast<double>(product.rows) +
         8.0 * static_cast<double>(product.columns);
}

// A whole HDF5 file but for its samples, for as long as it is needed.
class Hdf5Frame {
 public:
  Hdf5Frame(const std::filesystem::path& path, const simulate::Product& product, const Encoding& encoding,
            const simulate::RunReport& report)
      : path_(path), places_(hdf5_module(path).row_places(path, product, encoding)), rows_(product.rows) {
    hdf5_module(path).write_frame(path, product, encoding, report);
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

}  // namespace

std::unique_ptr<simulate::Sink> make_sink(const std::filesystem::path& path, const simulate::Product& product,
                                          const SinkOptions& options) {
  if (options.format == scene::FileFormat::hdf5)
    return hdf5_module(path).make_sink(path, product, encoding_of(product, options), options.replace);
  return std::make_unique<StreamSink>(path, product, options);
}

double expected_bytes(const simulate::Product& product, const SinkOptions& options) {
  const Encoding encoding = encoding_of(product, options);
  const double rows = static_cast<double>(product.rows);
  const double columns = static_cast<double>(product.columns);
  const double data = rows * columns * 2.0 * static_cast<double>(component_bytes(encoding));
  switch (encoding.format) {
    case scene::FileFormat::binary: return data;
    case scene::FileFormat::npy: return data + static_cast<double>(npy_header_of(product, encoding).size());
    case scene::FileFormat::hdf5: return data + hdf5_overhead_bytes(product);
    default: break;
  }
  const double header = encoding.format == scene::FileFormat::csv && options.header
                            ? columns * (2.0 * mean_digits(columns - 1.0) + 4.0)
                            : 0.0;
  return expected_text_bytes(product, encoding) + header;
}

std::unique_ptr<simulate::Sink> make_discarding_sink(const simulate::Product& product, const SinkOptions& options) {
  return std::make_unique<DiscardingSink>(product, options);
}

std::optional<RowPlaces> row_places(const std::filesystem::path& scratch, const simulate::Product& product,
                                    const SinkOptions& options) {
  const Encoding encoding = encoding_of(product, options);
  if (options.format == scene::FileFormat::hdf5) return hdf5_module(scratch).row_places(scratch, product, encoding);
  const std::size_t component = component_bytes(encoding);
  if (component == 0) return std::nullopt;
  return RowPlaces{preamble(product, encoding, options.header).size(), 2 * product.columns * component};
}

void write_frame(core::RawFile& file, const std::filesystem::path& scratch, const simulate::Product& product,
                 const SinkOptions& options, const simulate::RunReport& report) {
  const Encoding encoding = encoding_of(product, options);
  if (options.format != scene::FileFormat::hdf5) {
    const std::string begin = preamble(product, encoding, options.header);
    file.write_at(0, std::as_bytes(std::span(begin)));
    file.resize(row_places(scratch, product, options).value().of(product.rows));
    return;
  }
  const Hdf5Frame frame(scratch, product, encoding, report);
  frame.copy_to(file);
}

}  // namespace sarsim::raster
