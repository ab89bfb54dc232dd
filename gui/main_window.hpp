#pragma once

#include <QMainWindow>
#include <map>
#include <utility>
#include <vector>

#include "gui/look/theme.hpp"
#include "ident/result/solution.hpp"

class QStackedWidget;
class QTabWidget;

namespace jointid::gui {

struct DroppedFiles;
class MessageBar;
class Project;
class Worker;

/// Projects in tabs, the menus, and what is kept from one start to the next.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);

  /// Scenes are opened, each in a tab; FRF files together become a new scene. Time records and curves go to their pages.
  void open(const QStringList& files);
  Project* current() const;
  int count() const;
  MessageBar* messages() const { return messages_; }

  /// From how many seconds of runs that are kept in no file closing asks.
  void set_long_runs(double seconds) { long_runs_s_ = seconds; }
  void set_theme(Theme theme);
  /// Kept for the next start; a message offers to begin anew at once.
  void set_language(const QString& language);

 Q_SIGNALS:
  /// Another window is to open these files in place of this one, which has nothing left to save.
  void begin_anew(const QStringList& files);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void add_menus();
  void add_file_menu();
  void add_edit_menu();
  void add_view_menu();
  void add_run_menu();
  void add_help_menu();
  QMenu* make_language_menu();
  Project* add_project();
  std::vector<std::pair<QString, std::vector<ident::Estimate>>> runs_beside(const Project& project) const;
  void open_scene(const QString& file);
  void new_scene();
  void open_data(const QStringList& files, const std::map<QString, QString>& variables = {});
  void ask_for_variables(const DroppedFiles& dropped, const QStringList& files, const std::map<QString, QString>& variables);
  QMenu* make_template_menu();
  void open_example();
  void show_help();
  void show_dropped(const DroppedFiles& dropped, const QString& folder);
  Project* start_project(const std::string& text, const QString& folder);
  Project* project_for_pages();
  void show_page(int page);
  void choose_files();
  bool save(Project& project);
  bool save_as(Project& project);
  bool may_close(Project& project);
  bool may_lose_runs(Project& project);
  bool may_close_all();
  void ask_to_begin_anew();
  bool close_project(int index);
  void show_titles();
  void fill_recent(QMenu& menu);
  void keep_layout() const;
  void restore_layout();

  MessageBar* messages_;
  QStackedWidget* stack_;
  QTabWidget* tabs_;
  Worker* worker_;
  double long_runs_s_ = 60.0;
};

}  // namespace jointid::gui
