#pragma once

#include <QFileSystemWatcher>
#include <QWidget>
#include <filesystem>
#include <functional>
#include <type_traits>

#include "gui/page/later.hpp"
#include "gui/scene/scene_check.hpp"
#include "study/comparison.hpp"

class QLabel;
class QSplitter;
class QTabWidget;

namespace jointid::gui {

class ComparePage;
class CouplePage;
class DataPage;
class GeometryPage;
class LoadingCurvePage;
class MessageBar;
class ModalPage;
class PlanPage;
class RecordsPage;
class SceneEditor;
class SceneForm;
class ScenePage;
class SolvePage;
class StudyPage;

/// One scene: its text on the left, what it leads to on the right. The text is all there is to save.
class Project : public QWidget {
  Q_OBJECT

 public:
  explicit Project(QWidget* parent = nullptr);

  /// Reads a scene file. False, and a message in the bar, where it cannot be read.
  bool open(const QString& file);
  /// A text that is no file yet; paths in it are relative to `folder`.
  void start(const std::string& text, const QString& folder);

  /// False, and a message, where there is no file yet, or the disk does not take it.
  bool save();
  bool save_as(const QString& file);

  const QString& file() const { return file_; }
  const QString& folder() const { return folder_; }
  /// Where a new scene is best saved: the paths in it are relative to that folder.
  QString suggested_file() const;
  QString title() const;
  bool is_modified() const;

  SceneEditor* editor() const { return editor_; }
  SceneForm* form() const { return form_; }
  /// The scene as a form, or as text, with the cursor in it.
  void switch_view(bool to_form);
  /// Of edits wherever they were made.
  void undo();
  void redo();
  /// To the field or line that is wrong.
  void go_to_error();
  /// Takes what is typed into a field of the form and not yet in the text.
  void commit();
  DataPage* data_page() const { return data_page_; }
  GeometryPage* geometry_page() const { return geometry_page_; }
  SolvePage* solve_page() const { return solve_page_; }
  ComparePage* compare_page() { return compare_page_.get(); }
  StudyPage* study_page() { return study_page_.get(); }
  PlanPage* plan_page() { return plan_page_.get(); }
  ModalPage* modal_page() { return modal_page_.get(); }
  LoadingCurvePage* loading_curve_page() { return loading_curve_page_.get(); }
  CouplePage* couple_page() { return couple_page_.get(); }
  ScenePage* response_page() { return response_page_.get(); }
  ScenePage* laws_page() { return laws_page_.get(); }
  ScenePage* oscillate_page() { return oscillate_page_.get(); }
  ScenePage* lines_page() { return lines_page_.get(); }
  RecordsPage* records_page() { return records_page_.get(); }
  QTabWidget* pages() const { return pages_; }
  MessageBar* messages() const { return messages_; }
  /// To the pages that need no scene, with these files.
  void open_curves(const QStringList& files);
  void open_records(const QStringList& files);
  /// Asks for the bolts of the joint and writes them into the text, one step that can be undone.
  void open_joint_assistant();
  /// That the scene is a proposal, and how to change its joint.
  void say_proposed();
  /// The pages alone, or the text beside them again.
  void fold_text();
  /// Seconds that the solutions took which are kept in no file, and lost with the session.
  double seconds_of_runs() const;
  /// Stops what runs on any page.
  void cancel();
  const CheckedScene& checked() const { return checked_; }

  /// What is in front, beside the scene: nothing where no run is kept there.
  void keep_layout() const;
  QByteArray layout_state() const;
  void restore_layout(const QByteArray& state);

 Q_SIGNALS:
  void title_changed();

 private:
  std::filesystem::path path() const;
  QWidget* make_views();
  void add_pages();
  void add_pages_of_scene();
  void add_other_pages();
  template <class Page>
  void add_later(Later<Page>& later, const QString& title, const QString& hint, std::type_identity_t<std::function<Page*()>> make,
                 std::type_identity_t<std::function<void(Page&)>> tell);
  template <class Page>
  void tell_other_kind(Page& page, bool is_of_kind);
  void protect_inputs(QWidget& page) const;
  void restore_kept_layout();
  void watch_commands(QWidget& page);
  void link_cursors();
  void check();
  void check_other_kinds(const std::string& text);
  void show_scene();
  void show_form();
  void edit(const std::string& table, const std::string& key, const std::string& value);
  void open_way(const study::Way& way);
  void take_frfs(const QString& file, bool of_assembly);
  void offer_dofs();
  void show_failure(const InputError& error);
  void show_problem();
  void watch();
  void file_changed();
  bool load(QString& why);
  bool write(const QString& target);
  bool is_changed_outside() const;
  void reload();

  SceneEditor* editor_;
  SceneForm* form_;
  bool of_another_kind_ = false;  ///< the scene checked last, than one of identification
  QTabWidget* views_;
  QLabel* problem_;
  MessageBar* messages_;
  QSplitter* splitter_;
  QTabWidget* pages_;
  DataPage* data_page_;
  GeometryPage* geometry_page_;
  SolvePage* solve_page_;
  Later<ComparePage> compare_page_;
  Later<StudyPage> study_page_;
  Later<PlanPage> plan_page_;
  Later<ModalPage> modal_page_;
  Later<LoadingCurvePage> loading_curve_page_;
  Later<CouplePage> couple_page_;
  Later<ScenePage> response_page_, laws_page_, oscillate_page_, lines_page_;
  Later<RecordsPage> records_page_;
  QFileSystemWatcher watcher_;
  QString file_, folder_;
  QString on_disk_;  ///< the text of the file as it was read or written last
  QStringList dofs_;  ///< of the files
  CheckedScene checked_;
};

}  // namespace jointid::gui
