"""What flip-evaluator 1.7 says of the three pairs of pictures beside this file, as figures.csv.

    python3 -m venv venv && venv/bin/pip install flip-evaluator==1.7 numpy && venv/bin/python flip_figures.py

The pictures are 160x90, linear radiance, made by this project at commit 382f795:
    courtyard, lamps   test: render LEVEL --out F.pfm; reference: --reference --spp 16
    portals            test: --reference --spp 1; reference: --reference --spp 64
of levels/01-courtyard.json, levels/samples/lamps.json and levels/samples/portals.json, --size 160x90.

Columns: pair, exposures (start, stop, count), mean HDR-FLIP, HDR-FLIP at five pixels of the file (row 0 comes first in
the file), mean LDR-FLIP of the pictures clipped to 0..1.
"""

import pathlib

import flip_evaluator
import numpy

HERE = pathlib.Path(__file__).parent
PIXELS = [(0, 0), (45, 80), (20, 33), (60, 120), (89, 159)]  # row, column


def pfm(name):
    kind, size, _, values = (HERE / name).read_bytes().split(b"\n", 3)
    assert kind == b"PF"
    width, height = map(int, size.split())
    return numpy.frombuffer(values, "<f4").reshape(height, width, 3).copy()


def row(pair):
    reference, test = pfm(pair + "-reference.pfm"), pfm(pair + "-test.pfm")
    hdr, mean, used = flip_evaluator.evaluate(reference, test, "HDR", False, False)
    _, ldr, _ = flip_evaluator.evaluate(reference.clip(0, 1), test.clip(0, 1), "LDR", False, False)
    exposures = [used["startExposure"], used["stopExposure"], used["numExposures"]]
    return [pair, *exposures, mean, *(hdr[p].item() for p in PIXELS), ldr]


if __name__ == "__main__":
    with open(HERE / "figures.csv", "w") as out:
        for pair in ("courtyard", "lamps", "portals"):
            print(*row(pair), sep=",", file=out)
