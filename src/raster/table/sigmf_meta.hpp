#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "raster/table/product_attributes.hpp"

namespace sarsim::raster {

/// The metadata of a SigMF recording about its samples.
struct SigmfMeta {
  std::string datatype;
  std::uint64_t columns = 0;         ///< Samples of a row; 0: not said.
  bool columns_of_captures = false;  ///< Each capture is a row.
  std::optional<double> sample_rate_hz;
  FileAttributes attributes;           ///< Those of the name space `sarsim`.
  std::vector<double> range_m;         ///< Empty where they do not say.
  std::vector<std::uint64_t> starts;   ///< First sample of each capture, from that of the file on.
  std::vector<std::uint64_t> indices;  ///< Its core:global_index; shorter where one has none.
  std::vector<double> time_s;          ///< Of each capture; shorter where one says none.
  std::vector<double> carrier_hz;      ///< The same.
  std::uint64_t header_bytes = 0;      ///< Bytes before the first sample in the file of samples.
  std::uint64_t trailing_bytes = 0;    ///< Bytes after the last sample.
  std::string sha512 = {};             ///< Of that file, in lower case; empty where they do not say.
};

/// Reads metadata. The keys of SigMF that locate samples are honoured: `core:header_bytes` of the first capture,
/// `core:trailing_bytes`, `core:offset`. InvalidRequest by name: several channels, metadata without samples, samples
/// in a file of another name, headers within the samples, extensions that are not optional, keys of the wrong type or
/// that are there twice, captures that are not in order.
/// @param text  of the file of metadata
/// @param data  name of the file of samples
[[nodiscard]] std::variant<SigmfMeta, core::Problem> parse_sigmf_meta(std::string_view text,
                                                                      const std::filesystem::path& data);

/// The error of metadata that contradict the samples: numbers of captures, times or ranges that match neither the rows
/// nor the samples of a row. Nothing if all match. A problem without a place.
[[nodiscard]] std::optional<core::Problem> misfit_of_meta(const SigmfMeta& meta, std::uint64_t rows,
                                                          std::uint64_t columns);

}  // namespace sarsim::raster
