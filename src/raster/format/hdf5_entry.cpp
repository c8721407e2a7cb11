// What the module shows to the program that loads it: one table, by the name that hdf5_module() looks for.

#include "raster/format/hdf5_reader.hpp"
#include "raster/format/hdf5_sink.hpp"
#include "raster/format/load_hdf5.hpp"

namespace sarsim {

namespace {

std::unique_ptr<Sink> make_hdf5_sink(const std::filesystem::path& path, const Product& product,
                                     const Encoding& encoding, bool replace) {
  return std::make_unique<Hdf5Sink>(path, product, encoding, replace);
}

RowPlaces hdf5_row_places(const std::filesystem::path& scratch, const Product& product, const Encoding& encoding) {
  const Hdf5Sink sink(scratch, product, encoding, true);
  return {sink.samples_offset(), 2 * product.columns * component_bytes(encoding)};
}

void write_hdf5_frame(const std::filesystem::path& path, const Product& product, const Encoding& encoding,
                      const RunReport& report) {
  Hdf5Sink sink(path, product, encoding, true);
  sink.append_axes(0, product.rows);
  sink.finish(report);
}

}  // namespace

}  // namespace sarsim

extern "C" {
[[gnu::visibility("default")]] extern const sarsim::Hdf5Module sarsim_hdf5_module;
const sarsim::Hdf5Module sarsim_hdf5_module{sarsim::open_hdf5, sarsim::make_hdf5_sink, sarsim::hdf5_row_places,
                                            sarsim::write_hdf5_frame};
}
