#include <gmock/gmock.h>

#include "file_fixture.hpp"
#include "frf/file/write.hpp"
#include "frf/hdf5/table_file.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

/// A disk that is full at any place of a file: the older file of the name stays as it was.
class FullDisk : public FileTest {
 protected:
  static FrfSet set_of(double value) {
    FrfSet set;
    for (int line = 1; line <= 40; ++line) set.header.frequency_hz.push_back(line);
    set.header.response = dofs({"1:+X", "2:+X", "3:+X", "4:+X"});
    set.header.reference = dofs({"1:+X", "2:+X"});
    set.header.noise = NoiseRecord::coherence;
    set.header.averages = 5.0;
    for (std::size_t i = 0; i < 320; ++i) set.values.emplace_back(value + static_cast<double>(i), -value);
    set.coherence.assign(320, 0.9);
    return set;
  }

  std::string bytes(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// Runs `write`, which replaces the file, on disks that hold ever more of it.
  template <class Write>
  void expect_older_file_kept(const std::string& name, const Write& write) const {
    const std::string older = bytes(name);
    ASSERT_FALSE(older.empty());
    const std::size_t places = 40;
    for (std::size_t i = 0; i < places; ++i) {
      const std::size_t limit = (older.size() - 1) * i / (places - 1);
      const std::string said = [&] {
        const SmallDisk disk(limit);
        return message_of(write);
      }();
      EXPECT_THAT(said, HasSubstr(name + ": cannot be written: ")) << name << " on a disk that holds " << limit << " bytes";
      EXPECT_TRUE(bytes(name) == older) << name << " on a disk that holds " << limit << " bytes";
      EXPECT_EQ(files_in_folder(), 1U) << name;
    }
    write();
    EXPECT_FALSE(bytes(name) == older) << "nothing else was written where there is room";
  }
};

class FullDiskOfFormat : public FullDisk, public ::testing::WithParamInterface<const char*> {};

TEST_P(FullDiskOfFormat, KeepsTheOlderFile) {
  write(set_of(1.0), path(GetParam()));
  expect_older_file_kept(GetParam(), [&] { write(set_of(2.0), path(GetParam())); });
}

INSTANTIATE_TEST_SUITE_P(Formats, FullDiskOfFormat, ::testing::Values("o.h5", "o.uff", "o.mat", "o.csv"),
                         [](const auto& info) { return std::string(info.param).substr(2); });

TEST_F(FullDisk, TablesOfTrialsKeepTheOlderFile) {
  const auto write = [&](double value) {
    const std::vector<double> rows(2 * 3000, value);
    TableWriter table(path("t.h5"), {.texts = {{"seed", "1"}}, .columns = {{"x", "N/m", 1.0}, {"y", "", 2.0}}}, 3000);
    table.append(rows);
    table.finish();
  };
  write(1.0);
  expect_older_file_kept("t.h5", [&] { write(2.0); });
}

}  // namespace
}  // namespace jointid::frf
