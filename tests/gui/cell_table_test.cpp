#include "gui/table/cell_table.hpp"

#include <gmock/gmock.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QTemporaryDir>

#include "base/error.hpp"
#include "gui/look/paths.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

CellRows two_by_two() { return {{"name", "value"}, {}, {{Cell{"K, left"}, Cell{"1"}}, {Cell{"D"}, Cell{"2"}}}}; }

TEST(CellTable, IsWrittenAsCsv) {
  const QTemporaryDir folder;
  CellTable table("table", "table");
  table.show_rows(two_by_two());
  table.write_csv(folder.filePath("t.csv"));
  EXPECT_EQ(read_file(folder.filePath("t.csv")), "name,value\n\"K, left\",1\nD,2\n");
}

TEST(CellTable, NumbersEndBelowEachOther) {
  CellTable table("table", "Table");
  table.show_rows({{"name", "value", "interval"}, {}, {{Cell{"K(1,1)"}, Cell{"-2.5e+06"}, Cell{"1.2 … 3.4"}}}});
  const auto alignment = [&](int column) {
    return table.cells()->index(0, column).data(Qt::TextAlignmentRole).toInt() & Qt::AlignHorizontal_Mask;
  };
  EXPECT_EQ(alignment(0), 0);
  for (const int column : {1, 2}) EXPECT_EQ(alignment(column), Qt::AlignRight) << column;
}

/// Tables that the reports share have their titles in the language of the window, and their rows as they are.
TEST(CellTable, TitlesOfReportsAreInGerman) {
  report::Table table({{"value"}, {"std error"}, {"95 % interval"}, {"|X(3)| m"}});
  table.add({"1", "2", "3", "4"});
  {
    const Spoken german("de");
    EXPECT_EQ(rows_of(table).columns, QStringList({"Wert", "Std.-Fehler", "95-%-Intervall", "|X(3)| m"}));
  }
  EXPECT_EQ(rows_of(table).columns.front(), "value");
}

TEST(CellTable, NoCsvReplacesAnInput) {
  const QTemporaryDir folder;
  const QString input = folder.filePath("frf.csv");
  write_file(input, "FRFs");
  CellTable table("table", "table");
  table.show_rows(two_by_two());
  table.protect({as_path(input)});
  EXPECT_THROW(table.write_csv(input), InputError);
  EXPECT_EQ(read_file(input), "FRFs");
}

TEST(CellTable, ItsMenuCopiesAndSaves) {
  CellTable table("table", "table");
  table.show_rows(two_by_two());
  ASSERT_EQ(table.actions().size(), 2);
  table.actions().front()->trigger();
  EXPECT_EQ(QApplication::clipboard()->text().toStdString(), "name\tvalue\nK, left\t1\nD\t2\n");
  EXPECT_EQ(table.actions().back()->shortcut(), QKeySequence("Ctrl+E"));
}

}  // namespace
}  // namespace jointid::gui
