#!/usr/bin/env python3
"""Runs mutants of every input format against the built program.

    scripts/black_box.py [--program build/bin/mrsim] [--count 2000] [--seed 1] [--keep FOLDER]

Each mutant is a run of the program in a folder of its own with limits on time and memory. A run may
succeed or end with an error about its input. It fails the check if it ends by a signal, with exit 3
(an internal fault), runs into the time limit, or changes, adds or removes a file other than the
outputs it was told to write. The same seed gives the same mutants; --keep holds what failed.
"""
import argparse
import hashlib
import json
import os
import random
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DATA = ROOT / "data"
CORPUS = ROOT / "tests" / "fuzz" / "corpus"
SECONDS = 20  # a run beyond it hangs
# Outputs of a run are its own; what else stands in the folder must stay as it was.
OUTPUTS = {"out.stl", "out.ply", "out.obj", "out.glb", "out.3mf", "out.off", "out.json", "out.html"}

TOOLS = b"""units = "mm"
[[tool]]
id = "4"
type = "endmill"
diameter = 5.0
flute_length = 12
shank = [[6, 40]]
holder = [[30, 40, 20]]
[[tool]]
id = "5"
type = "form"
profile = [[0, 0], [2, 0, 0.4], [3, 4]]
[offsets.D3]
radius = 5.0
[work.G54]
z = 0.0
"""
JOB = b"""program = "p.nc"
stock = "box:0,0,-10,40,40,0"
outputs = ["out.stl"]
voxel = 2.0
tool = ["4=endmill:d=5"]
threads = 1
"""
MILL = b"""G54 G17 G90 G21
T4 M6
S3000 F200 M3
G0 X0 Y0 Z5
G1 Z-2
G1 X20 Y5
G2 X30 Y15 I0 J10
G3 X20 Y25 R-12 Z-4
G41 D3 G1 X5 Y5
G40 X0 Y0
G0 Z20
M30
"""
TOKENS = [b"G", b"X", b"Y-1e9", b"Z.", b"R0", b"I-0", b"T99999", b"M30", b"G91", b"G18", b"(", b")", b";", b"/",
          b"N0", b"L1 P9999", b"M98 P1", b"CALL ", b"REPEAT A B P=9", b"TURN=999", b"CR=0", b"#1=#1", b"R1=R1+1", b"1e308",
          b"-1e-308", b"nan", b"inf", b"99999999999999999999", b"\x00", b"\xff\xfe", b"\r", b"\n\n", b"[[", b"]]", b"=", b"\"",
          b"'", b"<", b">", b"&", b"0x", b"-", b"+", b".", b"%", b"$", b"{", b"}"]


NESTS = [b"(", b"[", b"{", b"[[", b"{\"a\":", b"<a>", b"a.", b"#1=", b"/*"]
NUMBER = re.compile(rb"[-+]?[0-9]+\.?[0-9]*")

# Tables and libraries of tools of other programs, and what else a run reads, all with a tool 4 where they have numbers.
FUSION = [json.dumps({"data": [
    {"type": kind, "unit": unit, "description": "x", "post-process": {"number": 4},
     "geometry": {"DC": 6, "RE": 0.2, "TA": 30, "SIG": 118, "LCF": 12, "LB": 20, "SFDM": 6, "shoulder-length": 15},
     "holder": {"segments": [{"height": 20, "lower-diameter": 20, "upper-diameter": 30}]}}]}).encode()
          for kind, unit in (("flat end mill", "millimeters"), ("bull nose end mill", "inches"), ("drill", "millimeters"),
                             ("tapered mill", "millimeters"), ("lollipop mill", "millimeters"))]
LIBRARIES = {
    "t.tbl": [b"T4 P1 D6.0 Z-51 ;6mm flat end mill\nT2 P2 D3 Q2 I10 J30 ;CCMT\n"],
    "t.camotics": [b'{"units":"metric","tools":{"4":{"units":"imperial","shape":"snubnose","length":1,"diameter":0.5,'
                   b'"snub_diameter":0.1}},"files":["p.nc"],"workpiece":{"bounds":{"min":[0,0,-10],"max":[40,40,0]}}}'],
    "t.json": FUSION + [b'{"4":{"units":"metric","shape":"spheroid","length":5,"diameter":5}}'],
    "t.fctb": [b'{"version":2,"name":"v","shape":"v-bit.fcstd","parameter":{"CuttingEdgeAngle":"60.0 deg","Diameter":"1/4 in",'
               b'"CuttingEdgeHeight":"10 mm","ShankDiameter":"6 mm","TipDiameter":"0.1 mm"}}'],
    "t.fctl": [b'{"tools":[{"nr":4,"path":"x.fctb"},{"nr":5,"path":"x.fctb"}],"version":1}'],
}
MACHINE = b"""[machine]
kind = "mill"
rapid = [15000, 15000, 10000]
acceleration = 2000
corner_tolerance = 0.01
zero.G54 = [-210.5, -120, -180]
second = [-400, 0, 0]
limits = { x = [-600, 0], y = [-400, 0] }
"""


def box_obj():
    lines = [f"v {x} {y} {z}" for z in (-10, 0) for y in (0, 40) for x in (0, 40)]
    faces = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"]
    return ("\n".join(lines) + "\n" + "\n".join("f " + f for f in faces) + "\n").encode()


def programs():
    found = {"mill.nc": MILL}
    for name in sorted(os.listdir(DATA)):
        if name.endswith((".MPF", ".NC", ".CNC")) and "verbatim" not in name:
            found[name] = (DATA / name).read_bytes()
    return found


def run_program(program, arguments, folder, address_space):
    def limits():
        resource.setrlimit(resource.RLIMIT_AS, (address_space, address_space))
        resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 28, 1 << 28))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    begin = time.monotonic()
    process = subprocess.Popen([program] + arguments, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, preexec_fn=limits, start_new_session=True)
    try:
        text, _ = process.communicate(timeout=SECONDS)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return None, b"", time.monotonic() - begin
    return process.returncode, text, time.monotonic() - begin


class Mutator:
    """Bytes changed, removed, doubled, numbers replaced, tokens put in."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def mutate(self, data):
        data = bytearray(data)
        for _ in range(self.random.choice((1, 1, 1, 1, 2, 4))):
            self.step(data)
        return bytes(data[: 1 << 20])

    def step(self, data):
        r = self.random
        at = r.randrange(len(data) + 1)
        kind = r.choice((0, 0, 1, 2, 3, 4, 4, 4, 4, 5, 5, 6, 7, 7, 8, 8, 9))
        if kind == 0 and data:
            data[at % len(data)] = r.randrange(256)
        elif kind == 1:
            del data[at: at + r.choice((1, 4, 40, 400))]
        elif kind == 2:
            data[at:at] = data[at: at + r.choice((4, 40, 400))] * r.choice((1, 2, 50))
        elif kind == 3:
            data[at:at] = r.choice(TOKENS)
        elif kind == 4:
            self.change_number(data)
        elif kind == 5 and len(data) >= 4:
            struct.pack_into("<I", data, at % (len(data) - 3), r.choice((0, 1, 0x7f800000, 0xffffffff, 0x7f7fffff, 1 << 20)))
        elif kind == 6:
            del data[at:]
        elif kind == 7 and data:
            data[at % len(data)] ^= 1 << r.randrange(8)
        elif kind == 8:
            self.swap_numbers(data)
        elif kind == 9:
            data[at:at] = r.choice(NESTS) * r.choice((10, 1000, 50000))

    def swap_numbers(self, data):
        """One number in the place of another: references that lead elsewhere, or in a circle."""
        numbers = list(NUMBER.finditer(bytes(data[: 1 << 16])))
        if numbers:
            to, by = self.random.choice(numbers), self.random.choice(numbers)
            data[to.start(): to.end()] = by.group()

    def change_number(self, data):
        numbers = list(NUMBER.finditer(bytes(data[: 1 << 16])))
        if not numbers:
            return
        chosen = self.random.choice(numbers)
        new = self.random.choice((b"0", b"-0", b"1", b"-1", b"0.001", b"1e-9", b"1e9", b"-1e38", b"123456789", b"2147483648",
                                  b"4294967295", b"99999999999999999999", b"1e400", b"nan"))
        data[chosen.start(): chosen.end()] = new


class Case:
    """One format: the file that is mutated, what stands beside it, and the command."""

    def __init__(self, name, file, seeds, arguments, beside=None, repack=None):
        self.name, self.file, self.seeds, self.arguments = name, file, seeds, arguments
        self.beside = beside or {}
        self.repack = repack


def make_seeds(program, folder):
    """Files that only the program itself can make."""
    (folder / "p.nc").write_bytes(MILL)
    wanted = ["part." + end for end in ("stl", "obj", "ply", "off", "3mf", "glb", "vdb")]
    arguments = ["p.nc", "--stock", "box:0,0,-10,40,40,0", "--tool", "4=endmill:d=5", "--voxel", "2", "-q"]
    for name in wanted:
        arguments += ["-o", name]
    done = subprocess.run([program] + arguments, cwd=folder, capture_output=True)
    if done.returncode != 0:
        sys.exit("the seeds can not be made:\n" + done.stderr.decode())
    return {name: (folder / name).read_bytes() for name in wanted}


def cases(seeds):
    milled = ["--stock", "box:0,0,-10,40,40,0", "--tool", "4=endmill:d=5", "--voxel", "2", "--threads", "1",
              "--max-memory", "400M", "-o", "out.stl"]
    out = [Case("nc", "p.nc", list(programs().values()), ["check", "p.nc"]),
           Case("trace", "p.nc", list(programs().values()), ["trace", "p.nc", "--json", "--machine", "mill"]),
           Case("run", "p.nc", [MILL], ["p.nc"] + milled)]
    for dialect in ("sinumerik", "iso", "fanuc", "codesys"):
        out.append(Case(dialect, "p.nc", list(programs().values()),
                        ["check", "p.nc", "--dialect", dialect, "--machine", "mill", "--tool", "endmill:d=5"]))
    for end in ("stl", "obj", "ply", "off", "3mf", "glb", "vdb"):
        file = "s." + end
        stock = [seeds["part." + end], box_obj()] if end == "obj" else [seeds["part." + end]]
        out.append(Case("stock." + end, file, stock,
                        ["p.nc", "--stock", file] + milled[2:], {"p.nc": MILL}))
        out.append(Case("compare." + end, file, stock, ["compare", file, "n.stl", "--json", "out.json", "--threads", "1"],
                        {"n.stl": seeds["part.stl"]}))
    out.append(Case("nominal", "n.stl", [seeds["part.stl"]], ["compare", "a.ply", "n.stl", "--report", "out.html",
                                                             "--threads", "1"], {"a.ply": seeds["part.ply"]}))
    out.append(Case("step", "n.step", [p.read_bytes() for p in sorted(CORPUS.glob("step/*"))],
                    ["compare", "a.ply", "n.step", "--threads", "1", "--deflection", "0.1"], {"a.ply": seeds["part.ply"]}))
    # Level sets of other programs, whose voxels are read; those of mrsim are refused for their check sum.
    voxels = [p.read_bytes()[1:] for p in sorted(CORPUS.glob("vdb/*")) if p.read_bytes()[:1] == b"\0"]
    out.append(Case("voxels", "s.vdb", voxels, ["p.nc", "--stock", "s.vdb"] + milled[2:], {"p.nc": MILL}))
    out.append(Case("tools", "t.toml", [TOOLS], ["p.nc", "--tools", "t.toml"] + milled[:2] + milled[4:], {"p.nc": MILL}))
    out.append(Case("job", "job.toml", [JOB], ["job.toml"], {"p.nc": MILL}))
    beside = {"p.nc": MILL, "x.fctb": LIBRARIES["t.fctb"][0]}
    for file, seed in LIBRARIES.items():
        out.append(Case("library." + file[2:], file, seed, ["p.nc", "--tools", file] + milled[:2] + milled[4:], beside))
    out.append(Case("machine", "m.toml", [MACHINE], ["p.nc", "--machine-file", "m.toml"] + milled, {"p.nc": MILL}))
    for end in ("ply", "3mf", "glb"):
        out.append(Case("rest." + end, "s." + end, [seeds["part." + end]],
                        ["rest", "s." + end, "n.stl", "--voxel", "1", "--json", "out.json", "--threads", "1"],
                        {"n.stl": seeds["part.stl"]}))
    # The model of a 3MF is packed again, or nearly all mutants would fail at the check sum.
    models = [seeds["part.3mf"]]
    out.append(Case("3mf-model", "s.3mf", models, ["p.nc", "--stock", "s.3mf"] + milled[2:], {"p.nc": MILL}, repack=True))
    return out


def repacked(data, mutator):
    import io
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        parts = {n: archive.read(n) for n in archive.namelist()}
    parts["3D/3dmodel.model"] = mutator.mutate(parts["3D/3dmodel.model"])
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    return out.getvalue()


def state_of(folder):
    return {p.relative_to(folder).as_posix(): hashlib.sha256(p.read_bytes()).hexdigest()
            for p in folder.rglob("*") if p.is_file()}


def judge(program, case, number, seed, base, address_space):
    """A text where the run broke a promise, else nothing; and what it took."""
    mutator = Mutator(f"{seed}/{case.name}/{number}")
    folder = Path(tempfile.mkdtemp(dir=base))
    original = mutator.random.choice(case.seeds)
    mutant = repacked(original, mutator) if case.repack else mutator.mutate(original)
    for name, content in case.beside.items():
        (folder / name).write_bytes(content)
    (folder / case.file).write_bytes(mutant)
    before = state_of(folder)
    code, text, seconds = run_program(program, case.arguments, folder, address_space)
    after = {name: h for name, h in state_of(folder).items() if name not in OUTPUTS}
    if case.name == "job":  # names its outputs itself
        after = {name: h for name, h in after.items() if name in before or name.startswith(".")}
    fault = None
    if code is None:
        fault = f"ran for more than {SECONDS} s"
    elif code < 0 or code >= 128:
        fault = f"ended by signal {-code if code < 0 else code - 128}"
    elif code == 3:
        fault = "internal fault: " + text.decode(errors="replace").strip()[-200:]
    elif code not in (0, 1, 2, 4, 5):
        fault = f"exit {code}"
    elif after != before:
        changed = sorted(set(before.items()) ^ set(after.items()))
        fault = "touched " + ", ".join(sorted({name for name, _ in changed}))
    elif code != 0 and case.name != "nominal" and not case.name.startswith("compare") and b"error" not in text:
        fault = f"exit {code} without an error that says why"
    return case, number, folder, fault, code, seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default=str(ROOT / "build" / "bin" / "mrsim"))
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="formats whose names contain this")
    parser.add_argument("--keep", help="folder for the inputs of runs that failed")
    parser.add_argument("--address-space", type=int, default=4 << 30, help="bytes for each run")
    options = parser.parse_args()
    program = str(Path(options.program).resolve())
    begin = time.monotonic()
    faults, codes, slowest = [], {}, (0, "")
    with tempfile.TemporaryDirectory(prefix="mrsim-black-box-") as name:
        base = Path(name)
        (base / "seeds").mkdir()
        chosen = [c for c in cases(make_seeds(program, base / "seeds")) if not options.only or options.only in c.name]
        jobs = [(chosen[i % len(chosen)], i) for i in range(options.count)]
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for case, number, folder, fault, code, seconds in pool.map(
                    lambda job: judge(program, job[0], job[1], options.seed, base, options.address_space), jobs):
                codes[code] = codes.get(code, 0) + 1
                slowest = max(slowest, (seconds, f"{case.name} {number}"))
                if fault:
                    faults.append(f"{case.name} {number}: {fault}")
                    print(faults[-1], flush=True)
                    if options.keep:
                        shutil.copytree(folder, Path(options.keep) / f"{case.name}-{number}", dirs_exist_ok=True)
                        (Path(options.keep) / f"{case.name}-{number}" / ".command").write_text(" ".join(case.arguments) + "\n")
                shutil.rmtree(folder)
    exits = ", ".join(f"{n} exit {code}" for code, n in sorted(codes.items(), key=lambda item: str(item[0])))
    print(f"{options.count} mutants of {len(chosen)} kinds in {time.monotonic() - begin:.0f} s: {exits}; "
          f"slowest {slowest[0]:.1f} s ({slowest[1]}); {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
