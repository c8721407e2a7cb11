#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "raster/format/open_raster.hpp"

namespace sarsim::raster {

/// A file without a name that holds some bytes.
class MemoryFile {
 public:
  /// A file that holds a copy of `size` bytes.
  MemoryFile(const std::uint8_t* data, std::size_t size) : descriptor_(::memfd_create("samples", MFD_CLOEXEC)) {
    if (descriptor_ < 0 || ::write(descriptor_, data, size) != static_cast<ssize_t>(size))
      throw std::logic_error("cannot make a file in memory");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(descriptor_); }
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

/// For fuzz targets: opens a file of samples and reads what it claims to hold: its rows in parts, its last row again,
/// its axes. Throws std::logic_error where a promise of Raster is broken; a reading that fails (std::runtime_error) is
/// an answer like any other.
inline void probe_raster_at(const std::filesystem::path& path, const RasterHints& hints) {
  constexpr std::size_t max_samples = std::size_t{1} << 20;  // Enough of a file that claims more, for speed.
  const auto opened = open_raster(Integrity::whole, path, hints);
  if ((opened.raster != nullptr) == core::has_errors(opened.problems))
    throw std::logic_error("a file without errors or errors without a file are promised");
  if (!opened.raster) return;
  const Raster& raster = *opened.raster;
  if (raster.rows() == 0 || raster.columns() == 0) throw std::logic_error("an empty file was opened");
  try {
    const std::size_t part = max_samples / raster.columns();
    if (part == 0) return;
    std::vector<std::complex<double>> samples(std::min(part, raster.rows()) * raster.columns());
    raster.read_rows(0, std::min(part, raster.rows()), samples);
    raster.read_rows(raster.rows() - 1, 1, std::span(samples).first(raster.columns()));
    const auto axes = raster.axes();
    if (axes && (axes->row_time_s.size() != raster.rows() || axes->column_range_m.size() != raster.columns()))
      throw std::logic_error("axes of the wrong length");
  } catch (const std::runtime_error&) {
    return;
  }
}

/// The same of bytes as a file.
inline void probe_raster(const std::uint8_t* data, std::size_t size, const RasterHints& hints) {
  const MemoryFile memory(data, size);
  probe_raster_at(memory.path(), hints);
}

}  // namespace sarsim::raster
