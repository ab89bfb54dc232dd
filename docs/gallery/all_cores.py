"""How well does my test see the joint? A study on all cores, and many scenes side by side.

study() uses all cores by itself; results pickle, so that concurrent.futures (and dask) work over jointid.identify.
"""

import concurrent.futures
import multiprocessing
import tempfile

import jointid


def identified(seed):
    return jointid.identify(jointid.write_problem("A1", tempfile.mkdtemp(), seed=seed), threads=1)


if __name__ == "__main__":
    scene = jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)
    study = jointid.study(scene, trials=500)
    print(study["unknowns"][0])
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        for solution in pool.map(identified, [1, 2]):
            print(solution.status, f"K(1,1) = {solution.unknowns['K(1,1)'].value:.4g} N/m")
