// Units that programs write without brackets, remarks beside tables, and files of formats that are not read.
#include "frf/file/unit_suffix.hpp"

#include <gmock/gmock.h>

#include <utility>

#include "frf/csv/csv_suffix.hpp"
#include "frf/file/column_units.hpp"
#include "frf/file/file_format.hpp"
#include "frf/file/node_table.hpp"
#include "frf/file/other_format.hpp"
#include "frf/file/table_remarks.hpp"
#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using namespace std::string_view_literals;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(UnitSuffix, IsReadWhereTheNameAllowsNothingElse) {
  const std::vector<std::pair<std::string, std::string>> names = {{"F_N", "N"},
                                                                  {"u_mm", "mm"},
                                                                  {"F_kN", "kN"},
                                                                  {"acc_m_s2", "m/s2"},
                                                                  {"acc_mm_s2", "mm/s2"},
                                                                  {"vel_mm_s", "mm/s"},
                                                                  {"acc_g", "g"},
                                                                  {"t_ms", "ms"},
                                                                  {"time_s", "s"},
                                                                  {"disp_in", "in"},
                                                                  {"X_in", "in"},
                                                                  {"force_lbf", "lbf"},
                                                                  {"ch1_V", "V"},
                                                                  {"Acc1_Z_m_per_s2", "m/per"},
                                                                  {"run.u_mm", "mm"},
                                                                  {"fs_khz", "khz"},
                                                                  {"f_khz", "khz"},
                                                                  {"T_N_m", ""},
                                                                  {"torque_N_m", "N*m"},
                                                                  {"F_in", ""},
                                                                  {"F_m", ""},
                                                                  {"peak_g", ""},
                                                                  {"F_n", ""},
                                                                  {"sample_no", ""},
                                                                  {"force", ""},
                                                                  {"_mm", ""},
                                                                  {"u_", ""},
                                                                  {"Axial Force kN", "kN"},
                                                                  {"Standardweg mm", "mm"},
                                                                  {"node_N", "N"},
                                                                  {"x_out", ""},
                                                                  {"a_ms", ""},
                                                                  {"acc_m_s_2", "m/s2"},
                                                                  {"channel_g", ""}};
  for (const auto& [name, unit] : names) EXPECT_EQ(suffixed_name(name).unit, unit == "m/per" ? "m/s2" : unit) << name;
  EXPECT_EQ(suffixed_name("acc_m_s2").name, "acc");
  EXPECT_EQ(suffixed_name("run.u_mm").name, "run.u");
  EXPECT_EQ(stiffness_or_mass_suffix("K_N_mm"), "N/mm");
  EXPECT_EQ(stiffness_or_mass_suffix("M_tonne"), "tonne");
  EXPECT_EQ(stiffness_or_mass_suffix("K_aa"), "");
}

TEST(UnitSuffix, OfInputsBesideOutputsIsNone) {
  Columns both{"", {{"u_in", {}, {}}, {"u_out", {}, {}}}}, alone{"", {{"u_in", {}, {}}}};
  take_unit_suffixes(both);
  take_unit_suffixes(alone);
  EXPECT_EQ(both.columns[0].unit, "");
  EXPECT_EQ(alone.columns[0].unit, "in");
}

TEST(UnitSuffix, OfAnFrfIsTakenOutOfItsTitle) {
  for (const auto& [cell, title, unit] : std::vector<std::array<std::string, 3>>{{"H11_g_N_re", "H11_re", "g/N"},
                                                                                 {"Re_H11_mm_N", "Re_H11", "mm/N"},
                                                                                 {"H11_re_m_per_s2_N", "H11_re", "m/s2/N"},
                                                                                 {"H_2_1", "H_2_1", ""},
                                                                                 {"g_n_re", "g_n_re", ""}}) {
    CsvTitle read{cell, {}};
    take_ratio(read);
    EXPECT_EQ(read.title, title);
    EXPECT_EQ(read.unit, unit) << cell;
  }
}

class TableText : public FileTest {
 protected:
  Columns read(const std::string& text) const { return read_columns(write_file("a.csv", text)); }
  std::string error(const std::string& text) const {
    return message_of([&] { read(text); });
  }
};

TEST_F(TableText, HasUnitsBehindUnderscoresAndSeparatorsInQuotes) {
  const Columns suffixed = read("t_ms,F_kN,acc_m_s2\n0,1,2\n1,2,3\n");
  EXPECT_EQ(suffixed.columns[1].unit, "kN");
  EXPECT_EQ(suffixed.column("F").name, "F_kN");
  const Columns quoted = read("\"Displacement, upper [mm]\",\"Force, cell 1 [N]\"\n\"0\",\"1\"\n\"1\",\"2.5\"\n");
  ASSERT_EQ(quoted.columns.size(), 2u);
  EXPECT_EQ(quoted.columns[0].name, "Displacement, upper");
  EXPECT_EQ(quoted.columns[1].unit, "N");
  EXPECT_THAT(quoted.columns[1].values, ElementsAre(1.0, 2.5));
}

TEST_F(TableText, RemarksThatStateUnitsOrFactorsAreNotLost) {
  const auto length = [](const Unit& unit) { return unit.same_dimension({1.0, 1, 0, 0}); };
  const auto place = [&](const std::string& text) {
    const auto unread = unread_unit(read(text), length);
    return unread ? unread->place + " " + unread->unit : std::string();
  };
  EXPECT_EQ(place("# units: mm, kN\nu,F\n0,1\n1,2\n"), "line 1 mm");
  EXPECT_EQ(place("# a\n% displacement in mm\nu,F\n0,1\n1,2\n"), "line 2 mm");
  EXPECT_EQ(place("# thickness 5 mm, preload 2 kN\nu,F\n0,1\n1,2\n"), "");
  EXPECT_EQ(place("u,F\nmm,kN\n0,1\n1,2\n"), "");
  EXPECT_THAT(error("# scale = 0.5\nu,F\n0,1\n1,2\n"), HasSubstr("states a factor, 'scale = 0.5', which is not applied"));
  EXPECT_THAT(error("u,F x1000 [N]\n0,1\n1,2\n"), HasSubstr("states a factor"));
  EXPECT_EQ(read("# scale = 1\n# time scale = 2\nu,F\n0,1\n1,2\n").columns.size(), 2u);
}

TEST_F(TableText, ClockTimesNameTheRate) {
  EXPECT_THAT(error("time,F\n12:00:00.000,1\n12:00:00.001,2\n"), HasSubstr("by --rate"));
  EXPECT_THAT(error("time,F\nabc,1\n12,2\n"), HasSubstr("begin lines that are no numbers with #"));
}

TEST_F(TableText, NodesOfFiniteElementProgramsAreTheirNumbers) {
  const auto nodes = [&](const std::string& text) { return read_node_table(write_file("n.csv", text)); };
  const std::vector<Node> read = nodes("node,x_mm,y_mm,z_mm\nPART-1-1.21,100,0,0\nPART-1-1.22,0,50,0\n");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].id, 21);
  EXPECT_NEAR(read[1].position[1], 0.05, 1e-15);
  EXPECT_THAT(message_of([&] { nodes("node,x,y,z\nPART-1-1.21,1,0,0\nPART-2-1.21,0,5,0\n"); }),
              HasSubstr("'PART-2-1.21' is not a number"));
  EXPECT_THAT(message_of([&] { nodes("node,x [mm],y,z\n1,1,0,0\n"); }), HasSubstr("some of x, y and z have a unit"));
  EXPECT_THAT(message_of([&] { nodes("# all in mm\nnode,x,y,z\n1,1,0,0\n"); }), HasSubstr("line 1: states the unit 'mm'"));
}

TEST_F(TableText, PackedFilesAndOtherFormatsNameTheirRemedy) {
  const std::vector<std::pair<std::string, std::string>> heads = {{std::string("\x1F\x8B\x08\0abc", 7), "gunzip"},
                                                                  {"BZh91AY", "bunzip2"},
                                                                  {std::string("\xFD"
                                                                               "7zXZ\0a",
                                                                               7),
                                                                   "unxz"},
                                                                  {"\x28\xB5\x2F\xFD..", "unzstd"},
                                                                  {"RIFF....WAVE", "numpy.savez"},
                                                                  {"MDF     4.10", "asammdf"},
                                                                  {"TDSm....", "npTDMS"},
                                                                  {"PAR1....", "CSV"},
                                                                  {"SQLite format 3", "CSV"},
                                                                  {"PK\x03\x04....a.csv", "unzip"},
                                                                  {"PK\x03\x04....xl/workbook", "CSV"},
                                                                  {"{\"frequency\": [1]}", "CSV"},
                                                                  {"<?xml version=\"1.0\"?>", "CSV"}};
  for (const auto& [head, remedy] : heads) {
    const auto path = write_file("a.dat", head + std::string(300, 'x'));
    EXPECT_THAT(message_of([&] { open(path); }), HasSubstr(remedy)) << head;
    EXPECT_THAT(message_of([&] { read_columns(path); }), HasSubstr(remedy)) << head;
  }
  EXPECT_FALSE(other_format("PK\x03\x04....frf.npy"));
  EXPECT_FALSE(other_format("frequency_hz,1:+Z/1:+Z re\n"));
}

}  // namespace
}  // namespace jointid::frf
