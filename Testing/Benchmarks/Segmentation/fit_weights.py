#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fits the weights of the matching (MatchingWeights in Filters/Correspondence/Private/MatchingWeights.h).

    Testing/Benchmarks/Segmentation/fit_weights.py PROGRAM DATA [--meshes N] [--threads N] [--rounds N]

PROGRAM is marrow-matching-accuracy, DATA as for the segmentation benchmark. Every weight is tried a quarter
larger and smaller than it is, one at a time. From the categories that are fitted to, each weight takes the way that
is better there by more than the noise of one pair, and all go together; the step is halved until it helps. The
categories are in two halves, every other one in the order of the index: weights are fitted to one half and reported
on the other, both ways round, and then fitted to all. Prints the weights, and the accuracies before and after.
"""
import argparse
import subprocess
import sys

import numpy as np

STEP = 1.25
LEAST_GAIN = 0.0005  # of the mean accuracy: half a face in a thousand is noise
HALVINGS = 2


class Matching:
    """The accuracies of the categories by weights; what was asked once is remembered."""

    def __init__(self, command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.names = self.process.stdout.readline().split()
        self.categories = self.process.stdout.readline().split()
        self.defaults = np.array(self.process.stdout.readline().split(), dtype=float)
        self.known = {}

    def accuracies(self, weights):
        line = " ".join(f"{weight:.6g}" for weight in weights)
        if line not in self.known:
            print(line, file=self.process.stdin, flush=True)
            answer = self.process.stdout.readline()
            if not answer:
                sys.exit("The program stopped.")
            self.known[line] = np.array(answer.split(), dtype=float)
            print(f"{self.known[line].mean():.4f}  {line}", file=sys.stderr, flush=True)
        return self.known[line]


def improve(matching, weights, fitted):
    """One step of all weights for the categories `fitted`; the same weights if none helps."""
    before = matching.accuracies(weights)[fitted].mean()
    way = np.zeros(len(weights))
    for i in range(len(weights)):
        gains = []
        for exponent in (1.0, -1.0):
            tried = weights.copy()
            tried[i] *= STEP ** exponent
            gains.append((matching.accuracies(tried)[fitted].mean() - before, exponent))
        gain, exponent = max(gains)
        if gain > LEAST_GAIN:
            way[i] = exponent
    if not way.any():
        return weights
    for halving in range(HALVINGS + 1):
        tried = weights * STEP ** (way / 2.0 ** halving)
        if matching.accuracies(tried)[fitted].mean() > before + LEAST_GAIN:
            return tried
    return weights


def fit(matching, fitted, rounds):
    weights = matching.defaults
    for _ in range(rounds):
        better = improve(matching, weights, fitted)
        if better is weights:
            break
        weights = better
    return weights


def report(title, matching, weights, fitted):
    before, after = matching.accuracies(matching.defaults), matching.accuracies(weights)
    print(f"{title}: " + ", ".join(f"{name} {weight:.3g}" for name, weight in zip(matching.names, weights)))
    print(f"  fitted to: {before[fitted].mean():.4f} -> {after[fitted].mean():.4f}")
    if not fitted.all():
        print(f"  others:    {before[~fitted].mean():.4f} -> {after[~fitted].mean():.4f}")
    for name, old, new in zip(matching.categories, before, after):
        print(f"    {name:10s} {old:.3f} -> {new:.3f}")
    sys.stdout.flush()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data")
    parser.add_argument("--meshes", default="8", help="of each category, the last ones (default: %(default)s)")
    parser.add_argument("--threads")
    parser.add_argument("--rounds", type=int, default=1, help="steps at most (default: %(default)s)")
    options = parser.parse_args()
    command = [options.program, options.data, "--meshes", options.meshes]
    matching = Matching(command + (["--threads", options.threads] if options.threads else []))
    halves = np.arange(len(matching.categories)) % 2 == 0
    for title, fitted in (("first half", halves), ("second half", ~halves), ("all", halves | True)):
        report(title, matching, fit(matching, fitted, options.rounds), fitted)


if __name__ == "__main__":
    main()
