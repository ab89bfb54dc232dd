#pragma once

#include <QWidget>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "gui/page/output_buttons.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/page/table_menu.hpp"
#include "gui/work/worker.hpp"

class QLayout;
class QPushButton;

namespace jointid::gui {

class JobLine;

/// What a run found, as it is shown.
struct Findings {
  QString said;
  bool is_bad = false;
  std::vector<PlotMenu::Named> plots;
  std::vector<PlotMenu::NamedMap> maps{};
  std::vector<TableMenu::Named> tables;
  Outputs outputs;
  std::function<void(const std::filesystem::path&)> write_frfs{};  ///< by the ending of the name; empty where it made none
};

/// A page that asks what a command of the library answers: runs it in a worker, shows diagrams and tables, and writes what the
/// command writes.
class FindingsPage : public QWidget {
  Q_OBJECT

 public:
  virtual void run() = 0;
  void cancel();
  bool is_busy() const;

  const Findings* shown() const { return found_.get(); }
  QString status() const;
  PlotMenu* plots() const { return plots_; }
  TableMenu* tables() const { return tables_; }
  /// That finds the same.
  virtual QString command_line() const = 0;
  /// What the command writes with this ending; says in the status what went wrong.
  void write(const QString& file, const QString& ending) { outputs_->write(file, ending); }

 Q_SIGNALS:
  void failed(const jointid::InputError& error);

 protected:
  struct Names {
    std::string name;  ///< of widgets
    QString title, status, plots, plot_hint, tables;
  };
  FindingsPage(const Names& names, QWidget* parent);

  /// In the order from above to the status.
  void add_above(QWidget* widget);
  /// The widgets, then the buttons that cancel, write and copy the command.
  QLayout* buttons_behind(std::initializer_list<QWidget*> first);
  /// Finds it in the worker and shows it.
  void ask(std::function<Findings(const Worker::Watch&)> find);
  /// When something begins or ends, and when something was found.
  virtual void show_buttons() = 0;

  JobLine* line() const { return line_; }
  OutputButtons* outputs() const { return outputs_; }
  QPushButton* command() const { return command_; }

 private:
  JobLine* line_;
  OutputButtons* outputs_;
  QPushButton* command_;
  PlotMenu* plots_;
  TableMenu* tables_;
  int above_ = 0;
  std::shared_ptr<const Findings> found_;
};

}  // namespace jointid::gui
