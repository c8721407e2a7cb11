#include "raster/table/described_product.hpp"

#include <algorithm>

#include "core/build/version.hpp"
#include "core/report/expect.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "raster/table/axis_labels.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/pose_axes.hpp"

namespace sarsim::raster {

namespace {

constexpr std::int32_t format_version = 1;

void add_facts(Attributes& attributes, const Facts& facts) {
  for (const auto& [name, value] : facts) std::visit([&](const auto& v) { attributes.emplace_back(name, v); }, value);
}

Attributes root_attributes(const Product& product, const FileAttributes& option_words) {
  Attributes root{{"Conventions", std::string("CF-1.8")},
                  {"format_version", format_version},
                  {"program_version", std::string(core::program_version)}};
  const auto put = [&](const std::string& name, AttributeValue value) {
    if (is_known(product, name)) root.emplace_back(name, std::move(value));
  };
  put("script", product.script);
  put("radar", product.radar);
  put("processing", attribute_word(product.processing));
  for (const auto& [name, word] : option_words) put(name, word);
  put("seed", product.options.seed);
  put("engine", product.engine);
  put("tolerance", product.options.tolerance);
  put("sample_rate_hz", product.sample_rate_hz);
  put("bits", static_cast<std::int32_t>(product.bits));
  put("lsb_v", product.lsb_v);
  add_facts(root, product.image.facts);
  return root;
}

Attributes words_for(const char* units, const char* long_name) {
  return {{"units", std::string(units)}, {"long_name", std::string(long_name)}};
}

class Describer {
 public:
  explicit Describer(const Product& product) : product_(product) {}

  DescribedProduct describe(const FileAttributes& option_words, bool counts) {
    const ImageAxes& image = product_.image;
    described_.root = root_attributes(product_, option_words);
    // Times name the rows of recordings and go with those of images.
    described_.down = image.row_m ? image.rows : product_.row_time_s ? "pulse_time_s" : "pulse";
    described_.across = product_.column_range_m ? image.columns : "sample";
    add(image.columns, Along::columns, product_.column_range_m);
    add(image.rows, Along::rows, image.row_m);
    add("pulse_time_s", Along::rows, product_.row_time_s);
    // Of a recording; images and profiles have times of their own.
    if (product_.row_time_s && product_.processing != scene::Processing::srp && is_known(product_, "processing"))
      described_.arrays.back().attributes.emplace_back("meaning",
                                                       std::string("when the middle of the pulse leaves, s"));
    add("carrier_hz", Along::rows, product_.row_carrier_hz);
    std::string with_rows;
    for (const DescribedArray& array : described_.arrays)
      if (!array.is_coordinate()) with_rows += (with_rows.empty() ? "" : " ") + array.name;
    add_poses();
    const std::string unit = counts ? "count" : "V";
    described_.samples = {{"unit", unit}, {"units", unit}, {"long_name", std::string("complex envelope")}};
    if (!with_rows.empty()) described_.samples.emplace_back("coordinates", with_rows);
    if (!image.map.empty()) described_.samples.emplace_back("grid_mapping", std::string(map_name));
    add_facts(described_.map, image.map);
    return std::move(described_);
  }

 private:
  void add(const std::string& name, Along along, const std::function<double(std::size_t)>& axis) {
    if (!axis) return;
    const AxisLabels* const words = words_of_axis(name);
    CORE_EXPECT(words != nullptr);
    described_.arrays.push_back(
        {.name = words->name,
         .dimensions = {along == Along::rows ? described_.down : described_.across},
         .attributes = words_for(words->units, words->long_name),
         .along = along,
         .values = [axis](std::size_t i, std::span<double> numbers) { numbers.front() = axis(i); }});
  }

  void add_poses() {
    if (!product_.row_pose) return;
    described_.arrays.push_back({.name = "world_axis", .dimensions = {"world_axis"}, .words = {"x", "y", "z"}});
    for (const PoseAxis& axis : pose_axes) {
      DescribedArray array{.name = axis.name,
                           .dimensions = {described_.down, "world_axis"},
                           .attributes = words_for(axis.units, axis.long_name),
                           .along = Along::rows,
                           .width = 3};
      array.attributes.emplace_back("meaning", std::string(axis.meaning));
      array.values = [pose = product_.row_pose, part = axis.part](std::size_t i, std::span<double> numbers) {
        std::ranges::copy(pose(i).*part, numbers.begin());
      };
      described_.arrays.push_back(std::move(array));
    }
  }

  const Product& product_;
  DescribedProduct described_;
};

// Numbers that a file says of itself, from the text of an attribute.
std::optional<double> known_number(const FileAttributes& attributes, std::string_view name) {
  const auto found =
      std::ranges::find(attributes, name, [](const auto& pair) -> std::string_view { return pair.first; });
  return found == attributes.end() ? std::nullopt : core::parse_number(found->second);
}

// Attributes of these names in files of other programs are theirs: all of ours say which program wrote them.
std::optional<core::Problem> problem_of_own_words(const ArrayAttributes& root) {
  if (attribute_of(root.known, "program_version").empty()) return std::nullopt;
  const auto unknown = [](std::string found) {
    return file_problem({}, "format_version of the file is not known", std::move(found),
                        core::format_number(format_version), "a newer version of sarsim wrote it");
  };
  for (const auto& [name, found] : root.unreadable) {
    if (name == "format_version") return unknown(found);
    if (name == "processing")
      return file_problem({}, "processing of the file cannot be read", found, "raw, matched_filter or srp",
                          "write it as one word");
  }
  const std::string version = attribute_of(root.known, "format_version");
  if (version.empty() || core::parse_number(version) == format_version) return std::nullopt;
  return unknown(core::quoted_word(version));
}

}  // namespace

DescribedProduct describe(const Product& product, const FileAttributes& option_words, bool counts) {
  return Describer(product).describe(option_words, counts);
}

std::optional<core::Problem> problem_of_root(const ArrayAttributes& root) {
  if (auto problem = problem_of_own_words(root)) return problem;
  for (const auto& [name, found] : root.unreadable)
    if (name == "lsb_v" || name == "sample_rate_hz" || name == "bits")
      return file_problem({}, name + " of the file cannot be read", found, "a number", "write it as one number");
  return std::nullopt;
}

void take_known_attributes(RasterInfo& info) {
  const auto positive = [&](std::string_view name) {
    const auto number = known_number(info.attributes, name);
    return number && *number > 0.0 ? number : std::nullopt;
  };
  const auto bits = known_number(info.attributes, "bits");
  if (bits && *bits >= 1.0 && *bits <= 64.0) info.bits = static_cast<int>(*bits);
  info.lsb_v = positive("lsb_v");
  info.sample_rate_hz = positive("sample_rate_hz");
}

std::optional<RasterAxes> read_axes(std::size_t rows, std::size_t columns, const AxisReader& read) {
  auto time = read("pulse_time_s", rows, 1);
  auto carrier = read("carrier_hz", rows, 1);
  if (!time || !carrier) return std::nullopt;
  RasterAxes axes{std::move(*time), std::move(*carrier), {}, {}};
  // The first axis of a kind that the file has.
  const auto find = [&](AxisOf kind, std::size_t length, std::string& name, std::vector<double>& values) {
    for (const AxisLabels& axis : axis_words) {
      if (axis.of != kind) continue;
      auto found = read(axis.name, length, 1);
      if (!found) continue;
      name = axis.name;
      values = std::move(*found);
      return true;
    }
    return false;
  };
  find(AxisOf::image_rows, rows, axes.row_axis, axes.row_m);
  if (!find(AxisOf::columns, columns, axes.column_axis, axes.column_range_m)) return std::nullopt;
  // All of where the platform is, or nothing, as in files of older versions.
  std::vector<RowPose> poses(rows);
  for (const PoseAxis& axis : pose_axes) {
    const auto values = read(axis.name, rows, 3);
    if (!values) return axes;
    for (std::size_t i = 0; i < rows; ++i) std::copy_n(values->data() + 3 * i, 3, (poses[i].*axis.part).begin());
  }
  axes.row_pose = std::move(poses);
  return axes;
}

}  // namespace sarsim::raster
