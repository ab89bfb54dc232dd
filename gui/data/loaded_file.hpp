#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "gui/plot/curve.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::gui {

/// A file of a scene, opened with what the scene says of it. The source belongs to the thread that reads; the header is a copy.
struct LoadedFile {
  std::string name;  ///< without folders
  bool is_assembly = false;
  std::shared_ptr<frf::FrfSource> source;  ///< empty where it cannot be read
  frf::FrfHeader header;                   ///< of a file that cannot be read: the nodes of a universal file, if it has any
  std::string error;
};

/// Opens the files of a scene (headers only), runs of one measurement as their mean. One that cannot be read has an error. Throws
/// Interrupted.
std::vector<LoadedFile> open_files(const ident::DataSection& data, const std::function<bool()>& interrupted);

/// What some lines tell of an FRF.
struct EntryFigures {
  double missing = 0.0;               ///< share of the lines
  std::optional<double> coherence;    ///< mean
  std::optional<double> deviation;    ///< median of σ/|H|
  std::optional<double> reciprocity;  ///< √2 ‖H_rc − H_cr‖ / √(‖H_rc‖² + ‖H_cr‖²): 2 for a wrong sign
};

/// Of all FRFs of a file, [response, reference] row by row, from at most `most_lines` of its lines. Throws Interrupted.
std::vector<EntryFigures> figures_of(const LoadedFile& file, const std::function<bool()>& interrupted,
                                     std::size_t most_lines = 33);

/// An FRF at all lines.
Curve read_curve(const LoadedFile& file, std::size_t response, std::size_t reference);

}  // namespace jointid::gui
