#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""nginx.py BUILD: Debian's nginx before a league at a Unix socket, with the configuration that docs/hosting-server.md shows.

Catches a line of that configuration which nginx does not know, a hand-in or a stream of events that does not come through, a viewer
who passes for another, and a limit for each address that locks out a lecture hall. $MIROCUP_NGINX names the program if it lies elsewhere. Exit code 77: there is
no nginx.
"""
import os
import re
import resource
import shutil
import socket
import ssl
import subprocess
import sys
import tempfile
import time

nginx = os.environ.get("MIROCUP_NGINX") or shutil.which("nginx", path="/usr/sbin:/usr/bin")
if nginx is None:
    print("skipped: nginx is not here")
    sys.exit(77)
build = os.path.abspath(sys.argv[1])
mirocup = os.path.join(build, "mirocup")
folder = tempfile.mkdtemp(prefix="mirocup-nginx-")
at = {name: os.path.join(folder, name) for name in ["l", "league.sock", "cert.pem", "key.pem", "nginx.conf", "token", "large", "tmp"]}
# Of the four thousand that the first of these needs, nginx gets as many as it likes.
resource.setrlimit(resource.RLIMIT_NOFILE, (2048, resource.getrlimit(resource.RLIMIT_NOFILE)[1]))
hall = 100  # viewers behind one address
halves = 300  # of their requests that never become whole


def run(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def configuration(port):
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../docs/hosting-server.md")) as page:
        text = page.read()
    shown = re.search(r"\nnginx:\n```\n(.*?)```\n", text, re.S).group(1)
    below = re.search(r"```\n(  location /spring/.*?  }\n)", text, re.S).group(1)
    shown = shown.rstrip().removesuffix("}") + below + "}\n"
    for there, here in [("listen 443 ssl", f"listen 0.0.0.0:{port} ssl"), ("/etc/ssl/league.pem", at["cert.pem"]),
                        ("/etc/ssl/league.key", at["key.pem"]), ("/run/mirocup/spring.sock", at["league.sock"])]:
        assert there in shown, there
        shown = shown.replace(there, here)
    places = "".join(f"{kind}_temp_path {at['tmp']}/{kind};\n" for kind in ["client_body", "proxy", "fastcgi", "uwsgi", "scgi"])
    return f"user root;\npid {folder}/pid;\nevents {{ worker_connections 1000; }}\nhttp {{\naccess_log off;\n{places}{shown}}}\n"


def connect(port, source="127.0.0.1"):
    plain = socket.socket()
    plain.settimeout(60)
    plain.bind((source, 0))
    plain.connect(("127.0.0.1", port))
    return ssl.create_default_context(cafile=at["cert.pem"]).wrap_socket(plain, server_hostname="127.0.0.1")


def ask(port, method, target, *headers, body=b"", source="127.0.0.1", stop=None):
    """Returns what is received until the connection ends, or until `stop`."""
    words = [f"{method} {target} HTTP/1.1", "Host: league.example", "Connection: close", *headers]
    if body:
        words.append(f"Content-Length: {len(body)}")
    received = b""
    with connect(port, source) as end:
        try:
            end.sendall("\r\n".join(words).encode() + b"\r\n\r\n" + body)
        except OSError:
            pass  # it has its answer already
        while stop is None or stop not in received:
            part = end.recv(65536)
            if not part:
                break
            received += part
    return received


def expect(what, is_so, received):
    print(f"{'ok    ' if is_so else 'FAILED'} {what}")
    if not is_so:
        print(received[:600])
    return is_so


def try_all(port, token):
    known = f"Authorization: Bearer {token}"
    page = ask(port, "GET", "/")
    yield expect("a page", page.startswith(b"HTTP/1.1 200") and b"</html>" in page, page)
    told = subprocess.run([mirocup, "hand-in", f"https://127.0.0.1:{port}", "--token-file", at["token"], "--ca", at["cert.pem"],
                           os.path.join(build, "house/striker.so")], capture_output=True, text=True)
    yield expect("a hand-in, its events and its verdict", told.returncode == 0 and "alpha: entry 2 was accepted" in told.stdout,
                 told.stdout + told.stderr)
    page = ask(port, "GET", "/spring/hand-in", known)
    yield expect("a team's page below a path", page.startswith(b"HTTP/1.1 200") and b'="/' not in page, page)
    told = subprocess.run([mirocup, "hand-in", f"https://127.0.0.1:{port}/spring", "--token-file", at["token"], "--ca", at["cert.pem"],
                           "--pin", "2"], capture_output=True, text=True)
    yield expect("a pin below a path", told.returncode == 0 and told.stdout == "entry 2 plays\n", told.stdout + told.stderr)
    with open(os.path.join(build, "house/navigator.so"), "rb") as file:
        taken = ask(port, "PUT", "/api/v1/entries?name=navigator.so", known, body=file.read())
    yield expect("a file by PUT", taken.startswith(b"HTTP/1.1 202"), taken)
    first = ask(port, "GET", "/api/v1/entries/3/events", known, stop=b"\n\n")
    yield expect("the first event comes at once", b"event: state" in first and b'"verdict"' not in first, first)
    events = ask(port, "GET", "/api/v1/entries/3/events", known)
    yield expect("events until the verdict", b'"state":"accepted"' in events and events.endswith(b"0\r\n\r\n"), events)
    states = [ask(port, "GET", "/api/v1/entries", "Authorization: Bearer " + "A" * 26, f"X-Forwarded-For: 10.0.0.{i}")[9:12]
              for i in range(12)]
    yield expect("a viewer who invents addresses is one viewer", states[0] == b"401" and states[-1] == b"429", states)
    other = ask(port, "GET", "/api/v1/entries", "Authorization: Bearer " + "A" * 26, source="127.0.0.2")
    yield expect("another viewer is another", other.startswith(b"HTTP/1.1 401"), other)
    large = ask(port, "PUT", "/api/v1/entries?name=x.so", known, body=b"x" * (33 << 20))
    yield expect("a file that is too large", large.startswith(b"HTTP/1.1 413"), large)
    viewers = [connect(port, "127.0.0.3") for _ in range(hall)]
    for end in viewers:
        end.sendall(b"GET /events HTTP/1.1\r\nHost: x\r\n\r\n")
    opened = sum(end.recv(4096).startswith(b"HTTP/1.1 200") for end in viewers)
    yield expect(f"a hall of {hall} viewers", opened == hall, opened)
    viewers += [connect(port, "127.0.0.3") for _ in range(halves)]
    for end in viewers[hall:]:
        end.sendall(b"GET / HTTP/1.1\r\nX: ")
    for source, what in [("127.0.0.3", f"one more behind this address, beside {halves} half requests"), ("127.0.0.4", "a viewer elsewhere")]:
        page = ask(port, "GET", "/", source=source)
        yield expect(what, page.startswith(b"HTTP/1.1 200"), page)
        page = ask(port, "GET", "/api/v1/team", known, source=source)
        yield expect(f"{what}, with a token", page.startswith(b"HTTP/1.1 200"), page)
    for end in viewers:
        end.close()


def main():
    run("openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-subj", "/CN=127.0.0.1",
        "-addext", "subjectAltName=IP:127.0.0.1", "-keyout", at["key.pem"], "-out", at["cert.pem"])
    run(mirocup, "league", "init", at["l"], "--team", "alpha=house:chaser", "--team", "beta=house:keeper", "--half", "5")
    token = run(mirocup, "league", "token", at["l"], "alpha").strip()
    with open(at["token"], "w") as file:
        file.write(token)
    os.mkdir(at["tmp"])
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with open(at["nginx.conf"], "w") as file:
        file.write(configuration(port))
    command = [nginx, "-p", folder, "-c", at["nginx.conf"], "-e", "stderr", "-g", "daemon off;"]
    run(*command, "-t")
    league = subprocess.Popen([mirocup, "league", "serve", at["l"], "--hand-in", "--at", "unix:" + at["league.sock"]],
                              stdout=subprocess.PIPE, text=True)
    league.stdout.readline()
    proxy = subprocess.Popen(command)
    try:
        for _ in range(300):
            with socket.socket() as probe:
                if probe.connect_ex(("127.0.0.1", port)) == 0:
                    break
            time.sleep(0.1)
        results = list(try_all(port, token))
    finally:
        for process in [proxy, league]:
            process.terminate()
            process.wait(60)
    return 0 if results and all(results) else 1


try:
    code = main()
finally:
    shutil.rmtree(folder, ignore_errors=True)
sys.exit(code)
