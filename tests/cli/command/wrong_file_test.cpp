#include "base/statistics.hpp"
#include "hdf5_damage.hpp"
#include "wrong_input.hpp"

namespace jointid::cli {
namespace {

Spoil holds(const std::string& file, const std::string& text) {
  return [=](const InputFolder& folder) { folder.write(file, text); };
}

const Wrong any_files[] = {
    {"Absent", {}, {"info", "absent.h5"}, 3, {"absent.h5: ", "no such file", "check its path"}},
    {"Folder", {}, {"info", "."}, 3, {".: ", "is a folder", "name a file in it"}},
    {"Empty", holds("a.h5", ""), convert("a.h5"), 3, {"a.h5: ", "is empty", "write or copy it again"}},
    {"Text", holds("a.h5", "Dear Sir,\nthe FRFs are lost.\n"), convert("a.h5"), 3,
     {"a.h5: line 1, column 1: ", "'Dear Sir'", "no table of FRFs", "UFF"}},
    {"Prose", holds("a.uff", "the FRFs are lost\n"), convert("a.uff"), 3,
     {"a.uff: ", "begins with 'the FRFs are lost'", "give jointid-frf HDF5, UFF"}},
    {"Bytes", holds("a.mat", "\x7f" "ELF\x02\x01\x01"), convert("a.mat"), 3,
     {"a.mat: ", "begins with bytes 7f 45 4c 46", "give jointid-frf HDF5, UFF"}},
    {"LinkToNothing", [](const auto& folder) { std::filesystem::create_symlink("absent.h5", folder.path("link.h5")); },
     {"info", "link.h5"}, 3, {"link.h5: ", "no such file", "check its path"}},
    {"LinkToItself", [](const auto& folder) { std::filesystem::create_symlink("link.h5", folder.path("link.h5")); },
     {"info", "link.h5"}, 3, {"link.h5: ", "cannot be opened: Too many levels of symbolic links"}},
    {"Device", {}, {"info", "/dev/null"}, 3, {"/dev/null: ", "is not a regular file", "copy its data into one"}},
};
INSTANTIATE_TEST_SUITE_P(File, WrongInput, testing::ValuesIn(any_files), name_of);

const Wrong hdf5_files[] = {
    {"Truncated", cut("a.h5", 1500), convert("a.h5"), 3, {"a.h5: ", "cannot be opened as HDF5", "truncated"}},
    {"OtherFormat",
     hdf5_text_attribute("a.h5", "format", "frf-jointid"),
     convert("a.h5"),
     3,
     {"a.h5: ", "attribute format is 'frf-jointid', not 'jointid-frf'", "give a jointid-frf file"}},
    {"VersionThree", hdf5_number_attribute("a.h5", "version", 3.0), convert("a.h5"), 3, {"a.h5: ", "version 3", "reads versions 1"}},
    {"NoFrequency",
     hdf5_without("a.h5", "frequency"),
     convert("a.h5"),
     3,
     {"a.h5: ", "frequency: ", "is missing", "write the file again"}},
    {"NoFrf", hdf5_without("a.h5", "frf"), convert("a.h5"), 3, {"a.h5: ", "frf: ", "is missing", "write the file again"}},
    {"FrequencyNan",
     hdf5_frequency("a.h5", {10.0, nan, 30.0}),
     convert("a.h5"),
     3,
     {"a.h5: ", "frequency", "line 2", "nan Hz is not a frequency", "remove or correct that line"}},
    {"FrequencyNegative",
     hdf5_frequency("a.h5", {-10.0, 20.0, 30.0}),
     convert("a.h5"),
     3,
     {"a.h5: ", "frequency", "line 1", "-10 Hz is not a frequency", "remove or correct that line"}},
    {"FrequencyDescending",
     hdf5_frequency("a.h5", {10.0, 30.0, 20.0}),
     convert("a.h5"),
     3,
     {"a.h5: ", "frequency", "line 3", "20 Hz does not follow 30 Hz", "must increase"}},
    {"DimensionsDisagree",
     hdf5_frequency("a.h5", {10.0, 20.0}),
     convert("a.h5"),
     3,
     {"a.h5: ", "frf: ", "[3,2,1]", "[2,2,1]", "store it as [lines, responses, references]"}},
    {"DofTwice",
     hdf5_texts("a.h5", "response_dof", {"1:+Y", "1:-Y"}),
     convert("a.h5"),
     3,
     {"a.h5: ", "response", "1:-Y appears twice", "keep one of the two"}},
    {"DofText",
     hdf5_texts("a.h5", "response_dof", {"1:+Y", "two"}),
     convert("a.h5"),
     3,
     {"a.h5: ", "response_dof", "'two' is not a DOF", "write node:direction"}},
    {"Rank",
     hdf5_complex_frf("a.h5", {3, 2}),
     convert("a.h5"),
     3,
     {"a.h5: ", "frf: ", "has dimensions [3,2]", "[3,2,1]", "store it as"}},
    {"RealFrf", hdf5_real_frf("a.h5", {3, 2, 1}), convert("a.h5"), 3, {"a.h5: ", "frf: ", "does not hold complex numbers"}},
    {"UnknownFilter",
     hdf5_filtered_frf("a.h5", 32001),
     convert("a.h5"),
     3,
     {"a.h5: ", "frf: ", "packed by filter 32001", "which the HDF5 library here does not have", "h5repack -f GZIP=6"}},
    {"DeclaredAndNotStored",
     hdf5_empty_frf("a.h5", {1000000, 1000, 1000}),
     convert("a.h5"),
     3,
     {"a.h5: ", "frf: ", "declares 16000000", "MB and stores 0", "not written to its end"}},
    {"ExternalLink",
     hdf5_external_link("a.h5", "frf"),
     convert("a.h5"),
     3,
     {"a.h5: ", "frf: ", "is a link to somewhere else", "copy the data into this file"}},
    {"Coherence",
     hdf5_coherence("a.h5", {1.0, 0.5, 1.5, 0.5, 0.5, 0.5}),
     convert("a.h5"),
     3,
     {"a.h5: ", "coherence of 1:+Y/1:+Y, line 2: ", "1.5 is not between 0 and 1", "export the coherences again"}},
    {"VarianceBelowZero",
     with_set("a.h5",
              [](frf::FrfSet& set) {
                set.header.noise = frf::NoiseRecord::variance;
                set.variance.assign(6, {1.0, -2.0});
              }),
     convert("a.h5"),
     3,
     {"a.h5: ", "variance of 1:+Y/1:+Y, line 1: ", "-2 is below 0", "export the variances again"}},
    {"TruncatedInAScene", cut("A1_assembly.h5", 60000), solve(), 3, {"A1_assembly.h5: ", "truncated"}},
};
INSTANTIATE_TEST_SUITE_P(Hdf5, WrongInput, testing::ValuesIn(hdf5_files), name_of);

}  // namespace
}  // namespace jointid::cli
