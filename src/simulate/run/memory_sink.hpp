#pragma once

#include <complex>
#include <cstring>
#include <vector>

#include "raster/table/sink.hpp"

namespace sarsim::simulate {

/// A recording in memory: rows one after the other, in volts.
struct Recording {
  std::vector<std::complex<double>> samples;
  raster::RunReport report;
};

/// Collects a recording in memory: for programs that go on computing with it, and for tests.
class MemorySink : public raster::Sink {
 public:
  /// Keeps a reference.
  explicit MemorySink(Recording& recording) : recording_(&recording) {}

  [[nodiscard]] bool wants_counts() const override { return false; }
  [[nodiscard]] std::vector<std::byte> encode(const raster::Block& block) const override {
    const auto bytes = std::as_bytes(block.volts);
    return {bytes.begin(), bytes.end()};
  }
  void append(std::span<const std::byte> bytes, std::size_t /*first_row*/, std::size_t /*rows*/) override {
    auto& samples = recording_->samples;
    const std::size_t old = samples.size();
    samples.resize(old + bytes.size() / sizeof(std::complex<double>));
    if (!bytes.empty()) std::memcpy(samples.data() + old, bytes.data(), bytes.size());
  }
  void finish(const raster::RunReport& report) override { recording_->report = report; }

 private:
  Recording* recording_;
};

}  // namespace sarsim::simulate
