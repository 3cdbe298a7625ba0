#!/usr/bin/env python3
"""Compiles each source of src by itself, for its syntax alone: check_sources.py [--since COMMIT] [SOURCE...]

Builds that join sources (MRSIM_UNITY) hide a missing include behind the include of a neighbour. Sources that the build folder (BUILD=folder,
default build) compiles by themselves are left out, unless they are named. --since: only those in which it can be missing since then, which
have changed, or include, directly or not, a header that has lost a name that they use or an #include that they have from nowhere else;
all where git does not know COMMIT. Two seconds of a core for each.
"""

import concurrent.futures
import functools
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))


def commands(folder):
    """(source, its command without an output) of each source of the library and the program."""
    subprocess.run(["cmake", "--preset", "sources", "-B", folder], cwd=ROOT, check=True,
                   stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "compile_commands.json"), encoding="utf-8") as file:
        for entry in json.load(file):
            words = shlex.split(entry["command"])
            out = words.index("-o")
            del words[out:out + 2]
            words = [w for w in words if w not in ("-c", "-O2", "-O3")]
            yield os.path.relpath(entry["file"], ROOT), words + ["-fsyntax-only"], entry["directory"]


def compiled_alone():
    """Sources that the build folder does not join."""
    path = os.path.join(ROOT, os.environ.get("BUILD", "build"), "compile_commands.json")
    if not os.path.exists(path):
        return set()
    with open(path, encoding="utf-8") as file:
        return {os.path.relpath(entry["file"], ROOT) for entry in json.load(file)}


def differences(*words):
    """What git prints of the differences; None where it does not know the commit."""
    result = subprocess.run(["git", "diff", *words], cwd=ROOT, capture_output=True, text=True, check=False)
    return result.stdout if result.returncode == 0 else None


class Includes:
    """Who includes whom among the files of src and include, by the paths that stand in #include lines."""

    def __init__(self, root=ROOT):
        self.text, self.direct, self.users = {}, {}, {}
        for folder, _, names in (step for top in ("src", "include") for step in os.walk(os.path.join(root, top))):
            for name in names:
                path = os.path.relpath(os.path.join(folder, name), root)
                with open(os.path.join(root, path), encoding="utf-8") as file:
                    self.text[path] = code = code_of(file.read())
                self.direct[path] = set(INCLUDE.findall(code))
                for header in self.direct[path]:
                    self.users.setdefault(header, set()).add(path)

    def includers(self, header):
        """Files that include this one, directly or not."""
        found, todo = set(), [header]
        while todo:
            fresh = self.users.get(re.sub("^(src|include)/", "", todo.pop()), set()) - found
            found |= fresh
            todo += fresh
        return found

    @functools.lru_cache(maxsize=None)
    def includes(self, path):
        """What a file includes, directly or not."""
        found, todo = set(), [path]
        while todo:
            name = todo.pop()
            fresh = set().union(*(self.direct.get(top + name, ()) for top in ("", "src/", "include/"))) - found
            found |= fresh
            todo += fresh
        return found

    @functools.lru_cache(maxsize=None)
    def names(self, path):
        """What a file and its includes declare, as far as is known."""
        files = {top + name for name in {path} | self.includes(path) for top in ("", "src/", "include/")}
        return set().union(*(declared(self.text[file]) for file in files & self.text.keys()),
                           *(NAMES.get(name, ()) for name in {path} | self.includes(path)))

    def can_miss(self, header, lost):
        """Sources in which an include can be missing after a header, itself among its users, has lost these lines."""
        includes = set(INCLUDE.findall(lost))
        includes = includes.union(*(self.includes(name) for name in includes))
        gone = declared(lost).union(*(self.names(name) for name in includes))
        unknown = {name for name in includes if not self.names(name)}
        found = {user for user in self.includers(header) | {header}
                 if (gone & words_of(self.text[user])) - self.names(user) or unknown - self.includes(user)}
        return found.union(*(self.includers(user) for user in found))


INCLUDE = re.compile(r'^#include ["<]([^">]+)[">]', re.M)
# What a standard header is included for, of those that have few names; any use of others is possible.
NAMES = {"array": {"array"}, "atomic": {"atomic"}, "bitset": {"bitset"}, "cstddef": {"size_t", "byte", "ptrdiff_t"},
         "cmath": set("abs fabs sqrt cbrt hypot sin cos tan asin acos atan atan2 exp log log2 log10 pow floor ceil round trunc lround "
                      "llround rint nearbyint fmod remainder modf ldexp frexp copysign signbit isfinite isnan isinf nextafter fma fmin "
                      "fmax fdim".split()),
         "algorithm": set("min max minmax clamp sort stable_sort partial_sort nth_element is_sorted find find_if find_if_not "
                          "find_first_of adjacent_find search count count_if all_of any_of none_of for_each for_each_n equal mismatch "
                          "lexicographical_compare copy copy_n copy_if copy_backward move_backward fill fill_n generate generate_n "
                          "transform replace replace_if remove remove_if remove_copy_if unique unique_copy reverse reverse_copy rotate "
                          "shuffle partition stable_partition partition_point lower_bound upper_bound equal_range binary_search merge "
                          "inplace_merge includes set_union set_intersection set_difference min_element max_element minmax_element "
                          "push_heap pop_heap make_heap sort_heap next_permutation prev_permutation swap_ranges iter_swap "
                          "ranges".split()),
         "cstring": {"memcpy", "memmove", "memset", "memcmp", "memchr", "strlen", "strcmp", "strncmp", "strchr", "strerror"},
         "numeric": {"accumulate", "iota", "reduce", "inner_product", "partial_sum", "gcd", "lcm", "midpoint"},
         "deque": {"deque"}, "functional": {"function", "hash", "less", "greater", "plus", "ref", "cref", "invoke"},
         "initializer_list": {"initializer_list"}, "limits": {"numeric_limits"}, "map": {"map", "multimap"},
         "memory": {"unique_ptr", "shared_ptr", "weak_ptr", "make_unique", "make_shared"}, "mutex": {"mutex", "lock_guard"},
         "numbers": {"numbers"}, "optional": {"optional", "nullopt", "make_optional"}, "set": {"set", "multiset"},
         "span": {"span", "as_bytes"}, "string": {"string", "to_string", "stoi", "stod", "getline"},
         "string_view": {"string_view", "sv"}, "unordered_map": {"unordered_map"}, "unordered_set": {"unordered_set"},
         "utility": {"pair", "move", "swap", "exchange", "forward", "make_pair", "index_sequence"},
         "variant": {"variant", "visit", "get_if", "monostate"}, "vector": {"vector"},
         "cstdint": {f"{sign}int{form}{bits}_t" for sign in ("", "u") for form in ("", "_fast", "_least")
                     for bits in (8, 16, 32, 64)} | {"uintptr_t", "intptr_t", "uintmax_t", "intmax_t"}}


def code_of(text):
    """A source without its comments."""
    return re.sub(r"//.*", "", text)


@functools.lru_cache(maxsize=None)
def words_of(text):
    return set(re.findall(r"[A-Za-z_]\w*", text))


@functools.lru_cache(maxsize=None)
def declared(text):
    """Names of types, constants and macros, and of functions outside of classes, which begin their line."""
    functions = (re.findall(r"(\w+)\(", line) for line in re.findall(r"^[A-Za-z].*", text, re.M))
    return set(re.findall(r"\b(?:struct|class|enum|using|concept|define)\s+(\w+)", text)).union(
        re.findall(r"\bk[A-Z]\w*", text), *functions)


def doubtful_since(commit):
    """Sources in which an include can be missing since then; None = any."""
    changed = differences("--name-only", commit, "--", "src")
    if changed is None:
        return None
    doubtful, includes = set(changed.split()), Includes()
    for header in differences("--name-only", commit, "--", "src/*.h", "src/*.inl", "include/*.h").split():
        lost = re.findall("^-(?!-)(.*)", differences("-U0", commit, "--", header), re.M)
        doubtful |= includes.can_miss(header, code_of("\n".join(lost)))
    return doubtful


def main():
    words = sys.argv[1:]
    since = words[1] if words[:1] == ["--since"] else None
    wanted = {os.path.relpath(path, ROOT) for path in (words[2:] if since else words)}
    done = set() if wanted else compiled_alone()
    doubtful = doubtful_since(since) if since else None
    with tempfile.TemporaryDirectory() as folder:
        found = {source: (words, where) for source, words, where in commands(folder)
                 if source.startswith("src/") and source not in done and (not wanted or source in wanted)
                 and (doubtful is None or source in doubtful)}
        def compiled(source):
            words, where = found[source]
            return source, subprocess.run(words, cwd=where, capture_output=True, text=True, check=False)
        faults = 0
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for source, result in pool.map(compiled, sorted(found)):
                if result.returncode != 0:
                    faults += 1
                    print(f"{source} does not compile by itself\n{result.stderr}")
    print(f"{len(found)} sources, {faults} faults")
    return 1 if faults or not (found or since) else 0


if __name__ == "__main__":
    sys.exit(main())
