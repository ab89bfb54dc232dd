#pragma once

#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QWidget>

namespace jointid::gui {

/// The widget of that name below another; a test fails by a bad access where there is none, so ask with ASSERT_TRUE first.
template <class Widget = QWidget>
Widget* find(QWidget& below, const char* name) {
  return below.findChild<Widget*>(QString::fromLatin1(name));
}

/// Class and name of every visible widget that takes the focus and has nothing to tell a screen reader.
QStringList without_accessible_name(QWidget& window);

/// Over a place, sent to the widget itself: QTest::mouseMove needs the pointer of a real screen.
void move_mouse(QWidget* widget, const QPoint& to);

/// Files from the mouse; whether they were taken.
bool drop(QWidget& on, const QStringList& files);

/// The language of all windows; English again, whatever a test did.
class Spoken {
 public:
  explicit Spoken(const char* language) { speak(language); }
  ~Spoken() { speak("en"); }
  Spoken(const Spoken&) = delete;
  Spoken& operator=(const Spoken&) = delete;
  static void speak(const char* language);
};

void write_file(const QString& file, const std::string& text);
std::string read_file(const QString& file);

/// A built-in problem as files in a folder of its own.
class Measured {
 public:
  explicit Measured(const char* problem, const char* format = "h5");
  QString scene() const { return scene_; }
  QStringList files() const;  ///< with FRFs
  QString file(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }

 private:
  QTemporaryDir folder_;
  QString scene_;
};

/// Copies of universal files in a folder, without the datasets of nodes: the plain export of an analyser.
QStringList without_positions(const QStringList& files, const QTemporaryDir& folder);

/// The datasets of nodes of a universal file.
std::string only_positions(const QString& file);

/// A scene whose files need not be there.
inline const char* const small_scene = R"([data]
substructures = ["a.uff", "b.uff"]
assembly = ["c.uff"]

[joint]
dofs = ["1:+Y", "2:+Y"]

[joint.stiffness]
pattern = "symmetric"
)";

}  // namespace jointid::gui
