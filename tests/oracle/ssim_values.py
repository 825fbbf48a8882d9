#!/usr/bin/python3
"""Prints the expected values of tests/metrics_ssim_test.cpp (Debian: python3-skimage).

Each case is an image made by the rule below, and its SSIM by scikit-image against the same image
in coarser steps and with noise. The test makes the same images by the same rule.
"""
import numpy
from skimage.metrics import structural_similarity

# width, height, seed, noise of the image, step and noise of the shown one
CASES = [
    (64, 48, 1, 1, 4, 1),
    (64, 48, 2, 1, 32, 1),
    (33, 20, 3, 40, 8, 9),
    (7, 7, 4, 256, 16, 64),
    (9, 50, 5, 256, 1, 256),
    (120, 7, 6, 3, 64, 2),
]


def image(width, height, seed, noise):
    """Byte = (2 i + 3 j + 50 c + noise) mod 256, the noise from the top byte of a congruential
    generator that steps once a sample, by plane, row and column."""
    state = seed
    out = numpy.empty((3, height, width), dtype=numpy.int64)
    for c in range(3):
        for j in range(height):
            for i in range(width):
                state = (1664525 * state + 1013904223) % 2**32
                out[c, j, i] = (2 * i + 3 * j + 50 * c + (state >> 24) % noise) % 256
    return out


def shown(reference, seed, step, noise):
    """Steps of `step`, plus noise from a generator that starts at seed + 1000; at most 255."""
    state = seed + 1000
    out = reference // step * step
    for at in numpy.ndindex(out.shape):
        state = (1664525 * state + 1013904223) % 2**32
        out[at] = min(255, out[at] + (state >> 24) % noise)
    return out


for width, height, seed, noise, step, shown_noise in CASES:
    reference = image(width, height, seed, noise)
    value = structural_similarity(
        reference.astype(numpy.uint8), shown(reference, seed, step, shown_noise).astype(numpy.uint8),
        channel_axis=0, data_range=255)
    print(f"{{{width}, {height}, {seed}, {noise}, {step}, {shown_noise}, {value:.12f}}},")
