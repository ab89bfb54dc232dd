#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QTabWidget>
#include <QWhatsThis>

#include "gui/help/help_keys.hpp"
#include "gui/look/language.hpp"
#include "gui/main_window.hpp"
#include "gui/plan/plan_page.hpp"
#include "gui/project.hpp"
#include "gui/recent_files.hpp"
#include "gui/records/records_page.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"
#include "tasks/open/scene_templates.hpp"

namespace jointid::gui {
namespace {

/// Runs `act` on the project in front, if there is one, with what is typed in its form.
template <class Act>
auto on_current(MainWindow* window, Act act) {
  return [window, act] {
    Project* const project = window->current();
    if (project == nullptr) return;
    project->commit();
    act(*project);
  };
}

constexpr int curves_page = 7, records_page = 12;  // among the pages of a project

}  // namespace

void MainWindow::add_menus() {
  add_file_menu();
  add_edit_menu();
  add_view_menu();
  add_run_menu();
  add_help_menu();
}

void MainWindow::add_file_menu() {
  QMenu* const menu = menuBar()->addMenu(tr("&File"));
  menu->addAction(tr("&New scene"), QKeySequence::New, this, &MainWindow::new_scene);
  menu->addMenu(make_template_menu());
  menu->addAction(tr("&Open…"), QKeySequence::Open, this, &MainWindow::choose_files);
  menu->addAction(tr("Open &example…"), QKeySequence(tr("Ctrl+Shift+O")), this, &MainWindow::open_example);
  QMenu* const recent = menu->addMenu(tr("Open &recent"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { fill_recent(*recent); });
  menu->addSeparator();
  menu->addAction(tr("&Save"), QKeySequence::Save, this, on_current(this, [this](Project& project) { save(project); }));
  menu->addAction(tr("Save &as…"), QKeySequence(tr("Ctrl+Shift+S")), this,
                  on_current(this, [this](Project& project) { save_as(project); }));
  menu->addAction(tr("&Close"), QKeySequence(tr("Ctrl+W")), this, [this] { close_project(tabs_->currentIndex()); });
  menu->addSeparator();
  menu->addAction(tr("&Quit"), QKeySequence(tr("Ctrl+Q")), this, &QWidget::close);
}

/// Scenes to be filled in; records need none.
QMenu* MainWindow::make_template_menu() {
  auto* const menu = new QMenu(tr("New from &template"), this);
  const std::map<std::string_view, QString> titles = {{"joint", tr("&Two substructures and a joint")},
                                                      {"coupling", tr("&Coupling")},
                                                      {"decoupling", tr("&Decoupling")},
                                                      {"virtual-points", tr("&Isolator by virtual points")},
                                                      {"friction", tr("&Friction from vibration")}};
  for (const tasks::SceneTemplate& each : tasks::scene_templates())
    menu->addAction(titles.at(each.name), this, [this, &each] { start_project(std::string(each.text), {}); });
  menu->addAction(tr("&Records to FRFs"), this, [this] {
    project_for_pages()->pages()->setCurrentWidget(current()->records_page());
    current()->records_page()->choose_tool("frf");
  });
  return menu;
}

void MainWindow::fill_recent(QMenu& menu) {
  menu.clear();
  for (const QString& file : recent_files()) menu.addAction(file, this, [this, file] { open({file}); });
  if (menu.isEmpty()) menu.addAction(tr("none yet"))->setEnabled(false);
}

void MainWindow::add_edit_menu() {
  QMenu* const menu = menuBar()->addMenu(tr("&Edit"));
  menu->addAction(tr("&Undo"), QKeySequence::Undo, this, on_current(this, [](Project& project) { project.undo(); }));
  menu->addAction(tr("&Redo"), QKeySequence::Redo, this, on_current(this, [](Project& project) { project.redo(); }));
  menu->addSeparator();
  menu->addAction(tr("&Joint assistant…"), QKeySequence(tr("Ctrl+J")), this,
                  on_current(this, [](Project& project) { project.open_joint_assistant(); }));
  menu->addAction(tr("Go to &error"), QKeySequence(tr("F8")), this,
                  on_current(this, [](Project& project) { project.go_to_error(); }));
}

void MainWindow::add_view_menu() {
  QMenu* const menu = menuBar()->addMenu(tr("&View"));
  auto* const themes = new QActionGroup(this);
  const bool dark = QSettings().value(QStringLiteral("dark")).toBool();
  for (const auto& [theme, text] : {std::pair(Theme::light, tr("&Light")), std::pair(Theme::dark, tr("&Dark"))}) {
    QAction* const action = menu->addAction(text, this, [this, theme = theme] { set_theme(theme); });
    action->setCheckable(true);
    action->setChecked((theme == Theme::dark) == dark);
    themes->addAction(action);
  }
  menu->addMenu(make_language_menu());
  menu->addSeparator();
  menu->addAction(tr("&Scene"), QKeySequence(tr("Alt+1")), this,
                  on_current(this, [](Project& project) { project.switch_view(false); }));
  menu->addAction(tr("Scene as a &form"), QKeySequence(tr("F4")), this,
                  on_current(this, [](Project& project) { project.switch_view(true); }));
  int page = 0;
  for (const QString& text : {tr("&Data"), tr("&Geometry"), tr("S&olve"), tr("&Compare"), tr("S&tudy"), tr("&Modes"),
                              tr("Cou&pling"), tr("C&urves"), tr("Pl&anning"), tr("&Response"), tr("La&ws"), tr("Stic&k-slip"),
                              tr("R&ecords"), tr("&Z")}) {  // the words of the tabs
    const QString key = page < 9 ? QStringLiteral("Alt+%1").arg((page + 2) % 10) : QStringLiteral("Ctrl+%1").arg(page - 8);
    menu->addAction(text, QKeySequence(key), this, [this, page] { show_page(page); });
    ++page;
  }
  menu->addAction(tr("Fold the te&xt"), QKeySequence(tr("Ctrl+B")), this,
                  on_current(this, [](Project& project) { project.fold_text(); }));
  menu->addAction(tr("&Next project"), QKeySequence(tr("Ctrl+Tab")), this, [this] {
    if (tabs_->count() > 0) tabs_->setCurrentIndex((tabs_->currentIndex() + 1) % tabs_->count());
  });
}

/// Loading curves and time records need no scene: they are seen without one, too.
void MainWindow::show_page(int page) {
  if (current() == nullptr && page != curves_page && page != records_page) return;
  Project* const project = project_for_pages();
  project->commit();
  project->pages()->setCurrentIndex(page);
}

/// Each language by its own name.
QMenu* MainWindow::make_language_menu() {
  auto* const menu = new QMenu(tr("&Language"), this);
  auto* const group = new QActionGroup(this);
  for (const auto& [name, text] : {std::pair("en", QStringLiteral("&English")), std::pair("de", QStringLiteral("&Deutsch"))}) {
    const QString chosen = QString::fromLatin1(name);
    QAction* const action = menu->addAction(text, this, [this, chosen] { set_language(chosen); });
    action->setCheckable(true);
    action->setChecked(language() == chosen);
    action->setEnabled(has_language(chosen));
    group->addAction(action);
  }
  return menu;
}

void MainWindow::add_run_menu() {
  QMenu* const menu = menuBar()->addMenu(tr("&Run"));
  menu->addAction(tr("&Plan"), QKeySequence(tr("F6")), this, on_current(this, [](Project& project) {
                    project.pages()->setCurrentWidget(project.solve_page());
                    project.solve_page()->plan();
                  }));
  menu->addAction(tr("&Solve"), QKeySequence(tr("F5")), this, on_current(this, [](Project& project) {
                    project.pages()->setCurrentWidget(project.solve_page());
                    project.solve_page()->solve();
                  }));
  menu->addAction(tr("Predict &bounds"), QKeySequence(tr("F7")), this, on_current(this, [](Project& project) {
                    project.pages()->setCurrentWidget(project.plan_page());
                    project.plan_page()->predict();
                  }));
  menu->addAction(tr("&Cancel"), QKeySequence(tr("Shift+F5")), this,
                  on_current(this, [](Project& project) { project.cancel(); }));
}

/// Of the page in front, or of what has the focus in it.
void MainWindow::show_help() {
  const Project* const project = current();
  if (project == nullptr) return show_help_of(this);
  QWidget* const page = project->pages()->currentWidget();
  QWidget* const focus = QApplication::focusWidget();
  show_help_of(focus != nullptr && page->isAncestorOf(focus) ? focus : page);
}

void MainWindow::add_help_menu() {
  QMenu* const menu = menuBar()->addMenu(tr("&Help"));
  menu->addAction(tr("&Documentation of this page"), QKeySequence(tr("F1")), this, &MainWindow::show_help);
  menu->addAction(tr("&What's this?"), QKeySequence(tr("Shift+F1")), this, [] { QWhatsThis::enterWhatsThisMode(); });
  menu->addAction(tr("&About"), this, [this] {
    QMessageBox::about(this, tr("jointid workbench"),
                       tr("jointid workbench %1\n\nIdentifies joints from measured FRFs. Sources under BSD-3-Clause; this "
                          "program links QCustomPlot and is passed on under the GPL, version 3.")
                           .arg(QStringLiteral(JOINTID_VERSION)));
  });
}

}  // namespace jointid::gui
