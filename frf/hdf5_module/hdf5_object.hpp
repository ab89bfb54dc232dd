#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frf/hdf5_module/hdf5_handle.hpp"

namespace jointid::frf::hdf5 {

/// An open file (its root group) or dataset, and what messages call it.
struct Object {
  Handle id;
  std::string file;
  std::string place;  ///< "dataset frf"; empty for the root
};

struct Dataset : Object {
  std::vector<std::size_t> dims;
};

/// Throws InputError (data) about `object`.
[[noreturn]] void fail(const Object& object, std::string problem, std::string remedy = {});

/// Opens for reading. Throws InputError when HDF5 cannot.
Object open_file(const std::filesystem::path& path);

/// Whether the root holds something of that name.
bool has(const Object& file, const std::string& name);

/// Opens a dataset whose data lie in this file (no links to, and no storage in, other files), after checking
/// that as many bytes are stored as its dimensions declare. Throws InputError when it is missing or anything
/// else.
Dataset open_dataset(const Object& file, const std::string& name);

/// The same for an object that is open already (by a reference); `place` is what messages call it.
Dataset to_dataset(const Object& file, Handle id, std::string place);

/// Whether the dataset goes through filters (compression).
bool is_filtered(const Dataset& dataset);

/// Attribute as text or number (scalar or one element), nullopt when missing; InputError when of another
/// kind.
std::optional<std::string> text_attribute(const Object& object, const char* name);
std::optional<double> number_attribute(const Object& object, const char* name);

/// Whether there is an attribute of that name that is one text.
bool has_text_attribute(const Object& object, const char* name);

/// All elements of a dataset of any rank, in the order of the file.
std::vector<double> read_doubles(const Dataset& dataset);
std::vector<std::string> read_texts(const Dataset& dataset);

/// Of a dataset of one or two dimensions, the longer of which (the last of equal ones) counts the samples: samples
/// [first, first + count), [count, others].
std::vector<double> read_samples(const Dataset& dataset, std::size_t first, std::size_t count);

/// How many samples of a dataset, as read_samples() counts them, are packed or stored together; 1 without chunks.
std::size_t samples_in_chunk(const Dataset& dataset);

/// Memory type of std::complex<double> as compound with the given member names.
Handle complex_type(const char* real = "r", const char* imaginary = "i");

/// Whether the dataset's elements are compounds of exactly two floating-point members of these names.
bool is_complex(const Dataset& dataset, const char* real = "r", const char* imaginary = "i");

/// Names of the two members of a dataset of complex numbers, as MATLAB (real, imag), h5py (r, i) and others (re, im) write them, in any
/// case; empty where it holds none.
std::optional<std::array<std::string, 2>> complex_members(const Dataset& dataset);

/// The text of an attribute whatever the case of its name; nullopt where there is none of that name that is one text.
std::optional<std::string> any_text_attribute(const Object& object, std::string_view name);

/// Whether the dataset's elements are real numbers, floating-point or integer.
bool is_real(const Dataset& dataset);

}  // namespace jointid::frf::hdf5
