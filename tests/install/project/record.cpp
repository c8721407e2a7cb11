// Simulates the first recording of a script in memory, prints a checksum of its samples, and writes it as HDF5:
//
//   record SCRIPT FILE.h5

#include <complex>
#include <cstdint>
#include <cstring>
#include <exception>
#include <iostream>
#include <memory>
#include <vector>

#include "core/build/version.hpp"
#include "core/report/problem.hpp"
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

int record(const char* script, const char* file) {
  const sarsim::ScriptReading reading = sarsim::read_script_file(script);
  sarsim::Problems problems = reading.problems;
  if (!has_errors(problems)) problems = sarsim::check(reading.scene);
  for (const sarsim::Problem& problem : problems) std::cerr << to_string(problem) << '\n';
  if (has_errors(problems)) return 2;

  const sarsim::Plan plan = sarsim::make_plan(reading.scene, 0, nullptr, sarsim::Engine::automatic);
  const sarsim::Recording recording = sarsim::record(plan);
  std::cout << "sarsim " << sarsim::program_version << '\n'
            << plan.rows << " x " << plan.columns << '\n'
            << std::hex << checksum(recording.samples) << '\n';

  const sarsim::Product product = product_of(plan, sarsim::write_script(reading.scene));
  const std::unique_ptr<sarsim::Sink> sink = make_sink(file, product, {sarsim::FileFormat::hdf5});
  run(plan, plan.simulation.lsb_v, *sink, {});
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    return record(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
