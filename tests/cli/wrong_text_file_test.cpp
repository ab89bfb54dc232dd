#include "wrong_input.hpp"

namespace jointid::cli {
namespace {

/// The second dataset 58 of a.uff stands for the same FRF as the first.
const Spoil duplicated = edit("a.uff", "NONE               2   2", "NONE               1   2");

const Wrong uff_files[] = {
    {"Truncated", cut("b.uff", 1200), convert("b.uff"), 3, {"b.uff: ", "dataset 58 number 2", "record 10 (byte 837)", "ends before its 11 lines", "export it again"}},
    {"TruncatedText", cut("a.uff", 1100), convert("a.uff"), 3, {"a.uff: ", "dataset 58 number 2", "(byte 838)", "export it again"}},
    {"TooFewValues", edit("a.uff", "  5.000000000000E+00 -4.000000000000E+00\n", ""), convert("a.uff"), 3,
     {"a.uff: ", "dataset 58", "(byte 236)", "4 of 6 values", "export it again"}},
    {"NoNumber", edit("a.uff", "-4.000000000000E+00", "-4.00000OOOOOOE+00"), convert("a.uff"), 3,
     {"a.uff: ", "dataset 58", "data line 2", "-4.00000OOOOOOE+00", "must hold a number"}},
    {"UnknownQuantity", edit("a.uff", "         8    0    0    0 Displacement", "        15    0    0    0 Pressure    "),
     convert("a.uff"), 3, {"a.uff: ", "dataset 58", "records 9 and 10", "data type 15 over 13", "export receptances"}},
    {"DirectionZero", edit("a.uff", "NONE               2   2", "NONE               2   0"), convert("a.uff"), 3,
     {"a.uff: ", "dataset 58", "record 6", "node 2 with direction code 0 is not a DOF", "1 to 3 for +X to +Z"}},
    {"VmsFloats", edit("b.uff", "58b     1     2", "58b     1     1"), convert("b.uff"), 3,
     {"b.uff: ", "dataset 58 number 1", "number line", "VMS", "export"}},
    {"UnknownByteOrder", edit("b.uff", "58b     1     2", "58b     7     2"), convert("b.uff"), 3,
     {"b.uff: ", "dataset 58 number 1", "number line", "byte order 7", "export"}},
    {"FrfTwice", duplicated, convert("a.uff"), 3, {"a.uff: ", "dataset 58", "response 1:+Y and reference 1:+Y is already in dataset 58 number 1", "keep one of the two"}},
    {"PointsWrong", edit("a.uff", "         6         3         1", "         6         x         1"), convert("a.uff"), 3,
     {"a.uff: ", "dataset 58", "record 7", "number of points 'x'", "columns"}},
    {"NoFrfs", [](const auto& folder) { folder.write("a.uff", "    -1\n   151\nx\n    -1\n"); }, convert("a.uff"), 3,
     {"a.uff: ", "no frequency response functions", "dataset 151", "export"}},
};
INSTANTIATE_TEST_SUITE_P(Uff, WrongInput, testing::ValuesIn(uff_files), name_of);

const Wrong csv_files[] = {
    {"CellMissing", edit("a.csv", "20,3,-2,4,-3", "20,3,-2,4"), convert("a.csv"), 3,
     {"a.csv: line 5, column ", "4 cells", "5", "leave cells empty"}},
    {"NoNumber", edit("a.csv", "20,3,-2,4,-3", "20,3,two,4,-3"), convert("a.csv"), 3,
     {"a.csv: line 5, column 3: ", "'two' is not a number", "leave the cell empty"}},
    {"NoFrequency", edit("a.csv", "20,3", ",3"), convert("a.csv"), 3, {"a.csv: line 5, column 1: ", "no frequency", "fill or remove the line"}},
    {"OtherTable", [](const auto& folder) { folder.write("a.csv", "name,price\nbolt,1.5\n"); }, convert("a.csv"), 3,
     {"a.csv: line 1, column 1: ", "'name'", "frequency_hz"}},
    {"NoQuantity", edit("a.csv", "# quantity = receptance\n# unit = m/N\n", ""), convert("a.csv"), 3,
     {"a.csv: ", "does not say which quantity it holds", "# quantity = accelerance"}},
    {"QuantityWord", edit("a.csv", "receptance", "receptence"), convert("a.csv"), 3,
     {"a.csv: ", "quantity", "'receptence'", "receptance"}},
    {"DofText", edit("a.csv", "2:+Y/1:+Y re", "2:+W/1:+Y re"), convert("a.csv"), 3,
     {"a.csv: line 3, column 4: ", "2:+W", "write"}},
    {"UnknownPart", edit("a.csv", "2:+Y/1:+Y im", "2:+Y/1:+Y imag"), convert("a.csv"), 3,
     {"a.csv: line 3, column 5: ", "2:+Y/1:+Y imag", "re"}},
    {"Descending", edit("a.csv", "20,3", "5,3"), convert("a.csv"), 3,
     {"a.csv: ", "line 2", "5 Hz does not follow 10 Hz", "must increase"}},
};
INSTANTIATE_TEST_SUITE_P(Csv, WrongInput, testing::ValuesIn(csv_files), name_of);

/// A folder with a loading curve of this text, curve.csv.
Spoil curve(const std::string& text) {
  return [text](const auto& folder) { folder.write("curve.csv", text); };
}

const std::vector<std::string> fit_curve = {"loading-curve", "curve.csv"};

const Wrong curve_files[] = {
    {"Absent", {}, {"loading-curve", "absent.csv"}, 3, {"absent.csv: ", "no such file", "check its path"}},
    {"OtherColumns", {}, {"loading-curve", "a.csv"}, 3, {"a.csv: ", "no column is named as a displacement", "--displacement", "frequency_hz"}},
    {"CellMissing", curve("u,F\n1,2\n3\n"), fit_curve, 3, {"curve.csv: line 3: ", "1 cells", "2", "every line the same cells"}},
    {"NoNumber", curve("u,F\n1,2\n3,x\n"), fit_curve, 3, {"curve.csv: line 3, column 2: ", "'x' is not a number", "begin lines"}},
    {"Binary", curve(std::string("\1\0\2", 3)), fit_curve, 3, {"curve.csv: ", "no text, MATLAB or HDF5 file", "export"}},
    {"OnlyComments", curve("# nothing\n"), fit_curve, 3, {"curve.csv: ", "holds no numbers", "give columns"}},
    {"NothingFinite", curve("u,F\nnan,2\n"), fit_curve, 3, {"curve.csv: ", "there are no samples", "check the columns"}},
    {"UnitOfTheHeader", curve("u [kg],F\n1,2\n"), fit_curve, 3, {"curve.csv: column u: ", "'kg' is no unit of it", "--unit"}},
    {"TimeTurnsBack", curve("t,v,F\n1,1,1\n0,1,1\n"), {"loading-curve", "curve.csv", "--velocity"}, 3,
     {"curve.csv: ", "time does not increase at sample 2", "check the columns"}},
    {"SpecimenWithoutForce", curve("u,F\n1,2\n2,2\n"), {"loading-curve", "curve.csv", "--specimen", "curve.csv"}, 3,
     {"curve.csv: ", "the specimen's forces do not increase", "check the columns"}},
};
INSTANTIATE_TEST_SUITE_P(LoadingCurve, WrongInput, testing::ValuesIn(curve_files), name_of);

}  // namespace
}  // namespace jointid::cli
