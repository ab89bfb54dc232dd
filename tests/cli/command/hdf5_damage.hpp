#pragma once

#include <string>
#include <vector>

#include "input_folder.hpp"

/// What spoils an HDF5 file of the folder in ways that the library does not write.
namespace jointid::cli {

Spoil hdf5_text_attribute(std::string file, std::string name, std::string text);
Spoil hdf5_number_attribute(std::string file, std::string name, double value);
Spoil hdf5_without(std::string file, std::string dataset);
Spoil hdf5_frequency(std::string file, std::vector<double> hz);
Spoil hdf5_texts(std::string file, std::string dataset, std::vector<std::string> texts);
Spoil hdf5_coherence(std::string file, std::vector<double> values);
/// frf anew, zeros of these dimensions.
Spoil hdf5_real_frf(std::string file, std::vector<unsigned long long> dims);
Spoil hdf5_complex_frf(std::string file, std::vector<unsigned long long> dims);
/// frf as chunks of a line that pretend to be packed by the filter of that number.
Spoil hdf5_filtered_frf(std::string file, int filter);
/// frf of a size that nobody stored.
Spoil hdf5_empty_frf(std::string file, std::vector<unsigned long long> dims);
/// Makes a dataset a link into another file.
Spoil hdf5_external_link(std::string file, std::string dataset);

}  // namespace jointid::cli
