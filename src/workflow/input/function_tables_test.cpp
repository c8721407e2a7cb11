#include "workflow/input/function_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include "support/test_folder.hpp"
#include "workflow/input/motion_input.hpp"

namespace sarsim::workflow {
namespace function_tables_test {

using testing::HasSubstr;
using Knots = std::vector<core::Knot>;

class FunctionTables : public testing::Test {
 protected:
  // By the HDF5 library itself, which Python calls where it is there.
  [[nodiscard]] bool write_tables() const {
    std::ofstream(folder_ / "make.py") << R"(import ctypes as c, os
os.chdir(os.path.dirname(os.path.abspath(__file__)))
l, i = c.CDLL("libhdf5_serial.so.103"), c.c_int64
l.H5open()
for f in ("H5Fcreate", "H5Screate_simple", "H5Dcreate2"): getattr(l, f).restype = i
def w(name, rows):
    file = i(l.H5Fcreate(name.encode(), 2, i(0), i(0)))
    space = i(l.H5Screate_simple(2, (c.c_uint64 * 2)(len(rows), len(rows[0])), None))
    data = i(l.H5Dcreate2(file, b"points", i.in_dll(l, "H5T_IEEE_F64LE_g"), space, i(0), i(0), i(0)))
    flat = [float(x) for row in rows for x in row]
    l.H5Dwrite(data, i.in_dll(l, "H5T_NATIVE_DOUBLE_g"), i(0), i(0), i(0), (c.c_double * len(flat))(*flat))
    l.H5Dclose(data), l.H5Fclose(file)
w("cuts.h5", [[-10, -3, -4], [0, 0, 0], [10, -3, -5]])
w("gain.h5", [[0, 0], [30, -3]])
w("wide.h5", [[0] * 7] * 2)
)";
    return std::system(fmt::format("python3 {}/make.py 2> /dev/null", folder_.path().string()).c_str()) == 0;
  }

  test::TestFolder folder_;
};

// A stop is no damage of the file.
TEST_F(FunctionTables, AreLeftWhereAStopIsRequested) {
  if (!write_tables()) GTEST_SKIP() << "no library of HDF5 for Python";
  scene::Scene scene;
  scene.radars.resize(1);
  scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::user;
  scene.radars[0].transmit_antenna.gain_db.file = "cuts.h5";
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)read_function_tables(scene, folder_.path(), {1, &stop}), core::Interrupted);
}

TEST_F(FunctionTables, OfHdf5AreReadWithTheOtherFilesOfAScene) {
  if (!write_tables()) GTEST_SKIP() << "no library of HDF5 for Python";
  scene::Scene scene;
  scene.radars.resize(2);
  for (scene::Radar& radar : scene.radars) radar.transmit_antenna.pattern = scene::Antenna::Pattern::user;
  scene.radars[0].transmit_antenna.gain_db.file = "cuts.h5";
  scene.radars[1].transmit_antenna.gain_db.file = "wide.h5";
  scene.targets.resize(3);
  for (scene::Target& target : scene.targets) {
    scene::TargetTraits traits;
    traits.reflectivity = scene::TargetTraits::Reflectivity::directional;
    traits.gain = scene::TargetTraits::Gain::user;
    traits.gain_db.file = "gain.h5";
    target.traits = traits;
  }
  const core::Problems problems = read_files_of(scene, folder_.path());
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].subject.kind, "radar");
  EXPECT_EQ(problems[0].subject.index, 1U);
  EXPECT_THAT(problems[0].message, HasSubstr("has other columns"));
  EXPECT_EQ(scene.radars[0].transmit_antenna.gain_db.part[0].knots, (Knots{{-10, -3}, {0, 0}, {10, -3}}));
  EXPECT_EQ(scene.radars[0].transmit_antenna.gain_db.part[1].knots, (Knots{{-10, -4}, {0, 0}, {10, -5}}));
  for (const scene::Target& target : scene.targets)
    EXPECT_EQ(target.traits->gain_db.part[0].knots, (Knots{{0, 0}, {30, -3}}));
}

}  // namespace function_tables_test
}  // namespace sarsim::workflow
