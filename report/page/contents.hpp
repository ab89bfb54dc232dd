#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What a report page can show. Texts are plain: the page escapes them. NaN is "not there" everywhere.
namespace jointid::report {

/// A paragraph; `quiet` for remarks.
struct Text {
  std::string text;
  bool quiet = false;
};

/// How much a result can be trusted, as a colour.
enum class Trust { good, doubtful, bad };

/// A likely cause of a bad result: what is wrong, where, how one sees it, and the scene lines that would mend it.
struct SuspectLines {
  std::string kind, file, dofs, evidence, remedy;
};

/// What stands above everything else of a page: the status in its colour, why, and what is to be suspected, most likely first.
struct StatusBanner {
  Trust trust = Trust::good;
  std::string word;
  std::string message;
  std::vector<std::string> remarks{};  ///< one sentence each
  std::vector<SuspectLines> suspects{};
};

/// Names and values below each other.
struct Facts {
  std::vector<std::pair<std::string, std::string>> rows;
};

/// A square matrix over named coordinates, and how far each element is from the truth where that is known.
struct MatrixTable {
  std::string title;
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
  std::vector<std::vector<double>> truth;  ///< empty, or as `values`
  std::vector<std::vector<double>> errors{};  ///< empty, or as `values`: for the digits
};

/// How much of a table is shown, and where all of it is.
struct RowLimit {
  std::size_t most = 300;
  std::string rest = "--json and --csv write all of them";  ///< a clause; empty: nothing has them
};

enum class HeatUnit { decibel, noise };

/// Errors of FRFs, responses × references, in classes of colour that are the same on every page.
struct HeatMap {
  std::string title;
  std::vector<std::string> rows, columns;
  std::vector<double> values;                        ///< [rows × columns]; NaN: nothing to compare
  std::vector<double> row_totals, column_totals;     ///< over all of a row or column, also of what is not shown
  HeatUnit unit = HeatUnit::decibel;
};

/// Where a published number lies beside the range of trials; doubtful: its print is.
enum class InRange { inside, outside, doubtful };

/// A published number, what trials give for it, and whether it lies in their range.
struct ComparedCell {
  std::string published, ours, low, high;
  InRange verdict = InRange::inside;
};

/// A published table beside ours; rows may be shorter than the titles.
struct ComparedTable {
  std::vector<std::string> titles;
  std::vector<std::pair<std::string, std::vector<ComparedCell>>> rows;
};

/// One identified value.
struct Bar {
  std::string name;
  double value = 0.0;
  std::string unit;
  std::optional<std::array<double, 2>> interval;
  std::optional<double> truth;
  std::string remark;  ///< "not determined"
  std::optional<double> error{};  ///< of the value, for its digits; not drawn
};

/// Values as bars from zero. Those whose names start alike (K, M, C, D) and whose units are equal share a scale.
struct Bars {
  std::vector<Bar> bars;
};

struct Axis {
  std::string label;  ///< with unit
  bool log = false;
};

enum class Style {
  line,
  reference,  ///< broad and grey: what the other curves are compared with
  dashed,
  points,
  reference_points  ///< points in the colour of `reference`
};

struct Series {
  std::string name;
  std::vector<double> y;
  Style style = Style::line;
};

/// Curves over one axis.
struct CurvePlot {
  std::string title;
  Axis x, y;
  std::vector<double> x_values;  ///< ascending
  std::vector<Series> series;    ///< as long as x_values
  std::optional<std::array<double, 2>> band;  ///< part of the x-axis to shade
  std::optional<double> level;                ///< a horizontal line to compare with
  std::optional<double> period;               ///< of y: a curve that jumps by more than half of it is interrupted
  std::optional<std::array<double, 2>> y_range{};  ///< fixed ends of the y-axis
  std::optional<double> deviation{};  ///< the y-axis shows as much above `level` as below, at least this; the plot is a low strip
};

struct Point {
  double x = 0.0, y = 0.0;
  std::string label;
};

struct PointGroup {
  std::string name;
  std::vector<Point> points;
};

/// Curves behind the points of a scatter plot, over the same x-axis and a y-axis of their own on the right.
struct Backdrop {
  Axis y;
  std::vector<double> x_values;  ///< ascending
  std::vector<Series> series;    ///< as long as x_values
};

struct ScatterPlot {
  std::string title;
  Axis x, y;
  std::vector<PointGroup> groups;
  std::vector<Point> front;      ///< joined by a line; ascending in x
  std::string front_name{};      ///< e.g. "Pareto front"
  std::optional<Backdrop> backdrop{};
};

struct HistogramPlot {
  std::string title;
  Axis x;
  double low = 0.0, high = 1.0;  ///< ends of the first and last bin
  std::vector<double> counts;    ///< of bins of equal width
  std::optional<double> mark;    ///< a value to point at
  std::string mark_name;
};

using Plot = std::variant<CurvePlot, ScatterPlot, HistogramPlot>;

/// Plots that are shown together; curves over the same axis zoom together.
struct Choice {
  std::string name;
  std::vector<Plot> plots;
};

/// One choice is shown; a menu changes it when there are several.
struct PlotGroup {
  std::string menu;  ///< what the menu chooses, e.g. "FRF"
  std::vector<Choice> choices;
};

}  // namespace jointid::report
