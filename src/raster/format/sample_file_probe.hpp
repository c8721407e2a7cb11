#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "raster/format/sample_file.hpp"

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

/// For fuzz targets: opens bytes as a file of samples and reads what it claims to hold: its rows in parts, its last row
/// again, its axes. Throws std::logic_error where a promise of SampleFile is broken; a reading that fails
/// (std::runtime_error) is an answer like any other.
inline void probe_sample_file(const std::uint8_t* data, std::size_t size, const SampleFileHints& hints) {
  constexpr std::size_t most_samples = std::size_t{1} << 20;  // Enough of a file that claims more, for speed.
  const MemoryFile memory(data, size);
  const auto opened = SampleFile::open(memory.path(), hints);
  if (opened.file.has_value() == core::has_errors(opened.problems))
    throw std::logic_error("a file without errors or errors without a file are promised");
  if (!opened.file) return;
  const SampleFileInfo& info = opened.file->info();
  if (info.rows == 0 || info.columns == 0) throw std::logic_error("an empty file was opened");
  try {
    const std::size_t part = most_samples / info.columns;
    if (part == 0) return;
    std::vector<std::complex<double>> samples(std::min(part, info.rows) * info.columns);
    opened.file->read_rows(0, std::min(part, info.rows), samples);
    opened.file->read_rows(info.rows - 1, 1, std::span(samples).first(info.columns));
    const auto axes = opened.file->axes();
    if (axes && (axes->row_time_s.size() != info.rows || axes->column_range_m.size() != info.columns))
      throw std::logic_error("axes of the wrong length");
  } catch (const std::runtime_error&) {
    return;
  }
}

}  // namespace sarsim::raster
