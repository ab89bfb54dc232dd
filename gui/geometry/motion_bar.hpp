#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "frf/set/dof.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSlider;
class QToolButton;

namespace jointid::gui {

/// What moves the structure, a force at a reference or a mode, and how the motion is shown: amplitude, speed, phase.
class MotionBar : public QWidget {
  Q_OBJECT

 public:
  explicit MotionBar(QWidget* parent = nullptr);

  void set_references(const std::vector<frf::Dof>& references);
  /// Modes to choose from, behind the references.
  void set_modes(const QStringList& names);
  /// One of either, where anything is chosen.
  std::optional<frf::Dof> reference() const;
  std::optional<std::size_t> mode() const;
  void choose_mode(std::size_t mode);

  double frequency_hz() const;
  void set_frequency(double frequency_hz);
  bool moves() const;
  double amplitude() const;  ///< of the node that moves most, in parts of the structure's size
  bool is_of_joint() const;

 Q_SIGNALS:
  void motion_changed();  ///< another one, or whether it is shown
  void look_changed();    ///< amplitude, or what is shown of the motion
  void phase_changed(double phase_rad);
  void undeformed_wanted(bool on);
  void numbers_wanted(bool on);
  void shapes_wanted();  ///< of a file

 private:
  QLayout* make_look();
  void fill();
  void next_picture();
  void show_controls();

  QComboBox* source_;
  QDoubleSpinBox* frequency_;
  QToolButton *play_, *hold_;
  QSlider *amplitude_, *speed_, *phase_;
  QCheckBox* joint_;
  QTimer timer_;
  std::vector<frf::Dof> references_;
  QStringList modes_;
  double phase_rad_ = 0.0;
};

}  // namespace jointid::gui
