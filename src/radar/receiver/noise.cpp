#include "radar/receiver/noise.hpp"

#include "core/report/expect.hpp"

namespace sarsim::radar {

void add_noise(std::span<std::complex<double>> row, double stddev_v, const core::RandomStream& stream,
               std::int64_t pulse, std::int64_t first_sample) {
  CORE_EXPECT(stddev_v >= 0.0);
  if (stddev_v == 0.0) return;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto [in_phase, quadrature] = stream.normals(pulse, first_sample + static_cast<std::int64_t>(i));
    row[i] += std::complex(stddev_v * in_phase, stddev_v * quadrature);
  }
}

}  // namespace sarsim::radar
