#pragma once

#include <string>

namespace sarsim::core {

/// Version of the FFTW library that this process runs with, such as "3.3.10".
[[nodiscard]] std::string fft_library_version();

}  // namespace sarsim::core
