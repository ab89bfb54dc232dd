#pragma once

#include <QWidget>
#include <memory>

#include "gui/records/record_tool.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace jointid::gui {

class JobLine;
class ToolForm;

/// Tools for time records, as `jointid pod` and `jointid series` have them: proper orthogonal modes, delay and dimension, the
/// friction law of a contact. Needs no scene; files are chosen or dropped.
class RecordsPage : public QWidget {
  Q_OBJECT

 public:
  explicit RecordsPage(QWidget* parent = nullptr);

  void open(const QStringList& files);
  void run();
  void cancel();
  bool is_busy() const;

  const SceneFindings* shown() const { return found_.get(); }
  QString status() const;
  QComboBox* tools() const { return tool_; }
  PlotMenu* plots() const { return plots_; }
  TableMenu* tables() const { return tables_; }
  QString command_line() const;
  /// What the command writes with this ending; says in the status what went wrong.
  void write(const QString& file, const QString& ending) { outputs_->write(file, ending); }

 Q_SIGNALS:
  void failed(const jointid::InputError& error);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* make_top();
  const RecordTool& tool() const;
  ToolForm& form() const;
  void show_tool();
  void show_buttons();
  void show_found(std::shared_ptr<const SceneFindings> found);

  std::vector<RecordTool> all_;
  QPushButton *run_, *command_;
  QComboBox* tool_;
  QLabel* names_;
  QStackedWidget* forms_;
  OutputButtons* outputs_;
  JobLine* line_;
  PlotMenu* plots_;
  TableMenu* tables_;
  QStringList files_;
  std::shared_ptr<const SceneFindings> found_;
};

}  // namespace jointid::gui
