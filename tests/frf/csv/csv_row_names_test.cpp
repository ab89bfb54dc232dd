// Tables as write.table() of R writes them: titles in quotes, one fewer than cells, names of rows.
#include <gmock/gmock.h>

#include "frf/csv/csv_row_names.hpp"
#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

class CsvRowNames : public FileTest {
 protected:
  void expect_right(const std::string& table) const {
    const FrfSet set = load(*open(write_file("a.txt", "# quantity = receptance\n" + table)));
    EXPECT_EQ(set.header.frequency_hz, (std::vector<double>{10.5, 20.5})) << table;
    EXPECT_EQ(set.header.response, dofs({"12:-Z"})) << table;
    EXPECT_EQ(set.values, (std::vector<Complex>{{2.5, -1.5}, {3.5, 4.5}})) << table;
  }
};

TEST_F(CsvRowNames, EverySeparatorWithAndWithoutNamesAndQuotes) {
  const std::string blanks = R"("frequency_hz" "12:-Z/3:+X re" "12:-Z/3:+X im")" "\n";
  expect_right(blanks + "\"1\" 10.5 2.5 -1.5\n\"2\" 20.5 3.5 4.5\n");
  expect_right(blanks + "\"first\" 10,5 2,5 -1,5\n\"last\" 20,5 3,5 4,5\n");
  expect_right(blanks + "10.5 2.5 -1.5\n20.5 3.5 4.5\n");
  for (const char separator : {',', ';', '\t'}) {
    for (const bool quotes : {true, false}) {
      std::string table = R"("frequency_hz","12:-Z/3:+X re","12:-Z/3:+X im")" "\n\"1\",10.5,2.5,-1.5\n\"2\",20.5,3.5,4.5\n";
      std::ranges::replace(table, ',', separator);
      if (!quotes) std::erase(table, '"');
      expect_right(table);
    }
  }
}

TEST_F(CsvRowNames, OtherTablesWithACellMoreAreNone) {
  EXPECT_FALSE(without_row_names("frequency_hz,re,im\n10,1,2,3\n20,1,2,3\n"));
  EXPECT_FALSE(without_row_names("frequency_hz,re,im\n1,1,2,\n2,1,2,\n"));
  EXPECT_FALSE(without_row_names("frequency_hz,re,im\n1,1,2\n2,1,2\n"));
  EXPECT_THAT(message_of([&] { open(write_file("a.csv", "# quantity = receptance\nfrequency_hz,1:+Z/1:+Z re,1:+Z/1:+Z im\n10,1,2,3\n")); }),
              HasSubstr("the line has 4 cells and the header 3"));
}

}  // namespace
}  // namespace jointid::frf
