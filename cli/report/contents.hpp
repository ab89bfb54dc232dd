#pragma once

#include "report/page/contents.hpp"

/// A page is made of the parts that report/ has.
namespace jointid::cli::report {

using jointid::report::Axis;
using jointid::report::Backdrop;
using jointid::report::Bar;
using jointid::report::Bars;
using jointid::report::Choice;
using jointid::report::ComparedCell;
using jointid::report::ComparedTable;
using jointid::report::CurvePlot;
using jointid::report::Facts;
using jointid::report::HeatMap;
using jointid::report::HistogramPlot;
using jointid::report::MatrixTable;
using jointid::report::Plot;
using jointid::report::PlotGroup;
using jointid::report::Point;
using jointid::report::PointGroup;
using jointid::report::RowLimit;
using jointid::report::ScatterPlot;
using jointid::report::Series;
using jointid::report::StatusBanner;
using jointid::report::Style;
using jointid::report::SuspectLines;
using jointid::report::Text;
using jointid::report::Trust;
using jointid::report::Verdict;

}  // namespace jointid::cli::report
