#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "raster/format/data_test_support.hpp"
#include "raster/hdf5/hdf5_library.hpp"
#include "raster/table/product_attributes.hpp"

// The dimension scales of our files, as the HDF5 specification has them; tests/references reads them with xarray.
namespace sarsim::raster {
namespace hdf5_scales_test {

using namespace data_test;
using testing::ElementsAre;

using Names = std::vector<std::string>;

std::string name_of(hid_t object) {
  std::array<char, 64> name{};
  H5Iget_name(object, name.data(), name.size());
  return name.data();
}

std::string fixed_text(hid_t object, const char* attribute) {
  if (H5Aexists(object, attribute) <= 0) return {};
  const Hdf5Handle opened(H5Aopen(object, attribute, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(opened.get()), H5Tclose);
  if (H5Tis_variable_str(type.get()) > 0) return "a text of variable length";
  std::string text(H5Tget_size(type.get()), '?');
  H5Aread(opened.get(), type.get(), text.data());
  return text;
}

std::string text_attribute(hid_t object, const char* attribute) {
  if (H5Aexists(object, attribute) <= 0) return {};
  const Hdf5Handle opened(H5Aopen(object, attribute, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(opened.get()), H5Tclose);
  char* text = nullptr;
  H5Aread(opened.get(), type.get(), static_cast<void*>(&text));
  std::string result = text == nullptr ? "" : text;
  H5free_memory(text);
  return result;
}

std::string name_at(hid_t file, hobj_ref_t reference) {
  const Hdf5Handle object(H5Rdereference2(file, H5P_DEFAULT, H5R_OBJECT, &reference), H5Oclose);
  return object ? name_of(object.get()) : "nothing";
}

// A file that stays open, and what its scales say.
class Scaled {
 public:
  explicit Scaled(const fs::path& path) : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose) {}

  [[nodiscard]] Hdf5Handle dataset(const char* name) const {
    return {H5Dopen2(file_.get(), name, H5P_DEFAULT), H5Dclose};
  }
  [[nodiscard]] bool has(const char* name) const { return H5Lexists(file_.get(), name, H5P_DEFAULT) > 0; }

  // The scales of a dataset's dimensions.
  [[nodiscard]] Names dimensions(const char* name) const {
    const Hdf5Handle set = dataset(name);
    if (H5Aexists(set.get(), "DIMENSION_LIST") <= 0) return {};
    const Hdf5Handle list(H5Aopen(set.get(), "DIMENSION_LIST", H5P_DEFAULT), H5Aclose);
    const Hdf5Handle space(H5Aget_space(list.get()), H5Sclose);
    const Hdf5Handle type(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose);
    std::vector<hvl_t> of_dimension(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
    H5Aread(list.get(), type.get(), of_dimension.data());
    Names names;
    for (const hvl_t& references : of_dimension)
      names.push_back(references.len == 1 ? name_at(file_.get(), *static_cast<const hobj_ref_t*>(references.p))
                                          : "not one");
    H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, of_dimension.data());
    return names;
  }

  // Where a scale is used: "/samples 1".
  [[nodiscard]] Names uses(const char* scale) const {
    struct Use {
      hobj_ref_t dataset;
      std::int32_t dimension;
    };
    const Hdf5Handle set = dataset(scale);
    if (H5Aexists(set.get(), "REFERENCE_LIST") <= 0) return {};
    const Hdf5Handle list(H5Aopen(set.get(), "REFERENCE_LIST", H5P_DEFAULT), H5Aclose);
    const Hdf5Handle space(H5Aget_space(list.get()), H5Sclose);
    const Hdf5Handle type(H5Tcreate(H5T_COMPOUND, sizeof(Use)), H5Tclose);
    H5Tinsert(type.get(), "dataset", HOFFSET(Use, dataset), H5T_STD_REF_OBJ);
    H5Tinsert(type.get(), "dimension", HOFFSET(Use, dimension), H5T_NATIVE_INT32);
    std::vector<Use> uses(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
    H5Aread(list.get(), type.get(), uses.data());
    Names names;
    for (const Use& use : uses)
      names.push_back(name_at(file_.get(), use.dataset) + " " + std::to_string(use.dimension));
    return names;
  }

 private:
  Hdf5Use use_;
  Hdf5Handle file_;
};

const std::string scale_class("DIMENSION_SCALE", 16);  // With the zero at its end.

// Of a list whose references lead nowhere the library cannot close itself; it says so nowhere.
TEST(Hdf5Scales, ThatCannotBeFollowedLeaveTheLibrarySilentAtItsEnd) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const TestFolder folder;
  write_test_file(folder / "a.h5", test_product(5, 7, 12), {scene::FileFormat::hdf5});
  const std::string sound = contents(folder / "a.h5");
  const std::size_t list = sound.find("DIMENSION_LIST");
  ASSERT_NE(list, std::string::npos);
  for (const std::size_t at : {64U, 67U, 75U, 79U}) {
    std::string damaged = sound;
    damaged[list + at] = '\xFF';
    put(folder / "b.h5", damaged);
    EXPECT_EXIT((static_cast<void>(open_raster(Integrity::whole, folder / "b.h5")), std::exit(0)),
                testing::ExitedWithCode(0), testing::StrEq(""))
        << at;
  }
}

TEST(Hdf5Scales, TimesAndRangesNameTheDimensionsOfRecordings) {
  const TestFolder folder;
  write_test_file(folder / "a.h5", test_product(5, 7, 12), {scene::FileFormat::hdf5});
  const Scaled file(folder / "a.h5");
  EXPECT_THAT(file.dimensions("samples"), ElementsAre("/pulse_time_s", "/slant_range_m"));
  EXPECT_THAT(file.dimensions("carrier_hz"), ElementsAre("/pulse_time_s"));
  EXPECT_THAT(file.dimensions("platform_velocity_mps"), ElementsAre("/pulse_time_s", "/world_axis"));
  EXPECT_THAT(file.uses("slant_range_m"), ElementsAre("/samples 1"));
  EXPECT_THAT(file.uses("pulse_time_s"),
              ElementsAre("/carrier_hz 0", "/platform_position_m 0", "/platform_velocity_mps 0",
                          "/platform_rotation_rad 0", "/samples 0"));
  EXPECT_THAT(file.uses("world_axis"),
              ElementsAre("/platform_position_m 1", "/platform_velocity_mps 1", "/platform_rotation_rad 1"));
  for (const char* scale : {"pulse_time_s", "slant_range_m", "world_axis"}) {
    EXPECT_EQ(fixed_text(file.dataset(scale).get(), "CLASS"), scale_class) << scale;
    EXPECT_EQ(fixed_text(file.dataset(scale).get(), "NAME"), std::string(scale) + '\0') << scale;
    EXPECT_TRUE(file.dimensions(scale).empty()) << scale;  // Scales have none themselves.
  }
  EXPECT_EQ(text_attribute(file.dataset("samples").get(), "coordinates"), "carrier_hz");
  EXPECT_EQ(text_attribute(file.dataset("samples").get(), "units"), "V");
  EXPECT_EQ(text_attribute(file.dataset("platform_velocity_mps").get(), "units"), "m s-1");
  EXPECT_EQ(text_attribute(file.dataset("slant_range_m").get(), "long_name"), "one-way slant range");
}

TEST(Hdf5Scales, DimensionsWithoutCoordinatesHaveNamesAndLengthsOnly) {
  const TestFolder folder;
  Product product = test_product(5, 7, 12);
  product.row_time_s = {};
  product.row_carrier_hz = {};
  product.row_pose = {};
  product.column_range_m = {};
  write_test_file(folder / "a.h5", product, {.format = scene::FileFormat::hdf5, .counts = true});
  const Scaled file(folder / "a.h5");
  EXPECT_THAT(file.dimensions("samples"), ElementsAre("/pulse", "/sample"));
  EXPECT_EQ(fixed_text(file.dataset("sample").get(), "NAME"),
            std::string("This is a netCDF dimension but not a netCDF variable.         7") + '\0');
  EXPECT_EQ(H5Dget_storage_size(file.dataset("sample").get()), 0U);
  EXPECT_FALSE(file.has("world_axis"));
  EXPECT_EQ(text_attribute(file.dataset("samples").get(), "coordinates"), "");
  EXPECT_EQ(text_attribute(file.dataset("samples").get(), "units"), "count");
}

TEST(Hdf5Scales, ImagesHaveTheirOwnAxesAndMaps) {
  const TestFolder folder;
  Product product = test_product(5, 7, 12);
  product.image.rows = "azimuth_m";
  product.image.row_m = [](std::size_t row) { return 10.0 * static_cast<double>(row); };
  product.image.columns = "ground_range_m";
  product.image.facts = {{"geospatial_lat_min", -1.5}, {"geospatial_bounds", "POLYGON"}};
  product.image.map = {{"grid_mapping_name", "transverse_mercator"}, {"false_easting", 500e3}};
  write_test_file(folder / "a.h5", product, {scene::FileFormat::hdf5});
  {
    const Scaled file(folder / "a.h5");
    EXPECT_THAT(file.dimensions("samples"), ElementsAre("/azimuth_m", "/ground_range_m"));
    EXPECT_THAT(file.dimensions("pulse_time_s"), ElementsAre("/azimuth_m"));
    EXPECT_EQ(text_attribute(file.dataset("samples").get(), "coordinates"), "pulse_time_s carrier_hz");
    EXPECT_EQ(text_attribute(file.dataset("samples").get(), "grid_mapping"), "utm");
    EXPECT_EQ(text_attribute(file.dataset("utm").get(), "grid_mapping_name"), "transverse_mercator");
    EXPECT_EQ(text_attribute(file.dataset("azimuth_m").get(), "long_name"), "place along the track");
    EXPECT_FALSE(file.has("slant_range_m"));
  }
  const auto opened = open_raster(Integrity::whole, folder / "a.h5");
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_EQ(attribute_of(opened.raster->info().attributes, "geospatial_lat_min"), "-1.5");
  EXPECT_EQ(attribute_of(opened.raster->info().attributes, "geospatial_bounds"), "POLYGON");
  const auto axes = opened.raster->axes();
  ASSERT_TRUE(axes);
  EXPECT_EQ(axes->row_axis, "azimuth_m");
  EXPECT_EQ(axes->row_m, (std::vector<double>{0.0, 10.0, 20.0, 30.0, 40.0}));
  EXPECT_EQ(axes->column_axis, "ground_range_m");
  EXPECT_EQ(axes->column_range_m[1], 1001.5);
}

TEST(Hdf5Scales, SamplesHaveATypeWithAName) {
  const TestFolder folder;
  write_test_file(folder / "a.h5", test_product(2, 3, 12), {scene::FileFormat::hdf5});
  const Scaled file(folder / "a.h5");
  const Hdf5Handle type(H5Dget_type(file.dataset("samples").get()), H5Tclose);
  EXPECT_GT(H5Tcommitted(type.get()), 0);
  EXPECT_EQ(name_of(type.get()), "/complex");
}

// The library fills what it does not use of its structures, also of the lists of references.
TEST(Hdf5Scales, TheSameProductGivesTheSameBytes) {
  const TestFolder folder;
  for (const std::size_t rows : {3U, 9000U}) {
    write_test_file(folder / "a.h5", test_product(rows, 7, 12), {scene::FileFormat::hdf5, true});
    const std::vector<char> dirty(1U << 22U, '\x5a');  // Memory that is not zero when it is used again.
    const std::string first = contents(folder / "a.h5");
    write_test_file(folder / "b.h5", test_product(rows, 7, 12), {scene::FileFormat::hdf5, true});
    EXPECT_EQ(first, contents(folder / "b.h5")) << dirty.size();
  }
}

}  // namespace hdf5_scales_test
}  // namespace sarsim::raster
