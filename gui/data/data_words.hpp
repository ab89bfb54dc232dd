#pragma once

#include <QString>

#include "gui/data/frf_grid_model.hpp"

namespace jointid::gui {

/// What a figure of the grid is called.
QString text_of(GridFigure figure);

/// What a file holds: quantity, lines, FRFs, what it knows of its noise, and what was changed or is doubtful.
QString about(const frf::FrfHeader& header);

}  // namespace jointid::gui
