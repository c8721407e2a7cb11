// What attributes and types of other programs' HDF5 files change is followed or refused by name
// (docs/formats/samples.md).

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "raster/format/data_test_support.hpp"
#include "raster/hdf5/hdf5_library.hpp"

namespace sarsim::raster::hdf5_keys_test {

using namespace data_test;
using testing::HasSubstr;

// A file of two rows of three samples 1 + 2i, 3 + 4i ..., with axes, which a test may change before it is closed.
class Hdf5Keys : public testing::Test {
 protected:
  void write(const std::function<void(hid_t file, hid_t samples)>& change, const char* real = "r",
             const char* imaginary = "i", const char* name = "samples", hid_t number = H5T_IEEE_F64LE) {
    const Hdf5Use use;
    const Hdf5Handle file(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    const Hdf5Handle stored = pair(real, imaginary, number);
    const Hdf5Handle memory = pair(real, imaginary, H5T_NATIVE_DOUBLE);
    const std::array<double, 12> values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    add(file.get(), name, stored.get(), {2, 3});
    const Hdf5Handle samples(H5Dopen2(file.get(), name, H5P_DEFAULT), H5Dclose);
    ASSERT_GE(H5Dwrite(samples.get(), memory.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    add_axis(file.get(), "pulse_time_s", {0.5, 1.5});
    add_axis(file.get(), "carrier_hz", {1e9, 2e9});
    add_axis(file.get(), "slant_range_m", {10.0, 11.0, 12.0});
    change(file.get(), samples.get());
  }
  void write() {
    write([](hid_t, hid_t) {});
  }

  static Hdf5Handle pair(const char* real, const char* imaginary, hid_t number) {
    const std::size_t size = H5Tget_size(number);
    Hdf5Handle type(H5Tcreate(H5T_COMPOUND, 2 * size), H5Tclose);
    H5Tinsert(type.get(), real, 0, number);
    H5Tinsert(type.get(), imaginary, size, number);
    return type;
  }
  static void add(hid_t file, const char* name, hid_t type, const std::vector<hsize_t>& shape,
                  hid_t properties = H5P_DEFAULT) {
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
    const Hdf5Handle made(H5Dcreate2(file, name, type, space.get(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose);
    ASSERT_TRUE(made);
  }
  static void add_axis(hid_t file, const char* name, const std::vector<double>& values) {
    add(file, name, H5T_IEEE_F64LE, {values.size()});
    const Hdf5Handle axis(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    ASSERT_GE(H5Dwrite(axis.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  }
  static void say_numbers(hid_t object, const char* name, const std::vector<double>& values) {
    const hsize_t count = values.size();
    const Hdf5Handle space(count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr), H5Sclose);
    const Hdf5Handle made(H5Acreate2(object, name, H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    ASSERT_GE(H5Awrite(made.get(), H5T_NATIVE_DOUBLE, values.data()), 0);
  }
  static void say(hid_t object, const char* name, const std::string& text) {
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), text.size() + 1);
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle made(H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    ASSERT_GE(H5Awrite(made.get(), type.get(), text.c_str()), 0);
  }
  static void say_of(hid_t file, const char* dataset, const char* name, const std::string& text) {
    const Hdf5Handle object(H5Dopen2(file, dataset, H5P_DEFAULT), H5Dclose);
    say(object.get(), name, text);
  }

  // An attribute of a type with whatever it holds in memory.
  static void say_bytes(hid_t object, const char* name, hid_t type, hsize_t count, const void* values) {
    const Hdf5Handle space(count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr), H5Sclose);
    const Hdf5Handle made(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    ASSERT_GE(H5Awrite(made.get(), type, values), 0);
  }
  // The same in each form that is not read as text or as some numbers.
  static void say_unreadable(hid_t object, const char* name, int form) {
    const std::array<double, 20> numbers{0.5, 0.5};
    const std::array<long double, 1> wide{0.25L};
    const std::array<char, 8> texts{'m', 'V', 0, 0, 'V', 0, 0, 0};
    const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(text.get(), 4);
    switch (form) {
      case 0: return say_bytes(object, name, pair("r", "i", H5T_NATIVE_DOUBLE).get(), 1, numbers.data());
      case 1: return say_bytes(object, name, H5T_NATIVE_LDOUBLE, 1, wide.data());
      case 2: return say_bytes(object, name, H5T_NATIVE_DOUBLE, 20, numbers.data());
      default: return say_bytes(object, name, text.get(), 2, texts.data());
    }
  }
  static constexpr int unreadable_forms = 4;

  [[nodiscard]] OpenedRaster open(const std::string& dataset = "") const {
    RasterHints hints;
    hints.dataset = dataset;
    return open_raster(Integrity::whole, path_, hints);
  }
  [[nodiscard]] std::string refusal(const std::string& dataset = "") const {
    const auto opened = open(dataset);
    return opened.raster ? "" : text_of(opened.problems);
  }

  TestFolder folder_;
  fs::path path_ = folder_ / "a.h5";
};

TEST_F(Hdf5Keys, ScalesAndUnitsAreFollowed) {
  write([](hid_t file, hid_t samples) {
    say_numbers(samples, "scale_factor", {0.5});
    say(samples, "units", std::string("mV"));
    say_of(file, "slant_range_m", "units", "km");
    say_of(file, "carrier_hz", "units", "kHz");
    say_of(file, "pulse_time_s", "units", "us");
  });
  const auto opened = open();
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_EQ(read_all_rows(*opened.raster)[4], std::complex<double>(9.0 * 0.5e-3, 10.0 * 0.5e-3));
  std::vector<std::complex<float>> window(1);
  opened.raster->read_window({1, 1, 1, 1}, window);
  EXPECT_EQ(window[0], std::complex<float>(4.5e-3F, 5e-3F));
  const auto axes = opened.raster->axes();
  ASSERT_TRUE(axes);
  EXPECT_EQ(axes->column_range_m, (std::vector<double>{10e3, 11e3, 12e3}));
  EXPECT_EQ(axes->row_carrier_hz, (std::vector<double>{1e9 * 1e3, 2e9 * 1e3}));
  EXPECT_EQ(axes->row_time_s[1], 1.5 * 1e-6);
}

TEST_F(Hdf5Keys, IntegersWithAScaleAreVolts) {
  write([](hid_t, hid_t samples) { say_numbers(samples, "scale_factor", {0.25}); }, "r", "i", "samples", H5T_STD_I16LE);
  {
    const auto scaled = open();
    ASSERT_TRUE(scaled.raster) << text_of(scaled.problems);
    EXPECT_FALSE(scaled.raster->info().counts);
    EXPECT_EQ(read_all_rows(*scaled.raster)[0], std::complex<double>(0.25, 0.5));
  }
  write([](hid_t, hid_t) {}, "r", "i", "samples", H5T_STD_I16LE);
  EXPECT_TRUE(open().raster->info().counts);
}

TEST_F(Hdf5Keys, SamplesThatAreMissingAreNoNumbers) {
  write([](hid_t, hid_t samples) {
    say_numbers(samples, "_FillValue", {3.0});
    say_numbers(samples, "valid_range", {0.0, 11.5});
  });
  const auto opened = open();
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  const auto read = read_all_rows(*opened.raster);
  EXPECT_EQ(read[0], std::complex<double>(1.0, 2.0));
  EXPECT_TRUE(std::isnan(read[1].real()));
  EXPECT_TRUE(std::isnan(read[5].imag()));
}

TEST_F(Hdf5Keys, WhatCannotBeFollowedIsRefusedByName) {
  const std::pair<std::function<void(hid_t, hid_t)>, const char*> cases[] = {
      {[](hid_t, hid_t samples) { say_numbers(samples, "add_offset", {1.0}); }, "add_offset"},
      {[](hid_t, hid_t samples) { say_numbers(samples, "scale_factor", {0.0}); }, "scale_factor"},
      {[](hid_t, hid_t samples) {
         say_numbers(samples, "scale_factor", {1.0, 2.0});
       },
       "scale_factor"},
      {[](hid_t, hid_t samples) { say(samples, "units", std::string("dBm")); }, "units"},
      {[](hid_t file, hid_t) { say_of(file, "slant_range_m", "units", "s"); }, "units"},
      {[](hid_t file, hid_t) { say_of(file, "pulse_time_s", "units", "days since 1970-01-01"); }, "units"},
      {[](hid_t file, hid_t) { say_numbers(file, "lsb_v", {1e300}); }, "lsb_v"},
      {[](hid_t file, hid_t) { say_numbers(file, "sample_rate_hz", {-1.0}); }, "sample_rate_hz"},
      {[](hid_t file, hid_t) {
         add_axis(file, "azimuth_m", {1.0, 2.0, 3.0});
       },
       "azimuth_m"},
      {[](hid_t file, hid_t) { add_axis(file, "x_m", {1.0}); }, "x_m"}};
  for (const auto& [change, key] : cases) {
    write(change);
    EXPECT_THAT(refusal(), HasSubstr(key));
  }
}

// What cannot be read is there all the same.
TEST_F(Hdf5Keys, UnreadableAttributesAreRefusedByName) {
  for (const char* const key : {"scale_factor", "add_offset", "_FillValue", "valid_range", "units"})
    for (int form = 0; form < unreadable_forms; ++form) {
      write([&](hid_t, hid_t samples) { say_unreadable(samples, key, form); });
      EXPECT_THAT(refusal(), HasSubstr(std::string("its attribute ") + key)) << form;
      write([&](hid_t file, hid_t) {
        const Hdf5Handle axis(H5Dopen2(file, "slant_range_m", H5P_DEFAULT), H5Dclose);
        say_unreadable(axis.get(), key, form);
      });
      EXPECT_THAT(refusal(), HasSubstr(std::string("/slant_range_m: its attribute ") + key)) << form;
    }
  for (const char* const key : {"lsb_v", "sample_rate_hz", "bits"}) {
    write([&](hid_t file, hid_t) { say_unreadable(file, key, 0); });
    EXPECT_THAT(refusal(), HasSubstr(std::string(key) + " of the file cannot be read; found 'a structure'"));
  }
  write([](hid_t file, hid_t samples) {
    say_unreadable(samples, "history", 3);
    say_unreadable(file, "comment", 0);
  });
  EXPECT_TRUE(open().raster);
}

// xarray writes it at complex samples.
TEST_F(Hdf5Keys, AComplexFillValueThatIsNoNumberPasses) {
  write([](hid_t, hid_t samples) {
    const std::array<double, 2> none{std::nan(""), 0.0};
    say_bytes(samples, "_FillValue", pair("r", "i", H5T_NATIVE_DOUBLE).get(), 1, none.data());
  });
  const auto opened = open();
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_EQ(read_all_rows(*opened.raster)[0], std::complex<double>(1.0, 2.0));
}

// netCDF writes a text of no letters so.
TEST_F(Hdf5Keys, AnEmptyTextIsOne) {
  write([](hid_t, hid_t samples) {
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    const Hdf5Handle space(H5Screate(H5S_NULL), H5Sclose);
    const Hdf5Handle made(H5Acreate2(samples, "units", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    ASSERT_TRUE(made);
  });
  const auto opened = open();
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_EQ(read_all_rows(*opened.raster)[0], std::complex<double>(1.0, 2.0));
}

TEST_F(Hdf5Keys, PlacesThatStandForNoneAreRefused) {
  for (const auto& [key, value] : {std::pair("_FillValue", 11.0), std::pair("missing_value", 12.0),
                                   std::pair("valid_max", 11.5), std::pair("valid_min", 10.5)}) {
    write([&, key = key, value = value](hid_t file, hid_t) {
      const Hdf5Handle axis(H5Dopen2(file, "slant_range_m", H5P_DEFAULT), H5Dclose);
      say_numbers(axis.get(), key, {value});
    });
    EXPECT_THAT(refusal(), HasSubstr("the axis /slant_range_m has a number that stands for none")) << key;
  }
  write([](hid_t file, hid_t) {
    for (const char* const name : {"slant_range_m", "pulse_time_s", "carrier_hz"}) {
      const Hdf5Handle axis(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
      say_numbers(axis.get(), "_FillValue", {std::nan("")});
    }
  });
  const auto natural = open();
  ASSERT_TRUE(natural.raster) << text_of(natural.problems);
  ASSERT_TRUE(natural.raster->axes());
  EXPECT_EQ(natural.raster->axes()->column_range_m, (std::vector<double>{10.0, 11.0, 12.0}));
}

// An axis that cannot be read is none that is not there.
TEST_F(Hdf5Keys, AxesThatCannotBeReadAreRefusedByName) {
  const Hdf5Handle early(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_alloc_time(early.get(), H5D_ALLOC_TIME_EARLY);
  const std::pair<std::function<void(hid_t)>, const char*> cases[] = {
      {[](hid_t file) { H5Lcreate_soft("/pulse_time_s", file, "slant_range_m", H5P_DEFAULT, H5P_DEFAULT); }, "a link"},
      {[](hid_t file) { H5Lcreate_external("b.h5", "/r", file, "slant_range_m", H5P_DEFAULT, H5P_DEFAULT); }, "a link"},
      {[&](hid_t file) { add(file, "slant_range_m", pair("r", "i", H5T_IEEE_F64LE).get(), {3}, early.get()); },
       "does not hold numbers"},
      {[&](hid_t file) {
         const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
         H5Tset_size(text.get(), 4);
         add(file, "slant_range_m", text.get(), {3}, early.get());
       },
       "does not hold numbers"}};
  for (const auto& [replace, message] : cases) {
    write([&, replace = replace](hid_t file, hid_t) {
      H5Ldelete(file, "slant_range_m", H5P_DEFAULT);
      replace(file);
    });
    EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("the axis /slant_range_m"), HasSubstr(message)));
  }
}

// One of 1 says that whole numbers are volts, as docs/formats/samples.md has it.
TEST_F(Hdf5Keys, WholeNumbersWithAScaleOfOneAreVolts) {
  write([](hid_t, hid_t samples) { say_numbers(samples, "scale_factor", {1.0}); }, "r", "i", "samples", H5T_STD_I16LE);
  const auto opened = open();
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_FALSE(opened.raster->info().counts);
  EXPECT_EQ(read_all_rows(*opened.raster)[1], std::complex<double>(3.0, 4.0));
}

TEST_F(Hdf5Keys, TheSignOfTheTypeCounts) {
  write([](hid_t, hid_t samples) { say(samples, "_Unsigned", "true"); }, "r", "i", "samples", H5T_STD_I8LE);
  EXPECT_THAT(refusal(), HasSubstr("_Unsigned"));
  write([](hid_t, hid_t samples) { say(samples, "_Unsigned", "true"); }, "r", "i", "samples", H5T_STD_U8LE);
  EXPECT_EQ(refusal(), "");
}

// The layout of 2015 has the same attributes as any other.
TEST_F(Hdf5Keys, SamplesOf2015AreNoException) {
  const auto with = [&](const std::function<void(hid_t)>& change) {
    write([&](hid_t file, hid_t) {
      H5Ldelete(file, "samples", H5P_DEFAULT);
      const Hdf5Handle group(H5Gcreate2(file, "Data", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
      add(group.get(), "PulseNo_x_SampleNo_I&Q", H5T_IEEE_F64LE, {2, 6});
      const Hdf5Handle samples(H5Dopen2(group.get(), "PulseNo_x_SampleNo_I&Q", H5P_DEFAULT), H5Dclose);
      const std::array<double, 12> values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
      H5Dwrite(samples.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
      change(samples.get());
    });
  };
  with([](hid_t) {});
  ASSERT_TRUE(open().raster) << refusal();
  EXPECT_TRUE(open().raster->info().counts);
  with([](hid_t samples) { say_numbers(samples, "add_offset", {1.0}); });
  EXPECT_THAT(refusal(), HasSubstr("add_offset"));
  with([](hid_t samples) { say_numbers(samples, "scale_factor", {0.5}); });
  EXPECT_THAT(refusal(), HasSubstr("scale_factor or units, but holds counts"));
  with([](hid_t samples) { say(samples, "units", "V"); });
  EXPECT_THAT(refusal(), HasSubstr("scale_factor or units, but holds counts"));
  with([](hid_t samples) { say_numbers(samples, "_FillValue", {3.0}); });
  ASSERT_TRUE(open().raster) << refusal();
  EXPECT_TRUE(std::isnan(read_all_rows(*open().raster)[1].real()));
}

TEST_F(Hdf5Keys, NumbersOf2015ThatCannotBeAreRefused) {
  for (const auto& [name, value] :
       {std::pair("(GHz)_Sample_frequency", "1e300"), std::pair("(GHz)_Sample_frequency", "fast"),
        std::pair("(mV)_Least_Significant_Bit_value", "-1"), std::pair("(mV)_Least_Significant_Bit_value", "nan")}) {
    write([&, name = name, value = value](hid_t file, hid_t) {
      H5Ldelete(file, "samples", H5P_DEFAULT);
      const Hdf5Handle group(H5Gcreate2(file, "Data", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
      const Hdf5Handle early(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
      H5Pset_alloc_time(early.get(), H5D_ALLOC_TIME_EARLY);
      add(group.get(), "PulseNo_x_SampleNo_I&Q", H5T_IEEE_F64LE, {2, 6}, early.get());
      const Hdf5Handle details(H5Gcreate2(file, "Details", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
      add_axis(details.get(), "SIMULATION", {1.0});
      const Hdf5Handle simulation(H5Dopen2(details.get(), "SIMULATION", H5P_DEFAULT), H5Dclose);
      say(simulation.get(), name, value);
    });
    EXPECT_THAT(refusal(), HasSubstr(std::string(name) + " of /Details cannot be")) << value;
  }
}

TEST_F(Hdf5Keys, PositionsThatCannotBeAreRefused) {
  write([](hid_t file, hid_t) {
    for (const char* const name : {"platform_position_m", "platform_velocity_mps", "platform_rotation_rad"}) {
      add(file, name, H5T_IEEE_F64LE, {2, 3});
      const Hdf5Handle axis(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
      const std::array<double, 6> values{1.0, 2.0, 3.0, 1e300, 0.0, 0.0};
      H5Dwrite(axis.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    }
  });
  EXPECT_THAT(refusal(),
              HasSubstr("the axis platform_position_m has a value that cannot be; found '1e+300 at position 3"));
}

// Images may end before their axes do, recordings not.
TEST_F(Hdf5Keys, PlacesOfRecordingsThatAreNoNumbersAreRefused) {
  const double none = std::nan("");
  const auto put_none = [&](hid_t file, const char* name, std::vector<double> values) {
    values[1] = none;
    const Hdf5Handle axis(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    ASSERT_GE(H5Dwrite(axis.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  };
  const auto refused = [&](const char* name) {
    EXPECT_THAT(refusal(),
                HasSubstr(fmt::format("the axis {} has a value that cannot be; found 'nan at position 1", name)));
  };
  for (const char* const name : {"pulse_time_s", "carrier_hz", "slant_range_m"}) {
    write([&](hid_t file, hid_t) { put_none(file, name, {10.0, 11.0, 12.0}); });
    refused(name);
  }
  const std::array poses{"platform_position_m", "platform_velocity_mps", "platform_rotation_rad"};
  for (const char* const name : poses) {
    write([&](hid_t file, hid_t) {
      for (const char* const pose : poses) {
        add(file, pose, H5T_IEEE_F64LE, {2, 3});
        const Hdf5Handle axis(H5Dopen2(file, pose, H5P_DEFAULT), H5Dclose);
        const std::array<double, 6> values{};
        H5Dwrite(axis.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
      }
      put_none(file, name, std::vector<double>(6));
    });
    refused(name);
  }
  write([&](hid_t file, hid_t) {
    add_axis(file, "azimuth_m", {0.0, 1.0});
    put_none(file, "slant_range_m", {10.0, 11.0, 12.0});
  });
  EXPECT_TRUE(open().raster) << refusal();
}

// Files of other programs may have an attribute of that name.
TEST_F(Hdf5Keys, LaterVersionsOfTheLayoutAreRefused) {
  const auto write_version = [&](const std::string& version, bool own) {
    write([&](hid_t file, hid_t) {
      say(file, "format_version", version);
      if (own) say(file, "program_version", "99.0");
    });
  };
  write_version("2", true);
  EXPECT_THAT(refusal(), HasSubstr("format_version of the file is not known; found '2', expected 1"));
  EXPECT_THAT(refusal(), HasSubstr("a newer version of sarsim wrote it"));
  for (int form = 0; form < unreadable_forms; ++form) {
    write([&](hid_t file, hid_t) {
      say_unreadable(file, "format_version", form);
      say(file, "program_version", "99.0");
    });
    EXPECT_THAT(refusal(), HasSubstr("format_version of the file is not known")) << form;
    write([&](hid_t file, hid_t) {
      say_unreadable(file, "processing", form);
      say(file, "program_version", "99.0");
    });
    EXPECT_THAT(refusal(), HasSubstr("processing of the file cannot be read")) << form;
  }
  write_version("1", true);
  EXPECT_TRUE(open().raster) << refusal();
  write_version("2", false);
  EXPECT_TRUE(open().raster) << refusal();
}

TEST_F(Hdf5Keys, ComplexNumbersOfMatlabAreRead) {
  for (const auto& [real, imaginary] : {std::pair("real", "imag"), std::pair("re", "im")}) {
    write([](hid_t, hid_t) {}, real, imaginary);
    const auto opened = open();
    ASSERT_TRUE(opened.raster) << text_of(opened.problems);
    EXPECT_EQ(read_all_rows(*opened.raster)[2], std::complex<double>(5.0, 6.0));
  }
  write([](hid_t, hid_t) {}, "amplitude", "phase");
  EXPECT_THAT(refusal(), HasSubstr("does not hold complex numbers"));
}

TEST_F(Hdf5Keys, AnotherDatasetIsNamedOrListed) {
  write([](hid_t, hid_t) {}, "real", "imag", "raw");
  const std::string listed = refusal();
  EXPECT_THAT(listed, HasSubstr("/raw (2 x 3, complex)"));
  EXPECT_THAT(listed, HasSubstr("/pulse_time_s (2, float)"));
  EXPECT_THAT(listed, HasSubstr("--dataset NAME"));
  for (const char* const name : {"raw", "/raw"}) {
    const auto opened = open(name);
    ASSERT_TRUE(opened.raster) << text_of(opened.problems);
    EXPECT_EQ(read_all_rows(*opened.raster)[0], std::complex<double>(1.0, 2.0));
    EXPECT_TRUE(opened.raster->axes());
  }
  EXPECT_THAT(refusal("other"), HasSubstr("/other is not in the file"));
  EXPECT_THAT(refusal("carrier_hz"), HasSubstr("does not hold complex numbers"));
}

// The library would look for a plug-in, which is code from elsewhere.
TEST_F(Hdf5Keys, FiltersThatAreNotBuiltInAreRefusedByName) {
  for (const auto& [filter, name] :
       {std::pair(32001, "blosc (32001)"), std::pair(32015, "zstd (32015)"), std::pair(40123, "40123")}) {
    write([filter = filter](hid_t file, hid_t) {
      const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
      const std::array<hsize_t, 2> chunk{1, 3};
      H5Pset_chunk(properties.get(), 2, chunk.data());
      H5Pset_filter(properties.get(), filter, H5Z_FLAG_OPTIONAL, 0, nullptr);
      add(file, "packed", pair("r", "i", H5T_IEEE_F64LE).get(), {2, 3}, properties.get());
    });
    const std::string found = refusal("packed");
    EXPECT_THAT(found, HasSubstr("a filter that is not built in"));
    EXPECT_THAT(found, HasSubstr(name));
    EXPECT_THAT(found, HasSubstr("h5repack -f /packed:NONE"));
  }
}

TEST_F(Hdf5Keys, ADatasetIsForHdf5Alone) {
  write_test_file(folder_ / "b.npy", test_product(2, 3, 8), {scene::FileFormat::npy});
  RasterHints hints;
  hints.dataset = "raw";
  EXPECT_THAT(text_of(open_raster(Integrity::whole, folder_ / "b.npy", hints).problems),
              HasSubstr("a dataset is named"));
}

}  // namespace sarsim::raster::hdf5_keys_test
