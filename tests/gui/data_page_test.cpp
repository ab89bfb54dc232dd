#include "gui/data/data_page.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QCheckBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "gui/data/frf_grid_model.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/theme.hpp"
#include "gui/plot/frf_plot.hpp"
#include "ident/scene/read_scene.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Loaded {
  Measured measured;
  ident::Scene scene;
  DataPage page;

  explicit Loaded(const char* problem = "rig1", const char* format = "uff")
      : measured(problem, format), scene(ident::read_scene(as_path(measured.scene()))) {
    page.resize(900, 700);
    page.show();
    page.set_scene(scene, "one");
    EXPECT_TRUE(rests());
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy() && !page.files().empty(); }, 20000);
  }
  void choose(std::size_t file) {
    page.choose_file(file);
    EXPECT_TRUE(rests());
  }
};

TEST(DataPage, ShowsFilesGridAndTheFirstFrf) {
  Loaded loaded;
  EXPECT_EQ(loaded.page.files().size(), 3U);
  loaded.choose(2);
  EXPECT_EQ(loaded.page.grid()->rowCount(), 12);
  EXPECT_THAT(loaded.page.grid()->known_figures(),
              ElementsAre(GridFigure::coherence, GridFigure::reciprocity, GridFigure::missing));
  EXPECT_EQ(loaded.page.plot()->curves().size(), 1U);
  EXPECT_EQ(loaded.page.plot()->curves().front().coherence.size(), 401U);
}

TEST(DataPage, DrawsAnFrfBeforeItReadsAllForTheGrid) {
  Loaded loaded;
  FrfGridModel& grid = *loaded.page.grid();
  std::vector<std::size_t> curves;
  QObject::connect(&grid, &FrfGridModel::dataChanged, &loaded.page,
                   [&] { curves.push_back(loaded.page.plot()->curves().size()); });
  loaded.page.plot()->set_curves({});
  loaded.choose(1);
  ASSERT_FALSE(curves.empty());
  EXPECT_EQ(curves.front(), 1U);
  EXPECT_FALSE(grid.known_figures().empty());
}

TEST(DataPage, DrawsTheSameFrfOfAllFiles) {
  Loaded loaded;
  loaded.choose(2);
  find<QCheckBox>(loaded.page, "everywhere")->setChecked(true);
  loaded.page.choose_frfs({{0, 0}, {11, 11}, {0, 11}});
  ASSERT_TRUE(loaded.rests());
  EXPECT_EQ(loaded.page.plot()->curves().size(), 5U);  // 101/101 and 222/222 of a part and the assembly, 101/222 of the assembly
}

TEST(DataPage, AFileThatIsNoneIsMarkedAndTheOthersStay) {
  Loaded loaded("A1", "h5");
  write_file(as_name(loaded.scene.data.substructures[0].path), "no FRFs");
  loaded.page.set_scene(loaded.scene, "two");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !loaded.page.files()[0].error.empty(); }, 20000));
  EXPECT_TRUE(loaded.page.files()[1].error.empty());
  apply(Theme::dark, *qApp);
  QCoreApplication::processEvents();
  const QColor dark = loaded.page.findChild<QTreeWidget*>()->topLevelItem(0)->child(0)->foreground(0).color();
  apply(Theme::light, *qApp);
  EXPECT_EQ(dark, colours(Theme::dark).error);
  loaded.choose(1);
  EXPECT_EQ(loaded.page.grid()->rowCount(), 6);
  loaded.choose(0);
  EXPECT_EQ(loaded.page.grid()->rowCount(), 0);
}

TEST(DataPage, BandsAndJointDofsAreEditsOfTheScene) {
  Loaded loaded("A1", "h5");
  loaded.choose(2);
  QSignalSpy edits(&loaded.page, &DataPage::edit_wanted);
  Q_EMIT loaded.page.plot()->band_chosen(100.0, 200.0);
  loaded.page.choose_frfs({{4, 0}, {5, 0}, {4, 3}});
  find<QPushButton>(loaded.page, "use_as_joint")->click();
  ASSERT_EQ(edits.count(), 2);
  EXPECT_EQ(edits[0].at(2).value<std::string>(), "[[100, 200]]");
  EXPECT_EQ(edits[1].at(2).value<std::string>(), "[\"3:+Y\", \"3:+RZ\"]");
}

TEST(DataPage, SaysMissingFrfsAndJointDofs) {
  Loaded loaded("A1", "h5");
  loaded.choose(2);
  FrfGridModel& grid = *loaded.page.grid();
  EXPECT_TRUE(grid.headerData(6, Qt::Vertical, Qt::FontRole).isValid());
  EXPECT_FALSE(grid.headerData(0, Qt::Vertical, Qt::FontRole).isValid());
  EntryFigures none;
  none.missing = 1.0;
  grid.set_figures(std::vector<EntryFigures>(14 * 14, none));
  EXPECT_EQ(grid.data(grid.index(0, 0), Qt::DisplayRole).toString(), "missing");
}

TEST(DataPage, CanBeDestroyedWhileItReads) {
  const Measured measured("A1");
  for (int i = 0; i < 5; ++i) {
    DataPage page;
    page.set_scene(ident::read_scene(as_path(measured.scene())), "one");
    QTest::qWait(i);
  }
}

TEST(EntryFigures, SeeAFlippedSensorAsReciprocityError) {
  Loaded loaded("A1", "h5");
  loaded.scene.data.assembly[0].corrections.flip = {frf::Dof::parse("1:+Y")};
  const auto files = open_files(loaded.scene.data, {});
  const auto figures = figures_of(files[2], {});
  EXPECT_GT(*figures[1].reciprocity, 1.5);            // 1:+Y/1:+RZ against 1:+RZ/1:+Y
  EXPECT_LT(*figures[14 * 1 + 2].reciprocity, 1e-6);  // 1:+RZ/2:+Y
  EXPECT_FALSE(figures[0].reciprocity.has_value());   // a driving point
}

}  // namespace
}  // namespace jointid::gui
