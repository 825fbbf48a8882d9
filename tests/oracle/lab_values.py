#!/usr/bin/python3
"""Prints the expected values of tests/metrics_ciede2000_test.cpp (Debian: python3-skimage):
pairs of sRGB colours and their CIEDE2000 by scikit-image, whose own matrix has six digits."""
import numpy
from skimage.color import deltaE_ciede2000, rgb2lab

state = 7


def byte():
    global state
    state = (1664525 * state + 1013904223) % 2**32
    return state >> 24


for _ in range(24):
    a = [byte() for _ in range(3)]
    b = [byte() for _ in range(3)]
    lab = [rgb2lab(numpy.array([[c]], dtype=numpy.uint8)) for c in (a, b)]
    l, x, y = lab[0][0, 0]
    print(f"{{{{{a[0]}, {a[1]}, {a[2]}}}, {{{b[0]}, {b[1]}, {b[2]}}}, "
          f"{{{l:.3f}, {x:.3f}, {y:.3f}}}, {deltaE_ciede2000(*lab)[0, 0]:.3f}}},")
