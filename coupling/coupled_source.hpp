#pragma once

#include <memory>

#include "coupling/assembly_reader.hpp"

namespace jointid::coupling {

/// An assembly as a source of FRFs: what is asked for is coupled then and there. Every read() of a block couples its lines.
std::unique_ptr<frf::FrfSource> as_source(std::unique_ptr<AssemblyReader> reader);

}  // namespace jointid::coupling
