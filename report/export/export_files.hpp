#pragma once

#include <string>
#include <vector>

#include "tasks/export/exported_joint.hpp"

namespace jointid::report {

/// For which program, and by what.
enum class ExportTarget { nastran, ansys, abaqus, matrix_market };
enum class ExportWay {
  automatic,  ///< springs where the joint consists of springs and dampers that are not negative, between DOFs of one direction;
              ///< else matrix
  springs,    ///< a spring and a damper for each pair of DOFs: CELAS2 and CDAMP2, COMBIN14, *SPRING and *DASHPOT
  bush,       ///< an element for each pair of nodes: CBUSH with PBUSH, *CONNECTOR
  matrix      ///< whole matrices: DMIG, MATRIX27, *MATRIX INPUT, Matrix Market
};

/// "nastran", "ansys", "abaqus", "matrix-market"; "auto", "springs", "bush", "matrix". Throw InputError (usage) with the nearest
/// word.
ExportTarget parse_export_target(const std::string& word);
ExportWay parse_export_way(const std::string& word);

struct ExportOptions {
  ExportTarget target = ExportTarget::nastran;
  ExportWay way = ExportWay::automatic;
  bool millimetres = false;       ///< N, mm, s, tonnes in place of SI units
  std::size_t first_id = 900001;  ///< of elements, properties and types
};

/// A file: what its name adds to that of the result, and its text.
struct ExportFile {
  std::string suffix;  ///< ".bdf", "_K.mtx", "_covariance.csv"
  std::string text;
};

/// The endings of all files that export_files() may make.
std::vector<std::string> export_suffixes(const ExportOptions& options);

/// The joint as cards of a finite-element program, with the standard error of each value in a comment beside it, the covariance
/// of the unknowns as CSV (SI units), and for Matrix Market the DOFs as CSV. Values have at least ten digits. The first file is
/// the one to include.
///
///     Z(ω) = K − ω²M + i(ωC + D)
///
/// Throws InputError (usage) for what the program's elements do not hold: unsymmetric matrices outside of Nastran, Abaqus and
/// Matrix Market, springs and bushes for what are none.
std::vector<ExportFile> export_files(const tasks::ExportedJoint& joint, const ExportOptions& options);

}  // namespace jointid::report
