#pragma once

#include <QByteArray>
#include <QString>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

class QCustomPlot;
class QPainter;
class QSize;
class QWidget;

namespace jointid::gui {

/// A plot as it stands, `ending` png, svg or pdf.
QByteArray picture_of(QCustomPlot& plot, const QString& ending);

/// The same of anything that paints itself.
QByteArray picture_of(const QSize& size, const std::function<void(QPainter&)>& paint, const QString& ending);

/// What a plot can be saved as: its picture by the ending, and its numbers.
struct Saveable {
  std::function<QByteArray(const QString& ending)> picture;
  std::function<std::string(char separator)> table;
  bool is_film = false;  ///< it moves, and has a picture "gif"
};

/// PNG, SVG or PDF by the ending of the name, or CSV; of a film GIF, too. Throws InputError (usage) for another
/// ending, and where the disk does not take it or the file is one of `inputs`.
void save_plot(const QString& file, const Saveable& plot, const std::vector<std::filesystem::path>& inputs);

/// Asks for the name, which is proposed, and says what went wrong.
void ask_and_save(QWidget* parent, const Saveable& plot, const std::vector<std::filesystem::path>& inputs, const QString& proposed);

/// Numbers for a spreadsheet, and the picture.
void copy_plot(const Saveable& plot);

}  // namespace jointid::gui
