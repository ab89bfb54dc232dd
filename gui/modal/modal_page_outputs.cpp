#include <QLabel>

#include "gui/look/output.hpp"
#include "gui/look/paths.hpp"
#include "gui/modal/cross_mac.hpp"
#include "gui/modal/modal_page.hpp"
#include "gui/page/job_line.hpp"

/// What leaves the page, and what it is compared with: command line and files.
namespace jointid::gui {

QString ModalPage::command_line() const {
  if (structure() == nullptr) return {};
  modalfit::FitOptions wanted = sought_ ? used_ : options();
  wanted.poles = picked_.now();
  return modal_command(sought_ ? of_run_ : *structure(), wanted);
}

void ModalPage::write(const QString& file, const std::function<void(const std::filesystem::path&)>& to) {
  if (!run_) return line_->say(tr("No modes are found yet."), true);
  try {
    check_output(file, inputs_of(structures_));
    to(as_path(file));
    line_->say(tr("Written to %1.").arg(file));
  } catch (const InputError& error) {
    line_->say(QString::fromUtf8(error.what()), true);
  }
}

void ModalPage::compare_with(const QString& file) {
  if (!run_) return line_->say(tr("No modes are found yet."), true);
  other_modes_ = file;
  show_cross_mac();
}

/// Again with every pick.
void ModalPage::show_cross_mac() {
  if (other_modes_.isEmpty() || !run_) return;
  try {
    CrossMac found = gui::cross_mac(*run_, as_path(other_modes_));
    cross_mac_->draw(std::move(found.map));
    cross_word_->setText(found.said);
  } catch (const InputError& error) {
    cross_mac_->draw({});
    cross_word_->setText(QString::fromUtf8(error.what()));
  }
}

void ModalPage::write_shapes(const QString& file) {
  write(file, [this](const std::filesystem::path& path) { tasks::write_shapes(*run_, path); });
}

void ModalPage::write_regenerated(const QString& file) {
  write(file, [this](const std::filesystem::path& path) { tasks::write_regenerated(*run_, path); });
}

}  // namespace jointid::gui
