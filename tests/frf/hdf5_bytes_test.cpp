#include <gmock/gmock.h>
#include <sys/resource.h>

#include <cstring>
#include <random>

#include "base/stopwatch.hpp"
#include "file_fixture.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "frf/hdf5/table_file.hpp"

namespace jointid::frf {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

/// Bytes of small files changed one by one: an answer or one line, in little time and memory.
class Hdf5Bytes : public FileTest {
 protected:
  void SetUp() override {
    FileTest::SetUp();
    FrfSet set;
    set.header.frequency_hz = {1.0, 2.0, 3.0};
    set.header.response = dofs({"1:+X", "2:+X"});
    set.header.reference = dofs({"1:+X"});
    set.header.nodes = {{1, {}}, {2, {}}};
    for (int i = 0; i < 6; ++i) set.values.emplace_back(i, 1.0);
    write_hdf5(set, path("good.h5"));
    TableWriter table(path("table.h5"),
                      {.texts = {{"seed", "1"}, {"scene_hash", "x"}}, .columns = {{"K(1,1)", "N/m", 1.0}, {"K.k", "", 2.0}}}, 5);
    table.append(std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0});
    table.finish();
  }

  std::string bytes(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// What reading says of it, "read" where nothing.
  std::string said_of(const std::string& content) const {
    const auto file = write_file("bad.h5", content);
    try {
      load(*open_hdf5(file));
    } catch (const InputError& error) {
      EXPECT_EQ(error.kind(), ErrorKind::data);
      return error.what();
    }
    return "read";
  }

  static void put(std::string& content, std::size_t at, std::uint64_t number, std::size_t size = 8) {
    std::memcpy(content.data() + at, &number, size);
  }
};

/// HDF5 1.10 goes through the objects of a heap by their sizes: 0 has no end, 2⁶⁴−1 runs backwards, others lead beyond the heap.
TEST_F(Hdf5Bytes, ObjectsOfATextHeapLieInside) {
  const std::string good = bytes("good.h5");
  const std::size_t heap = good.find("GCOL");
  ASSERT_NE(heap, std::string::npos);
  constexpr std::uint64_t largest = ~std::uint64_t{0};
  for (const std::uint64_t size :
       {std::uint64_t{0}, std::uint64_t{15}, std::uint64_t{5000}, std::uint64_t{1} << 32U, largest, largest - 15}) {
    std::string bad = good;
    put(bad, heap + 8, size);
    EXPECT_THAT(said_of(bad), HasSubstr("bad.h5: ")) << "heap of " << size << " bytes";
    bad = good;
    put(bad, heap + 24, size);
    const Clock::time_point begun = Clock::now();
    EXPECT_THAT(said_of(bad), AnyOf(HasSubstr("bad.h5: "), HasSubstr("read"))) << "object of " << size << " bytes";
    EXPECT_LT(seconds_since(begun), 2.0);
  }
  std::string bad = good;
  put(bad, heap + 24, 5000);
  EXPECT_THAT(said_of(bad), HasSubstr("the heap of its texts is damaged"));
}

TEST_F(Hdf5Bytes, StorageIsHeldAgainstTheFile) {
  const std::string good = bytes("good.h5");
  std::size_t hits = 0;
  for (std::size_t at = 0; at + 8 <= good.size(); at += 8) {  // wherever the size of the storage of frequency, three numbers, stands
    std::uint64_t found = 0;
    std::memcpy(&found, good.data() + at, 8);
    if (found != 24) continue;
    std::string bad = good;
    put(bad, at, std::uint64_t{1} << 30U);
    rusage before{}, after{};
    ::getrusage(RUSAGE_SELF, &before);
    hits += said_of(bad) == "read" ? 0U : 1U;
    ::getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 100'000) << "kB";
  }
  EXPECT_GT(hits, 0U);
}

TEST_F(Hdf5Bytes, NoChangeCrashesOrHangs) {
  std::mt19937_64 random(7);
  std::size_t refused = 0;
  for (int i = 0; i < 100; ++i) {
    std::string bad = bytes(i % 2 == 0 ? "good.h5" : "table.h5");
    for (std::size_t k = 0; k <= random() % 4; ++k) {
      put(bad, random() % (bad.size() - 8), random() % 3 == 0 ? ~std::uint64_t{0} : random(), 1U << random() % 4);
    }
    const auto file = write_file("bad.h5", bad);
    const Clock::time_point begun = Clock::now();
    const auto refuses = [&](const auto& read) {
      try {
        read();
      } catch (const InputError&) {
        return true;
      }
      return false;
    };
    refused += refuses([&] { load(*open_hdf5(file)); }) ? 1U : 0U;
    refused += refuses([&] {
      const TableReader table(file);
      std::vector<double> numbers(std::min<std::size_t>(table.rows(), 8));
      for (std::size_t column = 0; column < table.header().columns.size(); ++column) table.read(column, 0, numbers);
    }) ? 1U : 0U;
    EXPECT_LT(seconds_since(begun), 3.0) << i;
  }
  EXPECT_GT(refused, 100U) << "each is at best one of the two";
}

/// A finished study with one byte changed anywhere: its own numbers, or an error.
TEST_F(Hdf5Bytes, TablesKnowTheirNumbers) {
  const std::string good = bytes("table.h5");
  const auto read = [&](const std::filesystem::path& file) {
    const TableReader table(file);
    std::vector<double> all = {table.header().columns[0].truth, static_cast<double>(table.rows())};
    for (std::size_t column = 0; column < 2; ++column) {
      std::vector<double> numbers(table.rows());
      table.read(column, 0, numbers);
      all.insert(all.end(), numbers.begin(), numbers.end());
    }
    for (const TableColumn& column : table.header().columns) all.push_back(column.name == "K(1,1)" || column.name == "K.k" ? 0.0 : 1.0);
    all.push_back(table.header().texts == std::map<std::string, std::string>{{"seed", "1"}, {"scene_hash", "x"}} ? 0.0 : 1.0);
    return all;
  };
  const std::vector<double> right = read(path("table.h5"));
  std::size_t refused = 0, tried = 0;
  const std::size_t step = good.size() / 120;
  for (std::size_t at = 3; at < good.size(); at += step, ++tried) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x41);
    const auto file = write_file("bad.h5", bad);
    try {
      EXPECT_EQ(read(file), right) << "byte " << at;
    } catch (const InputError&) {
      ++refused;
    }
  }
  std::string zeros = good;
  const std::size_t numbers = good.find(std::string("\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\x08\x40", 16));  // 1, 3 of the first column
  ASSERT_NE(numbers, std::string::npos);
  std::memset(zeros.data() + numbers, 0, 16);
  EXPECT_THAT(message_of([&] { read(write_file("bad.h5", zeros)); }),
              HasSubstr("is damaged: the checksum of column K(1,1) does not agree"));
  EXPECT_GT(refused, 0U);
}

}  // namespace
}  // namespace jointid::frf
