"""Writes scipy_reference.hpp: FRFs and coherences of measured records by scipy.signal, the independent route of scipy_test.cpp.

    /usr/bin/python3 tests/records/scipy_reference.py ../shared/data > tests/records/scipy_reference.hpp

Made with scipy 1.10.1 and numpy 1.24.2 (Debian 12: python3-scipy). Spectral densities are csd() and welch() alone; H1 = Pfx/Pff, H2 = Pxx/Pxf,
coherence |Pfx|^2/(Pff Pxx). Every 331st line of the hammer's, every 16th of the shaker's.
"""
import sys

import numpy as np
import scipy.io
import scipy.signal as signal


def averaged(pairs, rate, **how):
    """Spectral densities of (force, response) records, averaged over them."""
    ff = fx = xx = 0
    for force, response in pairs:
        hz, pff = signal.welch(force, rate, **how)
        ff = ff + pff
        xx = xx + signal.welch(response, rate, **how)[1]
        fx = fx + signal.csd(force, response, rate, **how)[1]
    return hz, ff, fx, xx


def rows(name, densities, step):
    hz, ff, fx, xx = densities
    print("inline constexpr ReferenceLine %s[] = {" % name)
    for k in range(step, len(hz), step):
        h1, h2, coherence = fx[k] / ff[k], xx[k] / np.conj(fx[k]), abs(fx[k]) ** 2 / (ff[k] * xx[k])
        print("    {%d, %r, {%r, %r}, {%r, %r}, %r}," % (k, hz[k], h1.real, h1.imag, h2.real, h2.imag, coherence))
    print("};")


def main(folder):
    print("#pragma once\n\n#include <complex>\n#include <cstddef>\n")
    print("// By scipy_reference.py, from hammer-repeats/*.npy and siso-coherence/case1.mat.\nnamespace jointid::records {\n")
    print("struct ReferenceLine {\n  std::size_t line;\n  double hz;\n  std::complex<double> h1, h2;\n  double coherence;\n};\n")
    hits = [np.load("%s/hammer-repeats/measurements_%d.npy" % (folder, k)) for k in range(1, 6)]
    how = dict(window="boxcar", nperseg=hits[0].shape[1], noverlap=0, detrend=False)
    rows("hammer_reference", averaged([(hit[1], hit[2]) for hit in hits], 25600.0, **how), 331)
    case = scipy.io.loadmat("%s/siso-coherence/case1.mat" % folder)
    channels = [case["Time_chan_%d" % k].ravel().astype(float) for k in (1, 2)]
    how = dict(window="hann", nperseg=1024, noverlap=512, detrend="constant")
    rows("shaker_reference", averaged([channels], 1280.0, **how), 16)
    print("\n}  // namespace jointid::records")


main(sys.argv[1])
