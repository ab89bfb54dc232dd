#pragma once

#include <QWidget>

#include "gui/records/record_tool.hpp"

namespace jointid::gui {

/// The fields of a tool for records.
class ToolForm : public QWidget {
  Q_OBJECT

 public:
  /// Fields are named records_TOOL_OPTION.
  explicit ToolForm(const RecordTool& tool, QWidget* parent = nullptr);

  /// The channels of the files that were opened; what was chosen stays, if it is among them.
  void offer(const QStringList& channels);
  ToolValues values() const;

 Q_SIGNALS:
  /// A field was filled in, and left.
  void changed();

 private:
  void tell_changes();
  QWidget* make_field(const ToolField& field, const std::string& name);
  QWidget* make_file_field(const ToolField& field, const std::string& name);

  std::vector<std::pair<ToolField, QWidget*>> fields_;
};

}  // namespace jointid::gui
