#pragma once

namespace sarsim::simulate {

/// How echoes are summed: by one of the kernels of `row_kernels()`.
enum class Engine {
  automatic,
  reference,  ///< Plain double-precision sum (radar/echo/reference_kernel.hpp).
  direct,     ///< Sample by sample in SIMD (radar/echo/direct_kernel.hpp).
  spectral,   ///< Non-uniform Fourier transform (radar/echo/spectral_kernel.hpp).
};

}  // namespace sarsim::simulate
