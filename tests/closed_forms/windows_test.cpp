// Window functions on the compression of a chirp of very large time-bandwidth product, whose spectrum is nearly
// rectangular: the textbook values of the weightings (Harris 1978).

#include <gtest/gtest.h>

#include <cstdio>

#include "support/response.hpp"

namespace sarsim {
namespace windows_test {

constexpr double bandwidth_hz = 50e6;

scene::Scene long_chirp(scene::Radar::Window window) {
  scene::Scene scene = test::radar_at_origin();
  scene::Radar& radar = scene.radars[0];
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = bandwidth_hz;
  radar.pulse_width_s = 20000.0 / bandwidth_hz;
  radar.window = window;
  radar.hanning_pedestal = 0.0;
  scene.simulations[0].sample_rate_hz = 32.0 * bandwidth_hz;
  return scene;
}

// The echo that arrives late by s overlaps the window less by s/Tp at one end, where Hamming has 0.08 of its middle: at
// the side lobe (s about 4.5/B) 0.08 4.5/20000/0.54 = 3e-5 of the peak, 0.04 dB of a lobe at -42.7 dB. Of the other two
// windows the ends count less.
struct Weighting {
  scene::Radar::Window window;
  double side_lobe_db;
  double width;  // times B
  double peak_loss_db;
};

TEST(Windows, HaveTheTextbooksSideLobesAndWidths) {
  for (const Weighting& w : {Weighting{scene::Radar::Window::rectangular, -13.26, 0.886, 0.0},
                             Weighting{scene::Radar::Window::hanning, -31.47, 1.441, 0.0},
                             Weighting{scene::Radar::Window::hamming, -42.68, 1.303, 0.0},
                             Weighting{scene::Radar::Window::bartlett, -26.52, 1.276, 0.0}}) {
    const test::Response r = test::point_response(long_chirp(w.window), 8 * 32);
    const double side_db = test::side_lobe_db(r);
    const double width = test::half_power_width_s(r) * bandwidth_hz;
    std::printf("window %d: side lobe %.2f dB, %.2f expected; width %.4f/B, %.3f expected; peak %.6f\n",
                static_cast<int>(w.window), side_db, w.side_lobe_db, width, w.width, r.amplitude[r.peak]);
    EXPECT_NEAR(side_db, w.side_lobe_db, 0.06) << static_cast<int>(w.window);
    EXPECT_NEAR(width, w.width, 0.001) << static_cast<int>(w.window);
    EXPECT_NEAR(r.amplitude[r.peak], 1.0, 1e-9) << static_cast<int>(w.window);
  }
}

}  // namespace windows_test
}  // namespace sarsim
