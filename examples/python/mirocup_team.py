# SPDX-License-Identifier: MIT
"""libmirocup_team for Python, with the standard library alone.

The structures mirror mirocup/strategy.h and mirocup/team.h, which say what every number means:
metres, radians, seconds; the team always attacks +x.

    import mirocup_team

    def decide(setup, now):                    # once a tick: wheel speeds (left, right), rad/s
        return [(10.0, 10.0)] * now.robots

    def place(setup, now, placement):          # at restarts, if you like: where to stand
        placement.robots[1].y = 0.2

    print(mirocup_team.play("final", "blue", "mine", decide, place=place))
"""

import ctypes
import os
from ctypes import c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p

ABI_VERSION = 1  # of strategy.h, whose structures are below
MAX_ROBOTS = 11
MAX_LAWS = 16
MAX_CORNERS = 8
NOTHING, SEATED, TICK, OVER, REFUSED = range(5)
NO_RESTART, KICK_OFF, GOAL_KICK, PENALTY_KICK, FREE_BALL, FREE_KICK = range(6)  # now.restart
COLOURS = {"blue": 0, "yellow": 1}


class Error(Exception):
    """The library or the network cannot be used, or the server does not admit the team."""


class Robot(ctypes.Structure):
    _fields_ = [(name, c_double) for name in ("x", "y", "heading", "vx", "vy", "turn")]


class Counts(ctypes.Structure):
    _fields_ = [("time_s", c_double * MAX_LAWS), ("robots", c_int32 * MAX_LAWS),
                ("keeper", c_int32), ("advantage_against", c_int32)]


class Setup(ctypes.Structure):
    _fields_ = [(name, c_uint32) for name in ("size", "command_size", "placement_size")]
    _fields_ += [(name, c_int32) for name in ("league", "team", "robots", "corners", "laws")]
    _fields_ += [("seed", c_uint64)]
    _fields_ += [(name, c_double) for name in (
        "control_period", "half_s", "ready_s", "half_length", "half_width", "corner_leg",
        "goal_half_width", "goal_depth", "goal_area_depth", "goal_area_half_width",
        "penalty_area_depth", "penalty_area_half_width", "centre_circle_radius", "robot_side",
        "robot_mass", "wheel_distance", "wheel_radius", "wheel_speed_limit", "grip",
        "motor_time_constant", "turn_time_constant", "brake_time_constant")]
    _fields_ += [("corner_x", c_double * MAX_CORNERS), ("corner_y", c_double * MAX_CORNERS)]
    _fields_ += [(name, c_double) for name in (
        "ball_radius", "ball_mass", "rolling_resistance", "viscous_friction")]
    # These are the first members; the host fills in more.


class Observation(ctypes.Structure):
    _fields_ = [("size", c_uint32), ("tick", c_uint32), ("time", c_double), ("clock", c_double)]
    _fields_ += [(name, c_int32) for name in (
        "state", "phase", "restart", "own_restart", "placing", "own_score", "opponent_score",
        "robots", "laws", "ball_age_ticks")]
    _fields_ += [(name, c_double) for name in ("ball_x", "ball_y", "ball_vx", "ball_vy")]
    _fields_ += [("own", Robot * MAX_ROBOTS), ("opponent", Robot * MAX_ROBOTS),
                 ("own_age_ticks", c_int32 * MAX_ROBOTS),
                 ("opponent_age_ticks", c_int32 * MAX_ROBOTS),
                 ("stalemate_s", c_double), ("advantage_s", c_double),
                 ("own_counts", Counts), ("opponent_counts", Counts)]


class Wheels(ctypes.Structure):
    _fields_ = [("left", c_double), ("right", c_double)]


class Command(ctypes.Structure):
    _fields_ = [("wheels", Wheels * MAX_ROBOTS)]


class Pose(ctypes.Structure):
    _fields_ = [(name, c_double) for name in ("x", "y", "heading")]


class Placement(ctypes.Structure):
    _fields_ = [("ball_x", c_double), ("ball_y", c_double), ("robots", Pose * MAX_ROBOTS)]


class Call(ctypes.Structure):
    _fields_ = [("size", c_uint32), ("team", c_int32), ("server", c_char_p), ("match", c_char_p),
                ("name", c_char_p), ("credentials", c_char_p), ("domain", c_int32)]


def _built_library():
    """Returns the library of the build tree that this file belongs to, else the installed one."""
    above = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    built = os.path.join(above, "build", "libmirocup_team.so")
    return built if os.path.exists(built) else "libmirocup_team.so"


def load(path=None):
    """Loads the library from `path`, from $MIROCUP_TEAM_LIBRARY, or from the installation.

    Raises Error if it is not there.
    """
    path = path or os.environ.get("MIROCUP_TEAM_LIBRARY") or _built_library()
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise Error(f"{path} cannot be loaded ({error}); in mirocup's folder, `cmake --preset play && cmake --build "
                    "build --target mirocup_team` makes build/libmirocup_team.so, and "
                    "$MIROCUP_TEAM_LIBRARY says where it is") from error
    version = library.mirocup_team_version()
    if version != ABI_VERSION:
        raise Error(f"{path} is of version {version} of strategy.h, this file of version {ABI_VERSION}: take both "
                    "from one mirocup")
    library.mirocup_team_open.restype = c_void_p
    library.mirocup_team_open.argtypes = [ctypes.POINTER(Call), c_char_p, c_size_t]
    library.mirocup_team_wait.argtypes = [c_void_p, c_double]
    library.mirocup_team_setup.restype = ctypes.POINTER(Setup)
    library.mirocup_team_setup.argtypes = [c_void_p]
    library.mirocup_team_observation.restype = ctypes.POINTER(Observation)
    library.mirocup_team_observation.argtypes = [c_void_p]
    library.mirocup_team_place.restype = c_int32
    library.mirocup_team_place.argtypes = [c_void_p, ctypes.POINTER(Placement)]
    library.mirocup_team_send.restype = c_int32
    library.mirocup_team_send.argtypes = [c_void_p, ctypes.POINTER(Command)]
    library.mirocup_team_text.restype = c_char_p
    library.mirocup_team_text.argtypes = [c_void_p]
    library.mirocup_team_score.restype = ctypes.POINTER(c_int32)
    library.mirocup_team_score.argtypes = [c_void_p]
    library.mirocup_team_close.restype = None
    library.mirocup_team_close.argtypes = [c_void_p]
    return library


def standing(now):
    """Returns the placement that moves neither robots nor ball."""
    placement = Placement(now.ball_x, now.ball_y)
    for i in range(now.robots):
        placement.robots[i] = Pose(now.own[i].x, now.own[i].y, now.own[i].heading)
    return placement


def play(match, colour, name, decide, server=None, credentials=None, patience=60.0, place=None,
         domain=0):
    """Plays one leg and returns how it ended and the score, as in ("full_time", (2, 1)).

    decide(setup, observation) gives a (left, right) pair of wheel speeds for each robot.
    place(setup, observation, placement), if given, changes where the robots are to stand at a
    restart. `domain` is the DDS domain of the match. Raises Error if the match cannot be had within
    `patience` seconds.
    """
    library = load()

    def text(value):
        return None if value is None else str(value).encode()

    call = Call(ctypes.sizeof(Call), COLOURS[colour], text(server), text(match), text(name),
                text(credentials), domain)
    why = ctypes.create_string_buffer(512)
    connection = library.mirocup_team_open(ctypes.byref(call), why, len(why))
    if not connection:
        raise Error(why.value.decode())
    try:
        return _play(library, connection, decide, place, patience)
    finally:
        library.mirocup_team_close(connection)


def _play(library, connection, decide, place, patience):
    silence = 0.0
    while True:
        news = library.mirocup_team_wait(connection, 0.25)
        silence = silence + 0.25 if news == NOTHING else 0.0
        if news == TICK:
            setup = library.mirocup_team_setup(connection).contents
            now = library.mirocup_team_observation(connection).contents
            if place and now.placing:
                placement = standing(now)
                place(setup, now, placement)
                library.mirocup_team_place(connection, ctypes.byref(placement))
            command = Command()
            for i, (left, right) in enumerate(decide(setup, now)):
                command.wheels[i] = Wheels(left, right)
            library.mirocup_team_send(connection, ctypes.byref(command))
        elif news == OVER:
            score = library.mirocup_team_score(connection)
            return library.mirocup_team_text(connection).decode(), (score[0], score[1])
        elif news == REFUSED or silence > patience:
            raise Error(library.mirocup_team_text(connection).decode())
