#pragma once

#include <functional>
#include <string>

namespace jointid::frf {

/// From now on every HDF5 file that this process begins has the root attribute `provenance` with what `text` returns: how it was made.
/// Where that is empty, and before this is called, files have none. A table whose texts have one keeps its own.
void set_file_origin(std::function<std::string()> text);

/// What it returns; empty where none was set.
std::string file_origin();

}  // namespace jointid::frf
