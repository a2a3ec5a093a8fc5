# SPDX-License-Identifier: MIT
"""A team in Python: derive a class from Team in a file of its own.

    from mirocup.team import Team, drive_to, ball

    class Mine(Team):
        name = "mine"

        def decide(self, now):  # once a tick: (left, right) for each robot, rad/s
            return [drive_to(self.setup, robot, ball(now)) for robot in now.own]

`mirocup match --blue mine.py --yellow chaser` plays it, `mirocup check mine.py` says whether a league
would take it. It runs in the same sandbox as a library, with the same budget: 1 ms of processor time
for each tick in the mean of a leg. Python reads files only while it loads the team: import all
modules at the top of the file. `random` is seeded with setup.seed. print() writes to the log of the leg.

Frames, units, delays and limits are those of mirocup/strategy.h: metres, radians, seconds; the team
always attacks +x; its goal is at -setup.half_length. `self.draw_line` and its neighbours draw into the
replay, as in docs/thoughts.md. The skills and the prediction are those of C++: each function calls the
one of the same name in mirocup/skills.h, so a team decides in Python as in C++. skills.h names the
C++ headers that explain them.
Needs nothing but the standard library.
"""

import ctypes
import math
import os
import struct
from collections import namedtuple

SMALL, MIDDLE, LARGE = range(3)  # setup.league
BLUE, YELLOW = range(2)  # setup.team
READY, PLAY, OVER = range(3)  # now.state
FIRST_HALF, SECOND_HALF, EXTRA_TIME, SHOOT_OUT = range(4)  # now.phase
# now.restart
NO_RESTART, KICK_OFF, GOAL_KICK, PENALTY_KICK, FREE_BALL, FREE_KICK = range(6)

# The indexes of now.own_counts.time_s and .robots, of setup.time_limit_s and .robots_allowed
TWO_DEFENDERS, FOUR_DEFENDERS, TWO_ATTACKERS, KEEPER_HOLD = range(4)

MAX_ROBOTS = 11
_MAX_LAWS = 16

# These have the same bits on every system in a match, unlike those of the module math: see
# mirocup/elementary.h. The program that plays a team gives them; elsewhere they are those of math.
sin, cos, tan, asin, acos, atan, atan2, hypot, exp, log = (
    globals().get(_name, getattr(math, _name))
    for _name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "hypot", "exp", "log"))

Robot = namedtuple("Robot", "x y heading vx vy turn")
Pose = namedtuple("Pose", "x y heading")
Counts = namedtuple("Counts", "time_s robots keeper advantage_against", defaults=((), (), -1, 0))
_Setup = namedtuple("Setup", "league team robots seed control_period half_s ready_s half_length "
                    "half_width corner_leg goal_half_width goal_depth goal_area_depth "
                    "goal_area_half_width penalty_area_depth penalty_area_half_width "
                    "centre_circle_radius robot_side robot_mass wheel_distance wheel_radius "
                    "wheel_speed_limit grip motor_time_constant turn_time_constant "
                    "brake_time_constant ball_radius ball_mass rolling_resistance viscous_friction "
                    "ball_wall_restitution ball_robot_restitution robot_wall_restitution "
                    "robot_robot_restitution ball_wall_friction ball_robot_friction "
                    "robot_wall_friction robot_robot_friction stalemate_limit_s advantage_limit_s "
                    "time_limit_s robots_allowed outline",
                    defaults=10 * (0.0,) + 2 * (math.inf,) + ((), (), ()))

Wheels = namedtuple("Wheels", "left right")
Ball = namedtuple("Ball", "at velocity")
Shot = namedtuple("Shot", "at along aside is_on_line")
Crossing = namedtuple("Crossing", "seconds y")
Interception = namedtuple("Interception", "ball seconds is_reached")
Predicted = namedtuple("Predicted", "own_touched_ball opponent_touched_ball last_touch events")
_Observation = namedtuple("Observation", "tick time clock state phase restart own_restart placing "
                          "own_score opponent_score robots ball_age_ticks ball_x ball_y ball_vx "
                          "ball_vy own opponent own_age_ticks opponent_age_ticks stalemate_s "
                          "advantage_s own_counts opponent_counts")


class Setup(_Setup):
    """The facts of a leg. `outline`: the corners (x, y) of a robot that is not a square, else ()."""


class Observation(_Observation):
    """The observation of a tick; `own` and `opponent` are tuples of Robot."""


# A tuple for own or opponent. The program that plays a team gives a kind of its own, which tells the log
# of a negative index: Python counts it from the last robot, which is rarely meant.
_OfRobots = globals().get("_OfRobots", tuple)


class Team:
    """Derive from it, and define decide(). `setup` holds the facts of the leg."""

    name = ""  # as reports call it; without one, the name of the file

    def __init__(self, setup):
        self.setup = setup
        self.__host = _host

    def decide(self, now):
        """Returns a list with (left, right) for each robot, rad/s; None in its place lets a robot stand."""
        raise NotImplementedError("a team defines decide(self, now): name the method decide, in small letters")

    def place(self, now, placement):
        """At restarts: changes the places of the own robots, and of the ball where that is allowed."""

    def parameter(self, name, default):
        """Returns the parameter that the leg gives this team (--param NAME=VALUE), or the default."""
        return self.__host.parameter(name, float(default))

    # Draw into the replay of `mirocup match --thoughts`; without it, nothing. Points are (x, y) in
    # the own frame, m; a colour is 0xRRGGBBAA; a layer is a name that the page switches on and off.
    # The limits are those of "Thoughts" in mirocup/strategy.h.

    def draw_line(self, layer, colour, start, end):
        self.__host.draw(0, layer, colour, struct.pack("@4d", *start, *end), "")

    def draw_circle(self, layer, colour, centre, radius):
        self.__host.draw(1, layer, colour, struct.pack("@3d", *centre, radius), "")

    def draw_polygon(self, layer, colour, corners):
        numbers = [number for x, y in corners for number in (x, y)]
        self.__host.draw(2, layer, colour, struct.pack(f"@{len(numbers)}d", *numbers), "")

    def draw_text(self, layer, colour, at, text):
        self.__host.draw(3, layer, colour, struct.pack("@2d", *at), text)

    def draw_value(self, name, value):
        """The page shows a curve of the value over time. The name has at most 31 bytes."""
        self.draw_text("values", 0, (0.0, 0.0), f"{name} = {value:.6g}")


class Placement:
    """The places at a restart: `robots`, a list of Pose, and `ball`, a Point. Change what you like."""

    def __init__(self, now):
        self.ball = Point(now.ball_x, now.ball_y)
        self.robots = [Pose(r.x, r.y, r.heading) for r in now.own]


class Point(namedtuple("Point", "x y")):
    """A point or a vector, m."""

    __slots__ = ()

    def __add__(self, other):
        return Point(self[0] + other[0], self[1] + other[1])

    def __sub__(self, other):
        return Point(self[0] - other[0], self[1] - other[1])

    def __rmul__(self, factor):
        return Point(factor * self[0], factor * self[1])

    __mul__ = __rmul__


def dot(a, b):
    """Returns the dot product of two vectors."""
    return a[0] * b[0] + a[1] * b[1]


def length(a):
    """Returns the length of a vector."""
    return math.sqrt(dot(a, a))


def unit(a):
    """Returns the vector with the length 1; (1, 0) for one without a length."""
    l = length(a)
    return Point(a[0] / l, a[1] / l) if l > 0.0 else Point(1.0, 0.0)


def ball(now):
    return Point(now.ball_x, now.ball_y)


def ball_velocity(now):
    """Returns the velocity of the ball, m/s."""
    return Point(now.ball_vx, now.ball_vy)


def position(robot):
    """Returns the place of a robot, m."""
    return Point(robot.x, robot.y)


def wrapped(angle):
    """Returns the same angle in (-pi, pi], rad; NaN for an angle that is infinite or NaN."""
    if not math.isfinite(angle):
        return math.nan
    rest = math.remainder(angle, math.tau)
    return math.pi if rest <= -math.pi else rest


# ---- the bytes of strategy.h

_SETUP = struct.Struct(f"@3I 5i Q 22d 16d 14d {_MAX_LAWS}d {_MAX_LAWS}i 7P")
_ROBOTS = 6 * MAX_ROBOTS
_OBSERVATION = struct.Struct(f"@I I d d 10i 4d {2 * _ROBOTS}d {2 * MAX_ROBOTS}i 2d" +
                             2 * f"{_MAX_LAWS}d {_MAX_LAWS}i 2i")
_OWN = 18  # index of the first robot
_OPPONENT = _OWN + _ROBOTS
_AGES = _OPPONENT + _ROBOTS
_COUNTS = _AGES + 2 * MAX_ROBOTS + 2
_COMMAND = struct.Struct(f"@{2 * MAX_ROBOTS}d")
_PLACEMENT = struct.Struct(f"@2d {3 * MAX_ROBOTS}d")
_ROBOT = struct.Struct("@6d")


def _filled(values, length, value=0):
    return (*values, *((length - len(values)) * (value,)))


def _setup_of(data):
    v = _SETUP.unpack_from(data)  # newer hosts have more at the end
    corners, laws = v[6:8]
    outline = tuple(Point(*p) for p in zip(v[31:31 + corners], v[39:39 + corners]))
    setup = Setup(*v[3:6], *v[8:31], *v[47:61], v[61:61 + laws], v[77:77 + laws], outline)
    setup._bytes_of_setup = data
    return setup


def _setup_bytes(setup):
    """The setup as C sees it: of the host, or of a test, whose setup has no functions that draw."""
    try:
        return setup._bytes_of_setup
    except AttributeError:
        pass
    x, y = (_filled([p[k] for p in setup.outline], 8) for k in (0, 1))
    setup._bytes_of_setup = _SETUP.pack(
        _SETUP.size, _COMMAND.size, _PLACEMENT.size, *setup[:3], len(setup.outline), len(setup.time_limit_s),
        *setup[3:26], *x, *y, *setup[26:40], *_filled(setup.time_limit_s, _MAX_LAWS, math.inf),
        *_filled(setup.robots_allowed, _MAX_LAWS), *(7 * [0]))
    return setup._bytes_of_setup


def _counts_of(values, at, laws):
    robots = at + _MAX_LAWS
    return tuple.__new__(Counts, (values[at:at + laws], values[robots:robots + laws],
                                  *values[robots + _MAX_LAWS:robots + _MAX_LAWS + 2]))


def _observation_of(data):
    v = _OBSERVATION.unpack_from(data)
    n, laws = v[11:13]
    new = tuple.__new__  # in half the time of Robot(*numbers)
    own = new(_OfRobots, [new(Robot, v[k:k + 6]) for k in range(_OWN, _OWN + 6 * n, 6)])
    opponent = new(_OfRobots, [new(Robot, v[k:k + 6]) for k in range(_OPPONENT, _OPPONENT + 6 * n, 6)])
    now = new(Observation, (*v[1:12], *v[13:18], own, opponent, new(_OfRobots, v[_AGES:_AGES + n]),
                            new(_OfRobots, v[_AGES + MAX_ROBOTS:_AGES + MAX_ROBOTS + n]),
                            v[_COUNTS - 2], v[_COUNTS - 1], _counts_of(v, _COUNTS, laws),
                            _counts_of(v, _COUNTS + 2 * _MAX_LAWS + 2, laws)))
    now._bytes_of_now = data
    return now


def _observation_bytes(now):
    """The observation as C sees it; one that a team changed with _replace() is packed again."""
    try:
        return now._bytes_of_now
    except AttributeError:
        pass
    if not 0 <= now.robots <= MAX_ROBOTS or max(len(now.own), len(now.opponent)) > MAX_ROBOTS:
        raise ValueError(f"an observation of {now.robots} robots; at most {MAX_ROBOTS} are possible")
    ages = [*_filled(now.own_age_ticks, MAX_ROBOTS), *_filled(now.opponent_age_ticks, MAX_ROBOTS)]
    counts = [n for c in (now.own_counts, now.opponent_counts)
              for n in (*_filled(c.time_s, _MAX_LAWS), *_filled(c.robots, _MAX_LAWS), *c[2:])]
    now._bytes_of_now = _OBSERVATION.pack(_OBSERVATION.size, *now[:11], len(now.own_counts.time_s), *now[11:16],
                                          *_robots(now.own), *_robots(now.opponent), *ages, now.stalemate_s,
                                          now.advantage_s, *counts)
    return now._bytes_of_now


def _robots(robots):
    numbers = [number for robot in robots for number in robot]
    return numbers + (_ROBOTS - len(numbers)) * [0.0]


# ---- calling skills.h

def _load_skills():
    """The library: what a match gives as `_skills_in` (None: the program itself), or as it was built or
    installed beside this file."""
    if "_skills_in" in globals():
        return ctypes.PyDLL(_skills_in)
    name, above = "libmirocup_skills.so.0", os.path.dirname(os.path.abspath(__file__))
    multiarch = getattr(__import__("sys").implementation, "_multiarch", "")
    for _ in range(5):  # BUILD/python/mirocup, PREFIX/lib/python3/dist-packages/mirocup
        above = os.path.dirname(above)
        for folder in (above, os.path.join(above, "lib"), os.path.join(above, "lib", multiarch)):
            if os.path.exists(os.path.join(folder, name)):
                return ctypes.PyDLL(os.path.join(folder, name))
    raise ImportError(f"{name} was not found: build it (cmake --build build --target mirocup_skills)")


_c = _load_skills()


def _structure(name, **fields):
    return type(name, (ctypes.Structure,), {"_fields_": list(fields.items())})


_real, _whole, _address = ctypes.c_double, ctypes.c_int32, ctypes.c_void_p
_CPoint = _structure("_CPoint", x=_real, y=_real)
_CWheels = _structure("_CWheels", left=_real, right=_real)
_CPose = _structure("_CPose", x=_real, y=_real, heading=_real)
_CRobot = _structure("_CRobot", x=_real, y=_real, heading=_real, vx=_real, vy=_real, turn=_real)
_CBall = _structure("_CBall", at=_CPoint, velocity=_CPoint)
_CShot = _structure("_CShot", at=_CPoint, along=_CPoint, aside=_real, is_on_line=_whole)
_CCrossing = _structure("_CCrossing", seconds=_real, y=_real, is_ahead=_whole)
_CInterception = _structure("_CInterception", ball=_CBall, seconds=_real, is_reached=_whole)
_CPredicted = _structure("_CPredicted", own=ctypes.c_uint32, opponent=ctypes.c_uint32, last=_whole,
                         events=_whole)
_CCommand = _real * (2 * MAX_ROBOTS)


def _own(i, robots=MAX_ROBOTS):
    """A number of a robot as C may use it."""
    if not 0 <= i < robots:
        raise IndexError(f"there is no robot {i}")
    return i


def _point(p):
    return Point(p.x, p.y)


def _ball(b):
    return Ball(_point(b.at), _point(b.velocity))


# What a function of skills.h takes: how a call converts an argument, and what an error says is expected. The key is a type of C, or
# a type and the name of the parameter. All other pointers are addresses.
_Kind = namedtuple("_Kind", "from_param expected")
_KINDS = {
    "double": _Kind(_real.from_param, "a number"),
    "int32_t": _Kind(_whole.from_param, "a whole number"),
    "int32_t i": _Kind(lambda i: _whole.from_param(_own(i)), "the number of an own robot"),
    "int32_t me": _Kind(lambda i: _whole.from_param(_own(i)), "the number of an own robot"),
    "const char*": _Kind(lambda text: str(text).encode(), "a text"),
    "const mirocup_setup*": _Kind(_setup_bytes, "the setup of a team"),
    "const mirocup_observation*": _Kind(_observation_bytes, "an observation"),
    "const mirocup_robot*": _Kind(lambda robot: _ROBOT.pack(*robot), "a robot, such as now.own[1],"),
    "const mirocup_robot* robots": _Kind(lambda robots: b"".join([_ROBOT.pack(*r) for r in robots]), "a list of robots"),
    "const mirocup_command*": _Kind(lambda wheels: _command(wheels), "a list with (left, right) for each robot"),
    "mirocup_point": _Kind(lambda p: _CPoint(*p), "a point (x, y)"),
    "mirocup_wheels": _Kind(lambda w: _CWheels(*w), "(left, right) in rad/s"),
    "mirocup_pose": _Kind(lambda pose: _CPose(*pose), "a pose (x, y, heading)"),
    "mirocup_ball": _Kind(lambda b: _CBall(_CPoint(*b[0]), _CPoint(*b[1])), "a Ball, ((x, y), (vx, vy)),"),
    "mirocup_shot": _Kind(lambda s: _CShot(_CPoint(*s[0]), _CPoint(*s[1]), s[2], s[3]), "a Shot"),
}
# What a function returns: the type in C, and how a call converts it.
_RESULTS = {
    "mirocup_wheels": (_CWheels, lambda w: Wheels(w.left, w.right)),
    "mirocup_point": (_CPoint, _point),
    "mirocup_pose": (_CPose, lambda p: Pose(p.x, p.y, p.heading)),
    "mirocup_robot": (_CRobot, lambda r: Robot(r.x, r.y, r.heading, r.vx, r.vy, r.turn)),
    "mirocup_ball": (_CBall, _ball),
    "mirocup_shot": (_CShot, lambda s: Shot(_point(s.at), _point(s.along), s.aside, bool(s.is_on_line))),
    "mirocup_crossing": (_CCrossing, lambda c: Crossing(c.seconds, c.y) if c.is_ahead else None),
    "mirocup_interception": (_CInterception, lambda i: Interception(_ball(i.ball), i.seconds, bool(i.is_reached))),
    "mirocup_predicted": (_CPredicted, lambda p: Predicted(p.own, p.opponent, p.last, p.events)),
    "const mirocup_command*": (ctypes.POINTER(_CCommand), lambda command: command[0]),
    "double": (_real, None),
    "int32_t": (_whole, None),
    "void": (None, None),
}


def _bound(result, name, parameters):
    """Returns the function mirocup_NAME, with its declaration in C."""
    function = getattr(_c, "mirocup_" + name)
    function.restype, convert = _RESULTS.get(result, (_address, None))
    if convert:
        function.errcheck = lambda result, *_: convert(result)
    function.argtypes = [_KINDS.get(p) or _KINDS.get(p.rpartition(" ")[0]) or _Kind(_address.from_param, "an address")
                         for p in parameters.split(", ") if p]
    return function


def _explain(function, given):
    """Raises a sentence about the first argument that its parameter does not take."""
    for (parameter, value), kind in zip(given.items(), function.argtypes):
        try:
            kind.from_param(value)
            if parameter in ("i", "me") and "now" in given:
                _own(value, given["now"].robots)
        except Exception:
            raise TypeError(f"{function.__name__[8:]}(): {parameter} is {_short(value)}; {kind.expected} is "
                            "expected") from None


def _called(function, **given):
    try:
        return function(*given.values())
    except Exception:
        _explain(function, given)
        raise


def _speeds(answer, robots, who):
    """Returns the numbers of a list with (left, right), or None, for each robot."""
    try:
        pairs = list(answer)
        if isinstance(answer, (dict, set, frozenset)):  # without an order, or without the pairs
            raise TypeError
    except TypeError:
        raise TypeError(f"{who} {_short(answer)}; a list with (left, right) for each robot is "
                        "expected") from None
    if pairs and isinstance(pairs[0], (int, float)):
        raise ValueError(f"{who} {len(pairs)} numbers; {robots} pairs (left, right) are expected")
    if len(pairs) > robots:
        raise ValueError(f"{who} {len(pairs)} pairs of speeds for {robots} robots")
    numbers = []
    for i, pair in enumerate(pairs):
        try:
            left, right = (0.0, 0.0) if pair is None else pair
            numbers += float(left), float(right)
        except (TypeError, ValueError):
            raise TypeError(f"{who} {_short(pair)} for robot {i}; (left, right) in rad/s is "
                            "expected") from None
    return numbers


def _command(wheels, robots=MAX_ROBOTS, who="a command is"):
    return _CCommand(*_speeds(wheels, robots, who))


def _pairs(command, robots):
    return [Wheels(command[2 * i], command[2 * i + 1]) for i in range(robots)]


# The build puts the functions of skills.h here (plugins/predict/declarations.py).
# SKILLS


# ---- those of skills.h that are different in Python

def inside(setup, p, margin=None) -> Point:
    """Returns the nearest point of the field at least `margin` (m; None: to turn) from the walls."""
    return _called(_inside, setup=setup, p=p, margin=elbow_room(setup) if margin is None else margin)


def _changed(function, setup, now, wheels):
    """Calls a function that changes a command, with a list of wheel speeds; returns the list that it makes of it."""
    global _unchanged
    name = function.__name__[8:]
    _unchanged = wheels, name
    command = _command(wheels, now.robots, name + "() was given")
    _called(function, setup=setup, now=now, command=command)
    return _pairs(command, now.robots)


def moving_ball(now) -> Ball:
    return Ball(ball(now), ball_velocity(now))


def follow_field(setup, robot, pose, speed, obstacles=(), radius=0.075, smooth=0.07, lead_s=0.08) -> Wheels:
    """Drives along the field to a pose, round obstacles: pairs (at, velocity)."""
    others = (_CBall * len(obstacles))(*[_CBall(_CPoint(*at), _CPoint(*v)) for at, v in obstacles])
    return _called(_follow_field, setup=setup, robot=robot, pose=pose, speed=speed, obstacles=others, count=len(others),
                   radius=radius, smooth=smooth, lead_s=lead_s)


def cheapest_robot(now, first, last, bonus, cost):
    """Returns the own robot from `first` on with the least cost(i); `last` costs `bonus` less."""
    costs = (_real * MAX_ROBOTS)(*_own(first) * [0.0], *[cost(i) for i in range(first, now.robots)])
    return _cheapest_robot(now, first, last, bonus, costs)


def assign_places(now, places, free, last, bonus=0.1):
    """Returns the robot, one of `free`, for each place, the most important first; `last`: the answer
    of the last tick, whose robots count as `bonus` m nearer."""
    count = len(places)
    if not len(places) == len(free) == len(last) or count > MAX_ROBOTS:
        raise ValueError(f"assign_places(): {count} places, {len(free)} robots and {len(last)} of the last "
                         "tick; as many of each are expected")
    free, last = [_own(i, now.robots) for i in free], [int(i) for i in last]
    chosen = (_whole * count)()
    _assign_places(now, (_CPoint * count)(*[_CPoint(*p) for p in places]),
                   (_whole * count)(*free), (_whole * count)(*last), count, bonus, chosen)
    return list(chosen)


def out_of_reach(robots, ball) -> float:
    """Returns how far from the robots a ball passes that goes in: 0 at one, 1 out of reach of all."""
    return _called(_out_of_reach, robots=robots, count=len(robots), ball=ball)


# ---- what remembers: mirocup/skills/filter.hpp, penalty.hpp, mirocup/predict.hpp

class _Handle:
    """What mirocup_KIND_new() returns; freed with the object."""

    _kind = ""

    def __init__(self, *arguments, new="new"):
        self._handle = getattr(_c, f"mirocup_{self._kind}_{new}")(*arguments)

    def _call(self, function, *arguments):
        return getattr(_c, f"mirocup_{self._kind}_{function}")(self._handle, *arguments)

    def __del__(self):
        self._call("free")


class Filter(_Handle):
    """Under the conditions `camera`: where all bodies will be when the answer is driven."""

    _kind = "filter"

    def __init__(self, setup):
        super().__init__(setup)

    def see(self, seen, ticks_ahead=1):
        """Returns the observation `ticks_ahead` ticks later. Once in every tick."""
        now = ctypes.create_string_buffer(_OBSERVATION.size)
        self._call("see", seen, ticks_ahead, now)
        return _observation_of(now.raw)

    def sent(self, wheels):
        """Remembers the answer to the last observation of see()."""
        self._call("sent", wheels)


class PenaltyTaker(_Handle):
    """Takes a run-up, and chooses the corner when the keeper has shown its own."""

    _kind = "penalty"

    def stand(self, setup, now, y_bias):
        """Returns the Pose of the kicker, for place()."""
        return self._call("stand", setup, now, y_bias)

    def drive(self, setup, now, robot):
        """Returns the wheel speeds of the kicker."""
        return self._call("drive", setup, now, robot)


class Tracker(_Handle):
    """What predictions need from tick to tick: saw() at the start of decide(), sent() at its end."""

    _kind = "tracker"

    def __init__(self, setup):
        super().__init__(setup)
        self._robots = setup.robots

    def saw(self, now):
        self._call("saw", now)

    def sent(self, wheels):
        self._call("sent", wheels)

    def in_flight(self):
        """Returns your answer to the observation before, which is driven in this tick."""
        return _pairs(self._call("in_flight"), self._robots)

    def opponents(self):
        """Returns the wheel speeds of the opponents in the last tick."""
        return _pairs(self._call("opponents"), self._robots)


class Scene(_Handle):
    """All bodies at one instant, for a Simulator. Copy one to try several futures from it."""

    _kind = "scene"

    def __init__(self, now):
        if isinstance(now, Scene):
            super().__init__(now._handle, new="copy_new")
        else:
            super().__init__(now)

    def copy(self):
        return Scene(self)

    def show(self, now):
        """Returns `now` with the bodies of this scene, as your team would see them."""
        return self._shown("show", now)

    def show_to_opponents(self, now):
        """The same in the frame of the opponents, with own and opponent exchanged."""
        return self._shown("show_to_opponents", now)

    def _shown(self, function, now):
        seen = ctypes.create_string_buffer(_observation_bytes(now), _OBSERVATION.size)
        self._call(function, seen)
        return _observation_of(seen.raw)


class Simulator(_Handle):
    """The physics of a match in the frame of your team. A tick costs from 1 to 100 µs in the simulator."""

    _kind = "simulator"

    def __init__(self, setup, coarse=False):
        super().__init__(setup, coarse)

    def advance(self, scene, own, opponent, ticks=1):
        """Plays a tick from the scene, in place, with lists of wheel speeds; returns what happened."""
        if not isinstance(scene, Scene) or ticks < 1:
            raise TypeError(f"advance() was given {_short(scene)} and {ticks} ticks; a Scene and at least one "
                            "are expected")
        return self._call("advance", scene._handle, own, opponent, ticks)


__all__ = [name for name, value in globals().items()
           if name[0] != "_" and not isinstance(value, type(math)) and name not in ("namedtuple", "MAX_ROBOTS")]

# What follows is between the program that plays the team and the classes above: errors as sentences.
# A team does not need it.

_ZEROS = [0.0] * (3 * MAX_ROBOTS)
_warned = set()
_unchanged = None, ""  # the list that keep_laws() or the like got last, and the name of that function
_MANY_PLACES = 8  # calls of place() after which it should have changed a place


class _host:  # the program that plays a team puts its own functions in place of these
    def parameter(name, default):
        return default

    def draw(*shape):
        pass


def _warn(text):
    """Writes a line to the log, once for each kind. `mirocup check` shows it as a warning."""
    import sys
    kind = text.split("[")[0]
    if kind not in _warned:
        _warned.add(kind)
        sys.stderr.write(f"mirocup: {text}\n")


class _Log:
    """Standard output and standard error of a team in the sandbox. What does not fit is dropped."""

    encoding = "utf-8"
    errors = "replace"

    def __init__(self, descriptor):
        self._descriptor = descriptor

    def write(self, text):
        import posix
        try:
            posix.write(self._descriptor, text.encode("utf-8", "replace"))
        except OSError:
            pass
        return len(text)

    def flush(self):
        pass

    def isatty(self):
        return False

    def fileno(self):
        return self._descriptor


class _Runner:
    """One team that plays. The program calls it with the structures of strategy.h as bytes."""

    def __init__(self, team, robots):
        self._team = team
        self._robots = robots
        self._places = type(team).place is not Team.place
        self._idle_places = 0  # calls of place() without an effect; -1: one had an effect

    def decide(self, data):
        answer = self._team.decide(_observation_of(data))
        if answer is _unchanged[0] and answer is not None:
            name = _unchanged[1]
            _warn(f"{name}() returns a new list, which is not used: write wheels = {name}(self.setup, now, wheels)")
        if answer is None:
            _refuse("decide() returned None: each way through decide() has to end with return and the list")
        if hasattr(answer, "cr_await"):
            _refuse("decide() returned a coroutine: write def decide(self, now), without async")
        numbers = _speeds(answer, self._robots, "decide() returned")
        return _COMMAND.pack(*numbers, *_ZEROS[len(numbers):2 * MAX_ROBOTS])

    def place(self, data):
        now = _observation_of(data)
        placement = Placement(now)
        if self._places:
            returned = self._team.place(now, placement)
            self._look_at(placement, returned, now)
        values = [number for r in now.own for number in r[:3]]  # what it leaves out stays where it is
        place = "placement.robots[0]"
        try:
            for i, robot in enumerate(placement.robots[:self._robots]):
                place = f"placement.robots[{i}]"
                x, y, heading = robot
                values[3 * i:3 * i + 3] = float(x), float(y), float(heading)
            place = "placement.ball"
            ball_x, ball_y = placement.ball
            return _PLACEMENT.pack(float(ball_x), float(ball_y), *values, *_ZEROS[len(values):])
        except (TypeError, ValueError, struct.error):
            _refuse("place() left something else than (x, y, heading) for each robot and (x, y) for the ball: "
                    f"write {place} = Pose(x, y, heading)")

    def _look_at(self, placement, returned, now):
        """Warns about a place() that has no effect."""
        if returned is not None and returned is not placement:
            _warn(f"place() returned {_short(returned)}, which is not used: change "
                       "placement.robots and placement.ball")
        before = Placement(now)
        if placement.robots != before.robots or tuple(placement.ball) != tuple(before.ball):
            self._idle_places = -1  # it knows how
        elif self._idle_places >= 0:
            self._idle_places += 1
        if self._idle_places == _MANY_PLACES:
            _warn(f"place() was called {_MANY_PLACES} times and changed no place: it has to change "
                       "placement.robots and placement.ball themselves, not copies of them")
        try:
            count = len(placement.robots)
        except TypeError:
            return
        if count != self._robots:
            _warn(f"place() left {count} poses for {self._robots} robots")


def _warn_of_index(i):
    _warn(f"the index {i} of a robot counts from the last one; robots are 0 to now.robots - 1")


def _short(value, show=repr):
    text = show(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _begin(in_sandbox):
    import linecache
    import sys
    import traceback
    del linecache, traceback  # imported now, because no file can be opened later
    if in_sandbox:
        sys.stdin = None
        sys.stdout = sys.__stdout__ = _Log(1)
        sys.stderr = sys.__stderr__ = _Log(2)


def _load(source, name):
    """Runs the file of a team and returns its class."""
    import linecache
    import random
    import sys
    import types
    random.seed(0)  # for what the file draws before it has a setup
    text = source.decode("utf-8-sig")  # with or without the mark that editors on Windows put first
    linecache.cache[name] = (len(text), None, text.splitlines(True), name)
    module = types.ModuleType("__team__")
    module.__file__ = name
    sys.modules[module.__name__] = module
    exec(compile(text, name, "exec"), module.__dict__)
    classes = [value for value in vars(module).values()
               if isinstance(value, type) and issubclass(value, Team) and value is not Team
               and value.__module__ == module.__name__]
    # A class that another one of the file is derived from is not the team.
    leaves = [c for c in classes if not any(d is not c and issubclass(d, c) for d in classes)]
    if not leaves:
        raise TypeError("the file defines no class that is derived from mirocup.team.Team: write class Mine(Team)")
    if len(leaves) > 1:
        names = ", ".join(c.__name__ for c in leaves)
        raise TypeError(f"the file defines several teams: {names}; one is expected, hand in the others by themselves")
    return leaves[0]


def _create(team_class, data, host):
    import gc
    import random
    import sys
    import types
    global _host
    _host = types.SimpleNamespace(**host)
    setup = _setup_of(data)
    random.seed(setup.seed)
    numpy = sys.modules.get("numpy")
    if numpy is not None:
        numpy.random.seed(setup.seed % 2**32)
    team = team_class(setup)
    if not isinstance(team_class.name, str):
        _warn(f"the name of the team is {_short(team_class.name)}; a text is expected")
    if not isinstance(getattr(team, "setup", None), Setup):
        _refuse(f"{team_class.__name__}.__init__(self, setup) has to call super().__init__(setup) first")
    gc.collect()
    gc.freeze()
    return _Runner(team, setup.robots)


def _what_it_has(error):
    """Returns what an AttributeError leaves out: the names that come near, or where a team gets them."""
    if not isinstance(error, AttributeError):
        return ""
    if isinstance(error.obj, Team):
        return "; set it in __init__() after super().__init__(setup), or write that method"
    names = getattr(type(error.obj), "_fields", ())
    near = [n for n in names if n[:3] == error.name[:3]] or names
    return f"; it has {_short(near, ', '.join)}" if near else ""


def _refuse(text):
    raise TypeError(text)


def _cause_of(error, frames, own):
    """Returns a word for the cause of an error, often the name of its type. The sentences of Python change."""
    import sys
    kind = type(error).__name__
    for module, cause in (("/multiprocessing/", "process"), ("/asyncio/", "asyncio")):
        if any(module in frame.filename for frame in frames):
            return cause
    if frames and frames[-1].filename.endswith("/threading.py"):
        return "thread"
    if isinstance(error, AttributeError):
        set_it = "read_only" if error.name is None else kind
        return "import_package" if error.obj is sys.modules["mirocup"] else set_it
    if isinstance(error, NameError) and error.name in ("quit", "exit"):
        return "SystemExit"
    if kind == "ImportError" and error.name is None:
        return "relative_import"
    if isinstance(error, (TypeError, struct.error)) and own and ".draw_" in own[-1].line:
        return "bad_point" if ".parameter(" not in own[-1].line else "no_default"
    if kind != "TypeError":
        return kind
    if own:
        if "'setup'" in str(error) and "__init__()" in str(error):
            return "super" if "super()" in own[-1].line else "makes_team"
        return "no_default" if ".parameter(" in own[-1].line else kind
    # The call of a method itself does not take its arguments.
    return "signature" if frames and frames[-1].name in ("decide", "place", "_create") else kind


def _describe(error, name):
    """Prints the traceback to the log. Returns a sentence with the line of the team's file, the cause and the line."""
    import sys
    import traceback
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if frame.filename == name]
    first = next((i for i, frame in enumerate(frames) if frame.filename == name), len(frames))
    kept = error.__traceback__
    for _ in range(min(first, len(frames) - 1)):
        kept = kept.tb_next
    try:
        sys.stderr.write("".join(traceback.format_exception(type(error), error, kept)))
    except Exception:  # the team's own __str__ may fail
        pass
    if isinstance(error, SyntaxError) and error.filename == name:
        version = f"{sys.version_info.major}.{sys.version_info.minor}"
        return (f"line {error.lineno}: {type(error).__name__}: {error.msg} (this host has Python "
                f"{version})", "SyntaxError", error.lineno or 0)
    try:
        text = f"{type(error).__name__}: {error}{_what_it_has(error)}" if str(error) else type(error).__name__
    except Exception:
        text = type(error).__name__
    line = own[-1].lineno if own else 0
    return (f"line {line}: {text}" if own else text, _cause_of(error, frames, own), line)
