#include "raster/parts/stored_product.hpp"

#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/hash/checksum.hpp"
#include "core/os/raw_file.hpp"
#include "core/report/invalid_request.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/formats.hpp"
#include "scene/schema/option_words.hpp"

namespace sarsim::raster {

namespace {

constexpr std::uint64_t format_mark = 0x31'74'72'61'70'72'73'04U;
// The mark and the checksum are there; more than 180 million pulses with their times, carriers and poses are not.
constexpr std::uint64_t min_bytes = 2 * sizeof(std::uint64_t);
constexpr std::uint64_t max_bytes = std::uint64_t{1} << 34U;

// A part that enters the folder writes the file where it is missing.
[[noreturn]] void refuse(const std::filesystem::path& path, std::string message, std::string found,
                         std::string expected) {
  std::string hint = "run one of the parts again with --resume, which writes the file anew";
  if (!found.empty()) hint = "delete it; then " + hint;
  throw core::InvalidRequest(core::Problems{
      file_problem(path.string(), std::move(message), std::move(found), std::move(expected), std::move(hint))});
}

using Axis = std::function<double(std::size_t)>;
using Poses = std::function<RowPose(std::size_t)>;

// Words of 64 bits and texts, one after the other; a checksum at the end.
class Packer {
 public:
  void put(std::uint64_t word) { add(std::as_bytes(std::span(&word, 1))); }
  void put_real(double value) {
    std::uint64_t word = 0;
    std::memcpy(&word, &value, sizeof word);
    put(word);
  }
  void put_text(const std::string& text) {
    put(text.size());
    add(std::as_bytes(std::span(text)));
  }
  void put_axis(const Axis& axis, std::size_t count) {
    put(axis ? count : 0);
    for (std::size_t i = 0; axis && i < count; ++i) put_real(axis(i));
  }
  void put_poses(const Poses& poses, std::size_t count) {
    put(poses ? count : 0);
    for (std::size_t i = 0; poses && i < count; ++i) {
      const RowPose pose = poses(i);
      for (const auto& triple : {pose.position_m, pose.velocity_mps, pose.rotation_rad})
        for (const double value : triple) put_real(value);
    }
  }
  std::vector<std::byte> take() {
    core::Checksum sum;
    sum.add(bytes_);
    put(sum.value());
    return std::move(bytes_);
  }

 private:
  void add(std::span<const std::byte> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  std::vector<std::byte> bytes_;
};

class Unpacker {
 public:
  // At least `min_bytes`.
  Unpacker(std::span<const std::byte> bytes, std::filesystem::path path) : rest_(bytes), path_(std::move(path)) {
    core::Checksum sum;
    const std::size_t content = rest_.size() - sizeof(std::uint64_t);
    sum.add(rest_.first(content));
    std::uint64_t expected = 0;
    std::memcpy(&expected, rest_.data() + content, sizeof expected);
    if (sum.value() != expected) fail();
    rest_ = rest_.first(content);
  }

  [[nodiscard]] std::uint64_t word() {
    std::uint64_t value = 0;
    std::memcpy(&value, piece(sizeof value).data(), sizeof value);
    return value;
  }
  [[nodiscard]] double real() {
    const std::uint64_t value = word();
    double number = 0.0;
    std::memcpy(&number, &value, sizeof number);
    return number;
  }
  [[nodiscard]] std::string text() {
    const auto bytes = piece(word());
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  [[nodiscard]] Axis axis() {
    const std::uint64_t count = word();
    if (count == 0) return {};
    const auto values = std::make_shared<std::vector<double>>();
    for (std::uint64_t i = 0; i < count; ++i) values->push_back(real());
    return [values](std::size_t i) { return values->at(i); };
  }
  [[nodiscard]] Poses poses() {
    const std::uint64_t count = word();
    if (count == 0) return {};
    const auto values = std::make_shared<std::vector<RowPose>>();
    for (std::uint64_t i = 0; i < count; ++i) {
      RowPose pose;
      for (auto* triple : {&pose.position_m, &pose.velocity_mps, &pose.rotation_rad})
        for (double& value : *triple) value = real();
      values->push_back(pose);
    }
    return [values](std::size_t i) { return values->at(i); };
  }
  [[noreturn]] void fail() const {
    refuse(path_, "the description of the recording is damaged", "bytes that do not fit together or their checksum",
           "what a part of this version of the program wrote");
  }

 private:
  std::span<const std::byte> piece(std::uint64_t size) {
    if (size > rest_.size()) fail();
    const auto bytes = rest_.first(static_cast<std::size_t>(size));
    rest_ = rest_.subspan(static_cast<std::size_t>(size));
    return bytes;
  }

  std::span<const std::byte> rest_;
  std::filesystem::path path_;
};

// All bytes of the file, once its beginning and its size are those of a description.
std::vector<std::byte> bytes_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored) && !ignored)
    refuse(path, "the description of the recording is missing", {}, "the file that each part leaves in the folder");
  const core::RawFile file(path, core::RawFile::Mode::read);
  const std::uint64_t size = file.size();
  if (size < min_bytes || size > max_bytes)
    refuse(path, "the size is not that of the description of a recording", fmt::format("{} bytes", size),
           fmt::format("{} to {} bytes", min_bytes, max_bytes));
  std::uint64_t mark = 0;
  if (!file.read_at(0, std::as_writable_bytes(std::span(&mark, 1))) || mark != format_mark)
    refuse(path, "this is not the description of a recording", "another kind of file, or another version of it",
           "what a part of this version of the program wrote");
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  static_cast<void>(file.read_at(0, bytes));
  return bytes;
}

}  // namespace

void store_product(const std::filesystem::path& path, const StoredProduct& stored) {
  const Product& product = stored.product;
  const bool axes = format_of(stored.options.format).carries_axes;
  Packer packer;
  packer.put(format_mark);
  packer.put_text(product.radar);
  packer.put(static_cast<std::uint64_t>(product.processing));
  packer.put(product.rows);
  packer.put(product.columns);
  packer.put_real(product.sample_rate_hz);
  packer.put(static_cast<std::uint64_t>(product.bits));
  packer.put_real(product.lsb_v);
  packer.put(product.options.seed);
  packer.put_real(product.options.tolerance);
  for (const auto& [id, word] : scene::option_words(product.options)) packer.put_text(word);
  packer.put_text(product.engine);
  packer.put_text(product.script);
  packer.put(static_cast<std::uint64_t>(stored.options.format));
  packer.put(static_cast<std::uint64_t>(stored.options.counts));
  packer.put(static_cast<std::uint64_t>(stored.options.header));
  packer.put(static_cast<std::uint64_t>(stored.options.doubles));
  packer.put(static_cast<std::uint64_t>(stored.estimate_lsb));
  packer.put_text(stored.engine_reason);
  packer.put(stored.identity.size());
  for (const auto& [name, value] : stored.identity) {
    packer.put_text(name);
    packer.put_text(value);
  }
  packer.put_axis(axes ? product.row_time_s : Axis(), product.rows);
  packer.put_axis(axes ? product.row_carrier_hz : Axis(), product.rows);
  packer.put_axis(axes ? product.column_range_m : Axis(), product.columns);
  packer.put_poses(axes ? product.row_pose : Poses(), product.rows);
  static_cast<void>(core::replace_file(path, packer.take()));
}

StoredProduct load_product(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = bytes_of(path);
  Unpacker from(bytes, path);
  static_cast<void>(from.word());  // The mark.
  StoredProduct stored;
  Product& product = stored.product;
  product.radar = from.text();
  product.processing = static_cast<scene::Processing>(from.word());
  product.rows = from.word();
  product.columns = from.word();
  product.sample_rate_hz = from.real();
  product.bits = static_cast<int>(from.word());
  product.lsb_v = from.real();
  product.options.seed = from.word();
  product.options.tolerance = from.real();
  for (const auto& [id, word] : scene::option_words(product.options))
    if (!scene::take_option_word(product.options, id, from.text())) from.fail();
  product.engine = from.text();
  product.script = from.text();
  stored.options.format = static_cast<scene::FileFormat>(from.word());
  stored.options.counts = from.word() != 0;
  stored.options.header = from.word() != 0;
  stored.options.doubles = from.word() != 0;
  stored.estimate_lsb = from.word() != 0;
  stored.engine_reason = from.text();
  for (std::uint64_t left = from.word(); left > 0; --left) {
    std::string name = from.text();
    stored.identity.emplace_back(std::move(name), from.text());
  }
  product.row_time_s = from.axis();
  product.row_carrier_hz = from.axis();
  product.column_range_m = from.axis();
  product.row_pose = from.poses();
  return stored;
}

}  // namespace sarsim::raster
