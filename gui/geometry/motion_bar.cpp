#include "gui/geometry/motion_bar.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

constexpr int picture_ms = 40, slider_width = 110, last_degree = 359;
constexpr double one_percent = 0.01, full_turn = 2.0 * std::numbers::pi;

QSlider* slider(const char* name, const QString& title, int least, int most, int value) {
  auto* made = named(new QSlider(Qt::Horizontal), name, title, title);
  made->setRange(least, most);
  made->setValue(value);
  made->setMaximumWidth(slider_width);
  return made;
}

QToolButton* toggle(const char* name, const QString& text, const QString& hint) {
  auto* made = named(new QToolButton, name, hint, hint);
  made->setText(text);
  made->setCheckable(true);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

}  // namespace

MotionBar::MotionBar(QWidget* parent) : QWidget(parent) {
  named(this, "geometry_top", tr("Motion"));
  source_ = named(new QComboBox, "force_at", tr("Excitation or mode shape"),
                  tr("A harmonic force at a reference of the assembly, or a mode shape from the page Modes or from a file"));
  source_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  frequency_ = named(new QDoubleSpinBox, "force_frequency", tr("Frequency of the force"), tr("Follows the cursor of the plots"));
  frequency_->setRange(0.0, 1e6);
  frequency_->setSuffix(tr(" Hz"));
  frequency_->setKeyboardTracking(false);
  frequency_->findChild<QLineEdit*>()->setAccessibleName(tr("Frequency of the force"));
  play_ = toggle("play", tr("Move"), tr("Show the motion"));
  hold_ = toggle("hold", tr("Hold"), tr("Hold the motion at its phase"));
  auto* shapes = push_button("shapes_file", tr("Shapes…"),
                             tr("Read mode shapes from a universal file (dataset 55), or from JSON of jointid modalfit"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({source_, frequency_, play_, hold_}, {shapes}));
  rows->addLayout(make_look());
  timer_.setInterval(picture_ms);
  connect(&timer_, &QTimer::timeout, this, &MotionBar::next_picture);
  connect(source_, &QComboBox::currentIndexChanged, this, [this] {
    show_controls();
    Q_EMIT motion_changed();
  });
  connect(frequency_, &QDoubleSpinBox::valueChanged, this, &MotionBar::motion_changed);
  connect(shapes, &QPushButton::clicked, this, &MotionBar::shapes_wanted);
  for (QToolButton* button : {play_, hold_}) connect(button, &QToolButton::toggled, this, &MotionBar::show_controls);
  connect(play_, &QToolButton::toggled, this, &MotionBar::motion_changed);
  show_controls();
}

QLayout* MotionBar::make_look() {
  amplitude_ = slider("amplitude", tr("Amplitude"), 1, 100, 25);
  speed_ = slider("speed", tr("Speed"), 1, 100, 30);
  phase_ = slider("phase", tr("Phase in degrees"), 0, last_degree, 0);
  joint_ = named(new QCheckBox(tr("joint")), "joint_only", tr("Deflection of the joint"),
                 tr("Show only the relative motion of the joint's nodes"));
  auto* undeformed = named(new QCheckBox(tr("undeformed")), "undeformed", tr("Show the structure at rest, too"));
  undeformed->setChecked(true);
  auto* numbers = named(new QCheckBox(tr("numbers")), "node_numbers", tr("Show the numbers of nodes"));
  numbers->setChecked(true);
  connect(amplitude_, &QSlider::valueChanged, this, &MotionBar::look_changed);
  connect(joint_, &QCheckBox::toggled, this, &MotionBar::look_changed);
  connect(undeformed, &QCheckBox::toggled, this, &MotionBar::undeformed_wanted);
  connect(numbers, &QCheckBox::toggled, this, &MotionBar::numbers_wanted);
  connect(phase_, &QSlider::valueChanged, this, [this](int degrees) {
    phase_rad_ = degrees * full_turn / 360.0;
    Q_EMIT phase_changed(phase_rad_);
  });
  connect(phase_, &QSlider::sliderPressed, this, [this] { hold_->setChecked(true); });
  return row_of({new QLabel(tr("amplitude")), amplitude_, new QLabel(tr("speed")), speed_, new QLabel(tr("phase")), phase_},
                {joint_, undeformed, numbers});
}

void MotionBar::set_references(const std::vector<frf::Dof>& references) {
  references_ = references;
  fill();
}

void MotionBar::set_modes(const QStringList& names) {
  modes_ = names;
  fill();
}

/// What was chosen stays, if it is still there.
void MotionBar::fill() {
  const QString before = source_->currentText();
  {
    const QSignalBlocker quiet(source_);
    source_->clear();
    for (const frf::Dof& dof : references_) source_->addItem(tr("force at %1").arg(q(dof.name())));
    for (const QString& name : modes_) source_->addItem(tr("mode %1").arg(name));
    source_->setCurrentIndex(source_->count() == 0 ? -1 : std::max(0, source_->findText(before)));
  }
  show_controls();
  Q_EMIT motion_changed();
}

std::optional<frf::Dof> MotionBar::reference() const {
  const auto chosen = static_cast<std::size_t>(source_->currentIndex());
  return source_->currentIndex() >= 0 && chosen < references_.size() ? std::optional(references_[chosen]) : std::nullopt;
}

std::optional<std::size_t> MotionBar::mode() const {
  const auto chosen = static_cast<std::size_t>(source_->currentIndex());
  if (source_->currentIndex() < 0 || chosen < references_.size()) return std::nullopt;
  return chosen - references_.size();
}

void MotionBar::choose_mode(std::size_t mode) { source_->setCurrentIndex(static_cast<int>(references_.size() + mode)); }

double MotionBar::frequency_hz() const { return frequency_->value(); }

void MotionBar::set_frequency(double frequency_hz) { frequency_->setValue(frequency_hz); }

bool MotionBar::moves() const { return play_->isChecked(); }

double MotionBar::amplitude() const { return one_percent * amplitude_->value(); }

bool MotionBar::is_of_joint() const { return joint_->isChecked(); }

void MotionBar::show_controls() {
  frequency_->setEnabled(!mode());
  if (play_->isChecked() && !hold_->isChecked())
    timer_.start();
  else
    timer_.stop();
}

/// A turn takes from half a second to five.
void MotionBar::next_picture() {
  const double turns_per_second = 0.02 * speed_->value() + 0.2;
  phase_rad_ = std::fmod(phase_rad_ + full_turn * turns_per_second * picture_ms / 1000.0, full_turn);
  const QSignalBlocker quiet(phase_);
  phase_->setValue(static_cast<int>(phase_rad_ * 360.0 / full_turn));
  Q_EMIT phase_changed(phase_rad_);
}

}  // namespace jointid::gui
