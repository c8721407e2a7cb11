// What the module shows to the program that loads it: one table, by the name that hdf5_module() looks for.

#include "raster/format/load_hdf5.hpp"
#include "raster/hdf5/hdf5_arrays.hpp"
#include "raster/hdf5/hdf5_points.hpp"
#include "raster/hdf5/hdf5_reader.hpp"
#include "raster/hdf5/hdf5_sink.hpp"

namespace sarsim::raster {

namespace {

std::unique_ptr<Sink> make_hdf5_sink(const std::filesystem::path& path, const Product& product,
                                     const FileAttributes& option_words, const Encoding& encoding, bool replace) {
  return std::make_unique<Hdf5Sink>(path, product, option_words, encoding, replace);
}

RowPlaces hdf5_row_places(const std::filesystem::path& scratch, const Product& product,
                          const FileAttributes& option_words, const Encoding& encoding) {
  const Hdf5Sink sink(scratch, product, option_words, encoding, true);
  return {sink.samples_offset(), 2 * product.columns * array_component_bytes(encoding)};
}

void write_hdf5_frame(const std::filesystem::path& path, const Product& product, const FileAttributes& option_words,
                      const Encoding& encoding, const RunReport& report) {
  Hdf5Sink sink(path, product, option_words, encoding, true);
  sink.append_axes(0, product.rows);
  sink.finish(report);
}

}  // namespace

}  // namespace sarsim::raster

extern "C" {
[[gnu::visibility("default")]] extern const sarsim::raster::Hdf5Module sarsim_hdf5_module;
const sarsim::raster::Hdf5Module sarsim_hdf5_module{sarsim::core::use_temporary_names, sarsim::raster::open_hdf5,
                                                    sarsim::raster::make_hdf5_sink,    sarsim::raster::hdf5_row_places,
                                                    sarsim::raster::write_hdf5_frame,  sarsim::raster::hdf5_arrays,
                                                    sarsim::raster::read_hdf5_points};
}
