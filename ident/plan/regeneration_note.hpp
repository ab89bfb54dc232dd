#pragma once

#include <cstddef>
#include <string>

namespace jointid::ident {

/// What a modal model made of one set of FRFs.
struct ModalRegeneration {
  std::string file;
  std::size_t modes = 0;
  double rms_db_away = 0.0;  ///< model against measurement, away from antiresonances
  std::string harm;          ///< why the model is worse than the data; empty when it is not
};

/// A sentence for the user.
std::string note(const ModalRegeneration& of);

}  // namespace jointid::ident
