#pragma once

#include "gui/records/record_tool.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace jointid::gui {

class ToolForm;

/// Tools for time records, as `jointid pod` and `jointid series` have them: proper orthogonal modes, delay and dimension, the
/// friction law of a contact. Needs no scene; files are chosen or dropped.
class RecordsPage : public FindingsPage {
  Q_OBJECT

 public:
  explicit RecordsPage(QWidget* parent = nullptr);

  void open(const QStringList& files);
  void run() override;
  QComboBox* tools() const { return tool_; }
  QString command_line() const override;
  /// The tool of that name (RecordTool::name).
  void choose_tool(const std::string& name);
  /// Writes the FRFs that were found, and tells where.
  void write_frfs(const QString& file);

 Q_SIGNALS:
  /// FRFs of a structure to be taken into the scene.
  void frfs_written(const QString& file, bool of_assembly);

 private:
  QWidget* make_top();
  const RecordTool& tool() const;
  ToolForm& form() const;
  void show_tool();
  void fit_forms();
  void begin();
  void run_again();
  void ask_and_write_frfs();
  void show_buttons() override;

  std::vector<RecordTool> all_;
  QPushButton* run_;
  QComboBox *tool_, *role_;
  QPushButton* to_scene_;
  QLabel* names_;
  QStackedWidget* forms_;
  QStringList files_;
  ToolValues used_;  ///< by the last run
};

}  // namespace jointid::gui
