#pragma once

#include <cstddef>
#include <string>

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

}  // namespace jointid::report
