// Zarr stores: what their JSON says, and a small store that says so. The input is the text of a `.zarray` and, behind a
// byte 0, that of a `.zattrs`.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "raster/format/zarr_metadata.hpp"
#include "raster_probe.hpp"

namespace {

namespace fs = std::filesystem;

// A store with two chunks of 96 bytes, for as long as the process runs.
class Store {
 public:
  Store() {
    std::string name = (fs::temp_directory_path() / "sarsim-zarr-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::logic_error("cannot make a folder");
    folder_ = name;
    fs::create_directory(folder_ / "samples");
    put(".zgroup", R"({"zarr_format": 2})");
    for (const char* chunk : {"samples/0.0", "samples/1.0"}) put(chunk, std::string(96, '1'));
  }
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;
  ~Store() { fs::remove_all(folder_); }

  void put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Store store;
  const std::string all(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = std::min(all.find('\0'), all.size());
  const std::string array = all.substr(0, cut);
  const std::string attributes = cut < all.size() ? all.substr(cut + 1) : "{}";
  static_cast<void>(sarsim::raster::parse_zarr_attributes(attributes));
  // Most of what is no JSON ends here, without a file.
  if (std::holds_alternative<sarsim::core::Problem>(sarsim::raster::parse_zarr_array(array))) return 0;
  store.put("samples/.zarray", array);
  store.put(".zattrs", attributes);
  sarsim::raster::probe_raster_at(store.folder(), {});
  return 0;
}
