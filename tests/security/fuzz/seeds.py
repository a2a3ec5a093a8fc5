#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
#
# Makes the inputs that every reader begins with: seeds.py BUILD FOLDER writes FOLDER/READER/NAME. Whole files of each kind,
# and one of each find: what once crashed a reader, or took its time or its memory.
import io
import json
import os
import struct
import subprocess
import sys
import tarfile
import tempfile
import zipfile

build, folder = sys.argv[1:3]


def seed(reader, name, data):
    os.makedirs(os.path.join(folder, reader), exist_ok=True)
    with open(os.path.join(folder, reader, name), "wb") as out:
        out.write(data if isinstance(data, bytes) else data.encode())


def nested(depth, inside=""):
    return "[" * depth + inside + "]" * depth


# --- ELF: a byte that says "with headers", then what a library has behind its two segments at `base`.
EHDR, PHDR = 64, 56
base = EHDR + 2 * PHDR
NULL, NEEDED, HASH, STRTAB, SYMTAB, RPATH, GNU_HASH, FLAGS_1 = 0, 1, 4, 5, 6, 15, 0x6FFFFEF5, 0x6FFFFFFB


def dynamic(entries, size=None):
    data = b"".join(struct.pack("<QQ", *e) for e in entries)
    return data.ljust(size, b"\0") if size else data


def elf(entries, tail):
    """The dynamic entries get what follows them at base + 16 * len(entries)."""
    return b"\1" + dynamic(entries) + tail


def elf_at(n):
    return base + 16 * n


symbol = struct.pack("<IBBHQQ", 0, 2, 0, 1, 0, 0)  # a function whose name is at 0
name = b"mirocup_entry\0"
n = 4
seed("elf", "exports", elf([(STRTAB, elf_at(n)), (SYMTAB, elf_at(n) + 16), (HASH, elf_at(n) + 16 + 24), (NULL, 0)],
                           name.ljust(16, b"\0") + symbol + struct.pack("<III", 1, 1, 0)))
seed("elf", "needs", elf([(STRTAB, elf_at(n)), (SYMTAB, elf_at(n)), (NEEDED, 0), (NULL, 0)], b"libm.so.6\0"))
# Many needed libraries that share one long name: each was copied.
count = 4090
seed("elf", "needed_shared", elf([(STRTAB, elf_at(count + 3)), (SYMTAB, elf_at(count + 3))] + [(NEEDED, 0)] * count +
                                 [(NULL, 0)], b"x" * (31 << 20) + b"\0"))
seed("elf", "needed_long", elf([(STRTAB, elf_at(n)), (SYMTAB, elf_at(n)), (NEEDED, 0), (NULL, 0)], b"x" * 300 + b"\0"))
seed("elf", "search_path_long", elf([(STRTAB, elf_at(n)), (SYMTAB, elf_at(n)), (RPATH, 0), (NULL, 0)],
                                    b"x" * (1 << 20) + b"\0"))
# A million symbols whose names have no end near: each was looked for to the end of the file.
links = 1 << 20
seed("elf", "chain_of_symbols", elf([(STRTAB, elf_at(n) + 24 + 8), (SYMTAB, elf_at(n)), (HASH, elf_at(n) + 24), (NULL, 0)],
                                    symbol + struct.pack("<II", 1, links) + b"m" * (4 << 20) + b"\0"))
seed("elf", "chain_of_symbols_large",
     elf([(STRTAB, elf_at(n) + 8), (SYMTAB, elf_at(n) + 8), (HASH, elf_at(n)), (NULL, 0)],
         struct.pack("<II", 1, links) + (struct.pack("<IBBHQQ", 0x6D6D6D, 2, 0, 1, 0, 0)) * links + b"m" * (6 << 20) + b"\0"))
# A GNU hash table whose chain has a million links that all have the name's hash.
h = 5381
for c in b"mirocup_entry":
    h = (h * 33 + c) & 0xFFFFFFFF
chain = struct.pack("<I", h & ~1)
seed("elf", "gnu_chain", elf([(STRTAB, elf_at(n)), (SYMTAB, elf_at(n)), (GNU_HASH, elf_at(n)), (NULL, 0)],
                             struct.pack("<IIIII", 1, 0, 0, 0, 0) + chain * links))
# Tables that lie over each other and over the header, and addresses that wrap around.
seed("elf", "overlapping", elf([(STRTAB, 0), (SYMTAB, 0), (GNU_HASH, 0), (HASH, 0), (NEEDED, 1), (RPATH, 2), (NULL, 0)], b""))
seed("elf", "wraps", elf([(STRTAB, 2**64 - 8), (SYMTAB, 2**64 - 24), (GNU_HASH, 2**64 - 16), (NEEDED, 2**64 - 1), (NULL, 0)], b""))
library = os.path.join(build, "house", "idle.so")
if os.path.exists(library):
    with open(library, "rb") as whole:
        seed("elf", "idle", b"\0" + whole.read())

# --- Texts that no reader of JSON may follow.
bad_json = {
    "deep_lists": nested(200000),
    "deep_objects": '{"a":' * 100000 + "1" + "}" * 100000,
    "deep_unclosed": "[" * 200000,
    "deep_in_a_key": '{"schema":' + nested(200000) + ',"duration":1}',
    "long_number": "[" + "9" * 1000000 + "]",
    "long_fraction": "[0." + "3" * 1000000 + "]",
    "huge_exponent": "[1e999999999]",
    "beyond_2_53": '{"seed":9007199254740993,"schema":"mirocup/league/1"}',
    "twice": '{"schema":"mirocup/scene/1","schema":"mirocup/match/1"}',
    "lone_surrogate": '{"schema":"\\ud800"}',
    "nul_in_key": '{"a\\u0000b":1}',
    "nul_in_text": '{"schema":"mirocup/scene/1\\u0000"}',
    "not_utf8": b'{"schema":"\xff\xfe"}',
    "long_text": '{"schema":"' + "x" * 2000000 + '"}',
    "many_keys": "{" + ",".join('"%d":0' % i for i in range(100000)) + "}",
    "many_values": "[" + "0," * 3000000 + "0]",
    "many_lists": "[" + "[]," * 2000000 + "[]]",
    "control": '{"\\u001b[31m":1}',
    "empty": "",
    "zeros": b"\0" * 1000,
}
for reader in ("league", "record", "scene", "trace"):
    for what, text in bad_json.items():
        seed(reader, what, text)
for what, text in bad_json.items():
    data = text if isinstance(text, bytes) else text.encode()
    seed("journal", what, b"\0" + data + b"\n")
    seed("journal", what + "_sealed", b'\1"kind":' + (data or b"null") + b"\n")

# --- Journal: the lines between number and hashes.
lines = [
    '"kind":"start","config_sha256":"%s","version":"0.1.0","build":"g++","game":"%s","conditions":{"preset":"exact"}' % ("0" * 64, "0" * 16),
    '"kind":"leg","fixture":"r1-f1","leg":1,"attempt":1,"home":"a","away":"c","blue":"a","score":{"home":2,"away":1},'
    '"winner":"a","end":"full_time","fault":null,"penalties":{"home":0,"away":0},"record":"records/r1-f1-1-1.json",'
    '"state_hash":"5f4dafcc058c55c0"',
    '"kind":"void","fixture":"r1-f1","leg":2,"attempt":1,"cause":"host","why":"w"',
    '"kind":"ruling","fixture":"r1-f2","leg":1,"score":{"home":0,"away":10},"why":"w","by":"h"',
    '"kind":"pause","team":"b","why":"w"',
    '"kind":"resume","team":"b","why":"w"',
    '"kind":"withdraw","team":"d","results":"annul","why":"w"',
    '"kind":"entry","team":"a","entry":2,"sha256":"%s"' % ("1" * 64),
]
for i in range(1, len(lines) + 1):
    seed("journal", "lines_%d" % i, b"\1" + "\n".join(lines[:i]).encode() + b"\n")
seed("journal", "torn", b"\1" + "\n".join(lines).encode())
seed("journal", "score_overflows", b"\1" + "\n".join([lines[0]] + [
    '"kind":"ruling","fixture":"r1-f%d","leg":%d,"score":{"home":2147483647,"away":0},"why":"w"' % (f, leg)
    for f in (1, 2) for leg in (1, 2)]).encode() + b"\n")
seed("journal", "many_lines", b"\1" + (lines[4] + "\n" + lines[5] + "\n").encode() * 2000)

# --- League files.
league = {"schema": "mirocup/league/1", "title": "t", "format": {"kind": "swiss", "rounds": 3}, "league": "small",
          "rules": {"preset": "mirosot", "half_s": 30}, "seed": 7, "points": {"win": 3, "draw": 1, "loss": 0},
          "tie_breaks": ["goals", "wins"], "freeze": "2026-11-30T18:00:00Z", "strikes": 3, "site": "/srv/pages",
          "teams": [{"name": "a", "entry": "house:idle"}, {"name": "b", "entry": "b.so", "dds": True}]}
seed("league", "whole", json.dumps(league))
seed("league", "points_overflow", json.dumps(dict(league, points={"win": 2147483647})))
seed("league", "rules_huge", json.dumps(dict(league, rules={"preset": "vsss", "half_s": 1e308, "mercy_goal_diff": 2**31 - 1})))

# --- Traces.
seed("trace", "whole", json.dumps(
    {"id": "x", "state": "PLAY", "lerp": True, "frames": [
        {"t": 0, "ball": [0, 0], "L": [[-0.5, 0, 0]], "R": [[0.5, 0, 3.1]], "contacts": [["L0", "R0"], ["L0", "ball"]],
         "drive": {"L0": 1}, "last_touch": "L0", "fallen": ["R1"]}, {"t": 2, "ball": [0.8, 0]}],
     "hold": 3, "clock_stops": [[0.1, 0.2]], "events": [{"t": 0.5, "call": "L"}]}))
seed("trace", "place", json.dumps({"state": "PLACE", "restart": "FREE_BALL", "quarter": "+-", "place": {
    "ball": [0.4, -0.4], "L": [[0, 0, 0]], "R": [[0.1, 0.1, 1]]}}))
seed("trace", "long", json.dumps({"frames": [{"t": 0, "ball": [0, 0]}], "hold": 1e6}))
seed("trace", "longest", json.dumps({"frames": [{"t": 0, "ball": [0.3, 0]}], "hold": 3600}))
seed("trace", "many_frames", json.dumps({"lerp": True, "hold": 3600, "frames": [
    {"t": 0.36 * i, "ball": [0.1, 0], "L": [[-0.4, 0, 0]]} for i in range(9990)]}))
seed("trace", "many_contacts", json.dumps({"hold": 3600, "frames": [{"t": 0, "contacts": [["L0", "R0"]] * 100000}]}))

# --- Scenes.
scene = {"schema": "mirocup/scene/1", "duration": 0.2, "ball": {"position": [0, 0], "velocity": [1, 0]},
         "robots": [{"pose": [-0.3, 0, 0], "wheels": [[0, 40, 40], [0.1, 20, 40]]}], "sample_at": [0.1]}
seed("scene", "whole", json.dumps(scene))
for grip in (0, 1e-9, 1e-6, 1e-5):
    seed("scene", "grip_%g" % grip, json.dumps(dict(scene, parameters={"grip": grip})))
for duration in (1e9, 1e308):
    seed("scene", "duration_%g" % duration, json.dumps(dict(scene, duration=duration)))
seed("scene", "many_rows", json.dumps(dict(scene, robots=[
    {"pose": [-0.3, 0, 0], "wheels": [[1e-7 * i, 40, 40] for i in range(200000)]}])))
seed("scene", "fast", json.dumps(dict(scene, ball={"position": [0, 0], "velocity": [5, 1]},
                                      parameters={"rolling_resistance": 0, "viscous_friction": 0,
                                                  "restitution": {"ball_wall": 1}})))
seed("scene", "polygon", json.dumps(dict(scene, parameters={
    "shape": [[0.04, 0], [0, 0.04], [-0.04, 0], [0, -0.04]], "contact_friction": {"robot_robot": 0.3}})))

# --- Replays: robots and ticks, then the file or what is in it.
head = struct.pack("<IIII", 1, 3, 1, 1)
one_tick = head + b"\0" * (24 + 8 + 7 + 46 * 8)
seed("replay", "one_tick", b"\4\x02" + one_tick)
seed("replay", "one_tick_of_head", b"\14\x02" + one_tick)
seed("replay", "many_ticks_claimed", b"\4\xff" + struct.pack("<IIII", 16711935, 3, 16711935, 0))
seed("replay", "grows", b"\4\xff" + b"\0" * (2 << 20))
seed("replay", "empty_frame", b"\0\0mirocup/replay/2\n\x28\xb5\x2f\xfd\x20\x00\x01\x00\x00")
seed("replay", "two_frames", b"\0\0mirocup/replay/2\n" + b"\x28\xb5\x2f\xfd\x20\x10\x81\x00\x00" + b"a" * 16 + b"\x28\xb5\x2f\xfd\x20\x00\x01\x00\x00")
seed("replay", "skippable", b"\0\0mirocup/replay/2\n" + struct.pack("<II", 0x184D2A50, 4) + b"abcd")
seed("replay", "claims_16_EB", b"\0\0mirocup/replay/2\n\x28\xb5\x2f\xfd\xe0" + b"\xff" * 8)

# --- Names of functions: a library of sections only, with one table of symbols and its texts.
def library_of(symbols, texts, shnum=3):
    header = struct.pack("<16sHHIQQQIHHHHHH", b"\x7fELF\2\1\1", 3, 62, 1, 0, 0, 64, 0, 64, 56, 0, 64, shnum, 0)
    tables = 64 + 3 * 64
    sections = struct.pack("<IIQQQQIIQQ", *[0] * 10)
    sections += struct.pack("<IIQQQQIIQQ", 0, 2, 0, 0, tables, len(symbols), 2, 0, 8, 24)
    sections += struct.pack("<IIQQQQIIQQ", 0, 3, 0, 0, tables + len(symbols), len(texts), 0, 0, 1, 0)
    return header + sections + symbols + texts


function = struct.pack("<IBBHQQ", 1, 2, 0, 1, 0x1000, 0x1000)
seed("names", "one", library_of(function, b"\0_ZN4Mine6decideEv\0"))
seed("names", "within", library_of(function, b"\0_ZZN12_GLOBAL__N_14Mine6decideEvENKUlvE_clEv\0"))
seed("names", "long_name", library_of(function, b"\0_ZN" + b"9999" * 5000))
seed("names", "many_symbols", library_of(function.replace(b"\x10", b"\x7f") * (1 << 20), b"\0f\0"))
seed("names", "sections_beyond_the_end", library_of(function, b"\0f\0", 65535))
if os.path.exists(library):
    with open(library, "rb") as whole:
        seed("names", "idle", whole.read())

# --- Archives of projects.
sources = [("team/main.cpp", b"int main() {}\n"), ("team/src/a.hpp", b"#pragma once\n"), ("team/.git/x", b"x")]


def tar_of(mode, members=(), files=sources):
    with io.BytesIO() as out:
        with tarfile.open(fileobj=out, mode=mode) as tar:
            for path, data in files:
                about = tarfile.TarInfo(path)
                about.size = len(data)
                tar.addfile(about, io.BytesIO(data))
            for about in members:
                tar.addfile(about)
        return out.getvalue()


def zip_of(files, mode=zipfile.ZIP_DEFLATED):
    with io.BytesIO() as out:
        with zipfile.ZipFile(out, "w", mode) as packed:
            for path, data in files:
                packed.writestr(zipfile.ZipInfo(path), data, mode)
        return out.getvalue()


def member(path, kind, target=""):
    about = tarfile.TarInfo(path)
    about.type, about.linkname = kind, target
    return about


seed("archive", "tar", tar_of("w"))
seed("archive", "gzip", tar_of("w:gz"))
seed("archive", "zip", zip_of(sources))
seed("archive", "grows", tar_of("w:gz", files=[("a.c", b"\0" * (9 << 20))]))
seed("archive", "links", tar_of("w", [member("l", tarfile.SYMTYPE, "/etc"), member("h", tarfile.LNKTYPE, "team/main.cpp")]))
seed("archive", "devices", tar_of("w", [member("p", tarfile.FIFOTYPE), member("d", tarfile.CHRTYPE)]))
for what, path in {"up": "../../x.c", "root": "/tmp/x.c", "empty": "", "deep": "d/" * 40 + "x.c", "control": "a\x1b[1m.c",
                   "file_and_folder": "team/main.cpp/x.c"}.items():
    seed("archive", "path_" + what, tar_of("w", files=sources + [(path, b"x")]))
    seed("archive", "zip_path_" + what, zip_of(sources + [(path, b"x")]))

# --- Arrays of a policy.
def npy(kind, shape, data):
    text = "{'descr': '%s', 'fortran_order': False, 'shape': %s, }" % (kind, shape)
    return b"\x93NUMPY\1\0" + struct.pack("<H", len(text)) + text.encode() + data


def npy_text(text):
    return npy("<U%d" % len(text), "()", text.encode("utf-32-le"))


arrays = [("schema.npy", npy_text("mirocup/policy/1")), ("spec.npy", npy_text('{"sight": "standard"}')),
          ("activation.npy", npy_text("tanh")), ("w0.npy", npy("<f4", "(2, 3)", b"\0" * 24)),
          ("b0.npy", npy("<f4", "(2,)", b"\0" * 8))]
for what, mode in {"stored": zipfile.ZIP_STORED, "deflated": zipfile.ZIP_DEFLATED}.items():
    seed("npz", what, zip_of(arrays, mode))
seed("npz", "grows", zip_of([("w%d.npy" % i, npy("<f4", "(%d,)" % (4 << 20), b"\0" * (16 << 20))) for i in range(8)]))
seed("npz", "shape_overflows", zip_of([("w0.npy", npy("<f4", "(67108864, 67108864, 67108864, 67108864)", b""))]))
seed("npz", "shape_is_2_to_64", zip_of([("w0.npy", npy("<f4", "(4194304, 2097152, 2097152)", b""))]))
seed("npz", "no_numbers", zip_of([("w0.npy", npy("<f4", "(0,)", b""))]))
seed("npz", "many", zip_of([("%d.npy" % i, npy("<f4", "(1,)", b"\0" * 4)) for i in range(300)]))

# --- Recordings of cameras.
seed("recording", "lines", '{"schema": "mirocup/recording/1", "robots": 2, "period": 0.033, "pitch": "mirosot"}\n'
     '{"t": 0, "ball": [0.1, -0.2], "blue": [[0, 0, 1.5], null], "commands": {"blue": [[1, 2], [3, 4]]}}\n'
     '{"t": 0.033, "ball": null, "blue": [[0, 0, 1.5], [1, 1, 0]], "yellow": [null, [0.2, 0.2, 0]]}\n')
seed("recording", "table", "ball_y,t,ball_x,blue0_x,blue0_y,blue0_heading,blue0_right,blue0_left\n"
     "0.2,0.0,0.1,1,2,3,5,4\n,0.1,,1,2,3,,\n")
seed("recording", "many_columns", "t," + ",".join("blue%d_x" % i for i in range(5000)) + "\n0\n1\n")
seed("recording", "many_rows", "t,ball_x,ball_y\n" + "".join("%d,0,0\n" % i for i in range(30000)))
seed("recording", "empty_rows", "t,ball_x,ball_y\n" + "\n" * 400000)

# --- Thoughts: frames of zstd with one plain block, with and without their size.
def frame(text, is_known=True):
    head = b"\xa0" + struct.pack("<I", len(text)) if is_known else b"\x00\x58"
    return b"\x28\xb5\x2f\xfd" + head + struct.pack("<I", len(text) << 3 | 1)[:3] + text


seed("thoughts", "plain", frame(b'{"tick": 1, "shapes": []}\n'))
seed("thoughts", "in_parts", frame(b'{"tick": 1, "shapes": []}\n', False))
seed("thoughts", "two_frames", frame(b"a\n") * 2)
seed("thoughts", "claims_4_GB", b"\x28\xb5\x2f\xfd\xa0\xff\xff\xff\xff")
# Blocks of one repeated byte: 128 KiB of text from 4 bytes.
seed("thoughts", "grows", b"\x28\xb5\x2f\xfd\x00\x58" + (struct.pack("<I", (1 << 17) << 3 | 2)[:3] + b"x") * 4000 + struct.pack("<I", 8 | 1 << 0)[:3] + b"x")

# --- Drills, situations and pitches.
drills = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "plugins", "drills")
for drill in sorted(name for name in os.listdir(drills) if name.endswith(".json")):
    with open(os.path.join(drills, drill), "rb") as whole:
        text = whole.read()
    seed("drill", drill, text)
    if b'"from"' not in text:
        seed("situation", drill, json.dumps(json.loads(text)["situation"]))
ranges = {"from": 0, "to": 1}
for _ in range(60):
    ranges = {"from": ranges, "to": 1}
seed("drill", "range_of_ranges", json.dumps({"schema": "mirocup/drill/1", "title": "t", "teaches": "t", "seconds": 5,
                                             "situation": {"ball": {"position": [ranges, 0]}}, "success": []}))
for preset in ("mirosot", "vsss", "simurosot"):
    seed("pitch", preset, json.dumps(preset))
    seed("pitch", preset + "_object", json.dumps({"preset": preset, "name": "ours"}))
seed("pitch", "whole", json.dumps({
    "preset": "vsss", "name": "ours", "parameters": {
        "wheel_radius": {"value": 0.021, "low": 0.02, "high": 0.022},
        "restitution": {"ball_wall": {"value": 0.5, "low": 0.4, "high": 0.6}}},
    "motor": {"kind": "two_lags", "turn_time_constant": 0.03}, "outline": [[0.03, -0.03], [0.03, 0.03], [-0.03, 0.0]]}))
for reader in ("drill", "situation", "pitch", "recording"):
    for what, text in bad_json.items():
        seed(reader, what, text)

# --- HTTP.
get = "GET %s HTTP/1.1\r\nHost: x\r\n\r\n"
for what, path in {"root": "/", "table": "/table.json", "events": "/events", "live": "/live/r1-f1-1/", "up": "/../../etc/passwd",
                   "coded": "/%2e%2e%2f%00", "long": "/" + "a" * 8000, "longer": "/" + "a" * 60000}.items():
    seed("http", what, get % path)
seed("http", "post", "POST / HTTP/1.1\r\nContent-Length: 4\r\n\r\nabcd")
seed("http", "post_huge", "POST / HTTP/1.1\r\nContent-Length: 18446744073709551615\r\n\r\nabcd")
seed("http", "chunked", "POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nffffffffffffffff\r\nabcd\r\n0\r\n\r\n")
seed("http", "multipart", "POST / HTTP/1.1\r\nContent-Type: multipart/form-data; boundary=b\r\nContent-Length: 40\r\n\r\n--b\r\n"
                          "Content-Disposition: form-data; name=\"a\"\r\n\r\nx\r\n--b--\r\n")
seed("http", "ranges", "GET / HTTP/1.1\r\nRange: bytes=" + "0-0," * 1000 + "0-0\r\n\r\n")
seed("http", "many_headers", "GET / HTTP/1.1\r\n" + "".join("X%d: y\r\n" % i for i in range(5000)) + "\r\n")
seed("http", "expect", "PUT / HTTP/1.1\r\nExpect: 100-continue\r\nContent-Length: 3\r\n\r\nabc")
# The desk of a league: alpha is named as a trusted proxy names a team.
alpha = " HTTP/1.1\r\nHost: a\r\nOrigin: http://a\r\nX-Team: alpha\r\n"
for what, path in [("page", "/hand-in"), ("entry_page", "/hand-in/entries/1"), ("replay", "/hand-in/friendlies/alpha/1/replay"),
                   ("team", "/api/v1/team"), ("entries", "/api/v1/entries"), ("entry", "/api/v1/entries/1"),
                   ("other_team", "/api/v1/entries/1?team=beta"), ("events", "/api/v1/entries/1/events"), ("legs", "/api/v1/legs"),
                   ("log", "/api/v1/legs/r1-f1-1-1/log"), ("friendlies", "/api/v1/friendlies"), ("up", "/api/v1/friendlies/../1/log")]:
    seed("http", "desk_" + what, "GET " + path + alpha + "\r\n")
for what, request in [("put", "PUT /api/v1/entries?name=team.so"), ("pin", "PUT /api/v1/pin?entry=1"), ("unpin", "PUT /api/v1/pin?entry=latest"),
                      ("friendly", "POST /api/v1/friendlies?opponent=house%3Astriker"), ("log_out", "POST /hand-in/log-out"),
                      ("log_in", "POST /hand-in/log-in")]:
    seed("http", "desk_" + what, request + alpha + "Content-Length: 9\r\n\r\ntoken=%41")
    seed("http", "desk_short_" + what, request + alpha + "Content-Length: 900\r\n\r\ntoken=%41")
seed("http", "desk_token", "GET /api/v1/team HTTP/1.1\r\nAuthorization: Bearer AAAAAAAAAAAAAAAAAAAAAAAAAA\r\n\r\n")
seed("http", "desk_cookie", "GET /api/v1/team HTTP/1.1\r\nCookie: mirocup_session=A; mirocup_session=B\r\n\r\n")
seed("http", "desk_chunked", "PUT /api/v1/entries" + alpha + "Transfer-Encoding: chunked\r\n\r\n3\r\nELF\r\n0\r\n\r\n")
seed("http", "gzip", b"POST / HTTP/1.1\r\nContent-Encoding: gzip\r\nContent-Length: 20\r\n\r\n\x1f\x8b\x08\0\0\0\0\0\0\3" + b"\xff" * 10)

# --- FIRASim: a command to each robot, a replacement, a placement; fields of the wrong kind, lengths beyond the end.
def field(number, kind, data):
    return bytes([number << 3 | kind]) + (bytes([len(data)]) if kind == 2 else b"") + data


def real(number, value):
    return field(number, 1, struct.pack("<d", value))


command = field(1, 0, b"\1") + field(2, 0, b"\1") + real(6, 10.0) + real(7, -10.0)
robot = field(1, 0, b"\2") + real(2, -0.5) + real(3, 0.1) + real(4, 90.0)
seed("firasim", "commands", field(1, 2, field(1, 2, command) * 3) + field(15, 0, b"\x20"))
seed("firasim", "replacement", field(2, 2, field(1, 2, real(1, 0.1) + real(3, 1.0)) + field(2, 2, field(1, 2, robot))))
seed("firasim", "placement", field(1, 2, field(1, 0, b"\1") + field(2, 2, robot) * 3))
seed("firasim", "not_finite", field(1, 2, field(1, 2, real(6, float("nan")) + real(7, float("inf")))))
seed("firasim", "many", field(1, 2, b"\x0a\0" * 60) * 3)
seed("firasim", "long_number", b"\x78" + b"\xff" * 12)
seed("firasim", "cut", field(1, 2, field(1, 2, command))[:-3])

# --- What libFuzzer found.
finds = os.path.join(os.path.dirname(os.path.abspath(__file__)), "finds")
for reader in os.listdir(finds):
    for found in os.listdir(os.path.join(finds, reader)):
        with open(os.path.join(finds, reader, found), "rb") as data:
            seed(reader, found, data.read())

# --- A record as mirocup writes it, and its replay.
program = os.path.join(build, "mirocup")
if os.path.exists(program):
    with tempfile.TemporaryDirectory() as temporary:
        path = os.path.join(temporary, "leg.json")
        subprocess.run([program, "match", "--blue", "idle", "--yellow", "idle", "--half", "1", "--record", path],
                       check=True, stdout=subprocess.DEVNULL)
        with open(path, "rb") as record:
            seed("record", "leg", record.read())
        with open(os.path.join(temporary, "leg.replay.zst"), "rb") as replay:
            seed("replay", "leg", b"\0\x5a" + replay.read())
