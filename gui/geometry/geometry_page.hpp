#pragma once

#include <QWidget>
#include <atomic>

#include "gui/geometry/mode_shapes.hpp"
#include "tasks/joint/joint_springs.hpp"

class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace jointid::gui {

class MotionBar;
class StructureView;
class Worker;

/// The structure of a scene in space, its measured DOFs beside it in a list; either chooses the DOFs of the joint. The assembly
/// as it moves under a harmonic force at a reference, at the frequency of the cursor, or in a mode.
class GeometryPage : public QWidget {
  Q_OBJECT

 public:
  explicit GeometryPage(QWidget* parent = nullptr);

  /// Files are opened when the page is seen, anew when `signature` has changed.
  void set_scene(const ident::Scene& scene, const std::string& signature);
  /// Lines drawn by hand, as the scene has them.
  void set_own_lines(std::vector<frf::NodeLine> lines);
  void set_frequency(double frequency_hz);
  bool is_busy() const;
  /// Modes of the modal fit, to choose from beside those of files.
  void set_modes(std::vector<NamedShape> shapes);
  /// Springs of the joint as a solution found them; none: no solution.
  void set_springs(const std::vector<tasks::JointSpring>& springs);
  /// Those of a universal file (dataset 55), or of the JSON of a modal fit.
  void open_shapes(const QString& file);

  StructureView* view() const { return view_; }
  QListWidget* dofs() const { return list_; }
  MotionBar* motion() const { return motion_; }
  QString status() const;
  const Deflection& deflection() const { return deflection_; }
  /// The picture, PNG, SVG or PDF by the ending, or the nodes as CSV. Throws InputError.
  void save(const QString& file) const;

 Q_SIGNALS:
  void edit_wanted(const std::string& table, const std::string& key, const std::string& value);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QLayout* make_foot();
  QPushButton* make_pen();
  void say_structure();
  void connect_motion();
  void open_files_if_seen();
  void show_structure(const Structure& structure);
  void show_joint();
  void toggle(const frf::Dof& dof);
  void item_changed(QListWidgetItem* item);
  void read_deflection();
  void show_deflection();
  void offer_modes();
  const NamedShape& chosen_mode() const;
  QListWidgetItem* item_of(const frf::Dof& dof) const;

  StructureView* view_;
  QListWidget* list_;
  MotionBar* motion_;
  QLabel* status_;
  QPushButton* pen_;
  Worker* worker_;
  ident::DataSection data_;
  std::vector<frf::Dof> joint_;
  std::string wanted_signature_, signature_;
  std::shared_ptr<std::vector<LoadedFile>> files_;  ///< opened by the worker's thread, and read by it alone
  Deflection deflection_;
  std::vector<std::filesystem::path> inputs_;  ///< that no output replaces
  std::vector<NamedShape> fitted_, of_files_;
  /// Counts deflections asked for, so that only the last is read and shown.
  std::shared_ptr<std::atomic<std::size_t>> wanted_ = std::make_shared<std::atomic<std::size_t>>(0);
};

}  // namespace jointid::gui
