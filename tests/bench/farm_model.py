#!/usr/bin/env python3
"""What `isomotion submit` gains from workers: measured for 1 and 2 here, modelled beyond.

    tests/bench/farm_model.py build/release/isomotion [--scene blobby75] [--size 512x512]
                              [--frames 40] [--rounds 5] [--sequence 10000] [--files-per-second 2000]

Every process draws with one thread (LP_NUM_THREADS=1), as workers do; another encodes, so a worker
left alone on two cores takes a part of the second. So one worker is measured on a core of its own, as
farms give it, and on both. All take turns, so that what else the machine does weighs on each. CPU time
tells what two processes cost each other, even on a busy machine. The model is arithmetic on the
measured parts, below.
"""
import argparse
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time


def timed(command, cores=None):
    """Wall and CPU seconds of a command and its children, on so many cores."""
    allowed = sorted(os.sched_getaffinity(0))[:cores]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begin = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL,
                   preexec_fn=lambda: os.sched_setaffinity(0, allowed),
                   env=dict(os.environ, LP_NUM_THREADS="1", MESA_SHADER_CACHE_DISABLE="true"))
    wall = time.perf_counter() - begin
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


SETTINGS = {"1 worker on 1 core": (1, 1), "1 worker on 2 cores": (1, 2), "2 workers on 2 cores": (2, 2)}


def scaling(arguments, folder):
    """Wall and CPU seconds of the same frames in each setting, round by round."""
    rounds = []
    for number in range(arguments.rounds):
        times = {}
        order = list(SETTINGS) if number % 2 == 0 else list(reversed(SETTINGS))
        for name in order:
            workers, cores = SETTINGS[name]
            times[name] = timed([arguments.program, "submit", arguments.scene, "--size", arguments.size,
                                 "--frames", f"1-{arguments.frames}", "--chunk", "5", "--workers", str(workers),
                                 "-o", f"{folder}/s{number} {name}/a.####.png"], cores)
        rounds.append(times)
    return rounds


def parts(arguments, folder):
    """CPU seconds of a worker's parts: what a core is busy with, whoever else wants it."""
    few, many = 1, 1 + arguments.frames // 2

    def render(last, out, *more):
        return timed([arguments.program, "render", arguments.scene, "--size", arguments.size, "--frames",
                      f"1-{last}", "-o", f"{folder}/{out}/a.####.png", *more])[1]

    median = lambda measure: statistics.median(measure(k) for k in range(arguments.rounds))
    one = median(lambda k: render(few, f"one{k}"))
    all_of_them = median(lambda k: render(many, f"many{k}"))
    one_kept = median(lambda k: render(few, f"one{k}", "--resume"))
    all_kept = median(lambda k: render(many, f"many{k}", "--resume"))
    frame = (all_of_them - one) / (many - few)
    kept = (all_kept - one_kept) / (many - few)
    start = one_kept - kept
    return {"start": start, "compile": one - frame - start, "frame": frame, "kept": kept}


def file_seconds(arguments, folder):
    """Writing, syncing and renaming a file of a frame's size, as every frame's is."""
    size = os.path.getsize(f"{folder}/many0/a.0001.png")
    times = []
    for k in range(50):
        begin = time.perf_counter()
        descriptor = os.open(f"{folder}/part", os.O_WRONLY | os.O_CREAT, 0o644)
        os.write(descriptor, bytes(size))
        os.fsync(descriptor)
        os.close(descriptor)
        os.rename(f"{folder}/part", f"{folder}/file{k}")
        times.append(time.perf_counter() - begin)
    return size, statistics.median(times)


def modelled(part, sequence, workers, chunk, files_per_second):
    """Seconds until all frames of the sequence are there, and until they are looked through once."""
    chunks = min(sequence, workers * math.ceil(math.ceil(sequence / chunk) / workers))
    size = math.ceil(sequence / chunks)
    busy = math.ceil(chunks / workers) * (part["start"] + part["compile"] + size * (part["frame"] + part["file"]))
    drawn = max(busy, sequence / files_per_second)
    return size, drawn, drawn + part["start"] + sequence * part["kept"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("--scene", default="blobby75")
    parser.add_argument("--size", default="512x512")
    parser.add_argument("--frames", type=int, default=40,
                        help="of a measurement, in chunks of 5; a multiple of 10 is as many for 1 worker as for 2")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--sequence", type=int, default=10000, help="frames of the modelled sequence")
    parser.add_argument("--files-per-second", type=float, default=2000,
                        help="that the farm's file server takes, an assumption")
    arguments = parser.parse_args()

    with tempfile.TemporaryDirectory(prefix="isomotion-farm-") as folder:
        rounds = scaling(arguments, folder)
        print(f"measured: {arguments.scene}, {arguments.frames} frames of {arguments.size}, "
              f"{arguments.rounds} rounds, load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
        both = [times["2 workers on 2 cores"] for times in rounds]
        for name in SETTINGS:
            these = [times[name] for times in rounds]
            ratios = sorted(one[0] / two[0] for one, two in zip(these, both))
            print(f"  {name}: {statistics.median(wall for wall, _ in these):.2f} s, "
                  f"{statistics.median(cpu for _, cpu in these):.2f} s of CPU; over 2 workers "
                  f"{statistics.median(ratios):.2f} ({ratios[0]:.2f} to {ratios[-1]:.2f})")
        part = parts(arguments, folder)
        size, part["file"] = file_seconds(arguments, folder)
    print("  CPU seconds: start {start:.3f}, compile {compile:.3f}, a frame drawn and encoded {frame:.4f}, "
          "a frame kept {kept:.4f}".format(**part))
    print(f"  a file of {size / 1e3:.0f} kB written, synced and renamed: {1e3 * part['file']:.1f} ms")

    print(f"\nmodelled: {arguments.sequence} frames, chunks of 20 at most, a core a worker, "
          f"a file server of {arguments.files_per_second:g} files a second")
    alone = modelled(part, arguments.sequence, 1, 20, math.inf)[1]
    print("| workers | frames a chunk | all frames drawn | times as fast | of the workers' time drawing "
          "| and seen to be whole |")
    print("|--:|--:|--:|--:|--:|--:|")
    for workers in (1, 2, 10, 100, 500, 1000):
        chunk, drawn, joined = modelled(part, arguments.sequence, workers, 20, arguments.files_per_second)
        share = arguments.sequence * part["frame"] / (workers * drawn)
        print(f"| {workers:,} | {chunk} | {drawn:,.1f} s | {alone / drawn:,.1f} | {100 * share:.0f} % "
              f"| {joined:,.1f} s |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
