#include "workflow/input/cloud_input.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "raster/format/npy_header.hpp"
#include "scene/model/cloud_points.hpp"
#include "scene/model/world_frame.hpp"
#include "support/python.hpp"

namespace sarsim::workflow {
namespace cloud_input_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ReadClouds : public testing::Test {
 protected:
  ReadClouds() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~ReadClouds() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }

  template <class Number>
  void write_npy(const std::string& name, const std::vector<Number>& numbers, std::size_t columns,
                 bool fortran = false) const {
    const std::vector<std::size_t> shape{numbers.size() / columns, columns};
    std::string text = raster::npy_header_text(sizeof(Number) == 4 ? "<f4" : "<f8", shape);
    if (fortran) text.replace(text.find("False"), 5, "True ");
    write(name, text + std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)));
  }

  // The one cloud of a scene whose file this is.
  scene::Cloud read(const std::string& name, double rcs_m2 = 1.0, unsigned threads = 2) {
    scene::Scene scene;
    scene.clouds.emplace_back();
    scene.clouds[0].file = name;
    scene.clouds[0].rcs_m2 = rcs_m2;
    problems_ = read_clouds(scene, folder_, {threads});
    return scene.clouds[0];
  }

  void expect_refused(const std::string& name, const std::string& words) {
    EXPECT_FALSE(read(name).points) << name;
    ASSERT_EQ(problems_.size(), 1U) << name;
    EXPECT_EQ(problems_[0].severity, core::Severity::error);
    EXPECT_THAT(core::to_string(problems_[0]), HasSubstr(words));
    EXPECT_EQ(problems_[0].subject, (core::Subject{"cloud", 0, "file"}));
  }

  fs::path folder_ = fs::temp_directory_path() /
                     (std::string("clouds-") + testing::UnitTest::GetInstance()->current_test_info()->name());
  core::Problems problems_;
};

// A header of structures, as numpy.save writes it.
std::string structures_header(const std::string& fields, std::size_t points) {
  std::string text = raster::npy_header_text("<f8", std::vector<std::size_t>{points});
  const std::string old = "'<f8'";
  const std::size_t at = text.find(old);
  text.replace(at, old.size(), "[" + fields + "]");
  // What the padding of 64 bytes does not take up makes the header longer.
  std::string header = text.substr(10);
  header.resize((header.find_last_not_of(" \n") + 1 + 10 + 63) / 64 * 64 + 64 - 10 - 1, ' ');
  header += '\n';
  return text.substr(0, 8) + static_cast<char>(header.size() & 0xFFU) + static_cast<char>(header.size() >> 8U) + header;
}

TEST_F(ReadClouds, TakesStructuresByTheNamesOfTheirFields) {
  struct Point {
    double rcs, z;
    std::int32_t id;
    double x, y;
  } __attribute__((packed));
  const std::vector<Point> points{{4.0, 3.25, 1, 1.5, -2.0}, {0.25, 0.0, 2, -0.5, 1e6}};
  const std::string bytes(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(Point));
  const std::string fields = "('rcs', '<f8'), ('z', '<f8'), ('id', '<i4'), ('x', '<f8'), ('y', '<f8')";
  write("points.npy", structures_header(fields, 2) + bytes);
  const scene::Cloud cloud = read("points.npy");
  ASSERT_TRUE(cloud.points) << core::to_string(problems_.at(0));
  const radar::PointArrays& arrays = cloud.points->arrays;
  EXPECT_EQ(arrays.x_m, (std::vector<double>{1.5, -0.5}));
  EXPECT_EQ(arrays.y_m, (std::vector<double>{-2.0, 1e6}));
  EXPECT_EQ(arrays.z_m, (std::vector<double>{3.25, 0.0}));
  EXPECT_EQ(arrays.root_rcs_m, (std::vector<double>{2.0, 0.5}));
  write("without.npy", structures_header("('x', '<f8'), ('y', '<f8'), ('height', '<f8')", 2) + std::string(48, '\0'));
  expect_refused("without.npy", "x, y, height");
  write("mixed.npy", structures_header("('x', '<f8'), ('y', '<f4'), ('z', '<f8')", 2) + std::string(40, '\0'));
  expect_refused("mixed.npy", "'y' of the array is not of the type of the others");
  write("twice.npy",
        structures_header("('x', '<f8'), ('x_m', '<f8'), ('y', '<f8'), ('z', '<f8')", 2) + std::string(64, '\0'));
  expect_refused("twice.npy", "two fields of the array mean the same");
  write("cut.npy", structures_header("('x', '<f8'), ('y', '<f8'), ('z', '<f8')", 3) + std::string(48, '\0'));
  expect_refused("cut.npy", "shorter than its array");
  write("more.npy", structures_header("('x', '<f8'), ('y', '<f8'), ('z', '<f8')", 2) + std::string(56, '\0'));
  expect_refused("more.npy", "longer than its array");
}

TEST_F(ReadClouds, TakesTheSamePointsFromEachFormat) {
  const std::vector<double> rows{1.5, -2.0, 3.25, 4.0, -0.5, 1e6, 0.0, 0.25, 7.0, 8.0, 9.0, 0.0};
  std::vector<double> columns(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) columns[i % 4 * 3 + i / 4] = rows[i];
  write_npy("double.npy", rows, 4);
  write_npy("single.npy", std::vector<float>(rows.begin(), rows.end()), 4);
  write_npy("fortran.npy", columns, 4, true);
  write("named.csv", "# of a survey\nrcs,z,y,x,name\n4,3.25,-2,1.5,a\n0.25,0,1e6,-0.5,b\n\n0,9,8,7,c\n");
  write("bare.csv", "1.5;-2;3.25;4\n-0.5;1e6;0;0.25\n7;8;9;0");
  write("blanks.txt", "1.5  -2 3.25 4\r\n-0.5 1e6 0 0.25\r\n7 8 9 0\r\n");
  write("units.csv", "x [cm],y,z,rcs\n150,-2,3.25,4\n-50,1000 km,0,0.25\n700,8,9,0\n");
  const scene::Cloud first = read("double.npy");
  ASSERT_TRUE(first.points);
  const radar::PointArrays& points = first.points->arrays;
  EXPECT_EQ(points.x_m, (std::vector<double>{1.5, -0.5, 7.0}));
  EXPECT_EQ(points.y_m, (std::vector<double>{-2.0, 1e6, 8.0}));
  EXPECT_EQ(points.z_m, (std::vector<double>{3.25, 0.0, 9.0}));
  EXPECT_EQ(points.root_rcs_m, (std::vector<double>{2.0, 0.5, 0.0}));
  EXPECT_TRUE(first.points->own_rcs);
  EXPECT_EQ(first.points->min_m, (core::Vec3{-0.5, -2.0, 0.0}));
  EXPECT_EQ(first.points->max_m, (core::Vec3{7.0, 1e6, 9.0}));
  for (const char* name : {"single.npy", "fortran.npy", "named.csv", "bare.csv", "blanks.txt", "units.csv"}) {
    const scene::Cloud other = read(name);
    ASSERT_TRUE(other.points) << name << ": " << core::to_string(problems_.at(0));
    EXPECT_EQ(other.points->arrays.x_m, points.x_m) << name;
    EXPECT_EQ(other.points->arrays.y_m, points.y_m) << name;
    EXPECT_EQ(other.points->arrays.z_m, points.z_m) << name;
    EXPECT_EQ(other.points->arrays.root_rcs_m, points.root_rcs_m) << name;
    EXPECT_EQ(other.points->sum, first.points->sum) << name;
  }
}

TEST_F(ReadClouds, GiveAllPointsTheCloudsCrossSectionWhereTheTableHasNone) {
  write_npy("three.npy", std::vector<double>{1, 2, 3, 4, 5, 6}, 3);
  write("three.csv", "1,2,3\n4,5,6\n");
  write("empty.csv", "x,y,z,rcs\n1,2,3,\n4,5,6,9\n");
  write("decibels.csv", "x,y,z,rcs_dbsm\n1,2,3,20\n");
  for (const char* name : {"three.npy", "three.csv"}) {
    const scene::Cloud cloud = read(name, 6.25);
    ASSERT_TRUE(cloud.points) << name;
    EXPECT_FALSE(cloud.points->own_rcs);
    EXPECT_EQ(cloud.points->arrays.root_rcs_m, (std::vector<double>{2.5, 2.5})) << name;
  }
  EXPECT_EQ(read("empty.csv", 6.25).points->arrays.root_rcs_m, (std::vector<double>{2.5, 3.0}));
  EXPECT_EQ(read("decibels.csv").points->arrays.root_rcs_m, (std::vector<double>{10.0}));
}

TEST_F(ReadClouds, RefuseWhatIsNoTableOfPointsWithItsPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  write_npy("shape.npy", std::vector<double>(12, 1.0), 6);
  write_npy("flat.npy", std::vector<double>(12, 1.0), 1);
  write_npy("nan.npy", std::vector<double>{1, 2, 3, 4, nan, 6}, 3);
  write_npy("large.npy", std::vector<double>{1, 2, 3, 4, 5, 1e30}, 3);
  write_npy("phase.npy", std::vector<double>{1, 2, 3, 1, 0, 4, 5, 6, 1, 0.5}, 5);
  write("short.npy", raster::npy_header_text("<f8", std::vector<std::size_t>{1000, 3}) + "too short");
  write("whole.npy", raster::npy_header_text("<i4", std::vector<std::size_t>{1, 3}) + std::string(12, '\0'));
  write("word.csv", "x,y,z\n1,2,3\n\n4,five,6\n");
  write("nan.csv", "1,2,3\n1,2,nan\n");
  write("missing.csv", "1,2,3\n1,2\n");
  write("phase.csv", "x,y,z,rcs,phase\n1,2,3,4,5\n");
  write("columns.csv", "1,2,3,4,5\n");
  write("names.csv", "x,y,rcs\n1,2,3\n");
  write("nothing.csv", "x,y,z\n");
  write("bytes.dat", std::string("\0\1\2\3", 4));
  write("mac.csv", "1,2,3\r4,5,6\r");
  expect_refused("shape.npy", "(2, 6)");
  expect_refused("flat.npy", "not a table of points");
  expect_refused("nan.npy", "row 2, column 2 is not a number");
  expect_refused("large.npy", "row 2, column 3 is too large");
  expect_refused("phase.npy", "row 2 has a phase");
  expect_refused("short.npy", "shorter than its array");
  expect_refused("whole.npy", "float32 or float64");
  expect_refused("word.csv", "line 4: y:");
  expect_refused("nan.csv", "line 2: z");
  expect_refused("missing.csv", "line 2: z is missing");
  expect_refused("phase.csv", "column of phases");
  expect_refused("columns.csv", "5 columns");
  expect_refused("names.csv", "do not include z");
  expect_refused("nothing.csv", "no points");
  expect_refused("bytes.dat", "none of the formats");
  expect_refused("mac.csv", "carriage returns");
  expect_refused("absent.npy", "not there");
}

TEST_F(ReadClouds, WarnOfCrossSectionsBelowZero) {
  write_npy("dbsm.npy", std::vector<double>{1, 2, 3, -10, 4, 5, 6, 4}, 4);
  const scene::Cloud cloud = read("dbsm.npy");
  ASSERT_TRUE(cloud.points);
  EXPECT_EQ(cloud.points->arrays.root_rcs_m, (std::vector<double>{0.0, 2.0}));
  ASSERT_EQ(problems_.size(), 1U);
  EXPECT_EQ(problems_[0].severity, core::Severity::warning);
  EXPECT_THAT(core::to_string(problems_[0]), HasSubstr("1 of 2 points"));
}

// What Python's h5py writes, where it is there.
TEST_F(ReadClouds, TakeTheDatasetPointsOfHdf5Files) {
  const std::string script = fmt::format(
      "import h5py, numpy as n\n"
      "a = n.array([[1.5, -2, 3.25, 4], [-.5, 1e6, 0, .25], [7, 8, 9, 0]])\n"
      "def w(name, **k):\n"
      "    with h5py.File('{0}/' + name, 'w') as f:\n"
      "        for d, v in k.items(): f.create_dataset(d, data=v, chunks=(2, 2) if name == 'chunks.h5' else None)\n"
      "w('double.h5', points=a); w('single.h5', points=a.astype('f4')); w('big.h5', points=a.astype('>f8'))\n"
      "w('chunks.h5', points=a); w('other.h5', samples=a); w('wide.h5', points=n.zeros((4, 7)))\n"
      "w('words.h5', points=n.array([[b'a', b'b', b'c']]))\n"
      "w('whole.h5', points=n.array([[1, 2, 3]]))\n"
      "for i, (k, v) in enumerate([('_FillValue', -2.), ('valid_max', 1e5), ('units', n.array(['m', 'V'], 'S')),\n"
      "                            ('scale_factor', n.complex128(2)), ('_FillValue', n.nan)]):\n"
      "    w('key%d.h5' % i, points=a)\n"
      "    with h5py.File('{0}/key%d.h5' % i, 'r+') as f: f['points'].attrs[k] = v\n",
      folder_.string());
  write("make.py", script);
  if (std::system(fmt::format("{1} {0}/make.py > {0}/said 2>&1", folder_.string(), test::python()).c_str()) != 0)
    GTEST_SKIP() << "no h5py";
  write_npy("double.npy", std::vector<double>{1.5, -2.0, 3.25, 4.0, -0.5, 1e6, 0.0, 0.25, 7.0, 8.0, 9.0, 0.0}, 4);
  const scene::Cloud first = read("double.npy");
  for (const char* name : {"double.h5", "single.h5", "big.h5", "chunks.h5"}) {
    const scene::Cloud other = read(name);
    ASSERT_TRUE(other.points) << name << ": " << core::to_string(problems_.at(0));
    EXPECT_EQ(other.points->sum, first.points->sum) << name;
  }
  EXPECT_EQ(read("whole.h5").points->arrays.z_m, std::vector<double>{3.0});
  expect_refused("other.h5", "no dataset /points");
  expect_refused("wide.h5", "(4, 7)");
  expect_refused("words.h5", "does not hold numbers");
  expect_refused("key0.h5", "stands for none; found '-2 at position 1'");
  expect_refused("key1.h5", "stands for none; found '1e+06 at position 5'");
  expect_refused("key2.h5", "its attribute units cannot be followed");
  expect_refused("key3.h5", "its attribute scale_factor cannot be followed");
  EXPECT_TRUE(read("key4.h5").points);
  write("broken.h5", "\x89HDF\r\n\x1a\n" + std::string(1000, 'x'));
  expect_refused("broken.h5", "HDF5");
}

TEST_F(ReadClouds, LaysLatitudesInTheWorldOfTheEarth) {
  write("places.csv", "latitude,longitude,height,rcs\n-16.2,-76.2,50,4\n-16.25,-76 deg,0,9\n");
  write("pole.csv", "latitude,longitude,height\n90.5,0,0\n");
  expect_refused("places.csv", "the world is flat and has no latitudes");
  scene::Scene scene;
  scene.world.frame = scene::World::Frame::earth;
  scene.world.latitude = core::Angle::from_deg(-16.2);
  scene.world.longitude = core::Angle::from_deg(-76.2);
  scene.world.height_m = 50.0;
  scene.clouds.emplace_back().file = "places.csv";
  EXPECT_TRUE(read_clouds(scene, folder_).empty());
  ASSERT_TRUE(scene.clouds[0].points);
  const auto before = scene.clouds[0].points;
  EXPECT_EQ(before->arrays.x_m[0], 0.0);
  EXPECT_EQ(before->arrays.z_m[0], 0.0);
  const core::Vec3 second =
      scene::earth_of(scene.world)->world_of({core::rad_per_deg * -16.25, core::rad_per_deg * -76.0, 0.0});
  EXPECT_EQ(before->arrays.x_m[1], second.x);
  EXPECT_EQ(before->arrays.y_m[1], second.y);
  EXPECT_EQ(before->arrays.z_m[1], second.z);
  EXPECT_EQ(before->arrays.root_rcs_m, (std::vector<double>{2.0, 3.0}));

  EXPECT_TRUE(read_clouds(scene, folder_).empty());
  EXPECT_EQ(scene.clouds[0].points.get(), before.get());
  scene.world.height_m = 0.0;  // Another world: the points lie elsewhere in it.
  EXPECT_TRUE(read_clouds(scene, folder_).empty());
  EXPECT_NEAR(scene.clouds[0].points->arrays.z_m[0], 50.0, 1e-9);

  scene.platforms.emplace_back().name = "Ship";
  scene.clouds[0].platform = "Ship";
  EXPECT_THAT(core::to_string(read_clouds(scene, folder_).at(0)), HasSubstr("cannot be those of a platform"));
  scene.clouds[0].platform = "Earth";
  scene.clouds[0].file = "pole.csv";
  EXPECT_THAT(core::to_string(read_clouds(scene, folder_).at(0)), HasSubstr("beyond a pole"));
}

// Larger than a piece of text, so that lines lie across borders of pieces.
TEST_F(ReadClouds, TakeTheSamePointsOnAnyNumberOfThreads) {
  constexpr std::size_t points = 300'000;
  std::string text;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < points; ++i) {
    const auto x = static_cast<double>(i);
    numbers.insert(numbers.end(), {0.25 * x, -x, std::floor(0.01 * x), 1.0 + static_cast<double>(i % 7)});
    text += fmt::format("{},{},{},{}\n", 0.25 * x, -x, std::floor(0.01 * x), 1 + i % 7);
  }
  ASSERT_GT(text.size(), std::size_t{1} << 22);
  write("many.csv", text);
  write_npy("many.npy", numbers, 4);
  const scene::Cloud one = read("many.csv", 1.0, 1);
  ASSERT_TRUE(one.points);
  ASSERT_EQ(one.points->arrays.size(), points);
  for (const auto& [name, threads] : {std::pair{"many.csv", 3U}, {"many.npy", 1U}, {"many.npy", 3U}}) {
    const scene::Cloud other = read(name, 1.0, threads);
    ASSERT_TRUE(other.points) << name;
    EXPECT_EQ(other.points->arrays.x_m, one.points->arrays.x_m) << name;
    EXPECT_EQ(other.points->arrays.root_rcs_m, one.points->arrays.root_rcs_m) << name;
    EXPECT_EQ(other.points->sum, one.points->sum) << name;
  }
  write("many.csv", text + "1,2,x\n");
  expect_refused("many.csv", "line 300001: z");
}

TEST_F(ReadClouds, ReadAFileAgainWhereTheCloudMeansAnother) {
  write("a.csv", "1,2,3\n");
  write("b.csv", "4,5,6\n");
  scene::Scene scene;
  scene.clouds.resize(2);
  scene.clouds[0].file = scene.clouds[1].file = "a.csv";
  EXPECT_TRUE(read_clouds(scene, folder_).empty());
  EXPECT_EQ(scene.clouds[0].points.get(), scene.clouds[1].points.get()) << "read once";
  EXPECT_EQ(cloud_points(scene), 2U);
  scene.clouds[1].file = "b.csv";
  EXPECT_TRUE(read_clouds(scene, folder_).empty());
  EXPECT_EQ(scene.clouds[0].points->arrays.x_m[0], 1.0);
  EXPECT_EQ(scene.clouds[1].points->arrays.x_m[0], 4.0);
}

}  // namespace cloud_input_test
}  // namespace sarsim::workflow
