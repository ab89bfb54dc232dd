#pragma once

#include <string_view>

namespace jointid {

/// A part of jointid that calls a library which most runs do not need: a shared library jointid_NAME.so of its own, loaded when
/// it is first used and kept until the end. It is looked for where those of its caller are, of a program or a Python module
/// (RUNPATH, then LD_LIBRARY_PATH and the system).
struct Module {
  std::string_view name;     ///< e.g. "ceres"
  std::string_view purpose;  ///< what needs it, for messages: "solver ceres"
  std::string_view package;  ///< Debian's, with which it is built
};

/// Whether the module's file is there; it is not loaded. A build without the library has none.
bool is_there(const Module& module);

/// What the module's function jointid_module() returns: the address of an object that implements the module's interface. Throws
/// InputError when there is no such file, or when it or a library that it needs cannot be loaded.
void* load(const Module& module);

/// The interface of a module, loaded now.
template <class Interface>
Interface& interface_of(const Module& module) {
  return *static_cast<Interface*>(load(module));
}

}  // namespace jointid
