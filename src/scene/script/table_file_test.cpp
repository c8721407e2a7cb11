#include "scene/script/table_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "scene/script/data_file.hpp"

namespace sarsim::scene {
namespace table_file_test {

namespace blocks = function_blocks;
using testing::HasSubstr;
using Knots = std::vector<core::Knot>;

std::string errors_of(const DataFileReading& reading) {
  std::string text;
  for (const core::Problem& problem : reading.problems) text += core::to_string(problem) + "\n";
  return text;
}

struct Row {
  const char* text;
  const FunctionBlock& block;
  std::vector<Knots> functions;
  const char* name = "table";
};

TEST(TableFile, IsReadRowByRow) {
  const Row rows[]{
      {"angle,az,el\n-10,-3,-4\n0,0,0\n10,-3,-5\n",
       blocks::transmit_gain,
       {{{-10, -3}, {0, 0}, {10, -3}}, {{-10, -4}, {0, 0}, {10, -5}}}},
      {"-10 -3\n0 0\n10 -3\n", blocks::transmit_gain, {{{-10, -3}, {0, 0}, {10, -3}}, {{-10, -3}, {0, 0}, {10, -3}}}},
      {"# angle;gain\n0;0\n30;-3\n", blocks::target_gain, {{{0, 0}, {30, -3}}}},
      {"angle [rad],gain\n0,0\n0.5,-3\n", blocks::target_gain, {{{0, 0}, {28.64788975654116, -3}}}},
      {"x,I,Q\n0,1,0\n0.5,0,1\n1,1,0\n", blocks::pulse_iq, {{{0, 1}, {0.5, 0}, {1, 1}}, {{0, 0}, {0.5, 1}, {1, 0}}}},
      {"1,0\n0,1\n-1,0\n", blocks::pulse_iq, {{{0, 1}, {0.5, 0}, {1, -1}}, {{0, 0}, {0.5, 1}, {1, 0}}}, "iq.csv"},
      {"0,1\n0.5,0.5\n1,0.25\n", blocks::pulse_iq, {{{0, 1}, {0.5, 0.5}, {1, 0.25}}, {{0, 0}, {0.5, 0}, {1, 0}}}},
      {"9e9\n9.1e9\n", blocks::carrier_list, {{{0, 9e9}, {1, 9.1e9}}}},
      {"f [GHz]\n9\n9.1\n", blocks::carrier_list, {{{0, 9e9}, {1, 9.1e9}}}},
      {"1,0.001\n2,0.0012\n", blocks::pri, {{{0, 0.001}, {1, 0.0012}}}},
      {"t,x,y,z\n0,1,2,3\n1,4,5,6\n", blocks::trajectory, {{{0, 1}, {1, 4}}, {{0, 2}, {1, 5}}, {{0, 3}, {1, 6}}}},
      // In the order of their names.
      {"t,y,x,z\n0,1,2,3\n1,4,5,6\n", blocks::trajectory, {{{0, 2}, {1, 5}}, {{0, 1}, {1, 4}}, {{0, 3}, {1, 6}}}},
      {"z [m];Time [ms];north_km;east [km]\n1;0;2;3\n1;1e3;4;5\n",
       blocks::trajectory,
       {{{0, 3e3}, {1, 5e3}}, {{0, 2e3}, {1, 4e3}}, {{0, 1}, {1, 1}}}},
      {"angle,elevation,azimuth\n0,-6,0\n10,-9,-3\n", blocks::transmit_gain, {{{0, 0}, {10, -3}}, {{0, -6}, {10, -9}}}},
      {"fraction,Q,I\n0,2,1\n1,4,3\n", blocks::pulse_iq, {{{0, 1}, {1, 3}}, {{0, 2}, {1, 4}}}},
      {"Q,I\n0,1\n1,0\n", blocks::pulse_iq, {{{0, 1}, {1, 0}}, {{0, 0}, {1, 1}}}},
      {"I,Q\n0,0.5\n1,0.25\n", blocks::pulse_iq, {{{0, 0}, {1, 1}}, {{0, 0.5}, {1, 0.25}}}},
      {"fraction,I\n0,1\n0.5,2\n", blocks::pulse_iq, {{{0, 1}, {0.5, 2}}, {{0, 0}, {0.5, 0}}}},
      {"gain,range\n1,100\n2,200\n", blocks::stc_gain, {{{100, 1}, {200, 2}}}},
      {"pri,n\n0.001,0\n0.002,1\n", blocks::pri, {{{0, 0.001}, {1, 0.002}}}},
      {"t,roll,pitch,yaw\n0,1,2,3\n1,4,5,6\n",
       blocks::rotation,
       {{{0, 1}, {1, 4}}, {{0, 2}, {1, 5}}, {{0, 3}, {1, 6}}}},
      {"t_ms,x_km,y_m,z\n0,1,2,3\n1000,4,5,6\n",
       blocks::trajectory,
       {{{0, 1e3}, {1, 4e3}}, {{0, 2}, {1, 5}}, {{0, 3}, {1, 6}}}},
      // Names that mean nothing here, and a title.
      {"a,b\n0,1\n1,2\n", blocks::window_gain, {{{0, 1}, {1, 2}}}},
      {"my own weights over width\n0 1\n1 2\n", blocks::window_gain, {{{0, 1}, {1, 2}}}},
      {"\"range [km]\" \"gain\"\n1 1\n2 2\n", blocks::stc_gain, {{{1e3, 1}, {2e3, 2}}}},
      {"\"gain, voltage\",\"range [km]\"\n1,1\n2,2\n", blocks::stc_gain, {{{1e3, 1}, {2e3, 2}}}},
      // As numbers of points, as ever.
      {"2 0 0 10 -3\n2 0 0 10 -5\n", blocks::transmit_gain, {{{0, 0}, {10, -3}}, {{0, 0}, {10, -5}}}},
      {"3\n0 1\n0.5 2\n1 1\n", blocks::window_gain, {{{0, 1}, {0.5, 2}, {1, 1}}}},
      {"2 0 9 1 9.1", blocks::carrier_list, {{{0, 9e9}, {1, 9.1e9}}}},
  };
  for (const Row& row : rows) {
    const DataFileReading reading = read_data_file(row.text, row.name, row.block);
    EXPECT_EQ(errors_of(reading), "") << row.text;
    EXPECT_EQ(reading.functions, row.functions) << row.text;
  }
}

TEST(TableFile, SaysWhatIsWrongWithItsRows) {
  struct Bad {
    const char* text;
    const FunctionBlock& block;
    const char* says;
  };
  const Bad rows[]{
      {"angle,az,el,more\n1,2,3,4\n", blocks::transmit_gain, "has other columns"},
      {"angle,az,el\n0,0,0\n1,2\n", blocks::transmit_gain, "t.csv:3"},
      {"angle,gain\n10,0\n0,-3\n", blocks::target_gain, "must ascend"},
      {"angle,gain\n0,zero\n", blocks::target_gain, "'zero' is not a valid ratio"},
      {"angle [m],gain\n0,0\n", blocks::target_gain, "the unit of column 1 is not that of incidence angle"},
      {"f\n9e9\n-1\n", blocks::carrier_list, "out of range"},
      {"a,b\n", blocks::target_gain, "holds no numbers"},
      {"t,lat,lon,height\n0,1,2,3\n", blocks::trajectory, "the name of column 2 is not that of position x"},
      {"t,x,x,z\n0,1,2,3\n", blocks::trajectory, "two columns are named position x"},
      {"t,y,foo,z\n0,1,2,3\n", blocks::trajectory, "column 2 is another one by its name"},
      {"time,gain\n0,1\n", blocks::stc_gain, "the name of column 1 is not that of range"},
      {"angle,elevation\n0,1\n", blocks::transmit_gain, "one gain for both cuts"},
      {"fraction,Q\n0,1\n1,2\n", blocks::pulse_iq, "has no I"},
      {"t_ms [s],x,y,z\n0,1,2,3\n", blocks::trajectory, "name and unit of column 1 contradict"},
      {"t,y [alpha bravo],x,z\n0,1,2,3\n", blocks::trajectory, "found 'alpha...'"},
      {"x,w\n0,1\n1,5 alpha bravo\n", blocks::window_gain, "'5...' has a unit, 'alpha...'"},
      {"angle,gain\n0,1e30\n", blocks::target_gain, "cannot be computed with"},
      // Names of other quantities, even beside those of the axis.
      {"angle,gain_lin\n0,1\n10,0.5\n", blocks::transmit_gain, "10 log10 of a ratio of powers"},
      {"angle,loss [dB]\n0,0\n10,3\n", blocks::target_gain, "found 'loss [dB]', expected reflectivity"},
      {"angle,phase\n0,0\n10,3\n", blocks::target_gain, "have no phase"},
      {"grazing,gain\n0,0\n10,3\n", blocks::target_gain, "90 deg less the grazing angle"},
      {"angle,rcs_dBsm\n0,0\n10,3\n", blocks::target_gain, "the unit behind the name of column 2"},
      {"t,amplitude,phase\n0,1,0\n1,1,90\n", blocks::pulse_iq, "the name of column 2 is not that of I"},
      {"fraction,power\n0,1\n1,1\n", blocks::envelope_gain, "Write voltages"},
      {"fraction,weight_dB\n0,0\n1,-3\n", blocks::window_gain, "expected a number without a unit"},
      {"t,x,y,down\n0,1,2,3\n1,1,2,3\n", blocks::trajectory, "name the column up"},
      {"t,x_velocity,y,z\n0,1,2,3\n1,1,2,3\n", blocks::trajectory, "not its rate"},
      {"prf\n1000\n1200\n", blocks::pri, "1 over the repetition frequency"},
      {"frequency\n1000\n1200\n", blocks::pri, "1 over the repetition frequency"},
      {"wavelength\n0.03\n0.031\n", blocks::carrier_list, "the speed of light over the wavelength"},
      {"interval\n0.03\n0.031\n", blocks::carrier_list, "the name of column 1 is not that of frequency"},
      {"NA,NA\n0,1\n1,1\n", blocks::window_gain, "'NA'"},
  };
  for (const Bad& row : rows)
    EXPECT_THAT(errors_of(read_data_file(row.text, "t.csv", row.block)), HasSubstr(row.says)) << row.text;
}

template <class Number>
std::string npy(const std::string& type, const std::string& shape, const std::vector<Number>& numbers,
                bool columns_first = false) {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " + (columns_first ? "True" : "False") +
                       ", 'shape': " + shape + ", }\n";
  std::string bytes = "\x93NUMPY";
  bytes += std::string("\x01\x00", 2) + static_cast<char>(header.size()) + std::string(1, '\0') + header;
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  return bytes;
}

TEST(TableFile, MayBeAnArrayOfNumPy) {
  const std::vector<Knots> cut{{{0, 0}, {30, -3}}};
  for (const std::string& bytes :
       {npy<double>("<f8", "(2, 2)", {0, 0, 30, -3}), npy<float>("<f4", "(2, 2)", {0, 0, 30, -3}),
        npy<double>("<f8", "(2, 2)", {0, 30, 0, -3}, true), npy<std::int16_t>("<i2", "(2, 2)", {0, 0, 30, -3})}) {
    const DataFileReading reading = read_data_file(bytes, "t.npy", blocks::target_gain);
    EXPECT_EQ(errors_of(reading), "");
    EXPECT_EQ(reading.functions, cut);
  }
  const DataFileReading pulse =
      read_data_file(npy<float>("<c8", "(3,)", {1, 0, 0, 1, -1, 0}), "p.npy", blocks::pulse_iq);
  EXPECT_EQ(errors_of(pulse), "");
  EXPECT_EQ(pulse.functions, (std::vector<Knots>{{{0, 1}, {0.5, 0}, {1, -1}}, {{0, 0}, {0.5, 1}, {1, 0}}}));
  for (const auto& [bytes, says] :
       {std::pair{npy<double>(">f8", "(2, 2)", {0, 0, 30, -3}), "of a type that is not read"},
        std::pair{npy<double>("<f8", "(2, 5)", {0, 0, 30, -3}), "shorter than its array"},
        std::pair{npy<double>("<f8", "(2, 2)", {0, 0, 30, -3}) + "tail", "longer than its array"},
        std::pair{npy<double>("<f8", "(1, 4), 'shape': (2, 2)", {0, 0, 30, -3}), "header of the array"},
        std::pair{npy<double>("<f8", "(4,)", {0, 0, 30, -3}), "has other columns"},
        std::pair{npy<double>("<f8", "(1, 2, 2)", {0, 0, 30, -3}), "not a table"},
        std::pair{std::string("\x93NUMPY\x01\x00\xff\xff", 10), "header of the array"},
        std::pair{npy<double>("<f8", "(18446744073709551615, 2)", {0, 0}), "header of the array"},
        std::pair{npy<double>("<f8", "(9223372036854775807, 2)", {0, 0}), "shorter than its array"}})
    EXPECT_THAT(errors_of(read_data_file(bytes, "t.npy", blocks::target_gain)), HasSubstr(says));
}

TEST(TableFile, OfHdf5IsLeftToWhoReadsThatFormat) {
  const DataFileReading reading = read_data_file("\x89HDF\r\n\x1a\n...", "t.h5", blocks::target_gain);
  EXPECT_TRUE(reading.deferred);
  EXPECT_TRUE(reading.problems.empty());
  EXPECT_EQ(reading.functions.size(), 1U);
}

}  // namespace table_file_test
}  // namespace sarsim::scene
