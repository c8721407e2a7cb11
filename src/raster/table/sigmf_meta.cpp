#include "raster/table/sigmf_meta.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "raster/table/described_product.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/json_failure.hpp"
#include "raster/table/json_once.hpp"

namespace sarsim::raster {

namespace {

using SigmfJson = nlohmann::json;

constexpr std::string_view own_prefix = "sarsim:";

core::Problem problem_of_key(std::string_view key, std::string what, std::string found, std::string expected,
                             std::string hint = {}) {
  return file_problem({}, fmt::format("{} {}", key, what), std::move(found), std::move(expected), std::move(hint));
}

// A word of a value as it stands in the file.
std::string shown_json(const SigmfJson& value) {
  if (value.is_structured()) return value.is_array() ? "[ ... ]" : "{ ... }";
  return core::quoted_word(value.dump(-1, ' ', true, SigmfJson::error_handler_t::replace));
}

// Reads metadata and keeps the first problem.
class SigmfReader {
 public:
  explicit SigmfReader(const std::filesystem::path& data) : data_(data) {}

  std::variant<SigmfMeta, core::Problem> read(std::string_view text) {
    SigmfJson tree;
    try {
      tree = parse_json_once(text, twice_);
    } catch (const SigmfJson::exception& error) {
      return not_json({}, error);
    }
    if (!twice_.empty()) return problem_of_key(twice_, "is there twice", {}, "one value");
    const SigmfJson& global = member(tree, "global");
    if (!tree.is_object() || !global.is_object())
      return file_problem({}, "the metadata have no object 'global'", {}, "those of SigMF");
    take_own(global);
    take_global(global);
    take_places(global);
    if (const auto& captures = member(tree, "captures"); captures.is_array())
      take_captures(captures);
    else if (!captures.is_null())
      refuse("captures", "are no list", shown_json(captures), "[ ... ]");
    if (problem_) return std::move(*problem_);
    return std::move(meta_);
  }

 private:
  static const SigmfJson& member(const SigmfJson& object, std::string_view name) {
    static const SigmfJson none;
    if (!object.is_object()) return none;
    const auto found = object.find(name);
    return found == object.end() ? none : *found;
  }

  void refuse(std::string_view key, std::string what, std::string found, std::string expected, std::string hint = {}) {
    if (!problem_)
      problem_ = problem_of_key(key, std::move(what), std::move(found), std::move(expected), std::move(hint));
  }

  // A whole number from 0 on, where the key is there.
  std::optional<std::uint64_t> whole(const SigmfJson& object, const char* key) {
    const SigmfJson& value = member(object, key);
    if (value.is_null()) return std::nullopt;
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (value.is_number_float() && value.get<double>() >= 0.0 && value.get<double>() <= 0x1p53 &&
        std::floor(value.get<double>()) == value.get<double>())
      return static_cast<std::uint64_t>(value.get<double>());
    refuse(key, "is no whole number", shown_json(value), "a whole number from 0 on");
    return std::nullopt;
  }
  std::optional<double> number(const SigmfJson& object, const char* key, double least) {
    const SigmfJson& value = member(object, key);
    if (value.is_null()) return std::nullopt;
    if (value.is_number() && std::isfinite(value.get<double>()) && value.get<double>() >= least)
      return value.get<double>();
    refuse(key, "is no possible number", shown_json(value),
           std::isfinite(least) ? fmt::format("a number, at least {:g}", least) : "a finite number");
    return std::nullopt;
  }
  std::string text(const SigmfJson& object, const char* key) {
    const SigmfJson& value = member(object, key);
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_null()) refuse(key, "is no text", shown_json(value), "a text");
    return {};
  }

  void take_own(const SigmfJson& global) {
    ArrayAttributes own;
    for (const auto& [key, value] : global.items()) {
      if (!key.starts_with(own_prefix)) continue;
      const std::string name = key.substr(own_prefix.size());
      if (value.is_string())
        own.known.emplace_back(name, value.get<std::string>());
      else if (value.is_number_integer())
        own.known.emplace_back(name, value.dump());
      else if (value.is_number_float())
        own.known.emplace_back(name, core::format_number(value.get<double>()));
      else
        own.unreadable.emplace_back(name, shown_json(value));
    }
    if (auto problem = problem_of_root(own); problem && !problem_) problem_ = std::move(problem);
    meta_.attributes = std::move(own.known);
    meta_.columns = whole(global, "sarsim:samples_per_pulse").value_or(0);
    const SigmfJson& ranges = member(global, "sarsim:slant_range_m");
    if (ranges.is_null()) return;
    const bool numbers = ranges.is_array() && std::ranges::all_of(ranges, [](const SigmfJson& r) {
                           return r.is_number() && std::isfinite(r.get<double>());
                         });
    if (!numbers) return refuse("sarsim:slant_range_m", "is no list of numbers", shown_json(ranges), "[ ... ]");
    for (const SigmfJson& range : ranges) meta_.range_m.push_back(range.get<double>());
  }

  // What the samples are.
  void take_global(const SigmfJson& global) {
    meta_.datatype = text(global, "core:datatype");
    constexpr double min_rate_hz = 1e-9;
    meta_.sample_rate_hz = number(global, "core:sample_rate", min_rate_hz);
    if (const auto channels = whole(global, "core:num_channels"); channels && *channels != 1)
      refuse("core:num_channels", "other than 1 is not read", fmt::format("{}", *channels), "1",
             "store each channel as a recording of its own");
    if (const std::string version = text(global, "core:version"); !version.empty())
      if (const std::string major = version.substr(0, version.find('.')); major != "0" && major != "1")
        refuse("core:version", "is not known", core::quoted_word(version), "1.x");
    take_extensions(member(global, "core:extensions"));
  }

  // Only those that say so are optional.
  void take_extensions(const SigmfJson& extensions) {
    // Before version 1.0 they were an object, and all of them optional.
    if (extensions.is_null() || extensions.is_object()) return;
    if (!extensions.is_array()) return refuse("core:extensions", "are no list", shown_json(extensions), "[ { ... } ]");
    for (const SigmfJson& extension : extensions) {
      const SigmfJson& name = extension.is_object() ? member(extension, "name") : extension;
      if (member(extension, "optional") == true || name == "sarsim") continue;
      refuse("core:extensions", "asks for one that is not known", shown_json(name),
             "extensions that are optional, by \"optional\": true",
             "the samples may mean something else with it: convert the recording with the program that wrote it");
    }
  }

  // Where they are.
  void take_places(const SigmfJson& global) {
    if (member(global, "core:metadata_only") == true)
      refuse("core:metadata_only", "says that there are no samples", "true", "false, or none");
    if (const std::string name = text(global, "core:dataset"); !name.empty() && name != data_.filename().string())
      refuse("core:dataset", "names another file of samples", core::quoted_word(name), data_.filename().string(),
             "give that file this name");
    meta_.trailing_bytes = whole(global, "core:trailing_bytes").value_or(0);
    offset_ = whole(global, "core:offset").value_or(0);
    meta_.sha512 = core::lower_case(text(global, "core:sha512"));
    const bool digits = meta_.sha512.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!meta_.sha512.empty() && (meta_.sha512.size() != 128 || !digits))
      refuse("core:sha512", "is no checksum", core::quoted_word(meta_.sha512), "128 hexadecimal digits");
  }

  void take_captures(const SigmfJson& captures) {
    for (const auto& capture : captures) {
      if (!capture.is_object()) return refuse("captures", "holds something else", shown_json(capture), "{ ... }");
      const bool first = &capture == &captures.front();
      const std::uint64_t start = whole(capture, "core:sample_start").value_or(offset_);
      const std::uint64_t header = whole(capture, "core:header_bytes").value_or(0);
      if (start < offset_)
        refuse("core:sample_start", "lies before core:offset", fmt::format("{}", start), fmt::format("{}", offset_));
      if (!first && start < offset_ + meta_.starts.back())
        refuse("core:sample_start", "goes backwards", fmt::format("{}", start), "captures in order");
      if (first)
        meta_.header_bytes = header;
      else if (header > 0)
        refuse("core:header_bytes", "within the samples is not read", fmt::format("{}", header),
               "0 but in the first capture", "store the samples without headers");
      if (problem_) return;
      meta_.starts.push_back(start - offset_);
      if (const auto index = whole(capture, "core:global_index")) meta_.indices.push_back(*index);
      constexpr double any = -std::numeric_limits<double>::infinity();
      if (const auto time = number(capture, "sarsim:pulse_time_s", any)) meta_.time_s.push_back(*time);
      if (const auto carrier = number(capture, "core:frequency", any)) meta_.carrier_hz.push_back(*carrier);
    }
    // Captures as long as one another are pulses, and all of those that say how long a pulse is.
    meta_.columns_of_captures = meta_.columns > 0 && meta_.starts.size() > 1;
    if (meta_.columns > 0 || meta_.starts.size() < 2 || meta_.starts.front() != 0) return;
    const std::uint64_t step = meta_.starts[1];
    bool equal = step > 0;
    for (std::size_t i = 1; i < meta_.starts.size(); ++i)
      equal = equal && meta_.starts[i] - meta_.starts[i - 1] == step;
    if (equal) meta_.columns = step;
    meta_.columns_of_captures = equal;
  }

  const std::filesystem::path& data_;
  SigmfMeta meta_;
  std::uint64_t offset_ = 0;
  std::string twice_;
  std::optional<core::Problem> problem_;
};

}  // namespace

std::variant<SigmfMeta, core::Problem> parse_sigmf_meta(std::string_view text, const std::filesystem::path& data) {
  return SigmfReader(data).read(text);
}

std::optional<core::Problem> misfit_of_meta(const SigmfMeta& meta, std::uint64_t rows, std::uint64_t columns) {
  const auto count = [](std::uint64_t found, const char* what) { return fmt::format("{} {}", found, what); };
  if (!meta.starts.empty() && meta.starts.back() >= rows * columns)
    return problem_of_key("core:sample_start", "of a capture lies behind the last sample",
                          fmt::format("{}", meta.starts.back()), fmt::format("below {}", rows * columns),
                          "the file of samples is cut off, or belongs to other metadata");
  const bool each_row = meta.columns_of_captures || !meta.time_s.empty();
  if (each_row && meta.starts.size() != rows)
    return problem_of_key("captures", "are not as many as the rows of samples", count(meta.starts.size(), "captures"),
                          count(rows, "rows"), "the file of samples belongs to other metadata");
  if (!meta.range_m.empty() && meta.range_m.size() != columns)
    return problem_of_key("sarsim:slant_range_m", "has not the length of a row", count(meta.range_m.size(), "ranges"),
                          count(columns, "samples"), "correct sarsim:samples_per_pulse");
  for (std::size_t i = 0; each_row && i < meta.starts.size(); ++i)
    if (meta.starts[i] != i * columns)
      return problem_of_key("core:sample_start", fmt::format("of capture {} is not that of a row", i),
                            fmt::format("{}", meta.starts[i]), fmt::format("{}", i * columns),
                            "correct sarsim:samples_per_pulse");
  // Rows of captures may have any time between them; other rows would go across a gap.
  for (std::size_t i = 1; !each_row && meta.indices.size() == meta.starts.size() && i < meta.starts.size(); ++i)
    if (meta.indices[i] - meta.indices[0] != meta.starts[i] - meta.starts[0])
      return problem_of_key("core:global_index", fmt::format("of capture {} leaves a gap within the samples", i),
                            fmt::format("{}", meta.indices[i]),
                            fmt::format("{}", meta.indices[0] + meta.starts[i] - meta.starts[0]),
                            "store what lies before and behind the gap as recordings of their own");
  return std::nullopt;
}

}  // namespace sarsim::raster
