"""Results state how they were made."""

import hashlib
import json
import os
import pickle
import subprocess
import time

import jointid
import numpy as np


def sum_of(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def test_every_input_of_a_scene_has_its_sum(a1, tmp_path):
    solution = jointid.identify(a1)
    made = solution.to_dict()["provenance"]
    assert made["version"] == jointid.__version__ and made["python"] == "identify"
    files = {os.path.basename(each["file"]): each for each in made["inputs"]}
    assert set(files) == {"A1.toml", "A1_assembly.h5", "A1_substructure_1.h5", "A1_substructure_2.h5"}
    folder = type(tmp_path)(os.path.dirname(a1))
    for name, each in files.items():
        assert each["sha256"] == sum_of(folder / name) and each["bytes"] == (folder / name).stat().st_size
    assert any("libstdc++" in each for each in made["libraries"])
    assert pickle.loads(pickle.dumps(solution)).provenance == made


def test_the_commit_is_that_of_the_command(a1):
    command = [os.environ["JOINTID_COMMAND"], "check", a1, "--json", "-"]
    theirs = json.loads(subprocess.run(command, capture_output=True, text=True, timeout=120).stdout)["provenance"]
    ours = jointid.check(a1).provenance
    assert (ours["version"], ours["commit"]) == (theirs["version"], theirs["commit"])
    shas = lambda made: {each["sha256"] for each in made["inputs"]}
    assert shas(ours) == shas(theirs)


def test_saved_results_carry_it(a1, tmp_path):
    solution = jointid.identify(a1)
    solution.save(tmp_path / "a1.json")
    solution.save(tmp_path / "a1.html")
    saved = json.loads((tmp_path / "a1.json").read_text())
    assert saved == json.loads(json.dumps(solution.to_dict())) and list(saved)[-1] == "provenance"
    page = (tmp_path / "a1.html").read_text()
    assert "How this page was made" in page and saved["provenance"]["inputs"][0]["sha256"] in page


def test_sets_and_arrays_in_memory_have_sums():
    f = np.arange(30.0, 50.0, 0.1)
    frfs = jointid.FrfSet((1e-6 / (1 - (f / 40) ** 2 + 0.02j)).reshape(-1, 1, 1), f, ["1:+Z"], name="beam")
    (made,) = jointid.modalfit(frfs).provenance["inputs"]
    assert made["file"] == "beam" and made["place"] == "in memory"
    assert made["sha256"] == hashlib.sha256(frfs.frequency.tobytes() + frfs.frfs.tobytes()).hexdigest()
    t = np.arange(500) / 50
    record = np.column_stack([np.cos(t), np.sin(t)])
    (made,) = jointid.pod(record).provenance["inputs"]
    assert made["sha256"] == hashlib.sha256(record.tobytes()).hexdigest()


def test_a_file_that_was_written_since_has_no_sum(tmp_path):
    scene = jointid.write_problem("A1", tmp_path)
    result = jointid.check(scene)
    later = time.time() + 10
    os.utime(tmp_path / "A1_assembly.h5", (later, later))
    sums = {os.path.basename(each["file"]): each["sha256"] for each in result.provenance["inputs"]}
    assert sums.pop("A1_assembly.h5") is None and all(sums.values())


def test_rerun_names_what_it_cannot_repeat(a1, tmp_path):
    jointid.check(a1).save(tmp_path / "a1.json")
    done = subprocess.run([os.environ["JOINTID_COMMAND"], "rerun", tmp_path / "a1.json"], capture_output=True, text=True, timeout=60)
    assert done.returncode == 3 and "jointid.check() of Python made it" in done.stderr
