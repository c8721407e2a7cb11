#include "core/maths/fft_library.hpp"

#include <string_view>

#include <fftw3.h>

namespace sarsim::core {

std::string fft_library_version() {
  // "fftw-3.3.10-sse2-avx": the name, the version, what it was compiled for.
  std::string_view words(fftw_version);
  words.remove_prefix(words.starts_with("fftw-") ? 5 : 0);
  return std::string(words.substr(0, words.find('-')));
}

}  // namespace sarsim::core
