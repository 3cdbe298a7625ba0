#!/usr/bin/env python3
"""Breaks runs of the built program on purpose and counts what is lost: docs/reliability.md has the figures.

    python3 scripts/fault_injection.py [--program build/bin/mrsim] [--kills 300] [--seed 1]

Each run replaces a set of six files. Whatever happens to it, after the next run into the folder the files are those of one run,
whole, and no other file lies there. Faults: SIGKILL at random moments; SIGKILL before each system call that publishes files; each of
these calls refused (EACCES, ENOSPC); a limit of file sizes (RLIMIT_FSIZE); two runs at once. Exit 1 where anything was lost.
"""

import argparse
import hashlib
import os
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data")
OUTPUTS = ["a.stl", "b.ply", "c.obj", "d.off", "e.3mf", "f.glb"]

# Counts the calls that publish files; at call number MRSIM_FAULT_AT the process dies, or the call fails.
PRELOAD = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
static int strikes(void) {
  static int calls;
  const char* at = getenv("MRSIM_FAULT_AT");
  const char* error = getenv("MRSIM_FAULT_ERRNO");
  const int now = __sync_add_and_fetch(&calls, 1);
  const char* log = getenv("MRSIM_FAULT_LOG");
  if (log) { FILE* f = fopen(log, "w"); fprintf(f, "%d", now); fclose(f); }
  if (!at || now != atoi(at)) return 0;
  if (!error) raise(SIGKILL);
  errno = atoi(error);
  return 1;
}
#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
int rename(const char* a, const char* b) { return strikes() ? -1 : REAL(rename)(a, b); }
int link(const char* a, const char* b) { return strikes() ? -1 : REAL(link)(a, b); }
int linkat(int a, const char* b, int c, const char* d, int e) { return strikes() ? -1 : REAL(linkat)(a, b, c, d, e); }
int unlink(const char* a) { return strikes() ? -1 : REAL(unlink)(a); }
int fsync(int fd) { return strikes() ? -1 : REAL(fsync)(fd); }
"""


class Folder:
    """A folder with the set of one of two variants in it."""

    def __init__(self, program, place):
        self.program, self.place, self.lost, self.faults, self.sets = program, place, 0, 0, {}
        for name in ("PRIMER_2F.MPF", "block.stl"):
            os.symlink(os.path.abspath(os.path.join(DATA, name)), os.path.join(place, name))
        for variant in (0, 1):
            self.run(variant)
            self.sets[self.hashes()] = variant

    def command(self, variant):
        words = [self.program, "PRIMER_2F.MPF", "--stock", "block.stl", "-q", "--threads", "2", "--voxel", ("4", "5")[variant]]
        for name in OUTPUTS:
            words += ["-o", name]
        return words

    def start(self, variant, env=None, before=None):
        return subprocess.Popen(self.command(variant), cwd=self.place, env={**os.environ, **(env or {})}, preexec_fn=before,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    def run(self, variant, env=None, before=None):
        process = self.start(variant, env, before)
        process.communicate()
        return process.returncode

    def hashes(self):
        out = []
        for name in OUTPUTS:
            try:
                with open(os.path.join(self.place, name), "rb") as file:
                    out.append(hashlib.sha256(file.read()).hexdigest())
            except FileNotFoundError:
                out.append("missing")
        return tuple(out)

    def judge(self, what):
        """After the next run into the folder, which fails for want of a program."""
        self.faults += 1
        subprocess.run([self.program, "missing.nc", "-q", "-o", "a.stl"], cwd=self.place, stderr=subprocess.DEVNULL, check=False)
        litter = sorted(set(os.listdir(self.place)) - set(OUTPUTS) - {"PRIMER_2F.MPF", "block.stl"})
        if self.hashes() not in self.sets:
            self.lost += 1
            print(f"LOST: {what}: the files are not those of one run")
            self.run(0)
        if litter:
            self.lost += 1
            print(f"LITTER: {what}: {' '.join(litter)}")
            for name in litter:
                os.unlink(os.path.join(self.place, name))


def random_kills(folder, kills, chance):
    begin = time.monotonic()
    folder.run(0)
    length = time.monotonic() - begin
    killed = 0
    for i in range(kills):
        process = folder.start(i % 2)
        time.sleep(chance.uniform(0, 1.1) * length)
        killed += process.poll() is None
        process.kill()
        process.communicate()
        folder.judge(f"kill {i}")
    print(f"killed at random: {killed} of {kills} runs, the others had ended")


def each_call(folder, library, log, error):
    env = {"LD_PRELOAD": library, "MRSIM_FAULT_LOG": log}
    folder.run(0, env)
    with open(log, encoding="ascii") as file:
        calls = int(file.read())
    for call in range(1, calls + 1):
        faults = {**env, "MRSIM_FAULT_AT": str(call)}
        if error:
            faults["MRSIM_FAULT_ERRNO"] = str(error)
        code = folder.run(call % 2, faults)
        if code not in ((0, 1) if error else (-signal.SIGKILL, 0)):
            folder.lost += 1
            print(f"EXIT {code} at call {call}, errno {error}")
        folder.judge(f"call {call}, errno {error}")
    print(f"{'errno ' + str(error) if error else 'killed'} at each of {calls} calls")


def size_limits(folder, chance, rounds):
    for i in range(rounds):
        size = int(10 ** chance.uniform(0, 5.2))
        code = folder.run(i % 2, before=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
        if code not in (0, 1):
            folder.lost += 1
            print(f"EXIT {code} with files of at most {size} bytes")
        folder.judge(f"limit of {size} bytes")
    print(f"{rounds} limits of file sizes")


def pairs(folder, rounds):
    for i in range(rounds):
        both = [folder.start(0), folder.start(1)]
        for process in both:
            process.communicate()
        if any(process.returncode for process in both):
            folder.lost += 1
            print(f"EXIT {[process.returncode for process in both]} of two runs at once")
        folder.judge(f"pair {i}")
    print(f"{rounds} pairs of runs at once")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", default="build/bin/mrsim")
    parser.add_argument("--kills", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as place, tempfile.TemporaryDirectory() as tools:
        source, library = os.path.join(tools, "fault.c"), os.path.join(tools, "fault.so")
        with open(source, "w", encoding="ascii") as file:
            file.write(PRELOAD)
        subprocess.run(["cc", "-shared", "-fPIC", "-O1", source, "-o", library, "-ldl"], check=True)
        folder = Folder(os.path.abspath(options.program), place)
        for error in (0, 13, 28):  # killed, EACCES, ENOSPC
            each_call(folder, library, os.path.join(tools, "log"), error)
        size_limits(folder, chance, max(10, options.kills // 10))
        pairs(folder, max(5, options.kills // 20))
        random_kills(folder, options.kills, chance)
        print(f"{folder.faults} faults injected, {folder.lost} lost")
        return 1 if folder.lost else 0


if __name__ == "__main__":
    sys.exit(main())
