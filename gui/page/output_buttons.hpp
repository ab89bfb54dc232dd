#pragma once

#include <QWidget>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

class QPushButton;

namespace jointid::gui {

class JobLine;

/// What a command writes, by ending: html, json, csv.
using Outputs = std::map<QString, std::function<std::string()>>;

/// The buttons that save what a command writes with --report, --json and --csv; what came of it stands in the line of the page.
class OutputButtons : public QWidget {
  Q_OBJECT

 public:
  /// The buttons are named NAME_report, NAME_json and NAME_csv.
  OutputButtons(const std::string& name, JobLine& line, QWidget* parent = nullptr);

  /// Of what is shown; none where nothing is.
  void offer(Outputs outputs);
  /// Files that no output may replace.
  void protect(std::vector<std::filesystem::path> inputs) { inputs_ = std::move(inputs); }
  void write(const QString& file, const QString& ending);

 private:
  void ask_and_write(const QString& filter, const QString& ending);
  void show_state();

  JobLine& line_;
  std::map<QString, QPushButton*> buttons_;
  Outputs outputs_;
  std::vector<std::filesystem::path> inputs_;
};

}  // namespace jointid::gui
