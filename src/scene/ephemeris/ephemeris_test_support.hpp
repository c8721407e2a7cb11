#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "core/report/problem.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"

/// Small files of every format, and what tests ask about problems.
namespace sarsim::scene::ephemeris_test {

inline constexpr std::string_view eof_text = R"(<?xml version="1.0" ?>
<Earth_Explorer_File>
  <Earth_Explorer_Header>
    <Fixed_Header>
      <File_Name>S1A_OPER_AUX_POEORB_TEST</File_Name>
      <Mission>Sentinel-1A</Mission>
    </Fixed_Header>
    <Variable_Header>
      <Ref_Frame>EARTH_FIXED</Ref_Frame>
      <Time_Reference>UTC</Time_Reference>
    </Variable_Header>
  </Earth_Explorer_Header>
  <Data_Block type="xml">
    <!-- two <OSV> only -->
    <List_of_OSVs count="2">
      <OSV>
        <TAI>TAI=2024-04-01T23:00:19.000000</TAI>
        <UTC>UTC=2024-04-01T22:59:42.000000</UTC>
        <UT1>UT1=2024-04-01T22:59:41.991160</UT1>
        <Absolute_Orbit>+53249</Absolute_Orbit>
        <X unit="m">1950200.216160</X>
        <Y unit="m">-4143460.384445</Y>
        <Z unit="m">-5401629.615817</Z>
        <VX unit="m/s">579.550068</VX>
        <VY unit="m/s">-5889.842297</VY>
        <VZ unit="m/s">4730.338429</VZ>
        <Quality>NOMINAL</Quality>
      </OSV>
      <OSV>
        <TAI>TAI=2024-04-01T23:00:29.000000</TAI>
        <UTC>UTC=2024-04-01T22:59:52.000000</UTC>
        <UT1>UT1=2024-04-01T22:59:51.991160</UT1>
        <Absolute_Orbit>+53249</Absolute_Orbit>
        <X unit="m">1955843.846035</X>
        <Y unit="m">-4202130.437922</Y>
        <Z unit="m">-5354023.982384</Z>
        <VX unit="m/s">549.176492</VX>
        <VY unit="m/s">-5844.051702</VY>
        <VZ unit="m/s">4790.699309</VZ>
        <Quality>NOMINAL</Quality>
      </OSV>
    </List_of_OSVs>
  </Data_Block>
</Earth_Explorer_File>
)";

inline constexpr std::string_view oem_text = R"(CCSDS_OEM_VERS = 2.0
COMMENT made for a test
CREATION_DATE = 2024-04-02T00:00:00
ORIGINATOR = TEST

META_START
OBJECT_NAME = SENTINEL-1A
OBJECT_ID = 2014-016A
CENTER_NAME = EARTH
REF_FRAME = ITRF2014
TIME_SYSTEM = UTC
START_TIME = 2024-04-01T22:59:42
USEABLE_START_TIME = 2024-04-01T22:59:42
USEABLE_STOP_TIME = 2024-04-01T22:59:52
STOP_TIME = 2024-04-01T22:59:52
INTERPOLATION = HERMITE
INTERPOLATION_DEGREE = 7
META_STOP
COMMENT states
2024-04-01T22:59:42.0 1950.200216160 -4143.460384445 -5401.629615817 0.579550068 -5.889842297 4.730338429
2024-04-01T22:59:52.0 1955.843846035 -4202.130437922 -5354.023982384 0.549176492 -5.844051702 4.790699309

COVARIANCE_START
EPOCH = 2024-04-01T22:59:42
COV_REF_FRAME = RTN
1.0
0.1 1.0
0.1 0.1 1.0
COVARIANCE_STOP

META_START
OBJECT_NAME = SENTINEL-1A
OBJECT_ID = 2014-016A
CENTER_NAME = EARTH
REF_FRAME = ITRF2014
TIME_SYSTEM = UTC
START_TIME = 2024-092T22:59:52
STOP_TIME = 2024-092T23:00:12
META_STOP
2024-092T22:59:52 1955.843846035 -4202.130437922 -5354.023982384 0.549176492 -5.844051702 4.790699309 1e-6 2e-6 3e-6
2024-092T23:00:02 1961.183765026 -4260.339093078 -5305.817419836 0.518808624 -5.797563486 4.850523132 1e-6 2e-6 3e-6
2024-092T23:00:12 1966.220052182 -4318.079399439 -5257.015332251 0.488450856 -5.750382811 4.909803206 1e-6 2e-6 3e-6
)";

inline constexpr std::string_view sp3_text =
    "#cV2024  4  1 22 59 42.00000000       3 ORBIT IGS14 FIT  TST\n"
    "## 2308 169182.00000000    10.00000000 60401 0.9581250000000\n"
    "+    2   L51G07  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0\n"
    "++         0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0\n"
    "%c L  cc GPS ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc\n"
    "%c cc cc ccc ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc\n"
    "%f  1.2500000  1.025000000  0.00000000000  0.000000000000000\n"
    "%i    0    0    0    0      0      0      0      0         0\n"
    "/* made for a test\n"
    "*  2024  4  1 22 59 42.00000000\n"
    "PL51   1950.200216  -4143.460384  -5401.629616 999999.999999\n"
    "VL51   5795.500680 -58898.422970  47303.384290 999999.999999\n"
    "PG07  20000.000000  10000.000000  15000.000000    123.456789\n"
    "VG07  10000.000000  20000.000000      0.000000 999999.999999\n"
    "*  2024  4  1 22 59 52.00000000\n"
    "PL51   1955.843846  -4202.130438  -5354.023982 999999.999999\n"
    "EP   55   55   55     222  1234567 -1234567  5999999      -30       21 -1230000\n"
    "VL51   5491.764920 -58440.517020  47906.993090 999999.999999\n"
    "PG07      0.000000      0.000000      0.000000 999999.999999\n"
    "VG07      0.000000      0.000000      0.000000 999999.999999\n"
    "*  2024  4  1 23  0  2.00000000\n"
    "PL51   1961.183765  -4260.339093  -5305.817420 999999.999999\n"
    "VL51   5188.029160 -57982.611070  48510.601890 999999.999999\n"
    "PG07  20030.000000  10000.000000  15000.000000 999999.999999\n"
    "VG07  10000.000000  20000.000000      0.000000 999999.999999\n"
    "EOF\n";

inline constexpr std::string_view csv_text =
    "# made for a test\n"
    "t,x,y,z,vx,vy,vz\n"
    "-10,1950200.216160,-4143460.384445,-5401629.615817,579.550068,-5889.842297,4730.338429\n"
    "0,1955843.846035,-4202130.437922,-5354023.982384,549.176492,-5844.051702,4790.699309\n"
    "10,1961183.765026,-4260339.093078,-5305817.419836,518.808624,-5797.563486,4850.523132\n";

inline constexpr std::string_view tle_text =
    "SENTINEL TEST\n"
    "1 39634U 14016A   24092.50000000  .00000125  00000+0  36210-4 0  9992\n"
    "2 39634  98.1817 100.2500 0001340  85.1000 275.0350 14.59198062522311\n"
    "0 HIGH ONE\n"
    "1 A0001U 24001B   24001.00000001 -.00000084 -12345-6  00000+0 0    14\n"
    "2 A0001   0.0500 359.9999 7411000   0.0000 180.0000  2.00613016    13\n";

inline constexpr std::string_view omm_kvn_text = R"(CCSDS_OMM_VERS = 2.0
CREATION_DATE = 2024-04-01T20:00:00
ORIGINATOR = TEST

OBJECT_NAME = SENTINEL TEST
OBJECT_ID = 2014-016A
CENTER_NAME = EARTH
REF_FRAME = TEME
TIME_SYSTEM = UTC
MEAN_ELEMENT_THEORY = SGP4

EPOCH = 2024-04-01T12:00:00.000000
MEAN_MOTION = 14.59198062 [rev/day]
ECCENTRICITY = 0.0001340
INCLINATION = 98.1817 [deg]
RA_OF_ASC_NODE = 100.2500 [deg]
ARG_OF_PERICENTER = 85.1000 [deg]
MEAN_ANOMALY = 275.0350 [deg]

EPHEMERIS_TYPE = 0
CLASSIFICATION_TYPE = U
NORAD_CAT_ID = 39634
ELEMENT_SET_NO = 999
REV_AT_EPOCH = 52231
BSTAR = 0.00003621 [1/ER]
MEAN_MOTION_DOT = 0.00000125 [rev/day**2]
MEAN_MOTION_DDOT = 0.0 [rev/day**3]
)";

inline constexpr std::string_view omm_xml_text = R"(<?xml version="1.0" encoding="UTF-8"?>
<ndm xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
<omm id="CCSDS_OMM_VERS" version="2.0">
<header><CREATION_DATE/><ORIGINATOR/></header>
<body><segment>
<metadata><OBJECT_NAME>SENTINEL &#84;EST</OBJECT_NAME><OBJECT_ID>2014-016A</OBJECT_ID><CENTER_NAME>EARTH</CENTER_NAME>
<REF_FRAME>TEME</REF_FRAME><TIME_SYSTEM>UTC</TIME_SYSTEM><MEAN_ELEMENT_THEORY>SGP4</MEAN_ELEMENT_THEORY></metadata>
<data>
<meanElements><EPOCH>2024-04-01T12:00:00.000000</EPOCH><MEAN_MOTION units="rev/day">14.59198062</MEAN_MOTION>
<ECCENTRICITY>.0001340</ECCENTRICITY><INCLINATION units="deg">98.1817</INCLINATION>
<RA_OF_ASC_NODE units="deg">100.2500</RA_OF_ASC_NODE><ARG_OF_PERICENTER>85.1000</ARG_OF_PERICENTER>
<MEAN_ANOMALY>275.0350</MEAN_ANOMALY></meanElements>
<tleParameters><EPHEMERIS_TYPE>0</EPHEMERIS_TYPE><CLASSIFICATION_TYPE>U</CLASSIFICATION_TYPE>
<NORAD_CAT_ID>39634</NORAD_CAT_ID><ELEMENT_SET_NO>999</ELEMENT_SET_NO><REV_AT_EPOCH>52231</REV_AT_EPOCH>
<BSTAR>.3621E-4</BSTAR><MEAN_MOTION_DOT>.125E-5</MEAN_MOTION_DOT><MEAN_MOTION_DDOT>0</MEAN_MOTION_DDOT></tleParameters>
</data>
</segment></body>
</omm>
</ndm>
)";

inline constexpr std::string_view omm_csv_text =
    "OBJECT_NAME,OBJECT_ID,EPOCH,MEAN_MOTION,ECCENTRICITY,INCLINATION,RA_OF_ASC_NODE,ARG_OF_PERICENTER,MEAN_ANOMALY,"
    "EPHEMERIS_TYPE,CLASSIFICATION_TYPE,NORAD_CAT_ID,ELEMENT_SET_NO,REV_AT_EPOCH,BSTAR,MEAN_MOTION_DOT,MEAN_MOTION_"
    "DDOT\n"
    "SENTINEL TEST,2014-016A,2024-04-01T12:00:00.000000,14.59198062,.0001340,98.1817,100.2500,85.1000,275.0350,0,U,"
    "39634,999,52231,.3621E-4,.125E-5,0\n"
    "\"HIGH, \"\"ONE\"\"\",2024-001B,2024-01-01T00:00:00.000864,2.00613016,.7411000,0.0500,359.9999,0,180,0,U,"
    "100001,1,1,0,-.84E-6,0\n";

inline constexpr std::string_view omm_json_text = R"([
  {"OBJECT_NAME": "SENTINEL \u0054EST", "OBJECT_ID": "2014-016A", "EPOCH": "2024-04-01T12:00:00.000000",
   "MEAN_MOTION": 14.59198062, "ECCENTRICITY": 0.000134, "INCLINATION": 98.1817, "RA_OF_ASC_NODE": 100.25,
   "ARG_OF_PERICENTER": "85.1", "MEAN_ANOMALY": 275.035, "EPHEMERIS_TYPE": 0, "CLASSIFICATION_TYPE": "U",
   "NORAD_CAT_ID": 39634, "ELEMENT_SET_NO": 999, "REV_AT_EPOCH": 52231, "BSTAR": 3.621e-5, "MEAN_MOTION_DOT": 1.25e-6,
   "MEAN_MOTION_DDOT": 0, "MORE": {"nested": ["}", 1]}, "NOTHING": null}
]
)";

inline constexpr std::string_view aem_text = R"(CCSDS_AEM_VERS = 1.0
CREATION_DATE = 2024-04-01T00:00:00
ORIGINATOR = TEST
META_START
OBJECT_NAME = SENTINEL-1A
OBJECT_ID = 2014-016A
CENTER_NAME = EARTH
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
ATTITUDE_DIR = A2B
TIME_SYSTEM = UTC
START_TIME = 2024-04-01T22:59:42
STOP_TIME = 2024-04-01T23:00:02
ATTITUDE_TYPE = QUATERNION
QUATERNION_TYPE = LAST
INTERPOLATION_METHOD = LINEAR
INTERPOLATION_DEGREE = 1
META_STOP
DATA_START
2024-04-01T22:59:42 0 0 0.70710678 0.70710678
2024-04-01T22:59:52 0 0 -0.70710678 -0.70710678
2024-04-01T23:00:02 0.1 0.2 0.3 0.92736185
DATA_STOP
)";

/// The text with one piece replaced by another, at its first place; a test failure where it has none.
inline std::string replaced(std::string_view text, std::string_view piece, std::string_view by) {
  std::string changed(text);
  const std::size_t at = changed.find(piece);
  if (at == std::string::npos)
    ADD_FAILURE() << "no such piece: " << piece;
  else
    changed.replace(at, piece.size(), by);
  return changed;
}

/// The only problem of a reading, whatever it is; a test failure where there are others.
inline core::Problem only_problem(const core::Problems& problems) {
  EXPECT_EQ(problems.size(), 1U);
  for (std::size_t i = 1; i < problems.size(); ++i) ADD_FAILURE() << core::to_string(problems[i]);
  return problems.empty() ? core::Problem{} : problems.front();
}

/// All problems as text.
inline std::string words_of(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n";
  return text;
}

}  // namespace sarsim::scene::ephemeris_test
