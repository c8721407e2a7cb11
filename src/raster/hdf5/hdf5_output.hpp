#pragma once

#include <hdf5.h>

#include <exception>

#include "core/os/output_file.hpp"
#include "raster/hdf5/hdf5_library.hpp"

namespace sarsim::raster {

/// Lets the HDF5 library write into an OutputFile: a virtual file driver that never shows the library a failure of
/// the disk. The library cannot recover from one: a file whose closing failed stays half open and is flushed again at
/// the end of the program. So the driver keeps the first exception, takes every later byte in silence, and `check`
/// throws it; the file is given up then, not completed.
class Hdf5Output {
 public:
  /// Begins an HDF5 file; keeps a reference to the file that its bytes go to.
  explicit Hdf5Output(core::OutputFile& file);
  Hdf5Output(const Hdf5Output&) = delete;
  Hdf5Output& operator=(const Hdf5Output&) = delete;
  ~Hdf5Output();

  /// A file access property list that leads to the driver, for the newest format that HDF5 1.8 reads.
  [[nodiscard]] Hdf5Handle access_properties();

  /// Throws what went wrong with the disk so far.
  void check() const {
    if (failure_) std::rethrow_exception(failure_);
  }

  /// For the driver: an action on the file whose exception is kept. Nothing happens after the first failure.
  template <class Action>
  void attempt(Action action) noexcept {
    if (failure_) return;
    try {
      action(file_);
    } catch (...) {
      failure_ = std::current_exception();
    }
  }

 private:
  core::OutputFile& file_;
  Hdf5Handle driver_;
  std::exception_ptr failure_;
};

}  // namespace sarsim::raster
