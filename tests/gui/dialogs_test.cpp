#include <gmock/gmock.h>

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QTest>
#include <QTextDocument>
#include <QTimer>
#include <QToolButton>
#include <deque>
#include <functional>

#include "gui/data/data_page.hpp"
#include "gui/forms/field.hpp"
#include "gui/forms/scene_form.hpp"
#include "gui/geometry/geometry_page.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/main_window.hpp"
#include "gui/modal/modal_page.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/table/cell_table.hpp"
#include "widgets.hpp"

/// Dialogs are opened, answered and left by keys alone.
namespace jointid::gui {
namespace {

constexpr int patience_ms = 20000;

/// Answers the dialogs that a window opens, one after the other, whether one is opened by another or after it. Dialogs that nobody waits
/// for, and those that no key closes, are closed in the end, and the test fails.
class Answers {
 public:
  Answers() {
    QObject::connect(&poll_, &QTimer::timeout, [this] { look(); });
    poll_.start(10);
    QObject::connect(&guard_, &QTimer::timeout, [this] { give_up(); });
    guard_.start(patience_ms);
  }
  /// To a dialog that had none, or (`again`) to one that stayed open after its answer.
  void add(std::function<void(QWidget&)> give, bool again = false) { waiting_.push_back({std::move(give), again}); }
  int given() const { return given_; }

 private:
  struct Answer {
    std::function<void(QWidget&)> give;
    bool again;
  };
  void look() {
    QWidget* const dialog = QApplication::activeModalWidget();
    if (dialog == nullptr || !dialog->isVisible() || waiting_.empty() || seen_.contains(dialog) != waiting_.front().again) return;
    dialog->activateWindow();
    if (!dialog->isActiveWindow()) return;  // at another look
    seen_ << dialog;
    const auto give = waiting_.front().give;
    waiting_.pop_front();
    ++given_;
    // not in here: while it lasts the timer stands still, and the answer may open the next dialog
    QMetaObject::invokeMethod(dialog, [dialog, give] { give(*dialog); }, Qt::QueuedConnection);
  }
  void give_up() {
    if (QApplication::activeModalWidget() == nullptr) return;
    ADD_FAILURE() << QApplication::activeModalWidget()->windowTitle().toStdString() << " is still open";
    guard_.start(100);
    static_cast<QDialog*>(QApplication::activeModalWidget())->reject();
  }

  QTimer poll_, guard_;
  std::deque<Answer> waiting_;
  QList<QPointer<QWidget>> seen_;
  int given_ = 0;
};

struct Keys {
  QTemporaryDir folder;
  MainWindow window;
  Answers answers;

  Keys() {
    window.resize(1000, 700);
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
  }
  ~Keys() {
    for (Project* project : window.findChildren<Project*>()) project->editor()->document()->setModified(false);
  }
  QString file(const char* name) const { return folder.filePath(name); }
  Project& open(const std::string& text = small_scene) {
    write_file(file("scene.toml"), text);
    window.open({file("scene.toml")});
    return *window.current();
  }
  void next(const std::function<void(QWidget&)>& act) { answers.add(act); }
  void then(const std::function<void(QWidget&)>& act) { answers.add(act, true); }
  /// A key of the window, or of a widget in it, which a dialog that was open may have left inactive.
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier, QWidget* widget = nullptr) {
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    if (widget != nullptr) widget->setFocus();
    QTest::keyClick(widget == nullptr ? &window : widget, key, modifiers);
  }
};

void press_key(QWidget& dialog, Qt::Key key) { QTest::keyClick(&dialog, key); }

/// A name for the file, in the field that has the focus. Without the proposals of the field: a popup takes keys of its own, in its own
/// time.
QLineEdit& type_name(QWidget& dialog, const QString& name) {
  auto* const field = qobject_cast<QLineEdit*>(dialog.focusWidget());
  EXPECT_NE(field, nullptr);
  field->setCompleter(nullptr);
  field->selectAll();
  QTest::keyClicks(field, name);
  return *field;
}

void choose_by_return(QWidget& dialog, const QString& name) { QTest::keyClick(&type_name(dialog, name), Qt::Key_Return); }

/// To the button, as far as it is, and Space on it.
void choose_by_tab(QWidget& dialog, const QString& name) {
  type_name(dialog, name);
  const auto is_default = [&] {
    const auto* const button = qobject_cast<QPushButton*>(dialog.focusWidget());
    return button != nullptr && button->isDefault();
  };
  for (int tabs = 0; tabs < 20 && !is_default(); ++tabs) QTest::keyClick(dialog.focusWidget(), Qt::Key_Tab);
  ASSERT_TRUE(is_default());
  QTest::keyClick(dialog.focusWidget(), Qt::Key_Space);
}

TEST(Dialogs, EscapeOpensNothing) {
  Keys keys;
  keys.next([](QWidget& dialog) { press_key(dialog, Qt::Key_Escape); });
  keys.press(Qt::Key_O, Qt::ControlModifier);
  EXPECT_EQ(keys.answers.given(), 1);
  EXPECT_EQ(keys.window.count(), 0);
}

/// Enter saves, Escape stays.
TEST(Dialogs, UnsavedChangesAreAskedAbout) {
  Keys keys;
  QTest::keyClicks(keys.open().editor(), "# x");
  keys.next([](QWidget& dialog) { press_key(dialog, Qt::Key_Escape); });
  keys.press(Qt::Key_W, Qt::ControlModifier);
  ASSERT_EQ(keys.window.count(), 1);
  keys.next([](QWidget& dialog) { press_key(dialog, Qt::Key_Return); });
  keys.press(Qt::Key_W, Qt::ControlModifier);
  ASSERT_EQ(keys.window.count(), 0);
  EXPECT_THAT(read_file(keys.file("scene.toml")), testing::StartsWith("# x"));
  EXPECT_EQ(keys.answers.given(), 2);
}

TEST(Dialogs, AboutIsReadAndLeft) {
  Keys keys;
  QString text;
  keys.next([&](QWidget& dialog) {
    text = static_cast<QMessageBox&>(dialog).text();
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  keys.press(Qt::Key_H, Qt::AltModifier);
  ASSERT_NE(QApplication::activePopupWidget(), nullptr);
  QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_A);
  EXPECT_EQ(keys.answers.given(), 1);
  EXPECT_THAT(text.toStdString(), testing::HasSubstr("QCustomPlot"));
}

TEST(Dialogs, AFileIsOpenedByItsName) {
  Keys keys;
  write_file(keys.file("one.toml"), small_scene);
  write_file(keys.file("two.toml"), small_scene);
  keys.next([&](QWidget& dialog) { choose_by_return(dialog, keys.file("one.toml")); });
  keys.press(Qt::Key_O, Qt::ControlModifier);
  ASSERT_EQ(keys.window.count(), 1);
  keys.next([&](QWidget& dialog) { choose_by_tab(dialog, "two.toml"); });  // in the folder that is remembered
  keys.press(Qt::Key_O, Qt::ControlModifier);
  ASSERT_EQ(keys.window.count(), 2);
  EXPECT_EQ(keys.window.current()->file(), keys.file("two.toml"));
  EXPECT_EQ(keys.answers.given(), 2);
}

/// A name that is not there is said to be none, and the dialog stays.
TEST(Dialogs, AFileThatIsNotThereIsAskedForAgain) {
  Keys keys;
  write_file(keys.file("one.toml"), small_scene);
  keys.next([&](QWidget& dialog) { choose_by_return(dialog, keys.file("none.toml")); });
  keys.next([](QWidget& box) { press_key(box, Qt::Key_Return); });
  keys.then([&](QWidget& dialog) { choose_by_return(dialog, keys.file("one.toml")); });
  keys.press(Qt::Key_O, Qt::ControlModifier);
  ASSERT_EQ(keys.window.count(), 1);
  EXPECT_EQ(keys.window.current()->file(), keys.file("one.toml"));
}

TEST(Dialogs, ASceneIsSavedUnderAName) {
  Keys keys;
  QTest::keyClicks(keys.open().editor(), "# x");
  keys.next([&](QWidget& dialog) { choose_by_return(dialog, keys.file("other")); });
  keys.press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_THAT(read_file(keys.file("other.toml")), testing::StartsWith("# x"));
  EXPECT_EQ(read_file(keys.file("scene.toml")), small_scene);
  EXPECT_EQ(keys.window.current()->file(), keys.file("other.toml"));
}

/// What is there is asked about before it is replaced: Return keeps it, Alt+Y replaces it.
TEST(Dialogs, AFileIsReplacedOnlyWhenThatIsSaid) {
  Keys keys;
  QTest::keyClicks(keys.open().editor(), "# x");
  write_file(keys.file("other.toml"), "mine");
  keys.next([&](QWidget& dialog) { choose_by_return(dialog, keys.file("other.toml")); });
  keys.next([](QWidget& box) { press_key(box, Qt::Key_Return); });
  keys.then([](QWidget& dialog) { press_key(dialog, Qt::Key_Escape); });
  keys.press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(read_file(keys.file("other.toml")), "mine");
  keys.next([&](QWidget& dialog) { choose_by_return(dialog, keys.file("other.toml")); });
  keys.next([](QWidget& box) { QTest::keyClick(&box, Qt::Key_Y, Qt::AltModifier); });
  keys.press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_THAT(read_file(keys.file("other.toml")), testing::StartsWith("# x"));
  EXPECT_EQ(keys.answers.given(), 5);
}

TEST(Dialogs, ATableIsSavedFromItsKey) {
  Keys keys;
  Project& project = keys.open();
  project.pages()->setCurrentWidget(project.solve_page());
  CellTable& table = *project.solve_page()->unknowns();
  project.solve_page()->results()->setCurrentWidget(&table);
  table.show_rows({{"a", "b"}, {}, {{Cell{"1"}, Cell{"2"}}}});
  keys.next([&](QWidget& dialog) { choose_by_tab(dialog, keys.file("table")); });
  keys.press(Qt::Key_E, Qt::ControlModifier, &table);
  EXPECT_EQ(read_file(keys.file("table.csv")), "a,b\n1,2\n");
}

/// A plot by its button; a name that says nothing it can write is an error, which is left by Return.
TEST(Dialogs, APlotIsSavedFromItsButton) {
  Keys keys;
  Project& project = keys.open();
  project.pages()->setCurrentWidget(project.data_page());
  auto* const button = project.data_page()->plot()->findChild<QToolButton*>("plot_save");
  keys.next([&](QWidget& dialog) { choose_by_return(dialog, keys.file("plot")); });
  keys.press(Qt::Key_Space, Qt::NoModifier, button);
  EXPECT_TRUE(QFileInfo::exists(keys.file("plot.png")));
  QString said;
  keys.next([&](QWidget& dialog) { choose_by_return(dialog, keys.file("plot.doc")); });
  keys.next([&](QWidget& box) {
    said = static_cast<QMessageBox&>(box).text();
    press_key(box, Qt::Key_Return);
  });
  keys.press(Qt::Key_Space, Qt::NoModifier, button);
  EXPECT_THAT(said.toStdString(), testing::HasSubstr(".svg"));
  EXPECT_FALSE(QFileInfo::exists(keys.file("plot.doc")));
}

/// Wherever files were opened from in between.
TEST(Dialogs, OutputsAreProposedByNameInTheFolderOfTheScene) {
  Keys keys;
  Project& project = keys.open();
  const QTemporaryDir elsewhere;
  const QString other = elsewhere.filePath("other.uff");
  write_file(other, "");
  keys.next([&](QWidget& dialog) { choose_by_return(dialog, other); });
  EXPECT_EQ(choose_files_to_open(&keys.window), QStringList{other});
  CellTable& table = *project.solve_page()->unknowns();
  table.show_rows({{"a"}, {}, {{Cell{"1"}}}});
  const auto proposed = [&](QWidget& page, QWidget* widget, Qt::Key key, Qt::KeyboardModifiers modifiers) {
    project.pages()->setCurrentWidget(&page);
    QStringList files;
    keys.next([&](QWidget& dialog) {
      files = static_cast<QFileDialog&>(dialog).selectedFiles();
      press_key(dialog, Qt::Key_Escape);
    });
    keys.press(key, modifiers, widget);
    return files;
  };
  const auto by = [](QWidget& page, const char* name) { return page.findChild<QWidget*>(QString::fromLatin1(name)); };
  QWidget &data = *project.data_page(), &geometry = *project.geometry_page(), &modal = *project.modal_page();
  project.solve_page()->results()->setCurrentWidget(&table);
  EXPECT_EQ(proposed(*project.solve_page(), &table, Qt::Key_E, Qt::ControlModifier), QStringList{keys.file("unknowns.csv")});
  EXPECT_EQ(proposed(data, by(data, "plot_save"), Qt::Key_Space, {}), QStringList{keys.file("frf.png")});
  EXPECT_EQ(proposed(geometry, by(geometry, "geometry_save"), Qt::Key_Space, {}), QStringList{keys.file("geometry.png")});
  EXPECT_EQ(proposed(modal, by(modal, "chart_save"), Qt::Key_Space, {}), QStringList{keys.file("stabilisation.png")});
}

TEST(Dialogs, FilesAreAddedToTheForm) {
  Keys keys;
  Project& project = keys.open();
  write_file(keys.file("d.uff"), "");
  keys.press(Qt::Key_F4);
  keys.next([&](QWidget& dialog) { choose_by_return(dialog, keys.file("d.uff")); });
  keys.press(Qt::Key_Space, Qt::NoModifier, project.form()->field("data", "assembly")->findChild<QToolButton*>("choose_files"));
  EXPECT_THAT(project.editor()->text(), testing::HasSubstr("assembly = [\"c.uff\", \"d.uff\"]"));
}

/// The dialogs of all other outputs and inputs are these two.
TEST(Dialogs, WhatIsNotChosenIsNothing) {
  Keys keys;
  keys.next([](QWidget& dialog) { press_key(dialog, Qt::Key_Escape); });
  EXPECT_TRUE(choose_file_to_save(&keys.window, "Save", {}, "Tables (*.csv)", "csv").isEmpty());
  keys.next([](QWidget& dialog) { press_key(dialog, Qt::Key_Escape); });
  EXPECT_TRUE(choose_files_to_open(&keys.window).isEmpty());
  EXPECT_EQ(keys.answers.given(), 2);
}

}  // namespace
}  // namespace jointid::gui
