#include "gui/solve/spring_table.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QClipboard>
#include <QTest>

#include "gui/solve/solution_tables.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

ident::Estimate estimate(const std::string& name, double value, double half) {
  ident::Estimate out;
  out.name = name;
  out.unit = "N/m";
  out.value = value;
  out.ci95 = {{value - half, value + half}};
  return out;
}

/// Two bolts, of which the second is loose, and a spring by name.
ident::Solution bolts() {
  ident::Solution solution;
  solution.unknowns = {estimate("K[1:+X,11:+X]", 1e8, 1e6), estimate("K[2:+X,12:+X]", 2e7, 1e6),     estimate("left.K.z", 2e8, 2e6),
                       estimate("D[1:+X,11:+X]", 1e7, 5e5), estimate("D[2:+X,12:+X]", 1e6, 5e5), estimate("left.D.z", 2e6, 2e5)};
  return solution;
}

std::string text(const CellRows& rows, std::size_t row, std::size_t column) { return rows.cells.at(row).at(column).text.toStdString(); }

TEST(SpringRows, HaveStiffnessAndLossFactorWithIntervals) {
  const CellRows rows = spring_rows(bolts());
  ASSERT_EQ(rows.cells.size(), 3U);
  EXPECT_EQ(text(rows, 0, 0), "1:+X – 11:+X");
  EXPECT_EQ(text(rows, 0, 1), "1e+08");
  EXPECT_EQ(text(rows, 0, 4), "0.1");
  EXPECT_EQ(text(rows, 0, 5), "± 0.006");  // 5e5/1e8 + 1e7·1e6/1e16
  EXPECT_EQ(text(rows, 2, 0), "left: z");
  EXPECT_EQ(text(rows, 2, 4), "0.01");
}

TEST(SpringRows, ShowTheLooseBoltBesideTheOthersOfItsDirection) {
  const CellRows rows = spring_rows(bolts());
  EXPECT_DOUBLE_EQ((*rows.cells[0][6].bar)[1], 1.0);
  EXPECT_DOUBLE_EQ((*rows.cells[1][6].bar)[1], 0.2);
  EXPECT_DOUBLE_EQ((*rows.cells[2][6].bar)[1], 1.0);  // of another direction
}

TEST(SpringRows, OfOtherJointsThereAreNone) {
  ident::Solution solution;
  solution.unknowns = {estimate("K(1,2)", 1.0, 0.1), estimate("M[1:+X,2:+X]", 1.0, 0.1), estimate("LK.x", 1.0, 0.1)};
  EXPECT_TRUE(spring_rows(solution).cells.empty());
}

TEST(SpringRows, WithoutDampingOrDeterminedValuesTheCellsAreEmpty) {
  ident::Solution solution;
  solution.unknowns = {estimate("K[1:+X,ground]", 1e8, 1e6), estimate("K[2:+X,ground]", 1e8, 1e6), estimate("D[2:+X,ground]", 1e8, 1e6)};
  solution.unknowns[1].determined = false;
  const CellRows rows = spring_rows(solution);
  for (const std::size_t row : {0U, 1U}) EXPECT_EQ(text(rows, row, 4), "");
  EXPECT_THAT(text(rows, 1, 2), HasSubstr("not determined"));
}

TEST(UnknownRows, StiffnessAndDampingOfSpringsHaveScalesOfTheirOwn) {
  const CellRows rows = unknown_rows(bolts());
  EXPECT_NEAR((*rows.cells[0][5].bar)[1], 1e8 / 1.01e8, 1e-12);
  EXPECT_NEAR((*rows.cells[3][5].bar)[1], 1e7 / 1.05e7, 1e-12);
}

TEST(MatrixRows, SignsHaveTheirColoursAndWhatIsNoUnknownIsBlank) {
  ident::Solution solution;
  solution.dofs = {frf::Dof::parse("1:+X"), frf::Dof::parse("2:+X"), frf::Dof::parse("3:+X")};
  solution.bands.emplace_back();
  solution.bands[0].matrices[restrictions::Kind::stiffness] = {{2.0, -1.5, 0.0}, {-1.5, 1.5, 0.0}, {0.0, 0.0, 0.0}};
  solution.unknowns = {estimate("K(3,3)", 0.0, 0.1)};
  const CellRows rows = matrix_rows(solution, 0, restrictions::Kind::stiffness);
  EXPECT_GT(*rows.cells[0][0].shade, 0.0);
  EXPECT_LT(*rows.cells[0][1].shade, 0.0);
  EXPECT_NE(shade(Theme::light, 0.5), shade(Theme::light, -0.5));
  EXPECT_EQ(text(rows, 0, 2), "");
  EXPECT_THAT(text(rows, 2, 2), HasSubstr("± 0.1"));
}

TEST(CellTable, CopiesNumbersForASpreadsheet) {
  CellTable table("matrix", "Matrix");
  Cell cell{"1.2e+08\n± 3e+05"};
  cell.copied = "123456789";
  table.show_rows({{"a", "b"}, {}, {{cell, Cell{"text"}}}});
  table.selectAll();
  QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text().toStdString(), "123456789\ttext\n");
}

}  // namespace
}  // namespace jointid::gui
