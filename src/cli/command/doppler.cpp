#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/doppler_work.hpp"
#include "cli/command/image_writer.hpp"
#include "cli/shell/options.hpp"
#include "core/build/version.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::cli {

namespace {

constexpr std::size_t usual_pulses = 64;

// One run of the command. The image holds the maps of all intervals, one below the other.
class DopplerRun {
 public:
  DopplerRun(const SearchArguments& arguments, Streams& streams)
      : arguments_(arguments), work_(arguments, streams, "-doppler") {}

  ExitStatus run() {
    // The canceller takes its pulses from those that there are.
    const auto order = static_cast<std::int64_t>(arguments_.canceller.value_or(Canceller::none));
    work_.open(
        [order](const simulate::Plan& plan) {
          return std::min(usual_pulses,
                          static_cast<std::size_t>(std::max<std::int64_t>(plan.pulses.count() - order, 1)));
        },
        [](const workflow::PulseRows&) { return 0.0; });
    std::optional<ImageWriter> image;
    if (!arguments_.no_map) image.emplace(work_.output(), content_of_image(), arguments_.force, largest());
    work_.detect({}, [&](const workflow::SearchInterval& interval) {
      if (image) append(interval, *image);
    });
    if (image) image->finish();
    report();
    return exit_done;
  }

 private:
  [[nodiscard]] double doppler_step_hz() const { return prf_hz() / static_cast<double>(work_.options().rows()); }
  [[nodiscard]] double prf_hz() const { return 1.0 / work_.plan().radar.repetition.mean_interval_s(); }
  [[nodiscard]] double first_doppler_hz() const {
    const std::size_t rows_below_0 = work_.options().rows() / 2;
    return -static_cast<double>(rows_below_0) * doppler_step_hz();
  }
  [[nodiscard]] double carrier_hz() const { return work_.plan().radar.carrier.carrier_hz(work_.plan().pulses.first); }
  [[nodiscard]] double speed_of(double doppler_hz) const {
    return -0.5 * work_.plan().scene->conventions.light_speed_mps / carrier_hz() * doppler_hz;
  }
  [[nodiscard]] double range_step_m() const {
    const std::vector<double>& range_m = work_.rows().range_m;
    return range_m.size() > 1 ? range_m[1] - range_m[0] : 0.0;
  }

  // Counts have an LSB that the whole image decides: its maps are made twice.
  double largest() {
    float largest = 0.0F;
    if (needs_largest(work_.output()))
      work_.look_through(work_.output().string() + " (finding the largest magnitude)",
                         [&](const workflow::SearchInterval& interval) {
                           for (const auto& value : interval.map.values) largest = std::max(largest, std::abs(value));
                         });
    return static_cast<double>(largest);
  }

  void append(const workflow::SearchInterval& interval, ImageWriter& image) const {
    const std::span<const std::complex<float>> values = interval.map.values;
    for (std::size_t row = 0; row < interval.map.frequencies; ++row)
      image.append(values.subspan(row * interval.map.samples, interval.map.samples));
  }

  // Middle of an interval's first and last pulse.
  static double time_of(const radar::Repetition& repetition, std::int64_t first_pulse, std::int64_t last_pulse) {
    return 0.5 * (repetition.send_time_s(first_pulse) + repetition.send_time_s(last_pulse));
  }

  [[nodiscard]] simulate::Product axes() const {
    const workflow::SearchOptions& options = work_.options();
    simulate::Product product;
    product.radar = work_.plan().radar.name;
    product.row_time_s = [repetition = work_.plan().radar.repetition, frequencies = options.rows(),
                          first = work_.plan().pulses.first, step = options.step_pulses(),
                          last = options.recorded_pulses() - 1](std::size_t row) {
      const auto pulse = first + static_cast<std::int64_t>(row / frequencies * step);
      return time_of(repetition, pulse, pulse + static_cast<std::int64_t>(last));
    };
    product.row_carrier_hz = [carrier = carrier_hz(), frequencies = options.rows(), hz = first_doppler_hz(),
                              step = doppler_step_hz()](std::size_t row) {
      return carrier + hz + static_cast<double>(row % frequencies) * step;
    };
    product.column_range_m = [range_m = work_.rows().range_m](std::size_t column) { return range_m[column]; };
    product.sample_rate_hz = 1.0 / work_.plan().raw_grid.interval_s;
    product.options = work_.plan().scene->options;
    product.engine = "doppler";
    return product;
  }

  [[nodiscard]] ImageContent content_of_image() const {
    const workflow::SearchOptions& options = work_.options();
    ImageContent content;
    content.header.lines = work_.intervals() * options.rows();
    content.header.samples = work_.rows().samples();
    content.header.description = fmt::format(
        "Range-Doppler maps by sarsim {}, one below the other: lines along Doppler, samples along slant range",
        core::program_version);
    const radar::Repetition& repetition = work_.plan().radar.repetition;
    const std::int64_t first = work_.plan().pulses.first;
    const double time_s = time_of(repetition, first, first + static_cast<std::int64_t>(options.recorded_pulses()) - 1);
    const auto number = [](double value) { return fmt::format("{}", value); };
    content.header.fields = {{"map", "range doppler"},
                             {"intervals", fmt::format("{}", work_.intervals())},
                             {"frequencies", fmt::format("{}", options.rows())},
                             {"interval first s", number(time_s)},
                             {"interval step s", number(static_cast<double>(options.step_pulses()) / prf_hz())},
                             {"doppler first hz", number(first_doppler_hz())},
                             {"doppler step hz", number(doppler_step_hz())},
                             {"speed first mps", number(speed_of(first_doppler_hz()))},
                             {"speed step mps", number(speed_of(doppler_step_hz()))},
                             {"range first m", number(work_.rows().range_m.front())},
                             {"range step m", number(range_step_m())},
                             {"carrier hz", number(carrier_hz())},
                             {"light speed mps", number(work_.plan().scene->conventions.light_speed_mps)}};
    std::ranges::move(work_.origin_fields(), std::back_inserter(content.header.fields));
    content.product = axes();
    return content;
  }

  void report() {
    const workflow::SearchOptions& options = work_.options();
    const std::vector<double>& range_m = work_.rows().range_m;
    const std::string text =
        work_.doppler()
            ? fmt::format("{} frequencies {:.4g} Hz ({:.4g} m/s) apart x {} ranges {:.1f} to {:.1f} m, ",
                          options.rows(), doppler_step_hz(), std::abs(speed_of(doppler_step_hz())), range_m.size(),
                          range_m.front(), range_m.back())
            : fmt::format("{} ranges {:.1f} to {:.1f} m, ", range_m.size(), range_m.front(), range_m.back());
    work_.report(text, [&](core::JsonWriter& json) {
      json.member("rows", options.rows()).member("columns", range_m.size());
      json.member("doppler_first_hz", first_doppler_hz()).member("doppler_step_hz", doppler_step_hz());
      json.member("speed_first_mps", speed_of(first_doppler_hz()))
          .member("speed_step_mps", speed_of(doppler_step_hz()));
      json.member("range_first_m", range_m.front()).member("range_step_m", range_step_m());
    });
  }

  const SearchArguments& arguments_;
  PulseWork work_;
};

}  // namespace

Action add_doppler(CLI::App& app) {
  auto arguments = std::make_shared<SearchArguments>();
  add_search_arguments(
      app, *arguments,
      fmt::format("maps to write, one below the other: ENVI (.img, default), or {}", raster::image_extensions()),
      fmt::format("{}, or as many as there are", usual_pulses));
  add_examples(app, {{"sarsim doppler mti.scr --canceller two", "what moves: mti-doppler.img and its detections"},
                     {"sarsim doppler sim1.h5 --interval 128 --step 64 --window hamming", "overlapping intervals"},
                     {"sarsim doppler sim1.bin --script scene.scr --out maps.npy", "a file that carries no script"},
                     {"sarsim doppler mti.scr --cfar os --train 12:2 --pfa 1e-5", "another detector"}});
  return [arguments](Streams& streams) { return DopplerRun(*arguments, streams).run(); };
}

}  // namespace sarsim::cli
