#include "frf/file/columns.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>

#include <cmath>
#include <string>
#include <tuple>

#include "file_fixture.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class ColumnsFile : public FileTest {
 protected:
  std::string error(const std::string& text) const {
    return message_of([&] { read_columns(write_file("a.csv", text)); });
  }
};

std::vector<std::string> names(const Columns& columns) {
  std::vector<std::string> out;
  for (const NumberColumn& column : columns.columns) out.push_back(column.name);
  return out;
}

TEST_F(ColumnsFile, SmallTextTakesLittleMemory) {
  EXPECT_LT(read_text(write_file("a.csv", "time,F,a\n0,0,0\n")).capacity(), std::size_t{1} << 16);
}

TEST_F(ColumnsFile, TextLongerThanAnyPieceIsWhole) {
  std::string text;
  for (int row = 0; text.size() < 9'000'000; ++row) text += std::to_string(row) + ",1.5\n";
  EXPECT_EQ(read_text(write_file("a.csv", text)), text);
}

TEST_F(ColumnsFile, HeaderWithUnitsAndTabs) {
  const Columns read = read_columns(write_file("a.txt", "Time [s]\tPosition (mm)\tF\n0\t-1.5\t2e3\r\n0.5\t\t+7\n"));
  EXPECT_THAT(names(read), ElementsAre("Time", "Position", "F"));
  EXPECT_EQ(read.columns[1].unit, "mm");
  EXPECT_EQ(read.columns[2].unit, "");
  EXPECT_THAT(read.column("time").values, ElementsAre(0.0, 0.5));
  EXPECT_THAT(read.column("3").values, ElementsAre(2000.0, 7.0));
  EXPECT_TRUE(std::isnan(read.column("Position").values[1]));
}

/// As writetimetable() of MATLAB writes durations.
TEST_F(ColumnsFile, NumbersWithAUnitOfTime) {
  const Columns read = read_columns(write_file("a.csv", "Time,F\n0 sec,1\n0.5 sec,2\n"));
  EXPECT_EQ(read.columns[0].unit, "sec");
  EXPECT_THAT(read.columns[0].values, ElementsAre(0.0, 0.5));
  EXPECT_EQ(read_columns(write_file("a.csv", "Time [s],F\n0 sec,1\n0.5 sec,2\n")).columns[0].unit, "s");
  EXPECT_THAT(error("Time,F\n0 sec,1\n500 ms,2\n"),
              HasSubstr("line 3, column 1: 'ms' is behind a number, and 'sec' is the unit of the others"));
  EXPECT_THAT(error("Time,F\n0 sec,1\n1 rev,2\n"), HasSubstr("line 3, column 1: '1 rev' is not a number"));
}

/// A line of blanks between words is none of numbers because it begins with one.
TEST_F(ColumnsFile, WordsWithANumberAboveTheTitles) {
  const Columns read = read_columns(write_file("a.asc", "CONVERTED\n3 channels\nTime 1 [s]\tForce [N]\n0\t1\n0.5\t2\n"));
  EXPECT_THAT(names(read), ElementsAre("Time 1", "Force"));
  EXPECT_THAT(read.columns[1].values, ElementsAre(1.0, 2.0));
}

TEST_F(ColumnsFile, AnEmptyLastCellBetweenTabsIsNoNumber) {
  const Columns read = read_columns(write_file("a.txt", "a\tb\n1\t2\n3\t\n"));
  EXPECT_TRUE(std::isnan(read.columns[1].values[1]));
}

TEST_F(ColumnsFile, BlanksCommasSemicolonsAndNoHeader) {
  for (const char* text : {"# rig\n  1.5   2\n 3 -4.25e0\n", "1.5,2\n3,-4.25\n", "1,5;2\n3;-4,25\n", "1.5\t2\n\n3\t-4.25\n"}) {
    const Columns read = read_columns(write_file("a.csv", text));
    EXPECT_THAT(names(read), ElementsAre("1", "2")) << text;
    EXPECT_THAT(read.column("1").values, ElementsAre(1.5, 3.0)) << text;
    EXPECT_THAT(read.column("2").values, ElementsAre(2.0, -4.25)) << text;
  }
}

TEST_F(ColumnsFile, FreeLinesStandAboveTheTitles) {
  for (const char* above :
       {"Hammer test\n", "Channels,2\nSample rate,2048\n\n", "Date: 1.2.2024; Operator: X\nwindow,none,0,0\n"}) {
    const Columns read = read_columns(write_file("a.csv", std::string(above) + "Time [s],Force [N]\n0,1\n0.5,2\n"));
    EXPECT_THAT(names(read), ElementsAre("Time", "Force")) << above;
    EXPECT_EQ(read.columns[1].unit, "N") << above;
    EXPECT_THAT(read.columns[1].values, ElementsAre(1.0, 2.0)) << above;
  }
  EXPECT_THAT(names(read_columns(write_file("a.csv", "Rig,two\nTime [s],Force [N]\n0,1\n"))), ElementsAre("Time", "Force"));
  const Columns read = read_columns(write_file("a.csv", "Rig,two\nt,F\ns,N\n0,1\n"));
  EXPECT_THAT(names(read), ElementsAre("t", "F"));
  EXPECT_EQ(read.columns[1].unit, "N");
  EXPECT_THAT(error("t,F\nnow,x\nthen,y\n"), AllOf(HasSubstr("line 2"), HasSubstr("'now' is not a number")));
  EXPECT_THAT(error("t [s],F [N]\nnow,x\n0,1\n"), AllOf(HasSubstr("line 2, column 1"), HasSubstr("'now' is not a number")));
}

TEST_F(ColumnsFile, QuantitiesOverTheirUnits) {
  const std::string titles = "t/ms;F in lbf;a/(m/s²);v/V;AI 1/AI 2;m/s;b in m/s^2\n";
  const Columns read = read_columns(write_file("a.csv", titles + "0;1;2;3;4;5;6\n1;1;2;3;4;5;6\n"));
  EXPECT_THAT(names(read), ElementsAre("t/ms", "F in lbf", "a", "v/V", "AI 1/AI 2", "m/s", "b in m/s^2"));
  std::vector<std::string> units;
  for (const NumberColumn& column : read.columns) units.push_back(column.unit);
  EXPECT_THAT(units, ElementsAre("ms", "lbf", "m/s²", "V", "", "", "m/s^2"));
  EXPECT_EQ(read.place("F"), 1U);
  EXPECT_EQ(read.place("f in lbf"), 1U);
  EXPECT_EQ(read.place("b"), 6U);
  EXPECT_EQ(read.place("3"), 2U);
}

TEST_F(ColumnsFile, LabViewMeasurementFiles) {
  const std::string head =
      "LabVIEW Measurement\t\nSeparator\tTab\nDecimal_Separator\t,\nX_Columns\tOne\n***End_of_Header***\t\n\t\n"
      "Channels\t2\t\t\nY_Unit_Label\tNewtons\tg\t\nX_Dimension\tTime\tTime\t\nX0\t0\t0\t\nDelta_X\t0,5\t0,5\t\n"
      "***End_of_Header***\t\t\t\nX_Value\tForce\tAcc (m/s^2)\tComment\n";
  const Columns read = read_columns(write_file("a.lvm", head + "0,0\t1,5\t2\thit\n0,5\t-1\t4e1\t\n"));
  EXPECT_THAT(names(read), ElementsAre("Time", "Force", "Acc"));
  EXPECT_EQ(read.columns[0].unit, "s");
  EXPECT_EQ(read.columns[1].unit, "Newtons");
  EXPECT_EQ(read.columns[2].unit, "g");
  EXPECT_THAT(read.columns[0].values, ElementsAre(0.0, 0.5));
  EXPECT_THAT(read.columns[1].values, ElementsAre(1.5, -1.0));
  EXPECT_THAT(read.columns[2].values, ElementsAre(2.0, 40.0));
  EXPECT_THAT(error(head + "0\t1\t2\n***End_of_Header***\n0\t1\t2\n"), HasSubstr("begins another segment"));
}

TEST_F(ColumnsFile, PipesWordsBelowAndLineEndsOfOthers) {
  for (const char* text :
       {"| t [s] | x [m] |\n|---|---|\n| 0 | 1 |\n| 1 | 2.5 |\n", "t [s];x [m]\n0;1\n1;2.5\nEnd of data\n",
        "t [s];x [m]\r0;1\r1;2.5\r", "t [s];x [m]\r\n0;1\r\nPage 1 of 2\r\n1;2.5D+00\r\nPage 2 of 2\r\n\x1A"}) {
    const Columns columns = read_columns(write_file("a.csv", text));
    ASSERT_EQ(columns.columns.size(), 2U) << text;
    EXPECT_EQ(columns.columns[1].unit, "m") << text;
    EXPECT_THAT(columns.columns[1].values, ElementsAre(1.0, 2.5)) << text;
  }
  for (const char* none : {"#N/A", "-1.#IND", "NaN", ""}) {
    const Columns columns = read_columns(write_file("a.csv", std::string("t [s];x [m]\n0;1\n1;") + none + "\n2;3\n;\n;\n"));
    ASSERT_EQ(columns.columns[1].values.size(), 3U) << none;
    EXPECT_TRUE(std::isnan(columns.columns[1].values[1])) << none;
  }
  EXPECT_EQ(read_columns(write_file("a.csv", "t [s];x [m]\n0;1\n;\n2;3\n")).columns[1].values.size(), 3U)
      << "a sample is missing";
  EXPECT_THAT(error("t [s];x [m]\n0;1\noverload\n1;2\n"), AllOf(HasSubstr("line 3"), HasSubstr("overload")));
  EXPECT_THAT(error("t [s];x\n0;1\n1;2\nY Unit: mm\n"), HasSubstr("Y Unit: mm"));
}

TEST_F(ColumnsFile, FindsAColumnByAWordOfItsName) {
  const Columns read = read_columns(write_file("a.csv", "t,Normal_force,Rel. displacement\n1,2,3\n"));
  EXPECT_EQ(read.find({"displacement", "position"})->name, "Rel. displacement");
  EXPECT_EQ(read.find({"force"})->name, "Normal_force");
  EXPECT_EQ(read.find({"force"}, {"normal"}), nullptr);
  EXPECT_EQ(read.find({"velocity"}), nullptr);
}

TEST_F(ColumnsFile, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(error("u,F\n1,2\n3,x4\n"), AllOf(HasSubstr("a.csv: line 3, column 2"), HasSubstr("'x4' is not a number")));
  EXPECT_THAT(error("u,F\n1,2\n3\n"), AllOf(HasSubstr("line 3"), HasSubstr("1 cells")));
  EXPECT_THAT(error("# nothing\n"), HasSubstr("holds no numbers"));
  EXPECT_THAT(error(std::string("\0\1\2 5", 5)), HasSubstr("no text, MATLAB, HDF5 or numpy file"));
  const Columns read = read_columns(write_file("a.csv", "u,F\n1,2\n"));
  EXPECT_THAT(message_of([&] { (void)read.column("G"); }), AllOf(HasSubstr("no column 'G'"), HasSubstr("u, F")));
  EXPECT_THAT(message_of([&] { (void)read.column("3"); }), HasSubstr("no column '3'"));
  EXPECT_THAT(message_of([&] { read_columns(path("absent.csv")); }), HasSubstr("no such file"));
}

TEST_F(ColumnsFile, ANameThatStandsTwiceIsNobody) {
  const Columns read = read_columns(write_file("a.csv", "u,F,f,F\n1,2,3,4\n"));
  EXPECT_THAT(message_of([&] { (void)read.column("F"); }), HasSubstr("the name 'F' is above 2 columns; give the number"));
  EXPECT_EQ(read.column("f").values[0], 3.0);
  EXPECT_EQ(read.column("U").values[0], 1.0);
  EXPECT_EQ(read.place("4"), 3u);
}

TEST_F(ColumnsFile, RowOfUnitsAndSeparatorLine) {
  const Columns read = read_columns(write_file("a.csv", "sep=;\nTime;A\n(ms);[V]\n\n0,5;1\n1,0;2\n"));
  EXPECT_THAT(names(read), ElementsAre("Time", "A"));
  EXPECT_EQ(read.columns[0].unit, "ms");
  EXPECT_EQ(read.columns[1].unit, "V");
  EXPECT_THAT(read.columns[0].values, ElementsAre(0.5, 1.0));
  EXPECT_THAT(error("u,F\nx4,5\n"), HasSubstr("'x4' is not a number"));
  EXPECT_THAT(error("u\tF\n1.5\t1,000\n"), HasSubstr("line 2: there are decimal points and commas"));
}

/// A hundred thousand columns are read in a moment, more are refused in one.
TEST_F(ColumnsFile, ManyColumns) {
  const auto table = [](std::size_t count) {
    std::string titles = "c0", row = "1";
    for (std::size_t k = 1; k < count; ++k) titles += ",c" + std::to_string(k), row += ",1";
    return titles + "\n" + row + "\n";
  };
  const Columns many = read_columns(write_file("a.csv", table(100'000)));
  EXPECT_EQ(many.columns.size(), 100'000u);
  EXPECT_THAT(error(table(100'001)), HasSubstr("line 1: 100001 columns are more than the 100000 that are read"));
  EXPECT_THAT(message_of([&] { (void)many.column("absent"); }), HasSubstr("c19 and"));
}

/// A dataset of doubles in a new HDF5 file, dimensions as h5py shows them.
void add_dataset(hid_t file, const char* name, std::vector<hsize_t> dims, const std::vector<double>& values) {
  const hid_t space = H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr);
  const hid_t dataset = H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(dataset);
  H5Sclose(space);
}

TEST_F(ColumnsFile, VectorsAndMatricesOfHdf5) {
  const hid_t file = H5Fcreate(path("a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  add_dataset(file, "force", {3}, {1, 2, 3});
  add_dataset(file, "long", {3, 2}, {1, 4, 2, 5, 3, 6});
  add_dataset(file, "wide", {2, 3}, {1, 2, 3, 4, 5, 6});
  H5Fclose(file);
  const Columns read = read_columns(path("a.h5"));
  EXPECT_THAT(names(read), ElementsAre("force", "long(1)", "long(2)", "wide(1)", "wide(2)"));
  for (const char* name : {"force", "long(1)", "wide(1)"}) EXPECT_THAT(read.column(name).values, ElementsAre(1, 2, 3));
  for (const char* name : {"long(2)", "wide(2)"}) EXPECT_THAT(read.column(name).values, ElementsAre(4, 5, 6));
}

void add_text(hid_t object, const char* name, const std::string& text) {
  const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
  H5Tset_size(type, text.size());
  const hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, type, text.data());
  H5Aclose(attribute);
  H5Sclose(space);
  H5Tclose(type);
}

TEST_F(ColumnsFile, UnitsOfHdf5Attributes) {
  const hid_t file = H5Fcreate(path("a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  add_dataset(file, "time", {3}, {1, 2, 3});
  add_dataset(file, "force", {3}, {1, 2, 3});
  for (const auto& [name, attribute, unit] : {std::tuple("time", "units", "ms"), std::tuple("force", "Unit", "kN")}) {
    const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
    add_text(dataset, attribute, unit);
    H5Dclose(dataset);
  }
  H5Fclose(file);
  const Columns read = read_columns(path("a.h5"));
  EXPECT_EQ(read.column("time").unit, "ms");
  EXPECT_EQ(read.column("force").unit, "kN");
}

/// Zeros that deflate packs a thousandfold; `chunk` of them together.
void add_packed(const std::string& path, hsize_t count, hsize_t chunk) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(1, &count, nullptr), plist = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(plist, 1, &chunk);
  H5Pset_deflate(plist, 9);
  H5Pset_alloc_time(plist, H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_time(plist, H5D_FILL_TIME_ALLOC);
  const hid_t dataset = H5Dcreate2(file, "x", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, plist, H5P_DEFAULT);
  H5Dclose(dataset);
  H5Pclose(plist);
  H5Sclose(space);
  H5Fclose(file);
}

TEST_F(ColumnsFile, WhatUnpacksBeyondAllMeasureIsRefused) {
  add_packed(path("a.h5"), 12'000'000, 1'000'000);
  EXPECT_THAT(message_of([&] { read_columns(path("a.h5")); }), AllOf(HasSubstr("unpacks to 91 MB"), HasSubstr("times its size")));
  add_packed(path("b.h5"), 1'000'000, 1'000'000);
  EXPECT_EQ(read_columns(path("b.h5")).columns[0].values.size(), 1'000'000u);
}

}  // namespace
}  // namespace jointid::frf
