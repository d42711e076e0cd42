#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How time and memory of `marrow collection` grow with the collection, shared by several processes.

    PYTHONPATH=build/lib/python3/dist-packages measure_processes.py MARROW -o FOLDER
        [--meshes N]... [--processes R] [--faces F]

Writes N creatures (bipeds of different poses and proportions, each 125th of them labelled), labels them by
`mpiexec -n R MARROW collection`, one thread each, and writes FOLDER/processes.csv, a row for each N: the pairs that
were matched, the seconds that it took by the clock and those that the processors worked, and the most memory that the first
process and any other one held, in megabytes. FOLDER/processes.png is the plot of it (python3-matplotlib).
"""
import argparse
import csv
import glob
import os
import shutil
import subprocess
import sys
import time

COLUMNS = ["meshes", "pairs", "seconds", "processor_seconds", "first_megabytes", "other_megabytes"]
RANK = "OMPI_COMM_WORLD_RANK"


def run_and_note(note, command):
    """Runs a command as one of the processes and notes what it used."""
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    with open(f"{note}.{os.environ[RANK]}", "w", encoding="utf-8") as file:
        print(usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0, file=file)
    sys.exit(os.waitstatus_to_exitcode(status))


def write_creatures(folder, count, faces):
    import marrow

    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for i in range(count):
        mesh = marrow.creature("biped", seed=i + 1, pose=0.6, proportion=0.6, resolution=faces)
        name = os.path.join(folder, f"{i:04d}")
        marrow.write((mesh.points, mesh.faces), name + ".off")
        if i % 125 == 0:
            marrow.write(mesh, name + ".seg")


def measure(options, count):
    meshes = os.path.join(options.output, "meshes")
    labelled = os.path.join(options.output, "labelled")
    note = os.path.join(options.output, "used")
    write_creatures(meshes, count, options.faces)
    shutil.rmtree(labelled, ignore_errors=True)
    start = time.monotonic()
    subprocess.run(
        ["mpiexec", "-n", str(options.processes), sys.executable, os.path.abspath(__file__), "--note", note,
         os.path.abspath(options.marrow), "--threads", "1", "--quiet", "collection", meshes, "-o", labelled],
        check=True, env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                         "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1"})
    seconds = time.monotonic() - start
    used = []
    for rank in range(options.processes):
        with open(f"{note}.{rank}", encoding="utf-8") as file:
            used.append([float(value) for value in file.read().split()])
        os.remove(f"{note}.{rank}")
    pairs = len(glob.glob(os.path.join(labelled, ".marrow", "*.pair")))
    return [count, pairs, round(seconds), round(sum(seconds for seconds, _ in used)), round(used[0][1]),
            round(max(megabytes for _, megabytes in used[1:] or used))]


def plot(rows, processes, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    column = {name: [float(row[i]) for row in rows] for i, name in enumerate(COLUMNS)}
    figure, (of_time, of_memory) = pyplot.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    of_time.plot(column["pairs"], column["processor_seconds"], "o-", label="all processes together")
    of_time.set(xlabel="pairs matched", ylabel="seconds of the processors", xlim=(0, None), ylim=(0, None))
    of_memory.plot(column["meshes"], column["first_megabytes"], "o-", label="first process")
    of_memory.plot(column["meshes"], column["other_megabytes"], "s-", label="any other process, the most")
    of_memory.set(xlabel="meshes", ylabel="megabytes", xlim=(0, None), ylim=(0, None))
    for axes in (of_time, of_memory):
        axes.legend(frameon=False)
        axes.grid(alpha=0.3)
    figure.suptitle(f"marrow collection, {processes} processes")
    figure.savefig(path, dpi=120)


def main():
    if sys.argv[1:2] == ["--note"]:
        run_and_note(sys.argv[2], sys.argv[3:])
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("marrow")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--meshes", type=int, action="append")
    parser.add_argument("--processes", type=int, default=4)
    parser.add_argument("--faces", type=int, default=2000)
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    rows = []
    for count in options.meshes or [60, 125, 250, 500, 1000]:
        rows.append(measure(options, count))
        print(*rows[-1], file=sys.stderr)
        with open(os.path.join(options.output, "processes.csv"), "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([COLUMNS, *rows])
        plot(rows, options.processes, os.path.join(options.output, "processes.png"))


if __name__ == "__main__":
    main()
