#pragma once

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "raster/cphd/cphd_description.hpp"
#include "raster/cphd/cphd_file.hpp"
#include "raster/cphd/cphd_writer.hpp"

/// Small files for tests of readers.
namespace sarsim::raster::cphd_test {

/// A file of this process, removed at the end.
struct CphdScratch {
  explicit CphdScratch(const std::string& name)
      : path(std::filesystem::temp_directory_path() / (name + std::to_string(::getpid()) + ".cphd")) {}
  ~CphdScratch() { std::filesystem::remove(path); }
  std::filesystem::path path;
};

/// A collection of `vectors` pulses on a straight line past a point at latitude 0, longitude 0.
inline CphdDescription small_description(std::size_t vectors, std::size_t samples, SignalEncoding encoding) {
  CphdDescription d;
  d.collector = "Radar <1>";
  d.core_name = "test";
  d.parameters = {{"Seed", "7"}};
  d.start = "2000-01-01T00:00:00Z";
  d.tx_time2_s = 1e-3 * static_cast<double>(vectors - 1);
  d.fx_min_hz = 9.9e9;
  d.fx_max_hz = 9.9e9 + 1e6 * static_cast<double>(samples - 1);
  d.toa_min_s = -3e-7;
  d.toa_max_s = 3e-7;
  d.scene = {.origin_m = {6378137.0, 0.0, 0.0},
             .x_axis = {0.0, 1.0, 0.0},
             .y_axis = {0.0, 0.0, 1.0},
             .area = {-50.5, -40.5, 50.5, 40.5},
             .x_step_m = 1.0,
             .y_step_m = 1.0};
  d.encoding = encoding;
  d.channels = {{.id = "1", .vectors = vectors, .samples = samples, .reference = vectors / 2}};
  d.channels.front().centre_hz = 0.5 * (d.fx_min_hz + d.fx_max_hz);
  d.channels.front().band_hz = d.fx_max_hz - d.fx_min_hz;
  d.channels.front().toa_s = 6e-7;
  d.centre_time_s = {0.5 * d.tx_time2_s, 0.0, 0.0};
  d.dwell_s = d.tx_time2_s;
  return d;
}

/// Vector number `i` of such a collection.
inline PhaseVector small_vector(const CphdDescription& d, std::size_t i) {
  const double time_s = 1e-3 * static_cast<double>(i);
  PhaseVector v;
  v.tx_time_s = time_s;
  v.tx_m = {6378137.0 + 5000.0, 100.0 * (time_s - 0.5 * d.tx_time2_s), 8000.0};
  v.tx_mps = v.rcv_mps = {0.0, 100.0, 0.0};
  // Far along the line the way is longer.
  const double delay_s = std::max(6.3e-5, 2.0 * core::norm(v.tx_m - d.scene.origin_m) / 299792458.0);
  v.rcv_time_s = time_s + delay_s;
  v.rcv_m = v.tx_m + delay_s * v.tx_mps;
  v.srp_m = d.scene.origin_m;
  v.fx1_hz = v.first = d.fx_min_hz;
  v.fx2_hz = d.fx_max_hz;
  v.step = 1e6;
  v.toa1_s = d.toa_min_s;
  v.toa2_s = d.toa_max_s;
  return v;
}

/// The samples of that vector: a target of amplitude 1 at the reference point, one of 0.5 beside it.
inline std::vector<std::complex<double>> small_samples(const CphdDescription& d, std::size_t i) {
  std::vector<std::complex<double>> samples(d.channels.front().samples);
  for (std::size_t k = 0; k < samples.size(); ++k)
    samples[k] = 1.0 + 0.5 * std::polar(1.0, 0.1 * static_cast<double>(k) + 0.3 * static_cast<double>(i));
  return samples;
}

/// Writes such a file.
inline void write_small(const std::filesystem::path& path, const CphdDescription& d) {
  CphdWriter writer(path, d, true);
  for (std::size_t i = 0; i < d.channels.front().vectors; ++i)
    writer.append(encode_vector(small_vector(d, i), small_samples(d, i), d.encoding));
  writer.finish();
}

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A file or its problems.
struct Opened {
  std::shared_ptr<const CphdFile> file;
  core::Problems problems;

  [[nodiscard]] std::string text() const {
    std::string all;
    for (const core::Problem& problem : problems) all += core::to_string(problem) + "\n";
    return all;
  }
};

inline Opened opened_of(const std::filesystem::path& path) {
  Opened opened;
  auto input = core::InputFile::open(path);
  opened.file = CphdFile::open(std::move(std::get<core::InputFile>(input)), opened.problems);
  return opened;
}

inline Opened opened_of(const std::string& bytes, const std::filesystem::path& path) {
  std::ofstream(path, std::ios::binary) << bytes;
  return opened_of(path);
}

/// The text with one piece in place of another, which must be there; blanks fill up what is shorter, so that nothing
/// behind it moves.
inline std::string with(std::string bytes, const std::string& old, std::string piece) {
  const std::size_t at = bytes.find(old);
  if (at == std::string::npos || piece.size() > old.size()) return {};
  piece.resize(old.size(), ' ');
  return bytes.replace(at, old.size(), piece);
}

}  // namespace sarsim::raster::cphd_test
