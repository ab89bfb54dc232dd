#include <gmock/gmock.h>

#include "file_fixture.hpp"
#include "frf/file/write.hpp"
#include "frf/mat/mat_module.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

class Open : public FileTest {
 protected:
  std::string error(const std::string& name) const {
    return message_of([&] { open(path(name)); });
  }
};

TEST_F(Open, KnowsEveryFormatByItsContent) {
  std::mt19937 random(31);
  const FrfSet set = random_set(random, Quantity::accelerance, NoiseRecord::none);
  std::vector<std::string> formats = {"h5", "HDF5", ".csv"};
  if (has_matio()) formats.push_back("mat");
  for (const std::string& format : formats) {
    write(set, path("a.data"), format);
    expect_same(load(*open(path("a.data"))), set, 1e-15);
  }
}

TEST_F(Open, AUnitIsTakenWhereTheFormatHasNoOther) {
  FrfSet set;
  set.header.quantity = Quantity::accelerance;
  set.header.frequency_hz = {10.0, 20.0};
  set.header.response = {Dof::parse("4:+X")};
  set.header.reference = {Dof::parse("1:+Y")};
  set.values = {{1e-6, -2e-6}, {3e-6, 4e-6}};
  OpenOptions unit, axis;
  unit.unit = "g/N";
  axis.frequency_unit = "kHz";
  write(set, path("a.h5"));
  write(set, path("a.csv"));
  write(set, path("a.uff"));
  EXPECT_THAT(message_of([&] { open(path("a.h5"), unit); }, ErrorKind::usage),
              HasSubstr("the unit 'g/N' is given, and a file of format HDF5 jointid-frf has a place of its own for it"));
  EXPECT_THAT(message_of([&] { open(path("a.h5"), axis); }, ErrorKind::usage),
              HasSubstr("and a file of format HDF5 jointid-frf has Hz"));
  EXPECT_NO_THROW(open(path("a.uff"), unit));
  for (Complex& value : set.values) value *= 9.80665;
  expect_same(load(*open(path("a.csv"), unit)), set, 1e-14);
}

TEST_F(Open, ACoherenceOfUnknownAveragesIsKept) {
  std::mt19937 random(34);
  FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::coherence);
  set.header.averages = 0.0;
  std::vector<std::string> formats = {"h5", "csv"};
  if (has_matio()) formats.push_back("mat");
  for (const std::string& format : formats) {
    write(set, path("a.data"), format);
    expect_same(load(*open(path("a.data"))), set, 0.0);
  }
}

TEST_F(Open, TheExtensionChoosesWhatIsWritten) {
  std::mt19937 random(32);
  const FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::none);
  write(set, path("a.CSV"));
  std::ifstream in(path("a.CSV"));
  EXPECT_EQ(in.get(), '#');
  EXPECT_THAT(message_of([&] { write(set, path("a.xls")); }, ErrorKind::usage),
              HasSubstr("a.xls: 'xls' is no format of FRF files; name the file .h5, .uff, .mat or .csv"));
}

TEST_F(Open, AFullDiskLeavesTheOldFile) {
  std::mt19937 random(33);
  const FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::variance);
  write_file("a.data", "old");
  std::vector<std::string> formats = {"h5", "csv"};
  if (has_matio()) formats.push_back("mat");
  for (const std::string& format : formats) {
    for (const rlim_t room : {1u, 100u, 300u, 600u, 1000u}) {
      const SmallDisk disk(room);
      EXPECT_THAT(message_of([&] { write(set, path("a.data"), format); }), HasSubstr("a.data: cannot be written"));
    }
  }
  EXPECT_EQ(std::filesystem::file_size(path("a.data")), 3u);
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(Open, WhatCannotBeOpenedSaysWhy) {
  EXPECT_THAT(error("none.h5"), HasSubstr("none.h5: there is no such file"));
  write_file("empty.h5", "");
  EXPECT_THAT(error("empty.h5"), HasSubstr("empty.h5: is empty"));
  EXPECT_THAT(message_of([&] { open(folder_); }), HasSubstr("is a folder"));
  EXPECT_THAT(message_of([&] { open("/dev/null"); }), HasSubstr("is not a regular file"));
  EXPECT_THAT(error("empty.h5/a.h5"), HasSubstr("a.h5: "));
}

TEST_F(Open, WhatMayNotBeReadSaysSo) {
  using std::filesystem::perms;
  std::filesystem::permissions(write_file("a.h5", "x"), perms::none);
  std::filesystem::create_directory(path("closed"));
  write_file("closed/a.h5", "x");
  std::filesystem::permissions(path("closed"), perms::none);
  std::filesystem::permissions(folder_, perms::all);
  const uid_t user = ::geteuid();
  const bool is_root = user == 0;  // root may read everything, so be nobody for a moment
  ASSERT_EQ(::seteuid(is_root ? 65534 : user), 0);
  const std::string file = error("a.h5"), folder = error("closed/a.h5");
  ASSERT_EQ(::seteuid(user), 0);
  std::filesystem::permissions(path("closed"), perms::owner_all);  // so that it can be removed
  EXPECT_THAT(file, HasSubstr("a.h5: cannot be opened: Permission denied; check its permissions"));
  EXPECT_THAT(folder, HasSubstr("a.h5: cannot be opened: Permission denied; check its path and the permissions of its folders"));
}

TEST_F(Open, AnotherFormatSaysWhatWasFound) {
  write_file("a.bin", std::string("\x01\x02\x03\x04\0\0", 6));
  EXPECT_THAT(error("a.bin"), HasSubstr("a.bin: begins with bytes 01 02 03 04 00 00 and is no FRF file that this"));
  write_file("a.txt", "Dear reader\nhow do you do\n");
  EXPECT_THAT(error("a.txt"), HasSubstr("begins with 'Dear reader' and is no FRF file"));
  EXPECT_THAT(error("a.txt"), HasSubstr("give jointid-frf HDF5, UFF, MATLAB v4 to v7.3, CSV or the text export of an analyser"));
  write_file("old.mat", "MATLAB 5.0 MAT-file, and no more");
  EXPECT_THAT(error("old.mat"), HasSubstr(has_matio() ? "old.mat: is damaged or truncated: it ends early" : "need matio"));
}

}  // namespace
}  // namespace jointid::frf
