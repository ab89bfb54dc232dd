#pragma once

#include <string>

#include "models/model_use.hpp"

namespace jointid::ident {

/// How the FRFs of a file that describes a model are computed.
struct UsedModel {
  std::string file;
  models::ModelUse use;
};

}  // namespace jointid::ident
