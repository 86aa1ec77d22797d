"""What the scripts that time shading share."""
import collections
import json
import pathlib
import statistics
import subprocess
import sys

WIDTHS = [1, 4, 8, 16]


def run(*command):
    """Runs a program and gives what it prints. Ends the script where the program fails."""
    result = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, text=True)
    if result.returncode:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {command[0]} failed")
    return result.stdout


def nanoseconds(benchmark, libraries, repetitions):
    """Median time a point for each 'file/shader/width'."""
    report = json.loads(run(benchmark, *libraries, f"--benchmark_repetitions={repetitions}",
                            "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.02",
                            "--benchmark_format=json"))
    times = collections.defaultdict(list)
    for entry in report["benchmarks"]:
        if entry["run_type"] == "iteration":
            times[entry["run_name"]].append(1e9 / entry["points"])
    return {name: statistics.median(values) for name, values in times.items()}


def table(header, rows):
    """A table in Markdown; all columns but the first are figures."""
    return "\n".join(["| " + " | ".join(cells) + " |" for cells in
                      [header, ["---"] + ["---:"] * (len(header) - 1), *rows]])
