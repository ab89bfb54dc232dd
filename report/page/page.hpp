#pragma once

#include <string>
#include <vector>

#include "report/page/contents.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

/// One self-contained HTML page: its style, its program and its data are inside, and it may not load anything (which a
/// content security policy of its own says too). What is text or a table can be read without the program.
class ReportPage {
 public:
  ReportPage(std::string title, std::string subtitle);

  /// What stands above the first section, in its colour.
  void status(const StatusBanner& banner);

  /// Opens a section; what is added next stands in it.
  void section(const std::string& title);

  void add(const Text& text);
  void add(const Facts& facts);
  /// The first cell of a row is its name. Tables with a title stand beside each other where there is room. A table with more rows
  /// than `limit` is cut, and says so.
  void add(const Table& table, const std::string& title = "", const RowLimit& limit = {});
  void add(const HeatMap& map);
  void add(const MatrixTable& matrix);
  void add(const ComparedTable& table);
  void add(const Bars& bars);
  /// Groups without plots are left out.
  void add(const PlotGroup& group);

  std::string html() const;

 private:
  void append(const std::string& html);

  std::string title_, subtitle_, banner_;
  std::vector<std::string> sections_;
  std::vector<std::string> groups_;  ///< as JSON
};

}  // namespace jointid::report
