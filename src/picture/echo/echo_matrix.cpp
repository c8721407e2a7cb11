#include "picture/echo/echo_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sarsim::picture {

namespace {

// Row of the recording that leaves nearest to a time.
std::size_t nearest_row(const simulate::Plan& plan, double time_s) {
  const radar::Repetition& repetition = plan.acquisition.link.repetition;
  const std::int64_t before = repetition.pulses_in(time_s, time_s).last;
  std::int64_t pulse = std::clamp(before, plan.acquisition.timing.pulses.first, plan.acquisition.timing.pulses.last);
  const std::int64_t after =
      std::clamp(before + 1, plan.acquisition.timing.pulses.first, plan.acquisition.timing.pulses.last);
  if (std::abs(repetition.send_time_s(after) - time_s) < std::abs(repetition.send_time_s(pulse) - time_s))
    pulse = after;
  const std::int64_t last = static_cast<std::int64_t>(plan.acquisition.timing.rows) - 1;
  return static_cast<std::size_t>(std::clamp<std::int64_t>(plan.acquisition.timing.row_of(pulse), 0, last));
}

// Column of the recording nearest to a range; ranges ascend.
std::size_t nearest_column(const simulate::Plan& plan, double range_m) {
  const std::vector<double>& ranges = plan.acquisition.reception.column_range_m;
  const auto above = std::ranges::lower_bound(ranges, range_m);
  if (above == ranges.begin()) return 0;
  const auto column = static_cast<std::size_t>(above - ranges.begin());
  if (above == ranges.end()) return column - 1;
  return ranges[column] - range_m <= range_m - ranges[column - 1] ? column : column - 1;
}

// From the wanted element of each pixel to the different ones among them, and where each pixel finds its own.
struct Distinct {
  std::vector<std::size_t> element;
  std::vector<std::size_t> of_pixel;
};

Distinct distinct(const std::vector<std::size_t>& wanted) {
  Distinct d;
  d.element = wanted;
  std::ranges::sort(d.element);
  d.element.erase(std::ranges::unique(d.element).begin(), d.element.end());
  d.of_pixel.reserve(wanted.size());
  for (const std::size_t e : wanted)
    d.of_pixel.push_back(static_cast<std::size_t>(std::ranges::lower_bound(d.element, e) - d.element.begin()));
  return d;
}

// The elements alone, or with all that lie nearer to them than to the next wanted one.
std::vector<simulate::IndexSpan> spans_of(const std::vector<std::size_t>& element, std::size_t count, PixelRule rule) {
  std::vector<simulate::IndexSpan> spans;
  spans.reserve(element.size());
  if (rule == PixelRule::sample) {
    for (const std::size_t e : element) spans.push_back({e, e + 1});
    return spans;
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < element.size(); ++i) {
    const std::size_t end = i + 1 < element.size() ? (element[i] + element[i + 1] + 1) / 2 : count;
    spans.push_back({begin, end});
    begin = end;
  }
  return spans;
}

}  // namespace

SamplePlaces place_samples(const simulate::Plan& plan, const PlotSize& size, PixelRule rule) {
  const scene::Simulation& s = plan.acquisition.simulation;
  const EchoView view{s.range_start_m, s.range_end_m, s.time_start_s, s.time_end_s};
  std::vector<std::size_t> rows(std::max<std::size_t>(size.height_px, 1));
  for (std::size_t y = 0; y < rows.size(); ++y)
    rows[y] = nearest_row(plan, time_at(view, size, static_cast<double>(y)));
  std::vector<std::size_t> columns(std::max<std::size_t>(size.width_px, 1));
  for (std::size_t x = 0; x < columns.size(); ++x)
    columns[x] = s.processing == scene::Processing::srp
                     ? x * plan.acquisition.reception.columns / columns.size()
                     : nearest_column(plan, range_at(view, size, static_cast<double>(x)));
  // Where there are fewer than pixels every one is shown, however unevenly they lie.
  const auto all_of = [](std::size_t count, std::vector<std::size_t>& element) {
    element.resize(count);
    for (std::size_t i = 0; i < count; ++i) element[i] = i;
  };
  Distinct row = distinct(rows);
  Distinct column = distinct(columns);
  if (plan.acquisition.timing.rows < rows.size()) {
    all_of(plan.acquisition.timing.rows, row.element);
    row.of_pixel = rows;
  }
  SamplePlaces places;
  // A compressed echo may be a single sample wide, which a subset would leave out; its row is computed whole anyway.
  const PixelRule across = s.processing == scene::Processing::raw ? rule : PixelRule::peak;
  places.selection.pick =
      across == PixelRule::peak ? simulate::SampleSelection::Pick::peak : simulate::SampleSelection::Pick::first;
  places.selection.rows = spans_of(row.element, plan.acquisition.timing.rows, rule);
  places.selection.columns = spans_of(column.element, plan.acquisition.reception.columns, across);
  places.row = std::move(row.element);
  places.column = std::move(column.element);
  places.row_of_pixel = std::move(row.of_pixel);
  places.column_of_pixel = std::move(column.of_pixel);
  return places;
}

std::vector<std::complex<double>> SampleRoom::take(std::size_t count) {
  std::vector<std::complex<double>> samples;
  {
    const std::scoped_lock hold(lock_);
    if (!kept_.empty()) {
      samples = std::move(kept_.back());
      kept_.pop_back();
    }
  }
  samples.resize(count);
  return samples;
}

void SampleRoom::give_back(std::vector<std::complex<double>> samples) {
  constexpr std::size_t most = 2;
  const std::scoped_lock hold(lock_);
  if (kept_.size() < most) kept_.push_back(std::move(samples));
}

EchoMatrix::EchoMatrix(std::shared_ptr<const simulate::Plan> plan, EchoWindow window, const PlotSize& size,
                       std::shared_ptr<SampleRoom> room)
    : plan_(std::move(plan)),
      window_(std::move(window)),
      size_(size),
      places_(place_samples(*plan_, size_, window_.pixel_rule)),
      room_(room ? std::move(room) : std::make_shared<SampleRoom>()),
      samples_(room_->take(places_.row.size() * places_.column.size())),
      statistics_(places_.row.size()),
      ready_(places_.row.size()) {}

EchoMatrix::~EchoMatrix() { room_->give_back(std::move(samples_)); }

void EchoMatrix::set_ready(std::size_t row) {
  statistics_[row] = statistics_of(this->row(row));
  if (!ready_[row].exchange(true, std::memory_order_release)) ready_rows_.fetch_add(1, std::memory_order_release);
}

std::vector<std::size_t> EchoMatrix::nearest_ready() const {
  std::vector<std::size_t> nearest(rows());
  std::optional<std::size_t> last;
  for (std::size_t r = 0; r < rows(); ++r) {
    if (ready(r)) last = r;
    nearest[r] = last.value_or(rows());
  }
  if (!last) return {};
  std::size_t next = rows();
  for (std::size_t r = rows(); r-- > 0;) {
    if (nearest[r] == r) next = r;
    if (next == rows()) continue;
    if (nearest[r] == rows() || next - r < r - nearest[r]) nearest[r] = next;
  }
  return nearest;
}

}  // namespace sarsim::picture
