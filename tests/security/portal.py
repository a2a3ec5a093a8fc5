#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What strangers and teams that cheat send to a portal, each with the answer that is right.

Usage: tests/security/portal.py BUILD [--all] [--each]

Catches a route that is open to the wrong visitor, a request that is read in two ways, a bound that does not hold, and a secret in
an answer. Without --all it leaves out attacks that wait for limits of time. --each prints every attack, not only those with
another answer. At the end of a kind the server has to be well: it shows its page, holds no more files, and its league is whole.
A status of 0 is a connection that was closed without an answer. Exit code 1 if any of that was otherwise.
"""
import argparse
import concurrent.futures
import hashlib
import http.client
import itertools
import json
import os
import re
import resource
import select
import shutil
import socket
import ssl
import struct
import subprocess
import sys
import tempfile
import time
import urllib.parse

options = argparse.ArgumentParser()
options.add_argument("build")
options.add_argument("--all", action="store_true")
options.add_argument("--each", action="store_true")
options = options.parse_args()
mirocup = os.path.abspath(os.path.join(options.build, "mirocup"))
folder = tempfile.mkdtemp(prefix="mirocup-portal-")
resource.setrlimit(resource.RLIMIT_NOFILE, (4096, resource.getrlimit(resource.RLIMIT_NOFILE)[1]))
patience = 30  # s, longer than any limit of the server for a request that stands still
teams = ["alpha", "beta", "chunks", "bodies", "early", "pins", "flood", "old", "gone"] + [f"names{i}" for i in range(5)]
numbers = itertools.count()  # a generator must not be asked by two threads at once; this may


class Server:
    """A league of two teams, and more that have only tokens; what it takes, it checks."""

    def __init__(self, name, *words):
        self.league = os.path.join(folder, name)
        run("league", "init", self.league, "--team", "alpha=house:chaser", "--team", "beta=house:keeper", "--half", "5")
        self.tokens = {team: run("league", "token", self.league, team).strip() for team in teams}
        self.tokens["staff"] = run("league", "token", self.league, "--staff").strip()
        self.tokens["tutor"] = run("league", "token", self.league, "--tutor").strip()
        run("league", "token", self.league, "gone", "--revoke")
        path = os.path.join(self.league, "tokens.json")
        with open(path) as file:
            known = json.load(file)
        for token in known["tokens"]:
            if token["team"] == "old":
                token["expires"] = "2020-01-01T00:00:00Z"
        with open(path, "w") as file:
            json.dump(known, file)
        self.secrets = [token.encode() for token in self.tokens.values()] + [token["sha256"].encode() for token in known["tokens"]]
        self.secrets += [folder.encode(), b"root:x:"]
        self.errors = open(os.path.join(folder, name + ".err"), "w+")
        self.process = subprocess.Popen([mirocup, "league", "serve", self.league, "--hand-in", "--jobs", "1", *words],
                                        stdout=subprocess.PIPE, stderr=self.errors, text=True)
        url = self.process.stdout.readline().strip()
        if not url:
            self.errors.seek(0)
            sys.exit(self.errors.read())
        self.path = url[len("unix:"):] if url.startswith("unix:") else None
        self.port = None if self.path else int(url.rstrip("/").rsplit(":", 1)[1])
        self.is_encrypted = url.startswith("https")
        self.files = self.open_files()

    def connect(self, source=None):
        number = next(numbers)
        end = socket.socket(socket.AF_UNIX if self.path else socket.AF_INET)
        end.settimeout(patience)
        if not self.path:
            end.bind((source or f"127.9.{number // 250}.{number % 250 + 1}", 0))
        end.connect(self.path or ("127.0.0.1", self.port))
        return end

    def open_files(self):
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))

    def peak_memory(self):
        with open(f"/proc/{self.process.pid}/status") as file:
            return next(int(line.split()[1]) // 1024 for line in file if line.startswith("VmHWM"))

    def objection(self):
        """Says why the server is not well, or nothing."""
        if self.process.poll() is not None:
            return f"the server ended: {self.process.returncode}"
        if talk(self, request("GET", "/")).status != 200:
            return "the page is not shown"
        until = time.monotonic() + patience
        while self.open_files() > self.files + 3 and time.monotonic() < until:
            time.sleep(0.02)  # books that are being written, checks that run
        if self.open_files() > self.files + 3:
            return f"{self.open_files()} open files instead of {self.files}"
        return None if self.status() else "the league cannot be read"

    def status(self):
        """Returns what a host is told of the entries; the exit code 1 says that some were refused."""
        told = subprocess.run([mirocup, "league", "status", self.league, "--entries"], capture_output=True)
        return told.stdout if told.returncode in (0, 1) else b""

    def end(self):
        self.process.terminate()
        code = self.process.wait(60)
        self.errors.seek(0)
        said = [line for line in self.errors.read().split("\n")[:-1] if not re.fullmatch(r"mirocup: \w+: entry \d+ was not accepted: [ -~]+", line)]
        return f"exit code {code}: {said}" if code != 0 or said else None


def run(*words):
    return subprocess.run([mirocup, *words], check=True, capture_output=True, text=True).stdout


class Answer:
    def __init__(self, received, seconds, is_closed=True):
        self.all = received
        self.status = int(received[9:12]) if re.match(rb"HTTP/1\.1 \d\d\d ", received) else 0 if is_closed else -1
        self.head, _, self.body = received.partition(b"\r\n\r\n")
        self.seconds = seconds

    def header(self, name):
        for line in self.head.decode("latin-1").split("\r\n")[1:]:
            if line.lower().startswith(name.lower() + ":"):
                return line.split(":", 1)[1].strip()
        return None


def request(method, target, *headers, body=None, host="x", version="HTTP/1.1"):
    lines = [f"{method} {target} {version}"] + ([f"Host: {host}"] if host else []) + list(headers)
    if body is not None:
        lines.append(f"Content-Length: {len(body)}")
    return "\r\n".join(lines).encode("latin-1") + b"\r\n\r\n" + (body or b"")


def receive(end, since, stop=None):
    received = b""
    is_closed = True
    try:
        while stop is None or stop not in received:
            part = end.recv(65536)
            if not part:
                break
            received += part
    except (socket.timeout, TimeoutError):
        is_closed = False
    except OSError:
        pass
    return Answer(received, time.monotonic() - since, is_closed)


def talk(server, sent, source=None, end_of_sending=False, stop=None):
    """Sends bytes, or several parts after pauses in s, and returns the answer."""
    since = time.monotonic()
    with server.connect(source) as plain:
        end = encrypted(plain) if server.is_encrypted else plain
        try:
            for part in [sent] if isinstance(sent, bytes) else sent:
                if isinstance(part, (int, float)):
                    time.sleep(part)
                else:
                    end.sendall(part)
            if end_of_sending:
                end.shutdown(socket.SHUT_WR)
        except OSError:
            pass  # it has its answer already
        return receive(end, since, stop)


def bearer(token):
    return f"Authorization: Bearer {token}"


def form(**values):
    return urllib.parse.urlencode(values, encoding="latin-1").encode()


typed = "Content-Type: application/x-www-form-urlencoded"


def cookie_of(server, who):
    answer = talk(server, request("POST", "/hand-in/log-in", "Origin: http://x", typed, body=form(token=server.tokens[who])))
    return "Cookie: " + answer.header("Set-Cookie").split(";")[0]


class Kind:
    """Attacks of one kind. The table counts them."""

    def __init__(self, name, server):
        self.name, self.server = name, server
        self.count, self.slowest, self.answers, self.others = 0, 0.0, {}, []

    def note(self, attack, expected, got, seconds=0.0, received=b"", told=None):
        self.count += 1
        self.slowest = max(self.slowest, seconds)
        self.answers[got] = self.answers.get(got, 0) + 1
        is_right = got in expected if isinstance(expected, (set, range)) else got == expected
        if not is_right:
            self.others.append(f"{attack}: {got} instead of {expected}: {received[:300]!r}")
        for secret in self.server.secrets:
            if secret in received:
                self.others.append(f"{attack}: the answer tells {secret[:12]!r}…")
        if options.each:
            print(f"  {self.name}: {attack}: {got}{' ' + told if told else ''}, {seconds:.2f} s")

    def ask(self, attack, expected, sent, **how):
        answer = talk(self.server, sent, **how)
        self.note(attack, expected, answer.status, answer.seconds, answer.all)
        return answer

    def holds(self, attack, is_so, received=b""):
        self.note(attack, "holds", "holds" if is_so else "does not hold", received=received)


def tokens(kind):
    server, t = kind.server, kind.server.tokens
    of_alpha = bearer(t["alpha"])
    sha256 = hashlib.sha256(t["alpha"].encode()).hexdigest()
    place = hashlib.sha256(os.path.realpath(server.league).encode()).hexdigest()[:8]  # in the cookie's name
    for attack, expected, words in [
            ("none", 401, ()),
            ("wrong", 401, (bearer("A" * 26),)),
            ("Basic", 401, (f"Authorization: Basic {t['alpha']}",)),
            ("two headers", 401, (of_alpha, of_alpha)),
            ("two tokens in one", 401, (bearer(f"{t['beta']}, {t['alpha']}"),)),
            ("its hash", 401, (bearer(sha256),)),
            ("with more behind", 401, (bearer(t["alpha"] + "A"),)),
            ("with NUL", 400, (bearer(t["alpha"] + "\0"),)),
            ("64 kB", 401, (bearer("A" * 60000),)),
            ("revoked", 401, (bearer(t["gone"]),)),
            ("expired", 401, (bearer(t["old"]),)),
            ("in the query", 401, ()),
            ("as a cookie", 401, (f"Cookie: mirocup_{place}={t['alpha']}",)),
            ("as a person types it", 200, (bearer(" " + t["alpha"].lower()),))]:
        target = "/api/v1/entries" + (f"?token={t['alpha']}" if attack == "in the query" else "")
        kind.ask(attack, expected, request("GET", target, *words))
    for attack, expected, method, target, who in [
            ("entries of beta", 403, "GET", "/api/v1/entries?team=beta", "alpha"),
            ("legs of beta", 403, "GET", "/api/v1/legs?team=beta", "alpha"),
            ("a log of beta", 403, "GET", "/api/v1/legs/r1-f1-1-1/log?team=beta", "alpha"),
            ("team of the token", 403, "GET", "/api/v1/team?team=beta", "alpha"),
            ("a friendly of beta", 404, "GET", "/api/v1/friendlies/beta/1/log", "alpha"),
            ("a replay of beta", 404, "GET", "/hand-in/replays/r1-f1-1-1.html?team=beta", "alpha"),
            ("grades by a team", 403, "GET", "/hand-in/grades.csv", "alpha"),
            ("an act by a team", 403, "POST", "/hand-in/staff", "alpha"),
            ("an act by a tutor", 403, "POST", "/hand-in/staff", "tutor"),
            ("a file by the staff", 403, "PUT", "/api/v1/entries?team=alpha", "staff"),
            ("a pin by the staff", 403, "PUT", "/api/v1/pin?entry=1&team=alpha", "staff"),
            ("a friendly by the staff", 403, "POST", "/api/v1/friendlies?opponent=beta", "staff"),
            ("a file by nobody", 401, "PUT", "/api/v1/entries", None),
            ("a pin by nobody", 401, "PUT", "/api/v1/pin?entry=1", None),
            ("an act by nobody", 401, "POST", "/hand-in/staff", None),
            ("grades by nobody", 401, "GET", "/hand-in/grades.csv", None),
            ("a name that is unknown, by nobody", 401, "GET", "/api/v1/anything", None)]:
        body = b"ELF" if method != "GET" else None
        kind.ask(attack, expected, request(method, target, *([bearer(t[who])] if who else []), body=body))


def cookies(kind):
    server = kind.server
    own = cookie_of(server, "alpha")
    acts = [("PUT", "/api/v1/pin?entry=1"), ("POST", "/api/v1/friendlies?opponent=house:striker"), ("POST", "/hand-in/log-out")]
    for origin in [None, "null", "", "http://evil.example", "http://x.evil.example", "http://xx", "http://x:81", "https://x.",
                   "http://x@evil.example", "http://x/", "x", "file://x", "HTTP://EVIL"]:
        method, target = acts[kind.count % 3]
        headers = [own] + ([f"Origin: {origin}"] if origin is not None else [])
        kind.ask(f"{target} of {origin}", 403, request(method, target, *headers, body=b""))
    kind.ask("two origins", 403, request("PUT", acts[0][1], own, "Origin: http://x", "Origin: http://x", body=b""))
    kind.ask("a referrer", 403, request("PUT", acts[0][1], own, "Referer: http://x/hand-in", body=b""))
    kind.ask("log-in from another site", 403, request("POST", "/hand-in/log-in", "Origin: http://evil", typed,
                                                      body=form(token=server.tokens["beta"])))
    kind.ask("a token, from another site", 403, request("PUT", acts[0][1], bearer(server.tokens["alpha"]), "Origin: http://evil",
                                                        body=b""))
    entries = ("GET", "/api/v1/entries")
    kind.ask("two cookies of the name", 401, request(*entries, own + own.replace("Cookie:", ";").split("=")[0] + "=" + "0" * 32))
    kind.ask("a cookie of TLS without TLS", 401, request(*entries, own.replace("mirocup", "__Host-mirocup")))
    kind.ask("a longer name", 401, request(*entries, own.replace("Cookie: ", "Cookie: x")))
    kind.ask("two headers", 401, request(*entries, own, own))
    chosen = own.split("=")[0] + "=" + "c" * 32
    kind.ask("a chosen cookie, then a log-in", 303, request("POST", "/hand-in/log-in", chosen, "Origin: http://x", typed,
                                                            body=form(token=server.tokens["alpha"])))
    kind.ask("the chosen cookie", 401, request(*entries, chosen))
    kind.ask("log-out", 303, request("POST", "/hand-in/log-out", own, "Origin: http://x", body=b""))
    kind.ask("after the log-out", 401, request(*entries, own))
    for _ in range(30):
        cookie_of(server, "beta")
    with open(os.path.join(server.league, "sessions.json")) as file:
        kind.holds("30 log-ins leave 20 sessions", len(json.load(file)["sessions"]) <= 21)
    page = talk(server, request("GET", "/hand-in", cookie_of(server, "alpha")))
    kind.holds("the page may not be framed", b"frame-ancestors 'none'" in page.head and b"no-store" in page.head, page.all)


def proxies(kind, secret):
    """The server believes a proxy at 127.0.0.1 with a secret."""
    proof = f"X-Mirocup-Proxy: {secret}"
    entries = ("GET", "/api/v1/entries")
    near, far = {"source": "127.0.0.1"}, {"source": "127.0.0.2"}
    for attack, expected, headers, how in [
            ("the proxy", 200, (proof, "X-Team: alpha"), near),
            ("without the secret", 401, ("X-Team: alpha",), near),
            ("an empty secret", 401, ("X-Mirocup-Proxy:", "X-Team: alpha"), near),
            ("another secret", 401, ("X-Mirocup-Proxy: " + "0" * 32, "X-Team: alpha"), near),
            ("the secret and more", 401, (proof + "0", "X-Team: alpha"), near),
            ("two secrets", 401, (proof, proof, "X-Team: alpha"), near),
            ("the secret from another address", 401, (proof, "X-Team: alpha"), far),
            ("two teams", 401, (proof, "X-Team: alpha", "X-Team: beta"), near),
            ("two teams in one", 401, (proof, "X-Team: alpha, beta"), near),
            ("a path as a team", 401, (proof, "X-Team: ../alpha"), near),
            ("no team", 401, (proof, "X-Team:"), near),
            ("the staff as a team", {200, 401}, (proof, "X-Team: staff"), near),
            ("a tutor", 400, (proof, "X-Team: tutor:Z. Kern"), near),  # who has to name a team
            ("a tutor without the secret", 401, ("X-Team: tutor:Z. Kern",), near),
            ("a role that is none", 401, (proof, "X-Team: root:x"), near),
            ("a team as a role", 401, (proof, "X-Team: team:alpha"), near),
            ("another header", 401, (proof, "X-Teams: alpha"), near)]:
        answer = kind.ask(attack, expected, request(*entries, *headers), **how)
        if attack == "the staff as a team" and answer.status == 200:
            kind.holds("a team called staff has nothing", json.loads(answer.body)["entries"] == [])
    kind.ask("a pin from another site", 403, request("PUT", "/api/v1/pin?entry=1", proof, "X-Team: alpha", body=b""), **near)
    status = [talk(kind.server, request(*entries, bearer("B" * 26), f"X-Forwarded-For: 10.0.0.{i}"), "127.0.0.3").status
              for i in range(12)]
    kind.note("invented addresses do not save one from waiting", 429, status[-1])
    kind.ask("the right token at that address", 200, request(*entries, bearer(kind.server.tokens["beta"])), source="127.0.0.3")
    status = [talk(kind.server, request(*entries, bearer("C" * 26), proof, f"X-Forwarded-For: 10.0.0.{i}, 10.1.1.1"),
                   "127.0.0.1").status for i in range(12)]
    kind.note("what a viewer adds to the proxy's address", 429, status[-1])
    short = os.path.join(folder, "short")
    with open(short, "w") as file:
        file.write("123\n")
    for attack, words in [
            ("a team's header of everybody", ["--team-header", "X-Team"]),
            ("a proxy by its address only", ["--trust-proxy", "127.0.0.1"]),
            ("a team's header of an address", ["--trust-proxy", "127.0.0.1", "--team-header", "X-Team"]),
            ("a far proxy by its address only", ["--trust-proxy", "10.0.0.2", "--team-header", "X-Team"]),
            ("a short secret", ["--trust-proxy", "127.0.0.1", "--proxy-secret", short]),
            ("no secret", ["--trust-proxy", "127.0.0.1", "--proxy-secret", "/dev/null"])]:
        said = subprocess.run([mirocup, "league", "serve", kind.server.league, "--hand-in", *words], capture_output=True, text=True,
                              timeout=60)
        kind.note(attack, 2, said.returncode, received=said.stdout.encode())
        if said.stderr.count("\n") != 1:
            kind.others.append(f"{attack}: {said.stderr}")


def unix_socket(kind):
    entries = ("GET", "/api/v1/entries")
    kind.ask("the proxy", 200, request(*entries, "X-Team: alpha"))
    kind.ask("two teams", 401, request(*entries, "X-Team: alpha", "X-Team: beta"))
    kind.ask("nobody", 401, request(*entries))
    status = [talk(kind.server, request(*entries, bearer("D" * 26), f"X-Forwarded-For: 10.0.0.{i}, 10.1.1.2")).status
              for i in range(12)]
    kind.note("what a viewer adds to the proxy's address", 429, status[-1])
    kind.ask("another viewer", 401, request(*entries, bearer("D" * 26), "X-Forwarded-For: 10.1.1.3"))
    kind.ask("64 kB of addresses", 401, request(*entries, "X-Forwarded-For: " + "1.1.1.1, " * 6000))
    if os.geteuid() == 0:
        os.chmod(folder, 0o755)
        child = os.fork()
        if child == 0:
            os.setgroups([])
            os.setgid(64777)
            os.setuid(64777)
            try:
                kind.server.connect()
                os._exit(1)
            except PermissionError:
                os._exit(0)
        kind.holds("another user cannot connect", os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0)


def paths(kind):
    own = cookie_of(kind.server, "alpha")
    token = bearer(kind.server.tokens["alpha"])
    for target in ["/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%2f..%2fetc%2fpasswd", "/....//....//etc/passwd",
                   "//etc/passwd", "/%2fetc%2fpasswd", "/\\..\\..\\etc\\passwd", "/%5c..%5cetc", "/%00", "/index.html%00.json",
                   "/tokens.json", "/TOKENS.JSON", "/./tokens.json", "/league.json", "/teams.json", "/sessions.json",
                   "/journal.jsonl", "/hand-ins.jsonl", "/.lock", "/entries/alpha/1/strategy.so", "/entries/", "/records/",
                   "/records/../tokens.json", "/records/tokens.json", "/records/%2e%2e/tokens.json", "/replays/../../x.html",
                   "/replays/..%2f..%2ftokens.html", "/live/../x/", "/live/..%2f..%2f/", "/live/x/events", "/live/", "/live//",
                   "/league.js/", "/%", "/%zz", "/%c0%ae%c0%ae/tokens.json", "/proc/self/environ", "/~root/",
                   "/" + "a" * 8100, "/" + "../" * 2000 + "etc/passwd"]:
        kind.ask(target[:60], 404, request("GET", target))
    kind.ask("9000 letters", 414, request("GET", "/" + "a" * 9000))
    for target in ["http://x/../../etc/passwd", "http://evil.example/", "x", "etc/passwd", "?", "*"]:
        kind.ask(target, {400, 404}, request("GET", target))
    for target in ["-1", "0", "2147483648", "99999999999999999999", "1e0", "0x1", "+1", "%201", "1%00", "1%20", "١", "1.", "..",
                   "%2e%2e", "1/..", "1/events/x", "1/eventsx", "1/", "", "/1"]:
        kind.ask("entry " + target, 404, request("GET", "/api/v1/entries/" + target.encode().decode("latin-1"), token))
    for target in ["/hand-in/entries/..%2f..%2ftokens.json", "/hand-in/entries/1/../../../tokens.json", "/hand-in/entries/99",
                   "/hand-in/friendlies/../1/replay", "/hand-in/friendlies/alpha/..%2f1/replay", "/hand-in/friendlies/beta/1/replay",
                   "/hand-in/replays/..%2f..%2ftokens.json", "/hand-in/replays/../../tokens.json", "/hand-in/replays/%2fetc%2fpasswd",
                   "/hand-in/replays/"]:
        kind.ask(target, 404, request("GET", target, own))
    for target in ["/api/v1/legs/..%2f..%2ftokens.json%00/log", "/api/v1/legs/../../tokens.json/log", "/api/v1/legs//log",
                   "/api/v1/friendlies/../../tokens.json", "/api/v1/friendlies/alpha/1/../../../log", "/api/v1/entries//etc",
                   "/api/v1/", "/api/", "/api/v2/entries", "/API/v1/entries"]:
        kind.ask(target, 404, request("GET", target, token))


def headers(kind):
    token = bearer(kind.server.tokens["alpha"])
    for attack, expected, sent in [
            ("64 kB in one header", 431, request("GET", "/", "X: " + "a" * 70000)),
            ("64 kB in a thousand headers", 431, request("GET", "/", *["X: " + "a" * 70] * 1000)),
            ("a thousand ranges", 200, request("GET", "/", "Range: bytes=" + ",".join(["0-"] * 1000))),
            ("a range of less than nothing", 200, request("GET", "/", "Range: bytes=5-1,-99999999999999999999")),
            ("TRACE", 405, request("TRACE", "/")),
            ("CONNECT", {400, 405}, request("CONNECT", "evil.example:80")),
            ("a method of its own", 405, request("BREW", "/")),
            ("PATCH of an entry", 405, request("PATCH", "/api/v1/entries", token, body=b"x")),
            ("POST where PUT is meant", 405, request("POST", "/api/v1/entries", token, body=b"x")),
            ("DELETE of an entry", 405, request("DELETE", "/api/v1/entries/1", token)),
            ("PUT of a page", 405, request("PUT", "/", body=b"x")),
            ("HEAD", 200, request("HEAD", "/")),
            ("a method in the header", 200, request("GET", "/api/v1/entries", token, "X-HTTP-Method-Override: PUT")),
            ("an upgrade", 200, request("GET", "/", "Connection: Upgrade", "Upgrade: websocket", "Sec-WebSocket-Key: x")),
            ("HTTP/2 by upgrade", 200, request("GET", "/", "Connection: Upgrade, HTTP2-Settings", "Upgrade: h2c", "HTTP2-Settings: x")),
            ("HTTP/2 by its first line", {400, 505}, b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"),
            ("HTTP/0.9", 400, b"GET /\r\n\r\n"),
            ("HTTP/1.0", 200, request("GET", "/", host=None, version="HTTP/1.0")),
            ("HTTP/9.9", {400, 505}, request("GET", "/", version="HTTP/9.9")),
            ("no host", 400, request("GET", "/", host=None)),
            ("two hosts", 400, request("GET", "/", "Host: y")),
            ("a folded header", 400, request("GET", "/", "X: a\r\n b")),
            ("a space before the colon", 400, request("GET", "/", "Host : y")),
            ("no colon", 400, request("GET", "/", "X")),
            ("NUL in a value", 400, request("GET", "/", "X: a\0b")),
            ("CR in a value", 400, request("GET", "/", "X: a\rb")),
            ("lines that end by LF", 400, b"GET / HTTP/1.1\nHost: x\n\n"),
            ("a tab in the first line", 400, b"GET\t/\tHTTP/1.1\r\nHost: x\r\n\r\n"),
            ("a space in the target", 400, request("GET", "/ /")),
            ("a wish of its own", 417, request("GET", "/", "Expect: 200-ok")),
            ("letters of eight bits", 200, request("GET", "/", "X: \xff\xfe")),
            ("ESC in a target", {400, 404}, request("GET", "/\x1b[31m")),
            ("the handshake of TLS", {0, 400}, hello()),
            ("noise", {0, 400}, os.urandom(1000).replace(b"\r\n", b"xx") + b"\r\n\r\n"),
            ("empty lines first", {200, 400}, b"\r\n\r\n" + request("GET", "/"))]:
        answer = kind.ask(attack, expected, sent)
        if attack == "HEAD" and answer.body or answer.all.count(b"HTTP/1.1 ") > 1 or b"evil.example" in answer.head:
            kind.others.append(f"{attack}: {answer.all[:200]!r}")
    for attack, sent in [
            ("two requests in one", request("GET", "/") * 2),
            ("a hundred requests in one", request("GET", "/") * 100),
            ("a request in the body of a page", request("GET", "/", body=request("GET", "/table.json"))),
            ("a request that changes something behind one that reads", request("GET", "/") + request(
                "PUT", "/api/v1/entries", token, body=b"ELF piped")),
            ("a connection that shall stay", request("GET", "/", "Connection: keep-alive", "Keep-Alive: timeout=1000") * 2),
            ("noise behind a request", request("GET", "/") + os.urandom(1000)),
            ("1 MB behind a request", request("GET", "/") + b"x" * 1_000_000)]:
        answer = kind.ask(attack, 200, sent)
        if answer.all.count(b"HTTP/1.1 ") != 1 or answer.header("Connection") != "close":
            kind.others.append(f"{attack}: {answer.all.count(b'HTTP/1.1 ')} answers")
    entries = json.loads(talk(kind.server, request("GET", "/api/v1/entries", token)).body)["entries"]
    kind.holds("no piped hand-in was taken", len(entries) == 1)


def bodies(kind):
    server = kind.server
    put = ("PUT", "/api/v1/entries?name=x.so", bearer(server.tokens["bodies"]))
    chunked = "Transfer-Encoding: chunked"
    for attack, expected, sent in [
            ("an empty file", 400, request(*put, body=b"")),
            ("no length", 400, request(*put)),
            ("33 MB announced", 413, request(*put, "Content-Length: 34603008")),
            ("2^64 - 1 announced", {400, 413}, request(*put, f"Content-Length: {2**64 - 1}")),
            ("2^64 + 3 announced", 400, request(*put, f"Content-Length: {2**64 + 3}") + b"ELF"),
            ("-1 announced", 400, request(*put, "Content-Length: -1") + b"ELF"),
            ("3 and more announced", 400, request(*put, "Content-Length: 3 3") + b"ELF"),
            ("an empty length", 400, request(*put, "Content-Length:") + b"ELF"),
            ("two lengths", 400, request(*put, "Content-Length: 3", "Content-Length: 500") + b"ELF"),
            ("3, 3 announced", 400, request(*put, "Content-Length: 3, 3") + b"ELF"),
            ("length and chunks", 400, request(*put, "Content-Length: 3", chunked) + b"3\r\nELF\r\n0\r\n\r\n"),
            ("chunks twice", 400, request(*put, chunked, chunked) + b"3\r\nELF\r\n0\r\n\r\n"),
            ("chunked, chunked", 400, request(*put, "Transfer-Encoding: chunked, chunked") + b"3\r\nELF\r\n0\r\n\r\n"),
            ("gzip, chunked", 400, request(*put, "Transfer-Encoding: gzip, chunked") + b"3\r\nELF\r\n0\r\n\r\n"),
            ("chunked by a vertical tab", 400, request(*put, "Transfer-Encoding: \x0bchunked") + b"3\r\nELF\r\n0\r\n\r\n"),
            ("Transfer-Encoding :", 400, request(*put, "Transfer-Encoding : chunked") + b"3\r\nELF\r\n0\r\n\r\n"),
            ("chunks in HTTP/1.0", 400, request(*put, chunked, version="HTTP/1.0") + b"3\r\nELF\r\n0\r\n\r\n"),
            ("gzip", 415, request(*put, "Content-Encoding: gzip", body=b"\x1f\x8b\x08")),
            ("identity", 415, request(*put, "Content-Encoding: identity", body=b"ELF")),
            ("a file by a stranger", 401, request(*put[:2], body=b"x" * 3_000_000)),
            ("as a form in parts", 405, request("POST", *put[1:], "Content-Type: multipart/form-data; boundary=x",
                                                body=b"--x\r\nContent-Disposition: form-data; name=f\r\n\r\nELF\r\n--x--\r\n"))]:
        kind.ask(attack, expected, sent)
    for attack, sent in [("shorter than announced", request(*put, "Content-Length: 9") + b"short"),
                         ("nothing of what was announced", request(*put, "Content-Length: 9"))]:
        kind.ask(attack, 400, sent, end_of_sending=True)
    answer = kind.ask("33 MB in chunks", 413, request(*put, chunked) + (b"100000\r\n" + b"x" * (1 << 20) + b"\r\n") * 33)
    kind.holds("no memory for what is not taken", server.peak_memory() < 200)
    answer = kind.ask("longer than announced", 202, request(*put, "Content-Length: 3") + b"ELF and more")
    state = json.loads(talk(server, request("GET", json.loads(answer.body)["url"], put[2])).body)
    kind.holds("the announced bytes are the file", state["bytes"] == 3, answer.all)
    kind.holds("one hand-in was taken", taken(server, "bodies") == 1)


def taken(server, team):
    return len(json.loads(talk(server, request("GET", "/api/v1/entries", bearer(server.tokens[team]))).body)["entries"])


def chunks(kind):
    server = kind.server
    head = request("PUT", "/api/v1/entries?name=x.so", bearer(server.tokens["chunks"]), "Transfer-Encoding: chunked")
    for attack, body in [
            ("a negative size", b"-3\r\nELF\r\n0\r\n\r\n"),
            ("a size of other letters", b"zz\r\nELF\r\n0\r\n\r\n"),
            ("0x before a size", b"0x3\r\nELF\r\n0\r\n\r\n"),
            ("a size of 65 bits", b"10000000000000003\r\nELF\r\n0\r\n\r\n"),
            ("a size of 2^64 - 1", b"ffffffffffffffff\r\nELF\r\n0\r\n\r\n"),
            ("a size that is too small", b"2\r\nELF\r\n0\r\n\r\n"),
            ("a size that is too large", b"4\r\nELF\r\n0\r\n\r\n"),
            ("no end of a chunk", b"3\r\nELF0\r\n\r\n"),
            ("chunks that end by LF", b"3\nELF\n0\n\n"),
            ("a data part that ends by LF", b"3\r\nELF\n0\r\n\r\n"),
            ("NUL behind a size", b"3\0\r\nELF\r\n0\r\n\r\n"),
            ("no last chunk", b"3\r\nELF\r\n"),
            ("no end of the last chunk", b"3\r\nELF\r\n0\r\n"),
            ("an extension of 1 MB", b"3;" + b"x" * 1_000_000 + b"\r\nELF\r\n0\r\n\r\n"),
            ("a size of 1 MB of zeros", b"0" * 1_000_000 + b"3\r\nELF\r\n0\r\n\r\n"),
            ("trailers of 1 MB", b"3\r\nELF\r\n0\r\n" + (b"X: " + b"a" * 1000 + b"\r\n") * 1000 + b"\r\n"),
            ("a trailer without a colon", b"3\r\nELF\r\n0\r\nX\r\n\r\n"),
            ("a trailer", b"3\r\nELF\r\n0\r\nX: a\r\n\r\n"),
            ("a trailer that names somebody", b"3\r\nELF\r\n0\r\nAuthorization: x\r\n\r\n"),
            ("a folded trailer", b"3\r\nELF\r\n0\r\nX: a\r\n b\r\n\r\n"),
            ("no chunk but the last", b"0\r\n\r\n")]:
        kind.ask(attack, 400, head + body, end_of_sending=True)
    kind.holds("none of these was taken", taken(server, "chunks") == 0)
    for attack, body in [
            ("capital and small digits, zeros first", b"0003\r\nELF\r\n0A\r\n0123456789\r\n00\r\n\r\n"),
            ("an extension", b'3;name=value;other="quoted \\" "\r\nELF\r\n0;last\r\n\r\n'),
            ("one byte in each of 20 000 chunks", b"1\r\nx\r\n" * 20000 + b"0\r\n\r\n")]:
        kind.ask(attack, 202, head + body)
    kind.ask("in single packets", {202, 429}, [part for byte in head + b"3\r\nELI\r\n0\r\n\r\n" for part in (bytes([byte]), 0.0005)])


def early(kind):
    server = kind.server
    put = request("PUT", "/api/v1/entries?name=x.so", bearer(server.tokens["early"]), "Content-Length: 3000000")
    stream = request("GET", "/events")

    def leave(sent, wait=0.0, reset=True):
        with server.connect() as plain:
            end = encrypted(plain) if server.is_encrypted else plain
            end.sendall(sent)
            time.sleep(wait)
            if reset:
                end.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))

    for attack, sent, wait in [
            ("at once", b"", 0.0),
            ("in the first line", b"GET / HT", 0.0),
            ("in a header", b"GET / HTTP/1.1\r\nHost: x\r\nX: ", 0.0),
            ("after a request", request("GET", "/"), 0.0),
            ("before a body", put, 0.02),
            ("in a body", put + b"x" * 100000, 0.02),
            ("in a chunk", request("PUT", "/api/v1/entries", bearer(server.tokens["early"]), "Transfer-Encoding: chunked") +
             b"1000\r\nxx", 0.02),
            ("before 100 Continue", put.replace(b"\r\n\r\n", b"\r\nExpect: 100-continue\r\n\r\n"), 0.02),
            ("at the beginning of a stream", stream, 0.0),
            ("in a stream", stream, 0.02)]:
        leave(sent, wait)
        kind.note(attack + ", reset", "left", "left")
        # The server learns of an end of a stream when it next sends something.
        if sent != stream or options.all:
            leave(sent, wait, reset=False)
            kind.note(attack + ", closed", "left", "left")
    with concurrent.futures.ThreadPoolExecutor(16) as pool:
        list(pool.map(lambda _: leave(request("GET", "/")), range(100)))
    kind.note("after a request, a hundred at once", "left", "left")
    if not server.is_encrypted:
        kind.ask("the end of sending before the answer", 200, request("GET", "/"), end_of_sending=True)
    kind.holds("nothing was taken", taken(server, "early") == 0)
    uploads = os.path.join(server.league, "entries", ".uploads")
    until = time.monotonic() + patience
    while os.listdir(uploads) and time.monotonic() < until:
        time.sleep(0.02)
    kind.holds("no part of a file is left", not os.listdir(uploads))


def names(kind):
    server = kind.server
    given = ["../../x", "..%2f..%2fx.so", "/etc/passwd", "C:\\x.so", "", ".", "..", "a\nb", "a\r\nX: y", "\x1b[31mred", "<script>alert(1)",
             "\"'><img src=x onerror=alert(1)>", "--json", "-o.cpp", "x\0.so", "\xff\xfe", "‮os.exe", "x" * 5000, "{{name}}", "%s%n",
             "$(reboot).so", "`reboot`", "; reboot", "con", "x.so\n{\"kind\":\"answer\"}"]
    for number, name in enumerate(given):
        target = "/api/v1/entries?name=" + urllib.parse.quote(name, safe="", encoding="utf-8" if ord(max(name, default="a")) > 255 else "latin-1")
        token = bearer(server.tokens[f"names{number % 5}"])
        if number % 5 == 0:
            settle(server, [f"names{i}" for i in range(5)])
        kind.ask(repr(name[:40]), 202, request("PUT", target, token, body=b"no library %d" % number))
    settle(server, [f"names{i}" for i in range(5)])
    strange = re.compile(rb"[\x00-\x08\x0b-\x1f\x7f]|<script>alert|<img|\xff\xfe|\xe2\x80\xae")
    said = server.status()
    kind.holds("the terminal is told text only", said and not strange.search(said), said)
    for team in [f"names{i}" for i in range(5)]:
        answer = talk(server, request("GET", "/api/v1/entries", bearer(server.tokens[team])))
        listed = [entry["file"] for entry in json.loads(answer.body)["entries"]]
        kind.holds("names are text in JSON", len(listed) == 5 and not any(re.search(r"[\x00-\x1f/]", one) for one in listed), answer.body)
        page = talk(server, request("GET", "/hand-in", cookie_of(server, team)))
        kind.holds("names are text in a page", page.status == 200 and not strange.search(page.body), page.body)
    page = talk(server, request("GET", "/hand-in", cookie_of(server, "staff")))
    kind.holds("names are text in the page of the staff", page.status == 200 and not strange.search(page.body), page.body)


def settle(server, of):
    """Waits until the files of these teams have their verdicts."""
    until = time.monotonic() + 20 * patience
    while time.monotonic() < until:
        states = [entry["state"] for team in of
                  for entry in json.loads(talk(server, request("GET", "/api/v1/entries", bearer(server.tokens[team]))).body)["entries"]]
        if not {"queued", "compiling", "checking"} & set(states):
            return
        time.sleep(0.05)
    sys.exit("files wait for their verdicts")


def forms(kind):
    server = kind.server
    log_in = ("POST", "/hand-in/log-in", "Origin: http://x")
    for attack, expected, body, more in [
            ("an empty form", 401, b"", ()),
            ("an empty token", 401, b"token=", ()),
            ("two tokens, the second right", 401, form(token="A" * 26) + b"&" + form(token=server.tokens["beta"]), ()),
            ("NUL in a token", 401, b"token=%00" + server.tokens["beta"].encode(), ()),
            ("4 kB", 401, b"token=" + b"A" * 4000, ()),
            ("10 MB", 400, b"token=" + b"A" * 10_000_000, ()),
            ("a million keys", 400, b"a&" * 1_000_000, ()),
            ("in parts", 401, b"--x\r\nContent-Disposition: form-data; name=token\r\n\r\n" + server.tokens["beta"].encode() + b"\r\n--x--",
             ("Content-Type: multipart/form-data; boundary=x",)),
            ("as JSON", 401, json.dumps({"token": server.tokens["beta"]}).encode(), ("Content-Type: application/json",))]:
        kind.ask("log-in: " + attack, expected, request(*log_in, *more, body=body))
    kind.ask("log-in: by GET", 405, request("GET", f"/hand-in/log-in?token={server.tokens['beta']}"))
    staff = cookie_of(server, "staff")
    book = os.path.join(server.league, "journal.jsonl")
    before = os.path.exists(book) and os.path.getsize(book)
    act = ("POST", "/hand-in/staff", staff, "Origin: http://x", typed)
    for attack, body in [
            ("empty", b""),
            ("no such act", form(act="delete", reason="x", by="x")),
            ("no reason", form(act="pause", team="alpha")),
            ("a path as a team", form(act="pause", team="../alpha", reason="x", by="x")),
            ("a huge number", form(act="undo", decision="99999999999999999999", reason="x", by="x")),
            ("a fixture that is none", form(act="award", fixture="../../x", team="alpha", score="3-0", reason="x", by="x")),
            ("a score that is none", form(act="award", fixture="1", team="alpha", score="9" * 40, reason="x", by="x")),
            ("NUL", b"act=pause&team=alpha%00&reason=x&by=x"),
            ("10 MB", b"act=pause&reason=" + b"A" * 10_000_000)]:
        answer = kind.ask("staff: " + attack, {400, 403, 404, 409}, request(*act, body=body))
        if re.search(rb"<script>alert", answer.body):
            kind.others.append(f"{attack}: {answer.body[:300]!r}")
    kind.holds("the book is as it was", before == (os.path.exists(book) and os.path.getsize(book)))
    kind.ask("staff: from another site", 403, request("POST", "/hand-in/staff", staff, "Origin: http://evil", typed,
                                                      body=form(act="pause", team="alpha", reason="x", by="x")))


def at_once(kind):
    """Quotas hold when everything comes at the same time."""
    server = kind.server
    token = bearer(server.tokens["pins"])
    own = bearer(server.tokens["alpha"])
    for entry in ["", "0", "-1", "99999999999", "1x", "latest'", "../1", "1&entry=2"]:
        kind.ask("pin of " + entry, 400, request("PUT", f"/api/v1/pin?entry={entry}", own, body=b""))
    for entry in ["2", "999"]:
        kind.ask("pin of " + entry, 409, request("PUT", f"/api/v1/pin?entry={entry}", own, body=b""))
    kind.ask("pin of a team without an entry", 409, request("PUT", "/api/v1/pin?entry=1", token, body=b""))
    for opponent in ["", "../beta", "house:../beta", "house:", "house:nobody", "alpha", "dds:x", "python:x", "firasim:1", "nobody", "%00",
                     "/etc/passwd", "house%3a%2e%2e%2fx"]:
        kind.ask("friendly against " + opponent, 404, request("POST", f"/api/v1/friendlies?opponent={opponent}", own, body=b""))

    def all_at_once(count, sent):
        with concurrent.futures.ThreadPoolExecutor(count) as pool:
            return [answer.status for answer in pool.map(lambda i: talk(server, sent(i)), range(count))]

    done = all_at_once(40, lambda _: request("PUT", "/api/v1/pin?entry=1", own, body=b""))
    kind.holds("of 40 pins at once 10 count", done.count(200) == 10 and done.count(429) == 30)
    done = all_at_once(40, lambda _: request("POST", "/api/v1/friendlies?opponent=house:idle", own, body=b""))
    kind.holds("of 40 friendlies at once 10 count", done.count(202) == 10 and done.count(429) == 30)
    done = all_at_once(40, lambda i: request("PUT", "/api/v1/entries?name=x.so", bearer(server.tokens["flood"]), body=b"no %d" % i))
    kind.holds("of 40 files at once at most 20 wait", set(done) <= {202, 429} and 0 < done.count(202) <= 20)
    done = all_at_once(40, lambda _: request("GET", "/api/v1/entries", bearer("E" * 26)))
    kind.holds("of 40 wrong tokens each is wrong", set(done) <= {401, 429})


def encrypted(plain, **how):
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    for name, value in how.items():
        context.set_alpn_protocols(value) if name == "alpn" else setattr(context, name, value)
    return context.wrap_socket(plain, server_hostname="x")


def hello():
    """Returns what a client of TLS sends first."""
    incoming, outgoing = ssl.MemoryBIO(), ssl.MemoryBIO()
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    try:
        context.wrap_bio(incoming, outgoing, server_hostname="x").do_handshake()
    except ssl.SSLWantReadError:
        pass
    return outgoing.read()


def raw(server, *parts, end_of_sending=False):
    """Sends bytes below TLS, and returns whether the server closed the connection."""
    since = time.monotonic()
    with server.connect() as end:
        try:
            for part in parts:
                end.sendall(part) if isinstance(part, bytes) else time.sleep(part)
            if end_of_sending:
                end.shutdown(socket.SHUT_WR)
        except OSError:
            pass
        return receive(end, since)


def tls(kind):
    server = kind.server
    first = hello()
    for attack, parts in [
            ("a plain request", [request("GET", "/")]),
            ("noise", [b"\x16\x03\x01\xff\xff" + os.urandom(500)]),
            ("a record that is too long", [b"\x16\x03\x01\xff\xff" + b"\0" * 65535]),
            ("an empty record", [b"\x16\x03\x01\0\0"]),
            ("an alert first", [b"\x15\x03\x03\0\x02\x02\x28"]),
            ("data first", [b"\x17\x03\x03\0\x05hello"]),
            ("the greeting of SSL 2", [b"\x80\x2e\x01\0\x02\0\x15\0\0\0\x10" + b"\0" * 60]),
            ("a greeting of TLS 1.0", [first.replace(b"\x16\x03\x01", b"\x16\x03\x00", 1)[:60] + os.urandom(300)]),
            ("half of a greeting, then the end", [first[:len(first) // 2]]),
            ("a greeting, then the end", [first]),
            ("a greeting, then noise", [first, os.urandom(1000)])]:
        answer = raw(server, *parts, end_of_sending=True)
        kind.note(attack, "no page", "page" if b"<html" in answer.all or answer.status == 200 else "no page", answer.seconds, answer.all)
    for attack, words in [("TLS 1.0", ["-tls1", "-cipher", "ALL:@SECLEVEL=0"]), ("TLS 1.1", ["-tls1_1", "-cipher", "ALL:@SECLEVEL=0"]),
                          ("no encryption", ["-tls1_2", "-cipher", "NULL:@SECLEVEL=0"]),
                          ("nobody's certificate", ["-tls1_2", "-cipher", "aNULL:@SECLEVEL=0"])]:
        said = openssl(server, [], b"---\n", *words)
        is_agreed = re.search(rb"Cipher is (?!\(NONE\))", said)
        kind.note(attack, "refused", "agreed" if is_agreed else "refused" if b"SSL alert number" in said else "?", received=said)
    said = openssl(server, [b"R\n"], b"no renegotiation", "-tls1_2")
    kind.note("renegotiation by the client", "refused", "refused" if re.search(rb"RENEGOTIATING\n.*no renegotiation", said, re.S) else "?",
              received=said[-1000:])
    said = openssl(server, [b"K\n"] * 20 + [request("GET", "/")], b"</html>", "-tls1_3")
    kind.note("20 new keys, then a request", "answered", "answered" if b"HTTP/1.1 200" in said else "closed", received=said[-1000:])
    for attack, expected, how in [("only HTTP/2 by ALPN", "answered", {"alpn": ["h2"]}),
                                  ("TLS 1.2", "answered", {"maximum_version": ssl.TLSVersion.TLSv1_2})]:
        with server.connect() as plain:
            try:
                end = encrypted(plain, **how)
                end.sendall(request("GET", "/"))
                kind.note(attack, expected, "answered" if receive(end, time.monotonic()).status == 200 else "closed")
            except ssl.SSLError:
                kind.note(attack, expected, "refused")
    put = request("PUT", "/api/v1/entries?name=x.so", bearer(server.tokens["early"]), "Content-Length: 9")
    with server.connect() as plain:
        end = encrypted(plain)
        end.sendall(put + b"short")
        plain_end = socket.socket(fileno=end.detach())
        plain_end.shutdown(socket.SHUT_WR)
        receive(plain_end, time.monotonic())
        plain_end.close()
    kind.holds("a body that ends without the end of TLS is no file", taken(server, "early") == 0)
    many = [server.connect() for _ in range(50)]
    for end in many:
        end.sendall(first[:100])
    kind.ask("a page beside 50 half handshakes", 200, request("GET", "/"))
    for end in many:
        end.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        end.close()
    early(kind)


def openssl(server, typed_lines, last, *words):
    """Types lines into OpenSSL's client when it has its keys. Returns what it prints, up to `last`."""
    process = subprocess.Popen(["openssl", "s_client", "-connect", f"127.0.0.1:{server.port}", *words],
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    said = b""
    is_typed = not typed_lines
    until = time.monotonic() + patience
    while time.monotonic() < until and not (is_typed and last in said):
        if select.select([process.stdout], [], [], 0.1)[0]:
            part = os.read(process.stdout.fileno(), 65536)
            if not part:
                break
            said += part
        if not is_typed and b"Verify return code" in said:
            for line in typed_lines:
                process.stdin.write(line)
                process.stdin.flush()
                time.sleep(0.01)  # it reads a command where a line begins
            is_typed = True
    process.kill()
    process.communicate()
    return said


def slow(kind):
    """Connections that stand still or drip: all at the same time, each has to end by itself."""
    server = kind.server
    team = bearer(server.tokens["flood"])
    put = request("PUT", "/api/v1/entries?name=x.so", team, "Content-Length: 300")
    chunk = request("PUT", "/api/v1/entries?name=x.so", bearer(server.tokens["chunks"]), "Transfer-Encoding: chunked")
    log_in = request("POST", "/hand-in/log-in", "Origin: http://x", typed, "Content-Length: 400")

    def drip(head, byte, seconds):
        return [head] + [part for _ in range(int(seconds)) for part in (byte, 1.0)]

    attacks = [("nothing", 0, 6, [b""]), ("half of a first line", 0, 6, [b"GET / HT"]),
               ("half of a header", 0, 6, [b"GET / HTTP/1.1\r\nHost: x\r\nX"]),
               ("a header that drips", 0, 12, drip(b"GET / HTTP/1.1\r\nX: ", b"a", 15)),
               ("headers that drip", 0, 12, drip(b"GET / HTTP/1.1\r\n", b"X: a\r\n", 15)),
               ("a body that stands still", 400, 22, [put + b"x"]), ("a chunk that stands still", 400, 22, [chunk + b"100\r\nx"]),
               ("a chunk's size that stands still", 400, 22, [chunk + b"10"]),
               ("a form that stands still", 400, 12, [log_in + b"token="]),
               ("a form that drips", {0, 400}, 14, drip(log_in + b"token=", b"A", 15))]
    if server.is_encrypted:
        attacks = [("a greeting of TLS that stands still", 0, 7, None), ("half of a greeting", 0, 7, None), ("a greeting that drips", 0, 7, None)]
        first = hello()
        parts = {attacks[0][0]: [first], attacks[1][0]: [first[:100]], attacks[2][0]: drip(b"", first[:1], 10)}
        with concurrent.futures.ThreadPoolExecutor(16) as pool:
            answers = [(row, pool.submit(raw, server, *parts[row[0]])) for row in attacks]
            for (attack, expected, most, _), answer in answers:
                judge(kind, attack, expected, most, answer.result())
        return
    with concurrent.futures.ThreadPoolExecutor(16) as pool:
        answers = [(row, pool.submit(talk, server, row[3])) for row in attacks]
        for (attack, expected, most, _), answer in answers:
            judge(kind, attack, expected, most, answer.result())


def judge(kind, attack, expected, most, answer):
    # The limit of time stands beside the answer and decides nothing; a connection that is open after `patience` does.
    kind.note(attack, expected, answer.status, answer.seconds, answer.all, f"(limit {most} s)")


def main():
    secret = os.urandom(16).hex()
    secret_file = os.path.join(folder, "secret")
    with open(secret_file, "w") as file:
        file.write(secret + "\n")
    certificate, key = os.path.join(folder, "cert.pem"), os.path.join(folder, "key.pem")
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-subj", "/CN=x",
                    "-keyout", key, "-out", certificate], check=True, capture_output=True)
    plain = Server("plain")
    proxied = Server("proxied", "--trust-proxy", "127.0.0.1", "--proxy-secret", secret_file, "--team-header", "X-Team")
    local = Server("local", "--at", "unix:" + os.path.join(folder, "socket"), "--team-header", "X-Team")
    safe = Server("safe", "--tls", certificate, key)
    kinds = [("log-in, tokens, foreign teams", plain, tokens), ("cookies, other sites", plain, cookies),
             ("a proxy with a secret", proxied, lambda kind: proxies(kind, secret)), ("a Unix socket", local, unix_socket),
             ("paths", plain, paths), ("headers, methods, pipelining", plain, headers), ("bodies, lengths, codings", plain, bodies),
             ("chunks", plain, chunks), ("early ends", plain, early), ("names of files", plain, names), ("forms", plain, forms),
             ("pins, friendlies, files at once", plain, at_once), ("TLS", safe, tls)]
    if options.all:
        kinds += [("slow requests and bodies", plain, slow), ("slow TLS", safe, slow)]
    failed = False
    print("kind | attacks | other answers | answers | slowest, s | seconds")
    for name, server, attack in kinds:
        begun = time.monotonic()
        kind = Kind(name, server)
        attack(kind)
        if why := server.objection():
            kind.others.append(f"afterwards: {why}")
        answers = ", ".join(f"{count} x {answer}" for answer, count in sorted(kind.answers.items(), key=lambda one: -one[1]))
        print(f"{name} | {kind.count} | {len(kind.others)} | {answers} | {kind.slowest:.1f} | {time.monotonic() - begun:.1f}", flush=True)
        for other in kind.others:
            print("  " + other)
        failed = failed or bool(kind.others)
    for server in [plain, proxied, local, safe]:
        memory = server.peak_memory() if server.process.poll() is None else 0
        why = server.end()
        print(f"server {os.path.basename(server.league)}: at most {memory} MiB{', ' + why if why else ''}")
        failed = failed or why is not None
    return 1 if failed else 0


try:
    code = main()
finally:
    shutil.rmtree(folder, ignore_errors=True)
sys.exit(code)
