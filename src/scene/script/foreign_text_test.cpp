#include "scene/script/foreign_text.hpp"

#include <gmock/gmock.h>

#include "scene/script/reader.hpp"

namespace sarsim::scene::foreign_text_test {

using testing::HasSubstr;
using namespace std::string_view_literals;

TEST(ForeignText, NamesWhatContentSeemsToBe) {
  const std::pair<std::string_view, const char*> cases[] = {
      {"", "an empty file"},
      {" \n\n\t", "an empty file"},
      {"radar:\n  carrier: 9.6 GHz\n  gain: 30\ntargets:\n  - x: 1\n", "YAML"},
      {"---\na: 1\n", "YAML"},
      {"{\"radar\": {}}", "JSON"},
      {"[\n1, 2]", "JSON"},
      {"<?xml version=\"1.0\"?>\n<a/>", "XML"},
      {"<?xml version=\"1.0\"?>\n<kml xmlns=\"x\">", "KML"},
      {"<simulation name=\"a\">", "XML, perhaps a scene of FERS"},
      {"[radar]\ncarrier = 9.6 GHz\n", "an INI file"},
      {"x,y,z\n1,2,3\n4,5,6\n", "a table of numbers (CSV)"},
      {"name,kind\na,b\n", "a table (CSV)"},
      {"1 2 3\n4 5 6\n", "a table of numbers"},
      {"\x89PNG\r\n\x1a\n"sv, "a PNG picture"},
      {"\x89HDF\r\n\x1a\n"sv, "an HDF5 file"},
      {"PK\x03\x04\x14\0\0\0\0\0arr_0.npy"sv, "NumPy arrays in a ZIP archive (.npz)"},
      {"PK\x03\x04\x14\0\0\0other"sv, "a ZIP archive"},
      {"\x1f\x8b\x08\0"sv, "a gzip file"},
      {"\x7f"
       "ELF\x02\x01"sv,
       "a program (ELF)"},
      {"%PDF-1.7\n", "a PDF document"},
      {"#!/bin/sh\necho a\n", "a shell script"},
      {"#!/usr/bin/env python3\n", "a Python program"},
      {"import numpy as np\nx = 3\n", "a Python program"},
      {"MATLAB 5.0 MAT-file, Platform: GLNXA64", "a MATLAB file (.mat, version 5)"},
      {"MATLAB 7.3 MAT-file, Platform: GLNXA64", "a MATLAB file (.mat, version 7.3, HDF5)"},
      {"II*\0\x08\0\0\0"sv, "a TIFF picture, perhaps GeoTIFF"},
      {"\x93NUMPY\x01\0"sv, "a NumPy array"},
      {"\0\x01\x02\x03"sv, "binary data"},
      {"CCSDS_OEM_VERS = 2.0\n", "an orbit or attitude file of CCSDS"},
      {"ENVI\nsamples = 3\n", "the header of an ENVI image"},
      {"Dear reader,\nthis is a letter.\n", ""}};
  for (const auto& [content, kind] : cases) EXPECT_EQ(guess_of_content(content), kind) << content;
}

std::string errors_of(std::string_view text, bool draft = false) {
  ReadControl control;
  control.draft = draft;
  std::string errors;
  for (const core::Problem& problem : read_script(text, "a", {}, control).problems)
    if (problem.severity == core::Severity::error) errors += core::to_string(problem) + "\n";
  return errors;
}

TEST(ForeignText, AScriptWithoutACommandIsNone) {
  EXPECT_THAT(errors_of("radar:\n  carrier: 9.6 GHz\n"), HasSubstr("this is no scene: it seems to be YAML"));
  EXPECT_THAT(errors_of("a price of 5 $\n"), HasSubstr("this is no scene"));
  EXPECT_THAT(errors_of("a price of 5 $ or more\n"), HasSubstr("unknown command"));
  EXPECT_EQ(errors_of("! a scene without objects, as it is written\n"), "");
  EXPECT_THAT(errors_of("\x89PNG\r\n\x1a\n\0\0"sv), HasSubstr("it seems to be a PNG picture"));
  EXPECT_EQ(errors_of("", true), "") << "an editor's new text";
  EXPECT_EQ(errors_of("Radar", true), "") << "its first words";
  EXPECT_THAT(errors_of("radar:\n  carrier: 9.6 GHz\n", true), HasSubstr("YAML")) << "a file that was opened";
  EXPECT_EQ(errors_of("A radar of 1998\n$OPTIONS\n"), "") << "text before the first command";
}

}  // namespace sarsim::scene::foreign_text_test
