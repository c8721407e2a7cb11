#include "workflow/search/detection_table.hpp"

#include <cmath>
#include <span>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::workflow {

namespace {

void add_field(std::string& line, std::optional<double> value) {
  line += ',';
  if (value && std::isfinite(*value)) core::append_number(line, *value);
}

}  // namespace

double bearing_deg(double azimuth_rad) {
  const double azimuth = azimuth_rad * 180.0 / core::pi;
  return azimuth < 0.0 ? azimuth + 360.0 : azimuth;
}

DetectionTable::DetectionTable(const std::filesystem::path& path, bool replace, bool doppler, bool places)
    : doppler_(doppler), places_(places) {
  if (!path.empty()) file_.emplace(path, replace);
  pending_ = "interval,time_s,azimuth_deg,range_m,doppler_hz,speed_mps,magnitude_v,snr_db,threshold_v,target";
  if (places_) pending_ += ",x_m,y_m";
  pending_ += '\n';
}

void DetectionTable::append(const SearchDetection& d, std::optional<std::size_t> target, const GroundPlace& place) {
  std::string line = std::to_string(d.interval + 1);
  add_field(line, d.time_s);
  add_field(line, bearing_deg(d.azimuth_rad));
  add_field(line, d.range_m);
  add_field(line, doppler_ ? std::optional(d.doppler_hz) : std::nullopt);
  add_field(line, doppler_ ? std::optional(d.speed_mps) : std::nullopt);
  add_field(line, d.magnitude_v);
  add_field(line, core::power_db(d.snr));
  add_field(line, d.threshold_v);
  line += ',';
  if (target) line += std::to_string(*target + 1);
  if (places_) {
    add_field(line, place.x_m);
    add_field(line, place.y_m);
  }
  pending_ += line + '\n';
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
