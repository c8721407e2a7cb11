#include "workflow/search/detection_table.hpp"

#include <span>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"

namespace sarsim::workflow {

double bearing_deg(double azimuth_rad) {
  const double azimuth = azimuth_rad * 180.0 / core::pi;
  return azimuth < 0.0 ? azimuth + 360.0 : azimuth;
}

core::Facts facts_of(const SearchDetection& d, std::optional<std::size_t> target, bool doppler,
                     const std::optional<GroundPlace>& place) {
  core::Facts facts{{"interval", "Interval", d.interval + 1, "", core::fixed(0)},
                    {"time_s", "Time", d.time_s, "s", core::fixed(4)},
                    {"azimuth_deg", "Azimuth", bearing_deg(d.azimuth_rad), "deg", core::fixed(2)},
                    {"range_m", "Range", d.range_m, "m", core::fixed(2)},
                    {"doppler_hz", "Doppler", core::only(doppler, d.doppler_hz), "Hz", core::fixed(1)},
                    {"speed_mps", "Speed", core::only(doppler, d.speed_mps), "m/s", core::fixed(3)},
                    {"magnitude_v", "Magnitude", d.magnitude_v, "V", core::scientific(3)},
                    {"snr_db", "SNR", core::power_db(d.snr), "dB", core::fixed(1)},
                    {"threshold_v", "Threshold", d.threshold_v, "V", core::scientific(3)},
                    {"target", "Target", core::only(target.has_value(), target.value_or(0) + 1), "", core::fixed(0)}};
  if (place)
    append(facts, {{"x_m", "X", place->x_m, "m", core::fixed(1)}, {"y_m", "Y", place->y_m, "m", core::fixed(1)}});
  return facts;
}

DetectionTable::DetectionTable(const std::filesystem::path& path, bool replace, bool doppler, bool places)
    : doppler_(doppler), places_(places) {
  if (!path.empty()) file_.emplace(path, replace);
  pending_ =
      core::csv_names(facts_of(SearchDetection{}, {}, doppler_, places_ ? std::optional(GroundPlace{}) : std::nullopt));
}

void DetectionTable::append(const SearchDetection& d, std::optional<std::size_t> target, const GroundPlace& place) {
  pending_ += core::csv_line(facts_of(d, target, doppler_, places_ ? std::optional(place) : std::nullopt));
  constexpr std::size_t enough = std::size_t{1} << 16;
  if (file_ && pending_.size() >= enough) write_pending();
  ++count_;
}

void DetectionTable::write_pending() {
  file_->write(std::as_bytes(std::span(pending_)));
  pending_.clear();
}

void DetectionTable::finish() {
  if (!file_) return;
  write_pending();
  file_->commit();
}

}  // namespace sarsim::workflow
