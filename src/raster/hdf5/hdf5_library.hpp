#pragma once

#include <hdf5.h>

#include <cstdlib>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

#include "core/os/isolated.hpp"
#include "core/report/problem.hpp"
#include "core/task/stop.hpp"

namespace sarsim::raster {

/// The lock that a thread holds while it is inside the HDF5 library. The library has one of its own, but a process
/// that forks while another thread is in there leaves that lock closed for ever in the child; so whoever forks holds
/// this one.
[[nodiscard]] inline std::mutex& hdf5_lock() {
  static std::mutex lock;
  return lock;
}

/// While it lives, no other thread is inside the HDF5 library and the library prints no errors; neither does it at the
/// end of the process. All calls into the library are made under one; they may be nested.
class Hdf5Use {
 public:
  Hdf5Use() {
    if (uses_++ == 0) hdf5_lock().lock();
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    be_silent();
    // At the end of the process the library closes what it still has open, and would say what it cannot close.
    static const int at_end = std::atexit(be_silent);
    static_cast<void>(at_end);
  }
  Hdf5Use(const Hdf5Use&) = delete;
  Hdf5Use& operator=(const Hdf5Use&) = delete;
  ~Hdf5Use() {
    H5Eset_auto2(H5E_DEFAULT, function_, data_);
    if (--uses_ == 0) hdf5_lock().unlock();
  }

 private:
  static void be_silent() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

  // Of this thread. A lock that counts by itself would not know its thread again in a child process.
  static inline thread_local unsigned uses_ = 0;
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// Owns one HDF5 identifier and closes it with its own function.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Handle() = default;
  /// Takes over an identifier of the library, which `closer` gives back; a negative one is none.
  Hdf5Handle(hid_t id, Close closer) : id_(id), close_(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() { close(); }

  [[nodiscard]] hid_t get() const { return id_; }
  [[nodiscard]] explicit operator bool() const { return id_ >= 0; }
  /// Closes now; false where the library reports a failure. The identifier is given up either way.
  bool close() {
    if (id_ < 0) return true;
    const Hdf5Use use;
    return close_(std::exchange(id_, -1)) >= 0;
  }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// What the library's last failure on this thread was about, from the innermost cause to the call:
/// "unable to open file: file signature not found". Empty where there was none.
[[nodiscard]] std::string hdf5_error_text();

/// Whether that failure was that of getting memory or another resource of the system.
[[nodiscard]] bool hdf5_lacked_memory();

/// Processor time in seconds that a trial of a file may take (core/os/trial.hpp).
inline constexpr unsigned hdf5_trial_s = 20;

/// Tries in a child process what is about to be done with a file in this one. Throws Interrupted where a stop is
/// requested meanwhile.
/// @param stop  null: cannot be stopped
[[nodiscard]] core::IsolatedReport hdf5_trial(const std::function<std::string()>& work, const core::StopFlag* stop);

/// The error for a file whose trial takes more; the file may be sound.
[[nodiscard]] core::Problem too_much_hdf5_work();

}  // namespace sarsim::raster
