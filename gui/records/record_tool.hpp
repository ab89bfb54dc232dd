#pragma once

#include <QStringList>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gui/page/scene_page.hpp"

namespace jointid::gui {

/// What a tool wants to know beside its files: an option of the command.
struct ToolField {
  enum class Kind { column, columns, number, file, flag, texts };  ///< texts: parted by semicolons, an option each
  Kind kind = Kind::number;
  std::string option;   ///< "--load"
  QString title, hint;  ///< what stands in it while it is empty; what it means
};

/// What was filled in, by option; what is empty is left out. A flag is "on".
using ToolValues = std::map<std::string, QString>;

/// A tool for time records.
struct RecordTool {
  std::string name;  ///< "pod"
  QString title, command, plot_hint;
  bool takes_several = false;  ///< files: further samples of the same channels
  std::vector<ToolField> fields;
  /// Throws InputError, and Interrupted.
  std::function<Findings(const std::vector<std::filesystem::path>& files, const ToolValues& values, const Worker::Watch& watch)>
      run;
  bool runs_again = false;  ///< when a field changes, after it was run once
};

/// "a; b", without blanks around them.
QStringList parted(const QString& texts);

/// " --load 3 --keep-mean", in the order of the fields.
QString options_of(const RecordTool& tool, const ToolValues& values);

}  // namespace jointid::gui
