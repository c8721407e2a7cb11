#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/json.hpp"
#include "radar/earth/instant.hpp"
#include "raster/format/format_writer.hpp"
#include "raster/format/sigmf.hpp"
#include "raster/table/described_product.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/row_order.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/model/world_frame.hpp"
#include "scene/schema/option_words.hpp"

namespace sarsim::raster {

namespace fs = std::filesystem;

namespace {

// SigMF has integers of up to 32 bits; counts reach 2^(bits - 1), one more than such an integer does.
constexpr int max_short_bits = 15;
constexpr int max_bits = 31;

std::size_t sigmf_component_bytes(const Encoding& encoding) {
  return encoding.counts && encoding.bits <= max_short_bits ? 2 : array_component_bytes(encoding);
}

std::vector<std::byte> encode_sigmf(const Encoding& encoding, const Block& block) {
  std::vector<std::byte> bytes = encode_array(encoding, block);
  if (sigmf_component_bytes(encoding) == array_component_bytes(encoding)) return bytes;
  // The lower halves of integers of 32 bits, least significant byte first.
  for (std::size_t i = 0; 4 * i < bytes.size(); ++i) {
    bytes[2 * i] = bytes[4 * i];
    bytes[2 * i + 1] = bytes[4 * i + 1];
  }
  bytes.resize(bytes.size() / 2);
  return bytes;
}

std::string datatype_of(const Encoding& encoding) {
  return fmt::format("c{}{}_le", encoding.counts ? 'i' : 'f', 8 * sigmf_component_bytes(encoding));
}

void expect_possible(const fs::path& path, const Encoding& encoding) {
  if (encoding.counts && encoding.bits > max_bits)
    throw core::InvalidRequest({file_problem(path.string(), "SigMF has no integers for counts of so many bits",
                                             fmt::format("{} bits", encoding.bits), fmt::format("at most {}", max_bits),
                                             "record volts, or choose another format")});
  if (sigmf_files(path).front() == path || sigmf_files(path).back() == path) return;
  throw core::InvalidRequest(
      {file_problem(path.string(), "this is not the name of a SigMF recording", {},
                    "NAME.sigmf-meta, beside which the samples are NAME.sigmf-data", "give the output such a name")});
}

// When time 0 of a scene was, where it says so.
std::optional<radar::Instant> epoch_in(const std::string& script) {
  if (script.find("epoch") == std::string::npos) return std::nullopt;
  const auto reading = scene::read_scene_text(script, "script", {});
  return scene::epoch_of(reading.scene.world).instant;
}

// The metadata of a recording.
class MetaText {
 public:
  MetaText(const Product& product, const Encoding& encoding, const RunReport& report)
      : product_(product),
        encoding_(encoding),
        described_(describe(product, scene::option_words(product.options), encoding.counts)),
        epoch_(product.row_time_s ? epoch_in(product.script) : std::nullopt) {
    for (auto& [name, value] : described_.root)
      if (name == "lsb_v") value = report.lsb_v;
  }

  std::string text() {
    json_.begin_object();
    put_global();
    put_captures();
    json_.key("annotations").begin_array().end_array();
    json_.end_object();
    return json_.text();
  }

 private:
  void put_global() {
    json_.key("global").begin_object();
    json_.member("core:datatype", datatype_of(encoding_)).member("core:version", sigmf_version);
    json_.member("core:num_channels", 1);
    if (product_.sample_rate_hz > 0.0 && is_known(product_, "sample_rate_hz"))
      json_.member("core:sample_rate", product_.sample_rate_hz);
    json_.member("core:recorder", fmt::format("Sarsim {}", core::program_version));
    json_.member("core:description", "Radar echoes: a capture for each pulse, with a gap of time before the next one");
    json_.key("core:extensions").begin_array().begin_object();
    json_.member("name", "sarsim").member("version", "1.0.0").member("optional", true);
    json_.end_object().end_array();
    json_.member("sarsim:samples_per_pulse", product_.columns);
    const bool ranges = product_.column_range_m && product_.image.columns == "slant_range_m" && product_.columns > 0;
    if (ranges) {
      json_.key("sarsim:slant_range_m").begin_array();
      for (std::size_t i = 0; i < product_.columns; ++i) json_.value(product_.column_range_m(i));
      json_.end_array();
    }
    for (const auto& [name, value] : described_.root)
      if (name != "Conventions") std::visit([&](const auto& v) { json_.member("sarsim:" + name, v); }, value);
    json_.end_object();
  }

  void put_captures() {
    json_.key("captures").begin_array();
    for (std::size_t row = 0; row < product_.rows; ++row) {
      json_.begin_object().member("core:sample_start", row * product_.columns);
      if (product_.row_carrier_hz) json_.member("core:frequency", product_.row_carrier_hz(row));
      if (product_.row_time_s) put_time(product_.row_time_s(row));
      json_.end_object();
    }
    json_.end_array();
  }

  void put_time(double time_s) {
    if (epoch_)
      json_.member("core:datetime", radar::format_instant(radar::later(*epoch_, time_s), radar::TimeScale::utc));
    json_.member("sarsim:pulse_time_s", time_s);
  }

  const Product& product_;
  const Encoding& encoding_;
  DescribedProduct described_;
  std::optional<radar::Instant> epoch_;
  core::JsonWriter json_;
};

// Two files, which get their names when both are on the disk.
class SigmfSink final : public Sink {
 public:
  SigmfSink(const fs::path& path, const Product& product, const Encoding& encoding, bool replace)
      : product_(product),
        encoding_(encoding),
        meta_(sigmf_files(path).front(), replace),
        data_(sigmf_files(path).back(), replace),
        order_(product.rows) {}

  [[nodiscard]] bool wants_counts() const override { return encoding_.counts; }
  [[nodiscard]] std::vector<std::byte> encode(const Block& block) const override {
    return encode_sigmf(encoding_, block);
  }
  void append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) override {
    order_.expect(first_row, rows);
    data_.write(bytes);
    order_.take(rows);
  }
  void finish(const RunReport& report) override {
    order_.expect_all();
    const std::string text = MetaText(product_, encoding_, report).text();
    meta_.write(std::as_bytes(std::span(text)));
    meta_.secure();
    data_.commit();
    meta_.commit();
  }

 private:
  Product product_;
  Encoding encoding_;
  core::OutputFile meta_;
  core::OutputFile data_;
  RowOrder order_;
};

// About: the samples, and a line or six for each of captures and ranges.
double sigmf_bytes(const Product& product, const Encoding& encoding, bool) {
  constexpr double text = 1500.0;
  constexpr double capture = 114.0;
  constexpr double range = 26.0;
  const auto rows = static_cast<double>(product.rows);
  const auto columns = static_cast<double>(product.columns);
  return rows * columns * 2.0 * static_cast<double>(sigmf_component_bytes(encoding)) + text + capture * rows +
         range * columns + static_cast<double>(product.script.size());
}

std::unique_ptr<Sink> sigmf_sink(const fs::path& path, const Product& product, const Encoding& encoding, bool replace) {
  expect_possible(path, encoding);
  return std::make_unique<SigmfSink>(path, product, encoding, replace);
}

}  // namespace

std::vector<fs::path> sigmf_files(const fs::path& path) {
  return {fs::path(path).replace_extension(".sigmf-meta"), fs::path(path).replace_extension(".sigmf-data")};
}

const FormatWriter sigmf_writer{.encode = encode_sigmf,
                                .component_bytes = sigmf_component_bytes,
                                .expected_bytes = sigmf_bytes,
                                .make_sink = sigmf_sink};

}  // namespace sarsim::raster
