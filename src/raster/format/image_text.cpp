#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "raster/format/image_openers.hpp"
#include "raster/format/raw_decode.hpp"
#include "raster/format/text_reader.hpp"
#include "raster/format/text_rows.hpp"
#include "raster/table/count_range.hpp"
#include "raster/table/row_index.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t most_values_of_first_row = std::size_t{1} << 25;
constexpr std::size_t most_listed_rows = 10;
constexpr double byte_s = 8e-9;  // Of reading numbers, measured.

struct TextMark {
  std::uint64_t offset = 0;
  std::size_t line = 1;
};

// What the first row tells of the others.
struct FirstRow {
  TextMark begin;
  TextRow row;
  TextValues numbers;
  std::uint64_t bytes = 0;
  bool too_long = false;
};

struct TooLong {};

FirstRow read_first_row(const core::InputFile& file, const TextLayout& layout) {
  FirstRow first;
  TextScanner scanner = scanner_at_samples(file, layout.style);
  scanner.skip_white_space();
  first.begin = {scanner.offset(), scanner.line()};
  std::size_t values = 0;
  TextRowParser parser(scanner, layout, [&](const TextNumber& number) {
    if (++values > most_values_of_first_row) throw TooLong();
    first.numbers.note(number);
  });
  try {
    first.row = parser.parse();
  } catch (const TooLong&) {
    first.too_long = true;
  }
  first.bytes = scanner.offset() - first.begin.offset;
  return first;
}

// How the numbers of a row make samples.
struct TextSamples {
  std::size_t values = 0;      // Numbers of a row.
  std::size_t components = 2;  // Numbers of a sample.
  std::optional<CountRange> offset;

  [[nodiscard]] float decoded(const TextNumber& number) const {
    if (!offset || !number.whole) return as_float(number.value + 0.0);  // "-0" of old programs is 0.
    return static_cast<float>(offset->without_offset(number.magnitude));
  }

  // Whether a number is none of a converter whose offset is subtracted, which the first row alone made believe.
  [[nodiscard]] bool misfits(const TextNumber& number) const {
    return offset && (!number.whole || number.value < 0.0 || number.magnitude > offset->highest_stored());
  }
};

class TextImage final : public ImageSource {
 public:
  TextImage(ImageInfo info, core::InputFile file, TextLayout layout, TextSamples samples, const FirstRow& first)
      : ImageSource(std::move(info)),
        file_(std::move(file)),
        layout_(layout),
        samples_(samples),
        row_bytes_(first.bytes),
        resume_{first.begin},
        index_(mark_spacing(file_.size())) {
    begin_index(file_.size());
  }

  [[nodiscard]] std::size_t rows() const override { return index_.rows(); }
  std::size_t refresh() override {
    const std::scoped_lock hold(refresh_lock_);
    const std::uint64_t size = file_.current_size();
    if (size > indexed_bytes_ && !index_.running() && !damaged_) begin_index(size);
    return rows();
  }
  [[nodiscard]] double indexed() const override { return index_.done(); }
  void wait_until_indexed(const core::StopFlag* stop) const override { index_.wait(stop); }
  [[nodiscard]] core::Problems problems() const override { return index_.problems(); }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    return static_cast<double>(window.rows) * static_cast<double>(row_bytes_) * byte_s;
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    if (window.samples() == 0) return;
    const std::size_t grain = std::max<std::size_t>(1, (std::size_t{1} << 14U) / columns());
    core::parallel_ranges(window.rows, grain, control, [&](std::size_t begin, std::size_t end) {
      read_range(window, begin, end, out.subspan(begin * window.cols, (end - begin) * window.cols));
    });
  }

 private:
  using Recorder = RowIndex<TextMark>::Recorder;

  // Where the last row that was looked at begins.
  struct Resume {
    TextMark mark;
    std::size_t row = 0;
  };

  void begin_index(std::uint64_t size) {
    indexed_bytes_ = size;
    index_.start(file_.path().string(), [this, size](Recorder& recorder) { look_through(recorder, size); });
  }

  void look_through(Recorder& recorder, std::uint64_t size) {
    std::size_t row = resume_.row;
    TextScanner scanner(file_, resume_.mark.offset, resume_.mark.line);
    std::optional<double> misfit;
    TextRowParser parser(scanner, layout_, [&](const TextNumber& number) {
      if (!misfit && samples_.misfits(number)) misfit = number.value;
    });
    while (!recorder.stop_wanted()) {
      scanner.skip_white_space();
      misfit.reset();
      const TextMark mark{scanner.offset(), scanner.line()};
      const TextRow found = parser.parse();
      scanner.skip_white_space();
      const bool last = scanner.peek() == TextScanner::end;
      if (found.values == 0 && !found.malformed) break;
      resume_ = {mark, row};
      if (last && (found.malformed || found.values < samples_.values)) break;  // Cut off, or still being written.
      if (found.malformed) {
        core::Problem problem = *found.malformed;
        problem.place.file = file_.path().string();
        problem.hint = "the rows before it are shown";
        recorder.problem(std::move(problem));
        damaged_ = true;
        break;
      }
      if (misfit) {
        report_misfit(recorder, mark, *misfit);
        break;
      }
      if (found.values != samples_.values) report_uneven(recorder, found, row);
      recorder.row_begins(row, mark.offset, mark);
      recorder.rows_known(++row);
      recorder.part_done(static_cast<double>(scanner.offset()) / static_cast<double>(std::max<std::uint64_t>(size, 1)));
      if (last) break;
    }
  }

  void report_misfit(Recorder& recorder, const TextMark& mark, double value) {
    core::Problem problem = file_problem(
        file_.path().string(), "a value is not that of an A/D converter with an offset", fmt::format("{}", value),
        fmt::format("0 to {}, as in the first row", samples_.offset->highest_stored()),
        "give no number of A/D bits to have the values as they stand; the rows before it are shown");
    problem.place.line = mark.line;
    recorder.problem(std::move(problem));
    damaged_ = true;
  }

  void report_uneven(Recorder& recorder, const TextRow& found, std::size_t row) {
    if (++uneven_rows_ > most_listed_rows) return;
    core::Problem problem = with_severity(
        file_problem(file_.path().string(), fmt::format("row {} has another length", row + 1),
                     fmt::format("{} numbers", found.values), fmt::format("{}, as in the first row", samples_.values),
                     "what is missing is shown as 0, what is too much is left out"),
        core::Severity::warning);
    problem.place.line = found.line;
    problem.place.column = found.column;
    recorder.problem(std::move(problem));
  }

  void read_range(const ImageWindow& window, std::size_t begin, std::size_t end,
                  std::span<std::complex<float>> out) const {
    std::ranges::fill(out, std::complex<float>());
    std::complex<float>* target = nullptr;
    std::size_t value = 0;
    const auto put = [&](const TextNumber& number) {
      const std::size_t index = value++;
      if (target == nullptr) return;
      const std::size_t column = index / samples_.components;
      if (column < window.col0 || (column - window.col0) % window.col_step != 0) return;
      const std::size_t k = (column - window.col0) / window.col_step;
      if (k >= window.cols) return;
      const float decoded = samples_.decoded(number);
      index % samples_.components == 0 ? target[k].real(decoded) : target[k].imag(decoded);
    };
    for (std::size_t i = begin; i < end;) {
      // As far as one mark leads; the next rows may have a nearer one.
      auto [row, mark] = index_.before(window.row(i));
      const std::size_t marked = row;
      TextScanner scanner(file_, mark.offset, mark.line);
      TextRowParser parser(scanner, layout_, put);
      for (; i < end && (window.row_step == 1 || index_.before(window.row(i)).first == marked); ++i, ++row) {
        const auto take = [&] {
          value = 0;
          const TextRow found = parser.parse();
          if (found.malformed || found.values == 0)
            throw std::runtime_error("cannot read " + file_.path().string() + ": it has been changed");
        };
        target = nullptr;
        for (; row < window.row(i); ++row) take();
        target = out.data() + (i - begin) * window.cols;
        take();
      }
    }
  }

  core::InputFile file_;
  TextLayout layout_;
  TextSamples samples_;
  std::uint64_t row_bytes_;
  std::mutex refresh_lock_;
  std::uint64_t indexed_bytes_ = 0;
  Resume resume_;  // Of the thread of the index.
  std::size_t uneven_rows_ = 0;
  bool damaged_ = false;
  RowIndex<TextMark> index_;  // Last: its thread uses the others.
};

// CSV holds an offset that only the bits tell; values that do not fit it are taken as they stand.
std::optional<CountRange> offset_of(const FirstRow& first, const SampleFileHints& hints, const std::string& name,
                                    core::Problems& problems) {
  if (hints.bits == 0) {
    problems.push_back(with_severity(file_problem(name, "the values may contain the offset of the A/D converter", {},
                                                  {}, "give the number of A/D bits to have it subtracted"),
                                     core::Severity::note));
    return std::nullopt;
  }
  const CountRange range{hints.bits};
  if (first.numbers.may_have_offset(range)) return range;
  problems.push_back(with_severity(
      file_problem(name, fmt::format("the values are not those of {} A/D bits with an offset", hints.bits), {}, {},
                   "they are taken as they stand"),
      core::Severity::warning));
  return std::nullopt;
}

std::optional<core::Problem> first_row_problem(const std::string& name, const FirstRow& first,
                                               const TextLayout& layout) {
  if (first.too_long)
    return file_problem(name, "the first row does not end", fmt::format("{} numbers", most_values_of_first_row), {},
                        "give the samples of a row");
  if (first.row.malformed) {
    core::Problem problem = *first.row.malformed;
    problem.place.file = name;
    return problem;
  }
  if (first.row.values == 0) return file_problem(name, "the file holds no samples");
  if (first.row.values % 2 != 0 && layout.style != TextStyle::commas)
    return file_problem(name, "the first row ends with an I that has no Q",
                        fmt::format("{} numbers", first.row.values));
  if (layout.columns > 0 && first.row.values < 2 * layout.columns)
    return file_problem(name, "the file does not hold a single row", fmt::format("{} numbers", first.row.values),
                        fmt::format("{} samples", layout.columns));
  return std::nullopt;
}

}  // namespace

OpenedImage open_text_image(core::InputFile file, TextStyle style, const SampleFileHints& hints) {
  const std::string name = file.path().string();
  if (hints.bits < 0 || hints.bits > 64 || hints.columns > (std::size_t{1} << 60U))
    return {nullptr, {file_problem(name, "the samples of a row or the A/D bits are out of range")}};
  const TextLayout layout{style, style == TextStyle::commas ? 0 : hints.columns};
  const FirstRow first = read_first_row(file, layout);
  if (auto problem = first_row_problem(name, first, layout)) return {nullptr, {std::move(*problem)}};
  core::Problems problems;
  ImageInfo info;
  info.path = file.path();
  TextSamples samples;
  samples.values = first.row.values;
  if (first.row.values % 2 != 0) {
    samples.components = 1;
    info.value = ImageValue::real;
  } else if (style == TextStyle::commas) {
    samples.offset = offset_of(first, hints, name, problems);
  }
  info.columns = samples.values / samples.components;
  info.counts = first.numbers.whole && samples.components == 2;
  info.bits = info.counts ? hints.bits : 0;
  if (hints.lsb_v > 0.0) info.lsb_v = hints.lsb_v;
  return {std::make_shared<TextImage>(std::move(info), std::move(file), layout, samples, first), std::move(problems)};
}

}  // namespace sarsim::raster
