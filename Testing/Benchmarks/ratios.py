#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints how the stages compare with CGAL's mean curvature skeleton and with the acceptance thresholds.

Needs the benchmark build with CGAL:

    cmake --preset benchmark && cmake --build --preset benchmark
    Testing/Benchmarks/ratios.py

Every ratio is of two times of one run, by the CPU's clock and on one thread. MARROW_BENCHMARK_MESH may
name a mesh to be measured, reduced to each size, instead of the procedural biped.
"""

import argparse
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time

SIZES = (20000, 50000, 200000)
LEAST_SPEEDUP = {20000: 5.0, 50000: 8.0, 200000: 15.0}
# A machine on which the baseline takes 0.6 s for 20,000 faces does two files in 0.35 s.
MOST_FOR_TWO_FILES = 0.35 / 0.6
MOST_FOR_TRANSFER = 0.35
MOST_SECONDS_OF_LARGE = 8.0
MOST_GIGABYTES_OF_LARGE = 1.5
# Given up then: whatever comes after would be far beyond the bar.
SECONDS_LIMIT = 120.0


def benchmark_times(binaries: pathlib.Path, repetitions: int) -> dict[str, float]:
    """Seconds of the CPU by the name of the benchmark, the least of the repetitions."""
    sizes = "|".join(str(size) for size in SIZES)
    report = subprocess.run(
        [
            binaries / "MarrowBenchmarks",
            f"--benchmark_filter=^(MeasuresAndSkeleton|PeerMeanCurvatureSkeleton)/({sizes})/"
            "|^Transfer/20000/",
            f"--benchmark_repetitions={repetitions}",
            "--benchmark_min_time=0",
            "--benchmark_format=json",
        ],
        check=True,
        stdout=subprocess.PIPE,
    )
    times: dict[str, float] = {}
    for row in json.loads(report.stdout)["benchmarks"]:
        if row.get("error_occurred"):
            sys.exit(f"{row['name']}: {row['error_message']}")
        if row["run_type"] == "iteration":
            name = "/".join(row["name"].split("/")[:2])
            times[name] = min(times.get(name, float("inf")), row["cpu_time"] / 1000.0)
    return times


def run(command: list[object], one_thread: bool) -> tuple[float, float, float] | None:
    """Seconds from start to end, seconds of the CPU and greatest size in GB, as GNU time tells them;
    None if it was not done within SECONDS_LIMIT."""
    processor = min(os.sched_getaffinity(0))
    begin = time.monotonic()
    child = subprocess.Popen(
        [str(word) for word in command],
        preexec_fn=(lambda: os.sched_setaffinity(0, {processor})) if one_thread else None,
    )
    limit = threading.Timer(SECONDS_LIMIT, child.kill)
    limit.start()
    _, status, usage = os.wait4(child.pid, 0)
    limit.cancel()
    elapsed = time.monotonic() - begin
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode == -signal.SIGKILL and elapsed >= SECONDS_LIMIT:
        return None
    if child.returncode != 0:
        sys.exit(f"{command[0]} ended with code {child.returncode}")
    return elapsed, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024 / 1e9


def main() -> None:
    root = pathlib.Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=root / "build-benchmark")
    parser.add_argument("--repetitions", type=int, default=3, help="the least time counts")
    arguments = parser.parse_args()
    binaries = arguments.build / "bin"

    times = benchmark_times(binaries, arguments.repetitions)
    peer = times["PeerMeanCurvatureSkeleton/20000"]
    rows = []
    for size in SIZES:
        ours = times[f"MeasuresAndSkeleton/{size}"]
        theirs = times[f"PeerMeanCurvatureSkeleton/{size}"]
        rows.append(
            (
                f"skeleton with measures, {size:,} faces: {ours:.3f} s, CGAL {theirs:.3f} s",
                f"{LEAST_SPEEDUP[size]:.0f} × faster",
                f"{theirs / ours:.1f} ×",
            )
        )
    rows.append(
        (
            f"transfer, 20,000 faces: {times['Transfer/20000']:.3f} s",
            f"{MOST_FOR_TRANSFER:.2f} of CGAL's skeleton",
            f"{times['Transfer/20000'] / peer:.2f}",
        )
    )
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([binaries / "WriteBenchmarkMeshes", folder], check=True)
        command = [binaries / "marrow", "transfer", folder / "source.off"]
        output = ["--segments", folder / "source.seg", "-o", folder / "labelled.seg"]
        runs = [
            run(command + [folder / "target.off"] + output, one_thread=True)
            for _ in range(arguments.repetitions)
        ]
        seconds = min((done[1] for done in runs if done), default=float("inf"))
        rows.append(
            (
                f"two OFF files of 20,000 faces to labels: {seconds:.2f} s",
                f"{MOST_FOR_TWO_FILES:.2f} of CGAL's skeleton",
                f"{seconds / peer:.2f}",
            )
        )
        large = run(command + [folder / "large.off"] + output, one_thread=False)
        rows.append(
            (
                "target of 1,000,000 faces, start to written file",
                f"{MOST_SECONDS_OF_LARGE:.0f} s, {MOST_GIGABYTES_OF_LARGE} GB",
                f"{large[0]:.1f} s, {large[2]:.2f} GB"
                if large
                else f"not done in {SECONDS_LIMIT:.0f} s",
            )
        )
    print("| what | bar | measured |")
    print("| --- | --- | --- |")
    for row in rows:
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main()
