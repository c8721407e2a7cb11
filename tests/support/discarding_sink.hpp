#pragma once

#include "raster/table/sink.hpp"

namespace sarsim::test {

/// Takes every row and keeps none: to run a simulation for its report alone.
class DiscardingSink : public raster::Sink {
 public:
  [[nodiscard]] bool wants_counts() const override { return false; }
  [[nodiscard]] std::vector<std::byte> encode(const raster::Block& /*block*/) const override { return {}; }
  void append(std::span<const std::byte> /*bytes*/, std::size_t /*first_row*/, std::size_t rows) override {
    rows_ += rows;
  }
  void finish(const raster::RunReport& /*report*/) override { finished_ = true; }

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] bool finished() const { return finished_; }

 private:
  std::size_t rows_ = 0;
  bool finished_ = false;
};

}  // namespace sarsim::test
