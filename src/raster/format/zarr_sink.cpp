#include <memory>
#include <system_error>

#include "core/os/output_folder.hpp"
#include "raster/format/format_writer.hpp"
#include "raster/format/zarr_store.hpp"
#include "raster/table/placed_rows.hpp"
#include "raster/table/row_order.hpp"

namespace sarsim::raster {

namespace {

// Writes a product as a store of Zarr.
class ZarrSink final : public Sink {
 public:
  ZarrSink(const std::filesystem::path& path, const Product& product, const Encoding& encoding, bool replace)
      : path_(path),
        product_(product),
        encoding_(encoding),
        folder_(path, replace, is_own_zarr_store),
        places_(zarr_places(product, encoding)),
        rows_(folder_.working_path(), places_, core::RawFile::Mode::write),
        order_(product.rows) {}

  [[nodiscard]] bool wants_counts() const override { return encoding_.counts; }
  [[nodiscard]] std::vector<std::byte> encode(const Block& block) const override {
    return encode_array(encoding_, block);
  }
  void append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) override {
    order_.expect(first_row, rows);
    by_its_name([&] { rows_.write_at(places_.of(first_row), bytes); });
    order_.take(rows);
  }
  void finish(const RunReport& report) override {
    order_.expect_all();
    by_its_name([&] { complete_zarr(folder_.working_path(), product_, encoding_, report); });
    folder_.commit();
  }

 private:
  // Failures tell the name of the output, not of one of its files on their way.
  template <class Action>
  void by_its_name(const Action& action) const {
    try {
      action();
    } catch (const std::system_error& error) {
      throw std::system_error(error.code(), "cannot write " + path_.string());
    }
  }

  std::filesystem::path path_;
  Product product_;
  Encoding encoding_;
  core::OutputFolder folder_;
  RowPlaces places_;
  PlacedRows rows_;
  RowOrder order_;
};

// About: JSON of ten arrays, and the axes.
double zarr_bytes(const Product& product, const Encoding& encoding, bool) {
  constexpr double text = 8200.0;
  constexpr double pose = 72.0;
  const auto rows = static_cast<double>(product.rows);
  const auto columns = static_cast<double>(product.columns);
  return rows * columns * 2.0 * static_cast<double>(array_component_bytes(encoding)) + text +
         2.0 * static_cast<double>(product.script.size()) + 16.0 * rows + 8.0 * columns +
         (product.row_pose ? pose * rows : 0.0);
}

std::unique_ptr<Sink> zarr_sink(const std::filesystem::path& path, const Product& product, const Encoding& encoding,
                                bool replace) {
  return std::make_unique<ZarrSink>(path, product, encoding, replace);
}

RowPlaces places_in_zarr(const std::filesystem::path&, const Product& product, const Encoding& encoding) {
  return zarr_places(product, encoding);
}

}  // namespace

const FormatWriter zarr_writer{.encode = encode_array,
                               .component_bytes = array_component_bytes,
                               .expected_bytes = zarr_bytes,
                               .make_sink = zarr_sink,
                               .row_places = places_in_zarr,
                               .complete_folder = complete_zarr};

}  // namespace sarsim::raster
