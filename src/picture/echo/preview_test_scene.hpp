#pragma once

#include <complex>
#include <functional>
#include <memory>
#include <utility>

#include "picture/echo/echo_matrix.hpp"
#include "picture/echo/echo_window.hpp"
#include "scene/model/scene.hpp"
#include "simulate/plan/flight_test_scene.hpp"
#include "simulate/plan/plan.hpp"

/// Scenes that the tests of simulation windows share.
namespace sarsim::picture {

/// A window over all targets of `flight_scene` and 200 pulses.
inline EchoWindow flight_window(scene::Processing processing = scene::Processing::raw) {
  EchoWindow window = new_echo_window("Radar1", processing);
  set_view(window, {2100.0, 2700.0, -0.1, 0.1});
  window.sampling = {Sampling::Kind::rate, 60e6, 1.0};
  return window;
}

/// A matrix of a window with given samples, of row and column of the matrix; all rows are ready.
inline std::shared_ptr<EchoMatrix> filled_matrix(
    const EchoWindow& window, const PlotSize& size,
    const std::function<std::complex<double>(std::size_t, std::size_t)>& sample) {
  scene::Scene scene = simulate::flight_scene();
  scene.simulations = {simulation_of(window, 20e6)};
  auto matrix =
      std::make_shared<EchoMatrix>(std::make_shared<const simulate::Plan>(simulate::make_plan(scene, 0)), window, size);
  for (std::size_t r = 0; r < matrix->rows(); ++r) {
    for (std::size_t k = 0; k < matrix->columns(); ++k) matrix->samples()[r * matrix->columns() + k] = sample(r, k);
    matrix->set_ready(r);
  }
  return matrix;
}

}  // namespace sarsim::picture
