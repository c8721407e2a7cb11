// Metadata of SigMF recordings, beside samples of 96 bytes.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "raster_probe.hpp"

namespace {

namespace fs = std::filesystem;

// A recording, for as long as the process runs.
class Files {
 public:
  Files() {
    std::string name = (fs::temp_directory_path() / "sarsim-sigmf-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::logic_error("cannot make a folder");
    folder_ = name;
    put("a.sigmf-data", std::string(96, '1'));
  }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  ~Files() { fs::remove_all(folder_); }

  void put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] fs::path meta() const { return folder_ / "a.sigmf-meta"; }

 private:
  fs::path folder_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;  // An empty file is refused before it is read.
  static const Files files;
  files.put("a.sigmf-meta", {reinterpret_cast<const char*>(data), size});
  sarsim::raster::probe_raster_at(files.meta(), {});
  return 0;
}
