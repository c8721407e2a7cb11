#include "workflow/search/doppler.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "workflow/image/image_writer.hpp"
#include "workflow/search/pulse_pipeline.hpp"

namespace sarsim::workflow {

namespace {

// Middle of an interval's first and last pulse.
double middle_of_interval_s(const radar::Repetition& repetition, std::int64_t first_pulse, std::int64_t last_pulse) {
  return 0.5 * (repetition.send_time_s(first_pulse) + repetition.send_time_s(last_pulse));
}

// The image holds the maps of all intervals, one below the other.
class DopplerImage {
 public:
  DopplerImage(PulsePipeline& work, bool replace) : work_(work), replace_(replace) {}

  // Finds what stands in an image's header: the axes of a map.
  [[nodiscard]] DopplerReport axes() const {
    const std::vector<double>& range_m = work_.rows().range_m;
    const std::size_t rows_below_0 = work_.options().rows() / 2;
    DopplerReport report;
    report.rows = work_.options().rows();
    report.columns = range_m.size();
    report.doppler_step_hz = prf_hz() / static_cast<double>(report.rows);
    report.doppler_first_hz = -static_cast<double>(rows_below_0) * report.doppler_step_hz;
    report.speed_first_mps = speed_of(report.doppler_first_hz);
    report.speed_step_mps = speed_of(report.doppler_step_hz);
    report.range_first_m = range_m.front();
    report.range_last_m = range_m.back();
    report.range_step_m = range_m.size() > 1 ? range_m[1] - range_m[0] : 0.0;
    return report;
  }

  void begin() {
    if (work_.keeps_image())
      writer_.emplace(content());
    else
      writer_.emplace(work_.output(), content(), replace_, largest());
  }

  void append(const SearchInterval& interval) {
    if (!writer_) return;
    const std::span<const std::complex<float>> values = interval.map.values;
    for (std::size_t row = 0; row < interval.map.frequencies; ++row)
      writer_->append(values.subspan(row * interval.map.samples, interval.map.samples));
  }

  /// Returns the maps where they are kept.
  std::optional<InMemoryImage> finish() {
    if (!writer_) return std::nullopt;
    writer_->finish();
    if (!work_.keeps_image()) return std::nullopt;
    InMemoryImage kept = std::move(*writer_).kept();
    kept.largest_if_needed = true;
    return kept;
  }

 private:
  [[nodiscard]] double prf_hz() const { return 1.0 / work_.acquisition().link.repetition.mean_interval_s(); }
  [[nodiscard]] double carrier_hz() const {
    return work_.acquisition().link.carrier.carrier_hz(work_.acquisition().timing.pulses.first);
  }
  [[nodiscard]] double speed_of(double doppler_hz) const {
    return receding_speed_mps(work_.acquisition(), work_.acquisition().timing.pulses.first, doppler_hz);
  }

  // Counts have an LSB that the whole image decides: its maps are made twice.
  double largest() {
    float largest = 0.0F;
    if (needs_largest(work_.output()))
      work_.look_through(work_.output().string() + " (finding the largest magnitude)",
                         [&](const SearchInterval& interval) {
                           for (const auto& value : interval.map.values) largest = std::max(largest, std::abs(value));
                         });
    return static_cast<double>(largest);
  }

  [[nodiscard]] raster::Product product() const {
    const SearchOptions& options = work_.options();
    const DopplerReport axes = this->axes();
    raster::Product product;
    product.radar = work_.acquisition().link.name;
    product.row_time_s = [repetition = work_.acquisition().link.repetition, frequencies = options.rows(),
                          first = work_.acquisition().timing.pulses.first, step = options.step_pulses(),
                          last = options.recorded_pulses() - 1](std::size_t row) {
      const auto pulse = first + static_cast<std::int64_t>(row / frequencies * step);
      return middle_of_interval_s(repetition, pulse, pulse + static_cast<std::int64_t>(last));
    };
    product.row_carrier_hz = [carrier = carrier_hz(), frequencies = options.rows(), hz = axes.doppler_first_hz,
                              step = axes.doppler_step_hz](std::size_t row) {
      return carrier + hz + static_cast<double>(row % frequencies) * step;
    };
    product.column_range_m = [range_m = work_.rows().range_m](std::size_t column) { return range_m[column]; };
    product.sample_rate_hz = 1.0 / work_.acquisition().reception.raw_grid.interval_s;
    product.options = work_.acquisition().scene->options;
    product.engine = "doppler";
    return product;
  }

  [[nodiscard]] ImageContent content() const {
    const SearchOptions& options = work_.options();
    const DopplerReport axes = this->axes();
    ImageContent content;
    content.header.lines = work_.intervals() * options.rows();
    content.header.samples = work_.rows().samples();
    content.header.description = fmt::format(
        "Range-Doppler maps by sarsim {}, one below the other: lines along Doppler, samples along slant range",
        core::program_version);
    const std::int64_t first = work_.acquisition().timing.pulses.first;
    const double time_s = middle_of_interval_s(work_.acquisition().link.repetition, first,
                                               first + static_cast<std::int64_t>(options.recorded_pulses()) - 1);
    const auto number = [](double value) { return fmt::format("{}", value); };
    content.header.fields = {{"map", "range doppler"},
                             {"intervals", fmt::format("{}", work_.intervals())},
                             {"frequencies", fmt::format("{}", options.rows())},
                             {"interval first s", number(time_s)},
                             {"interval step s", number(static_cast<double>(options.step_pulses()) / prf_hz())},
                             {"doppler first hz", number(axes.doppler_first_hz)},
                             {"doppler step hz", number(axes.doppler_step_hz)},
                             {"speed first mps", number(axes.speed_first_mps)},
                             {"speed step mps", number(axes.speed_step_mps)},
                             {"range first m", number(axes.range_first_m)},
                             {"range step m", number(axes.range_step_m)},
                             {"carrier hz", number(carrier_hz())},
                             {"light speed mps", number(work_.acquisition().scene->conventions.light_speed_mps)}};
    std::ranges::move(work_.origin_fields(), std::back_inserter(content.header.fields));
    content.product = product();
    return content;
  }

  PulsePipeline& work_;
  bool replace_;
  std::optional<ImageWriter> writer_;
};

}  // namespace

std::size_t doppler_pulses(const simulate::Acquisition& acquisition, std::int64_t canceller) {
  return std::min(usual_doppler_pulses,
                  static_cast<std::size_t>(std::max<std::int64_t>(acquisition.timing.pulses.count() - canceller, 1)));
}

DopplerReport doppler(const DopplerRequest& request, const core::Observer& observer) {
  PulsePipeline work(request, observer, "-doppler");
  // The canceller takes its pulses from those that there are.
  const auto order = static_cast<std::int64_t>(request.canceller);
  work.open([order](const simulate::Acquisition& acquisition) { return doppler_pulses(acquisition, order); },
            [](const PulseRows&) { return 0.0; });
  DopplerImage image(work, request.replace);
  if (request.image) image.begin();
  work.detect({}, [&](const SearchInterval& interval) { image.append(interval); });
  std::optional<InMemoryImage> kept = image.finish();
  DopplerReport report = image.axes();
  static_cast<PulseReport&>(report) = work.report();
  report.kept = std::move(kept);
  return report;
}

}  // namespace sarsim::workflow
