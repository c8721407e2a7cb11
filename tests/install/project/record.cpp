// Simulates the first recording of a script in memory, prints a checksum of its samples, draws the magnitudes of its
// first pulse, and writes it as HDF5:
//
//   record SCRIPT FILE.h5 PICTURE

#include <complex>
#include <cstdint>
#include <cstring>
#include <exception>
#include <iostream>
#include <memory>
#include <vector>

#include "core/build/version.hpp"
#include "core/report/problem.hpp"
#include "picture/figure/figure_axes.hpp"
#include "picture/figure/picture_file.hpp"
#include "raster/format/sinks.hpp"
#include "scene/check/check.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/run/run.hpp"

namespace {

// FNV-1a over the samples as recordings in volts hold them: single precision, I before Q.
std::uint64_t checksum(const std::vector<std::complex<double>>& samples) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  const auto add = [&sum](double value) {
    const auto single = static_cast<float>(value);
    unsigned char bytes[sizeof single];
    std::memcpy(bytes, &single, sizeof single);
    for (const unsigned char byte : bytes) sum = (sum ^ byte) * 0x100000001b3U;
  };
  for (const std::complex<double>& sample : samples) add(sample.real()), add(sample.imag());
  return sum;
}

void draw(const sarsim::simulate::Recording& recording, std::size_t columns, const char* file) {
  std::vector<double> sample, magnitude_v;
  for (std::size_t i = 0; i < columns; ++i) {
    sample.push_back(static_cast<double>(i));
    magnitude_v.push_back(std::abs(recording.samples[i]));
  }
  sarsim::picture::Figure figure;
  sarsim::picture::FigureAxis across = sarsim::picture::axis_along("Sample", "", sample);
  figure.panels.push_back(
      sarsim::picture::curve_panel("First pulse", across, {"Magnitude", "V", 0.0, 1.0, {}}, sample, magnitude_v));
  sarsim::picture::write_picture(figure, file, {});
}

int record(const char* script, const char* file, const char* picture) {
  const sarsim::scene::ScriptReading reading = sarsim::scene::read_script_file(script);
  sarsim::core::Problems problems = reading.problems;
  if (!has_errors(problems)) problems = sarsim::scene::check(reading.scene);
  for (const sarsim::core::Problem& problem : problems) std::cerr << to_string(problem) << '\n';
  if (has_errors(problems)) return 2;

  const sarsim::simulate::Plan plan =
      sarsim::simulate::make_plan(reading.scene, 0, nullptr, sarsim::simulate::Engine::automatic);
  const sarsim::simulate::Recording recording = sarsim::simulate::record(plan);
  std::cout << "sarsim " << sarsim::core::program_version << '\n'
            << plan.acquisition.timing.rows << " x " << plan.acquisition.reception.columns << '\n'
            << std::hex << checksum(recording.samples) << '\n';
  draw(recording, plan.acquisition.reception.columns, picture);

  const sarsim::raster::Product product = product_of(plan, sarsim::scene::write_script(reading.scene));
  const std::unique_ptr<sarsim::raster::Sink> sink =
      sarsim::raster::make_sink(file, product, {sarsim::scene::FileFormat::hdf5});
  run(plan, plan.acquisition.simulation.lsb_v, *sink, {});
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  try {
    return record(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
