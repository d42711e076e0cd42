#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fits the confidence in a matching (ConfidenceOf in Filters/DenseCorrespondence/Private/AnswerChoice.cxx).

    Testing/Benchmarks/Segmentation/calibrate.py RESULTS/pairs.csv

Reads the pairs of the segmentation benchmark. An answer is right if the label accuracy is 0.8 or more: four
fifths of the surface. A logistic regression on what the surfaces say against the answer gives the probability.
Prints its weights, fitted on all categories, and the reliability of probabilities that were each fitted
without the category that they are for.
"""
import argparse
import csv

import numpy as np

RIGHT = 0.8


def read(path):
    with open(path, newline="") as file:
        rows = [row for row in csv.DictReader(file) if not row["error"]]
    features = np.array([[1.0, float(row["matching_evidence"])] for row in rows])
    right = np.array([float(row["label_accuracy"]) >= RIGHT for row in rows], dtype=float)
    return np.array([row["category"] for row in rows]), features, right


def fit(features, right):
    """Newton's method; the ridge keeps categories without a wrong pair from driving weights to infinity."""
    ridge = 1e-3 * np.eye(features.shape[1])
    weights = np.zeros(features.shape[1])
    for _ in range(100):
        p = probability(features, weights)
        gradient = features.T @ (p - right) + ridge @ weights
        hessian = (features.T * (p * (1.0 - p))) @ features + ridge
        weights -= np.linalg.solve(hessian, gradient)
    return weights


def probability(features, weights):
    return 1.0 / (1.0 + np.exp(-features @ weights))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pairs", help="pairs.csv of the segmentation benchmark")
    categories, features, right = read(parser.parse_args().pairs)
    print("constant %.2f, of the surfaces %.2f" % tuple(fit(features, right)))

    left_out = np.empty(len(right))
    for category in sorted(set(categories)):
        own = categories == category
        left_out[own] = probability(features[own], fit(features[~own], right[~own]))
    print("probability  pairs  right")
    for low in np.arange(0.0, 1.0, 0.1):
        chosen = (left_out >= low) & (left_out < low + 0.1)
        if chosen.any():
            print(f"{low:.1f} to {low + 0.1:.1f}  {chosen.sum():6d}  {right[chosen].mean():.2f}")
    print(f"Brier score {np.mean((left_out - right) ** 2):.3f}; "
          f"of always the mean, {right.mean():.2f}: {np.mean((right.mean() - right) ** 2):.3f}")


if __name__ == "__main__":
    main()
