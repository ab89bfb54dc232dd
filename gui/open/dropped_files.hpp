#pragma once

#include <QStringList>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace jointid::gui {

/// Files that were opened together, by what they hold.
struct DroppedFiles {
  QStringList records, curves;  ///< for the pages of time records and of loading curves
  std::optional<std::string> scene;     ///< of the files with FRFs
  bool is_proposal = false;             ///< of a joint; else the scene only shows the files
  std::optional<std::string> geometry;  ///< a scene that shows files which have nodes only
  std::string why;     ///< no joint is proposed for several files
  QStringList failed;  ///< why other files were left out
  /// Files in which several variables may be the FRFs, and these. Where there are any nothing else is filled in: somebody chooses first.
  std::vector<std::pair<QString, QStringList>> undecided;
};

/// Which variable of a file holds the FRFs, by the name of the file.
using ChosenNames = std::map<QString, QString>;

/// Opens the files (headers of FRFs only) and proposes a scene whose paths are relative to `folder`. Throws InputError where there is
/// nothing to open in any of them, and Interrupted.
DroppedFiles sort_dropped(const QStringList& files, const QString& folder, const std::function<bool()>& interrupted,
                          const ChosenNames& chosen = {});

}  // namespace jointid::gui
