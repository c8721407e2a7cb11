#include <array>
#include <ranges>

#include <fmt/format.h>

#include "cli/command/product_command.hpp"
#include "cli/shell/report.hpp"
#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::cli {

namespace {

std::string summary_text(const workflow::WrittenIsarImage& written) {
  const workflow::IsarImage& made = written.image;
  return fmt::format(
      "{}: {} x {} pixels of {:.4g} x {:.4g} m, bursts {} to {}, {:.6g} to {:.6g} s; centre at {:.2f} m and {} "
      "m/s; turned by {:.4g} degrees; resolution {:.4g} m in cross-range (unambiguous {:.4g} m), {:.4g} m in range\n",
      written.file.string(), made.image.azimuth.count, made.image.range.count, made.image.azimuth.step_m,
      made.image.range.step_m, written.first_burst + 1, written.first_burst + written.bursts, made.from_s, made.to_s,
      made.range_m, decimals(made.speed_mps, 3), core::deg_per_rad * made.turn_rad, made.cross_range_resolution_m,
      made.unambiguous_cross_range_m, made.range_resolution_m);
}

std::string points_text(const workflow::IsarImage& made) {
  constexpr std::size_t most = 20;
  std::string text = fmt::format("{:>6} {:>25} {:>25} {:>25}\n", "", "expected m", "error m", "width m");
  text += fmt::format("{:>6} {:>14} {:>10} {:>14} {:>10} {:>14} {:>10} {:>9}\n", "target", "cross-range", "range",
                      "cross-range", "range", "cross-range", "range", "error dB");
  constexpr std::array<std::size_t, 8> widths{6, 14, 10, 14, 10, 14, 10, 9};
  for (const workflow::HeldPoint& point : made.points | std::views::take(most))
    text += core::aligned_row(workflow::facts_of(point), widths);
  if (made.points.size() > most)
    text += fmt::format("and {}; --json lists them\n", counted(made.points.size() - most, "more target"));
  return text;
}

ProductText text_of_isar(const workflow::IsarReport& report, const workflow::IsarRequest& /*request*/) {
  ProductText text;
  for (const workflow::WrittenIsarImage& image : report.images) {
    text.summary += summary_text(image);
    text.tables += points_text(image.image);
  }
  text.summary += fmt::format("done in {}\n", core::duration_text(report.seconds));
  return text;
}

}  // namespace

Action add_isar(CLI::App& app) {
  return add_product(app, workflow::isar_product,
                     {{"sarsim isar turning_ship.toml", "simulate and image: turning_ship-isar.img"},
                      {"sarsim isar turning_ship.toml --bursts 64 --step 32", "a series of images"},
                      {"sarsim isar sim1.h5 --motion estimated --window taylor:35:5", "without knowing the path"},
                      {"sarsim isar turning_ship.toml --algorithm back-projection", "exact for any turning"}},
                     text_of_isar);
}

}  // namespace sarsim::cli
