#include "raster/format/sinks.hpp"

#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "raster/format/format_writer.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/row_order.hpp"

namespace sarsim::raster {

namespace {

Encoding encoding_of(const Product& product, const SinkOptions& options) {
  if (product.bits < 1 || product.bits > 64)
    throw std::invalid_argument(fmt::format("{} A/D bits are outside 1 to 64", product.bits));
  return {options.format, holds_counts(options.format, options.counts), product.bits,
          product.options.profile == scene::Profile::classic, options.doubles};
}

const FormatWriter& writer_of(const Encoding& encoding) { return *format_of(encoding.format).writer; }

// What stands before the first row.
std::string preamble(const Product& product, const Encoding& encoding, bool header) {
  const auto make = writer_of(encoding).preamble;
  return make == nullptr ? std::string() : make(product, encoding, header);
}

// The formats whose files are their rows one after the other.
class StreamSink final : public Sink {
 public:
  StreamSink(const std::filesystem::path& path, const Product& product, const SinkOptions& options)
      : encoding_(encoding_of(product, options)), file_(path, options.replace), order_(product.rows) {
    const std::string begin = preamble(product, encoding_, options.header);
    file_.write(std::as_bytes(std::span(begin)));
  }

  [[nodiscard]] bool wants_counts() const override { return encoding_.counts; }
  [[nodiscard]] std::vector<std::byte> encode(const Block& block) const override {
    return encode_rows(encoding_, block);
  }
  void append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) override {
    order_.expect(first_row, rows);
    file_.write(bytes);
    order_.take(rows);
  }
  void finish(const RunReport&) override {
    order_.expect_all();
    file_.commit();
  }

 private:
  Encoding encoding_;
  core::OutputFile file_;
  RowOrder order_;
};

class DiscardingSink final : public Sink {
 public:
  DiscardingSink(const Product& product, const SinkOptions& options)
      : encoding_(encoding_of(product, options)), order_(product.rows) {}

  [[nodiscard]] bool wants_counts() const override { return encoding_.counts; }
  [[nodiscard]] std::vector<std::byte> encode(const Block& block) const override {
    return encode_rows(encoding_, block);
  }
  void append(std::span<const std::byte>, std::size_t first_row, std::size_t rows) override {
    order_.expect(first_row, rows);
    order_.take(rows);
  }
  void finish(const RunReport&) override { order_.expect_all(); }

 private:
  Encoding encoding_;
  RowOrder order_;
};

// Of a file, or of all files in a folder.
std::uint64_t bytes_under(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code failure;
  if (!fs::is_directory(path, failure)) {
    const std::uint64_t bytes = fs::file_size(path, failure);
    return failure ? 0 : bytes;
  }
  std::uint64_t bytes = 0;
  for (fs::recursive_directory_iterator entry(path, failure), end; !failure && entry != end; entry.increment(failure))
    if (std::error_code gone; entry->is_regular_file(gone)) bytes += entry->file_size(gone);
  return bytes;
}

}  // namespace

std::unique_ptr<Sink> make_sink(const std::filesystem::path& path, const Product& product, const SinkOptions& options) {
  const Encoding encoding = encoding_of(product, options);
  const auto make = writer_of(encoding).make_sink;
  if (make != nullptr) return make(path, product, encoding, options.replace);
  return std::make_unique<StreamSink>(path, product, options);
}

double expected_bytes(const Product& product, const SinkOptions& options) {
  const Encoding encoding = encoding_of(product, options);
  return writer_of(encoding).expected_bytes(product, encoding, options.header);
}

std::unique_ptr<Sink> make_discarding_sink(const Product& product, const SinkOptions& options) {
  return std::make_unique<DiscardingSink>(product, options);
}

std::optional<RowPlaces> row_places(const std::filesystem::path& scratch, const Product& product,
                                    const SinkOptions& options) {
  const Encoding encoding = encoding_of(product, options);
  const auto find = writer_of(encoding).row_places;
  if (find != nullptr) return find(scratch, product, encoding);
  const std::size_t component = component_bytes(encoding);
  if (component == 0) return std::nullopt;
  return RowPlaces{preamble(product, encoding, options.header).size(), 2 * product.columns * component};
}

std::size_t piece_rows(const Product& product, const SinkOptions& options) {
  return format_of(options.format).folder ? row_places({}, product, options).value().piece_rows() : 1;
}

void write_frame(core::RawFile& file, const std::filesystem::path& scratch, const Product& product,
                 const SinkOptions& options, const RunReport& report) {
  const Encoding encoding = encoding_of(product, options);
  const auto write = writer_of(encoding).write_frame;
  if (write != nullptr) return write(file, scratch, product, encoding, report);
  const std::string begin = preamble(product, encoding, options.header);
  file.write_at(0, std::as_bytes(std::span(begin)));
  file.resize(row_places(scratch, product, options).value().of(product.rows));
}

void complete_folder(const std::filesystem::path& folder, const Product& product, const SinkOptions& options,
                     const RunReport& report) {
  const Encoding encoding = encoding_of(product, options);
  writer_of(encoding).complete_folder(folder, product, encoding, report);
}

std::uint64_t stored_bytes(const std::filesystem::path& path) {
  std::uint64_t bytes = 0;
  for (const std::filesystem::path& file : files_of(row_from_path(path), path)) bytes += bytes_under(file);
  return bytes;
}

}  // namespace sarsim::raster
