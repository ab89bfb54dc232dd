#pragma once

namespace jointid::frf {

/// Which sensors' masses were on the structure while a response was measured.
enum class SensorsOn {
  roving,    ///< that of the response's own DOF
  triaxial,  ///< those of the response's node
  fixed      ///< all
};

}  // namespace jointid::frf
