// What the module shows to the program that loads it: one table, by the name that hdf5_module() looks for.

#include "data/hdf5_reader.hpp"
#include "data/hdf5_sink.hpp"
#include "data/load_hdf5.hpp"

namespace sarsim {

namespace {

std::unique_ptr<Sink> make_hdf5_sink(const std::filesystem::path& path, const Product& product,
                                     const Encoding& encoding, bool replace) {
  return std::make_unique<Hdf5Sink>(path, product, encoding, replace);
}

}  // namespace

}  // namespace sarsim

extern "C" {
[[gnu::visibility("default")]] extern const sarsim::Hdf5Module sarsim_hdf5_module;
const sarsim::Hdf5Module sarsim_hdf5_module{sarsim::open_hdf5, sarsim::make_hdf5_sink};
}
