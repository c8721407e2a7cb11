#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "raster/cphd/cphd_file.hpp"
#include "raster/format/format_reader.hpp"

namespace sarsim::raster {

namespace {

// What a file says of itself, in words.
RasterInfo info_of_cphd(const CphdFile& file, std::size_t channel) {
  const CphdDescription& d = file.description();
  const PhaseChannel& c = d.channels[channel];
  RasterInfo info;
  info.path = file.file().path();
  info.columns = c.samples;
  info.attributes = {
      {"version", d.version},
      {"collector", d.collector},
      {"core name", d.core_name},
      {"collection", d.bistatic ? "bistatic" : "monostatic"},
      {"mode", d.mode},
      {"classification", d.classification},
      {"start", d.start},
      {"domain", d.domain == PhaseDomain::fx ? "FX" : "TOA"},
      {"sign", d.sign < 0 ? "-1" : "+1"},
      {"encoding", std::string(entry_of(d.encoding).name)},
      {"channels", std::to_string(d.channels.size())},
      {"channel", c.id},
      {"polarisation", c.transmitted + c.received},
      {"reference point", c.srp_fixed ? "fixed" : "moving"},
      {"centre frequency", core::with_prefix(c.centre_hz, "Hz", 9)},
      {"bandwidth", core::with_prefix(c.band_hz, "Hz", 9)},
      {"swath", fmt::format("{} to {}", core::with_prefix(d.toa_min_s, "s"), core::with_prefix(d.toa_max_s, "s"))},
      {"image area", fmt::format("{:.6g} to {:.6g} m, {:.6g} to {:.6g} m", d.scene.area.x1, d.scene.area.x2,
                                 d.scene.area.y1, d.scene.area.y2)}};
  for (const auto& parameter : d.parameters) info.attributes.push_back(parameter);
  return info;
}

// The samples of the reference channel: a row for each vector.
class CphdRaster final : public Raster {
 public:
  CphdRaster(std::shared_ptr<const CphdFile> file, std::size_t channel)
      : Raster(info_of_cphd(*file, channel)), file_(std::move(file)), channel_(channel) {}

  [[nodiscard]] std::size_t rows() const override { return file_->description().channels[channel_].vectors; }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    return static_cast<double>(window.rows) * static_cast<double>(columns()) * 5e-9;
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    core::parallel_ranges(window.rows, 16, control, [&](std::size_t begin, std::size_t end) {
      std::vector<std::complex<float>> samples(columns());
      for (std::size_t row = begin; row < end; ++row) {
        PhaseVector vector;
        const std::size_t at = window.row(row);
        file_->read_vectors(channel_, at, std::span(&vector, 1));
        file_->read_samples(channel_, at, vector.amplitude, samples);
        for (std::size_t column = 0; column < window.cols; ++column)
          out[row * window.cols + column] = samples[window.column(column)];
      }
    });
  }

 private:
  std::shared_ptr<const CphdFile> file_;
  std::size_t channel_;
};

}  // namespace

OpenedRaster open_cphd(core::InputFile file, const Format&, const RasterHints&, Integrity, const core::StopFlag* stop) {
  OpenedRaster opened;
  const auto cphd = CphdFile::open(std::move(file), opened.problems, stop);
  if (cphd) opened.raster = std::make_shared<CphdRaster>(cphd, cphd->description().reference_channel);
  return opened;
}

}  // namespace sarsim::raster
