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
replay, as in docs/thoughts.md. The functions below do what those of
the same names in mirocup/strategy.hpp do, and some in a simpler way: keep_goal(), free_ball() and
without_pushing() decide otherwise in places. make_way() and avoid_own_goals() are in C++ alone.
Needs nothing but the standard library.
"""

import math
import struct
from collections import namedtuple

__all__ = ["Team", "Placement", "Point", "Pose", "Robot", "Counts", "Setup", "Observation",
           "SMALL", "MIDDLE", "LARGE", "BLUE", "YELLOW", "READY", "PLAY", "OVER", "FIRST_HALF",
           "SECOND_HALF", "EXTRA_TIME", "SHOOT_OUT", "NO_RESTART", "KICK_OFF", "GOAL_KICK", "PENALTY_KICK", "FREE_BALL",
           "FREE_KICK", "dot", "length", "unit", "ball", "ball_velocity", "position", "wrapped",
           "wheels_for", "turn_to", "drive_to", "drive_to_pose", "ball_after", "inside",
           "meeting_point", "keep_out", "without_pushing", "out_of_area", "keep_laws", "drive_round",
           "drive_clear", "kick_to", "must_kick_off", "kick_off", "keep_goal", "is_stuck",
           "free_ball", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "hypot", "exp", "log"]

SMALL, MIDDLE, LARGE = range(3)  # setup.league
BLUE, YELLOW = range(2)  # setup.team
READY, PLAY, OVER = range(3)  # now.state
FIRST_HALF, SECOND_HALF, EXTRA_TIME, SHOOT_OUT = range(4)  # now.phase
# now.restart
NO_RESTART, KICK_OFF, GOAL_KICK, PENALTY_KICK, FREE_BALL, FREE_KICK = range(6)

MAX_ROBOTS = 11

# These have the same bits on every system in a match, unlike those of the module math: see
# mirocup/elementary.h. The program that plays a team gives them; elsewhere they are those of math.
sin, cos, tan, asin, acos, atan, atan2, hypot, exp, log = (
    globals().get(_name, getattr(math, _name))
    for _name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "hypot", "exp", "log"))

Robot = namedtuple("Robot", "x y heading vx vy turn")
Pose = namedtuple("Pose", "x y heading")
Counts = namedtuple("Counts", "defenders area_defenders attackers keeper advantage_against "
                    "two_defenders_s four_defenders_s two_attackers_s keeper_hold_s")
Setup = namedtuple("Setup", "league team robots seed control_period half_s half_length "
                   "half_width corner_leg goal_half_width goal_depth goal_area_depth "
                   "goal_area_half_width penalty_area_depth penalty_area_half_width "
                   "centre_circle_radius robot_side robot_mass wheel_distance wheel_radius "
                   "wheel_speed_limit motor_time_constant grip ball_radius ball_mass "
                   "turn_time_constant brake_time_constant rolling_resistance viscous_friction "
                   "ball_wall_restitution ball_robot_restitution robot_wall_restitution "
                   "robot_robot_restitution ball_wall_friction ball_robot_friction "
                   "robot_wall_friction robot_robot_friction stalemate_limit_s advantage_limit_s "
                   "keeper_hold_limit_s defenders_limit_s attackers_limit_s ready_s "
                   "defenders_allowed area_defenders_allowed attackers_allowed",
                   defaults=21 * (0.0,))
Observation = namedtuple("Observation", "tick time clock state phase restart own_restart own_score "
                         "opponent_score robots placing ball_x ball_y ball_vx ball_vy own opponent "
                         "own_counts opponent_counts stalemate_s advantage_s own_age_ticks "
                         "opponent_age_ticks ball_age_ticks")


class Team:
    """Derive from it, and define decide(). `setup` holds the facts of the leg."""

    name = ""  # as reports call it; without one, the name of the file

    def __init__(self, setup):
        self.setup = setup
        self.__host = _host

    def decide(self, now):
        """Returns a list with (left, right) for each robot, rad/s; None in its place lets a robot stand."""
        raise NotImplementedError("a team defines decide(self, now)")

    def place(self, now, placement):
        """At restarts: changes the places of the own robots, and of the ball where that is allowed."""

    def parameter(self, name, default):
        """Returns the parameter that the leg gives this team (--param NAME=VALUE), or the default."""
        return self.__host.parameter(name, float(default))

    # Draw into the replay of `mirocup match --thoughts`; without it, nothing. Points are (x, y) in
    # the own frame, m; a colour is 0xRRGGBBAA; a layer is a name that the page switches on and off.
    # The limits are those of "Thoughts" in mirocup/strategy.h.

    def draw_line(self, layer, colour, start, end):
        self.__host.draw_line(layer, colour, *start, *end)

    def draw_circle(self, layer, colour, centre, radius):
        self.__host.draw_circle(layer, colour, *centre, radius)

    def draw_polygon(self, layer, colour, corners):
        numbers = [number for x, y in corners for number in (x, y)]
        self.__host.draw_polygon(layer, colour, struct.pack(f"@{len(numbers)}d", *numbers))

    def draw_text(self, layer, colour, at, text):
        self.__host.draw_text(layer, colour, *at, text)

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
    return a[0] * b[0] + a[1] * b[1]


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    l = length(a)
    return Point(a[0] / l, a[1] / l) if l > 0.0 else Point(1.0, 0.0)


def ball(now):
    return Point(now.ball_x, now.ball_y)


def ball_velocity(now):
    return Point(now.ball_vx, now.ball_vy)


def position(robot):
    return Point(robot.x, robot.y)


def wrapped(angle):
    """Returns the same angle in (-pi, pi], rad; NaN for an angle that is infinite or NaN."""
    if not math.isfinite(angle):
        return math.nan
    rest = math.remainder(angle, math.tau)
    return math.pi if rest <= -math.pi else rest


def _clamp(value, low, high):
    return min(max(value, low), high)


def wheels_for(setup, forward, turn):
    """Returns the wheel speeds for a forward speed (m/s) and an angular velocity (rad/s)."""
    side = turn * setup.wheel_distance / 2.0
    left = (forward - side) / setup.wheel_radius
    right = (forward + side) / setup.wheel_radius
    fastest = max(abs(left), abs(right))
    if fastest > setup.wheel_speed_limit:
        k = setup.wheel_speed_limit / fastest
        return left * k, right * k
    return left, right


def turn_to(setup, robot, heading):
    """Turns on the spot towards a heading, rad."""
    return wheels_for(setup, 0.0, 8.0 * wrapped(heading - robot.heading))


def drive_to(setup, robot, target, arrival=0.0, fastest=1.5):
    """Drives to a point, forwards or backwards, and passes it at `arrival` m/s (0: stops there)."""
    dx, dy = target[0] - robot.x, target[1] - robot.y
    distance = hypot(dx, dy)
    if distance < 0.005 and arrival == 0.0:
        return 0.0, 0.0
    error = wrapped(atan2(dy, dx) - robot.heading)
    direction = 1.0
    if abs(error) > math.pi / 2.0:
        error = wrapped(error + math.pi)
        direction = -1.0
    turn = 9.0 * error
    speed = min(fastest, arrival + 5.0 * distance) * max(0.0, cos(error))
    steady = 0.8 * setup.grip * 9.81  # sliding wheels do not steer
    if abs(speed * turn) > steady:
        speed = steady / abs(turn)
    return wheels_for(setup, direction * speed, turn)


def drive_to_pose(setup, robot, target, heading, fastest=1.5):
    """Drives to a point and turns to a heading there."""
    target = Point(*target)
    forward = Point(cos(heading), sin(heading))
    to = target - position(robot)
    distance = length(to)
    if distance < 0.01:
        return turn_to(setup, robot, heading)
    if dot(to, forward) > 0.9 * distance:
        return drive_to(setup, robot, target, 0.0, fastest)
    run_up = _clamp(0.6 * distance, 0.05, 0.3)
    return drive_to(setup, robot, target - run_up * forward, 0.2, fastest)


def ball_after(now, seconds):
    """Returns the place of the ball after some seconds, without robots and walls."""
    k = seconds * (1.0 - 0.1 * seconds)
    return Point(now.ball_x + k * now.ball_vx, now.ball_y + k * now.ball_vy)


def inside(setup, p, margin=None):
    """Returns the nearest point of the field at least `margin` (m; None: to turn) from the walls."""
    margin = 0.6 * setup.robot_side if margin is None else margin
    return Point(_clamp(p[0], -setup.half_length + margin, setup.half_length - margin),
                 _clamp(p[1], -setup.half_width + margin, setup.half_width - margin))


def meeting_point(setup, now, robot, pace=1.2):
    """Returns the place where a robot that drives at `pace` m/s meets the ball."""
    p = ball(now)
    for _ in range(3):
        p = ball_after(now, min(hypot(p.x - robot.x, p.y - robot.y) / pace, 0.8))
    return inside(setup, p, setup.ball_radius)


def keep_out(setup, i, p):
    """Returns a target of robot `i`, moved out of the areas that the laws forbid. Not for keepers."""
    margin = setup.robot_side + (0.075 if setup.league == LARGE else 0.02)
    is_crowd = i >= 3 and setup.penalty_area_depth > 0.0
    depth = (setup.penalty_area_depth if is_crowd else setup.goal_area_depth) + margin
    half_width = (setup.penalty_area_half_width if is_crowd
                  else setup.goal_area_half_width) + margin
    if p[0] < -setup.half_length + depth and abs(p[1]) < half_width:
        return Point(-setup.half_length + depth, p[1])
    return Point(*p)


def without_pushing(setup, now, robot, wheels):
    """Returns the wheel speeds, or slower ones where the robot would push an opponent."""
    nose_x, nose_y = cos(robot.heading), sin(robot.heading)
    forward = setup.wheel_radius * (wheels[0] + wheels[1]) / 2.0
    turn = setup.wheel_radius * (wheels[1] - wheels[0]) / setup.wheel_distance
    if forward < 0.0:
        nose_x, nose_y = -nose_x, -nose_y
    ball_x, ball_y = now.ball_x - robot.x, now.ball_y - robot.y
    wide = setup.robot_side + 0.015  # two robots side by side
    if hypot(ball_x, ball_y) < wide:
        return wheels
    ball_along = ball_x * nose_x + ball_y * nose_y
    ball_ahead = (ball_along > 0.0 and
                  abs(ball_x * nose_y - ball_y * nose_x) < setup.robot_side / 2.0 + 0.0175)
    allowed = abs(forward)
    for other in now.opponent:
        x, y = other.x - robot.x, other.y - robot.y
        along = x * nose_x + y * nose_y
        if along <= 0.0 or abs(x * nose_y - y * nose_x) > wide:
            continue
        if ball_ahead and ball_along < along:  # pushing both is playing the ball
            continue
        gap = hypot(x, y) - (setup.robot_side + 0.025)
        allowed = min(allowed, 0.1 + 4.0 * gap if gap > 0.0 else -0.2)
    if allowed == abs(forward):
        return wheels
    return wheels_for(setup, -allowed if forward < 0.0 else allowed, turn)


def out_of_area(setup, i, robot, wheels):
    """Returns the wheel speeds, or ones that take robot `i` out of an area that keep_out() forbids."""
    is_crowd = i >= 3 and setup.penalty_area_depth > 0.0
    depth = setup.penalty_area_depth if is_crowd else setup.goal_area_depth
    half_width = setup.penalty_area_half_width if is_crowd else setup.goal_area_half_width
    height = 0.0
    if is_crowd or setup.league == SMALL:
        height = 0.1 if setup.league == LARGE else 0.05
    arc = height if abs(robot.y) < half_width / 2.0 else 0.0
    margin = setup.robot_side / 2.0 + 0.0025
    front = -setup.half_length + depth + arc + margin
    side = half_width + margin
    if robot.x + 0.1 * robot.vx > front or abs(robot.y + 0.1 * robot.vy) > side:
        return wheels
    if front - robot.x < side - abs(robot.y):
        return drive_to(setup, robot, (front + 0.1, robot.y))
    return drive_to(setup, robot, (robot.x, side + 0.1 if robot.y > 0.0 else -side - 0.1))


def keep_laws(setup, now, wheels):
    """Returns the list after without_pushing() and out_of_area(), for all robots but the keeper, 0."""
    lawful = list(wheels)
    for i in range(1, len(lawful)):
        lawful[i] = without_pushing(setup, now, now.own[i], lawful[i])
        lawful[i] = out_of_area(setup, i, now.own[i], lawful[i])
    return lawful


def drive_round(setup, robot, target, obstacle, arrival=0.0, fastest=1.5):
    """Drives to a point, around an obstacle on the line to it."""
    berth = setup.robot_side + 0.035
    here = position(robot)
    path = Point(*target) - here
    to = Point(*obstacle) - here
    along = unit(path)
    ahead = dot(to, along)
    aside = along.x * to.y - along.y * to.x
    if ahead <= 0.0 or ahead >= length(path) or abs(aside) >= berth:
        return drive_to(setup, robot, target, arrival, fastest)
    if length(to) < setup.robot_side + 0.04:  # too near to turn past it
        return drive_to(setup, robot, here - 0.1 * unit(to), 0.0, fastest)
    side = (-1.0 if aside > 0.0 else 1.0) * berth * 1.2
    beside = (obstacle[0] - side * along.y, obstacle[1] + side * along.x)
    return drive_to(setup, robot, beside, 0.3, min(fastest, 0.9))


def drive_clear(setup, now, robot, target, arrival=0.0, fastest=1.5):
    """Drives to a point, around the ball or an opponent that is on the line to it."""
    here = position(robot)
    way = Point(*target) - here
    if arrival == 0.0 and length(way) < 0.03:
        quarter = math.pi / 2.0
        return turn_to(setup, robot, quarter * math.floor(robot.heading / quarter + 0.5))
    obstacle = ball(now)
    nearest = length(obstacle - here)
    for other in now.opponent:
        to = Point(other.x - here.x, other.y - here.y)
        distance = length(to)
        if distance < 0.2 and distance < nearest and dot(to, way) > 0.0:
            obstacle, nearest = position(other), distance
    return drive_round(setup, robot, target, obstacle, arrival, fastest)


def kick_to(setup, now, robot, point, pace=1.5):
    """Kicks the ball towards a point: drives behind the ball first, and then through it."""
    meet = meeting_point(setup, now, robot)
    along = unit(Point(*point) - meet)
    x, y = robot.x - meet.x, robot.y - meet.y
    behind = -(x * along.x + y * along.y)
    aside = y * along.x - x * along.y
    if 0.0 < behind < 0.35 and abs(aside) < 0.02 + 0.35 * behind:
        through = (meet.x + 0.3 * along.x + 2.0 * aside * along.y,
                   meet.y + 0.3 * along.y - 2.0 * aside * along.x)
        return drive_to(setup, robot, through, pace, pace)
    return drive_clear(setup, now, robot, inside(setup, meet - (setup.robot_side + 0.035) * along), 0.3, pace)


def must_kick_off(now):
    """True if the ball is still on the spot of your own kick-off. It has to go backwards first."""
    return (now.restart == KICK_OFF and now.own_restart != 0
            and hypot(now.ball_x, now.ball_y) < 0.055)


def kick_off(setup, robot):
    """Takes a kick-off: rolls the ball straight back to the team-mates."""
    here = position(robot)
    pace = 0.8 if length(here) > setup.robot_side + 0.025 else 0.28
    return drive_to(setup, robot, -0.1 * unit(here), pace, pace)


def is_stuck(now, patience=0.6):
    """True if the ball has got nowhere for `patience` s and nearly stands."""
    return now.stalemate_s > patience and hypot(now.ball_vx, now.ball_vy) < 0.15


def free_ball(setup, now, robot):
    """Gets a stuck ball free: drives at it, and spins beside it."""
    x, y = now.ball_x - robot.x, now.ball_y - robot.y
    if hypot(x, y) > setup.robot_side + 0.01:
        return drive_to(setup, robot, ball(now), 0.6, 1.2)
    way_x, way_y = 1.0, 0.0
    if now.ball_x > 0.3 * setup.half_length:
        way_x, way_y = setup.half_length - 0.18 - now.ball_x, -now.ball_y
    elif now.ball_x < -setup.half_length + 0.06:
        way_x, way_y = 0.3, -1.0 if now.ball_y < 0.0 else 1.0
    return wheels_for(setup, 0.0, 30.0 if x * way_y - y * way_x > 0.0 else -30.0)


def keep_goal(setup, now, robot):
    """Keeps the goal: stays in its mouth where the ball will cross the line, kicks a slow ball away."""
    line = -setup.half_length + 0.4 * setup.robot_side
    x, y = now.ball_x - robot.x, now.ball_y - robot.y
    is_slow = hypot(now.ball_vx, now.ball_vy) < 0.4
    if (is_slow and now.ball_x > robot.x + 0.02 and hypot(x, y) < setup.robot_side + 0.085
            and now.ball_x < -setup.half_length + setup.goal_area_depth + 0.02):
        return drive_to(setup, robot, ball(now) + 0.2 * unit((x, y)), 1.0)
    # The place where the ball will cross the line, if it comes; else the middle of what it sees.
    left = hypot(now.ball_x + setup.half_length, now.ball_y - setup.goal_half_width)
    right = hypot(now.ball_x + setup.half_length, now.ball_y + setup.goal_half_width)
    at = setup.goal_half_width * (right - left) / (right + left)
    if now.ball_vx < -0.1:
        seconds = (line - now.ball_x) / now.ball_vx
        if 0.0 < seconds < 1.5:
            at = now.ball_y + now.ball_vy * seconds
    reach = setup.goal_half_width - (setup.robot_side / 2.0 + 0.001)
    at = _clamp(at, -reach, reach)
    if abs(line - robot.x) < 0.04 and abs(robot.y) < setup.goal_half_width + 0.05:
        # Along the line, and looking along it: a keeper that turns away throws the ball in.
        up = 1.0 if robot.heading > 0.0 else -1.0
        error = wrapped(up * math.pi / 2.0 - robot.heading)
        speed = up * _clamp(8.0 * (at - robot.y), -1.8, 1.8)
        return wheels_for(setup, speed * max(0.0, cos(2.0 * error)), 9.0 * error)
    return drive_round(setup, robot, (line, at), ball(now), 0.0, 1.5)


# What follows is between the program that plays the team and the classes above: the bytes of
# strategy.h, and errors as sentences. A team does not need it.

_SETUP = struct.Struct("@I i i i Q 21d 7P 12d 2i 16d 2I 6d 4i")
_ROBOTS = 6 * MAX_ROBOTS
_OBSERVATION = struct.Struct(f"@I I d d 8i 4d {_ROBOTS}d {_ROBOTS}d 6i 4d 6i 4d 2d "
                             f"{MAX_ROBOTS}i {MAX_ROBOTS}i i i")
_OWN = 16  # index of the first robot
_OPPONENT = _OWN + _ROBOTS
_COUNTS = _OPPONENT + _ROBOTS
_AGES = _COUNTS + 2 * 10 + 2
_COMMAND = struct.Struct(f"@{2 * MAX_ROBOTS}d")
_PLACEMENT = struct.Struct(f"@2d {3 * MAX_ROBOTS}d")
_ZEROS = [0.0] * (3 * MAX_ROBOTS)


class _host:  # the program that plays a team puts its own functions in place of these
    def parameter(name, default):
        return default

    def draw_line(*shape):
        pass

    draw_circle = draw_polygon = draw_text = draw_line


def _setup_of(data):
    values = _SETUP.unpack_from(data)  # newer hosts have more at the end
    return Setup(*values[1:26], *values[33:45], *values[65:74])


def _counts_of(values, at):
    return Counts(*values[at:at + 5], *values[at + 6:at + 10])


def _observation_of(data):
    v = _OBSERVATION.unpack_from(data)
    n = v[10]
    own = tuple([Robot(*v[k:k + 6]) for k in range(_OWN, _OWN + 6 * n, 6)])
    opponent = tuple([Robot(*v[k:k + 6]) for k in range(_OPPONENT, _OPPONENT + 6 * n, 6)])
    return Observation(*v[1:16], own, opponent, _counts_of(v, _COUNTS), _counts_of(v, _COUNTS + 10),
                       v[_AGES - 2], v[_AGES - 1], v[_AGES:_AGES + n],
                       v[_AGES + MAX_ROBOTS:_AGES + MAX_ROBOTS + n], v[_AGES + 2 * MAX_ROBOTS])


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
        self._warned = set()

    def _warn(self, text):
        """Writes a line to the log, once. `mirocup check` shows it as a warning."""
        import sys
        kind = text.split("[")[0]
        if kind not in self._warned:
            self._warned.add(kind)
            sys.stderr.write(f"mirocup: {text}\n")

    def decide(self, data):
        answer = self._team.decide(_observation_of(data))
        try:
            wheels = list(answer)
        except TypeError:
            raise TypeError(f"decide() returned {_short(answer)}; a list with (left, right) for each "
                            "robot is expected") from None
        if len(wheels) == 2 * self._robots and not any(isinstance(w, (tuple, list)) for w in wheels):
            raise ValueError(f"decide() returned {len(wheels)} numbers; {self._robots} pairs (left, "
                             "right) are expected")
        if len(wheels) > self._robots:
            raise ValueError(f"decide() returned {len(wheels)} pairs of speeds for {self._robots} "
                             "robots")
        values = _ZEROS[:2 * MAX_ROBOTS]
        for i, pair in enumerate(wheels):
            if pair is None:
                continue
            try:
                left, right = pair
                values[2 * i], values[2 * i + 1] = float(left), float(right)
            except (TypeError, ValueError):
                raise TypeError(f"decide() returned {_short(pair)} for robot {i}; (left, right) in "
                                "rad/s is expected") from None
        return _COMMAND.pack(*values)

    def place(self, data):
        now = _observation_of(data)
        placement = Placement(now)
        if self._places:
            returned = self._team.place(now, placement)
            if returned is not None and returned is not placement:
                self._warn(f"place() returned {_short(returned)}, which is not used: change "
                           "placement.robots and placement.ball")
            if len(placement.robots) > self._robots:
                self._warn(f"place() left {len(placement.robots)} poses for {self._robots} robots")
        values = _ZEROS[:]
        try:
            for i, (x, y, heading) in enumerate(placement.robots[:MAX_ROBOTS]):
                values[3 * i:3 * i + 3] = float(x), float(y), float(heading)
            ball_x, ball_y = placement.ball
            return _PLACEMENT.pack(float(ball_x), float(ball_y), *values)
        except (TypeError, ValueError, struct.error):
            raise TypeError("place() left something else than (x, y, heading) for each robot and "
                            "(x, y) for the ball") from None


def _short(value):
    text = repr(value)
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
        raise TypeError("the file defines no class that is derived from mirocup.team.Team")
    if len(leaves) > 1:
        names = ", ".join(c.__name__ for c in leaves)
        raise TypeError(f"the file defines several teams: {names}; one is expected")
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
    if not isinstance(getattr(team, "setup", None), Setup):
        raise TypeError(f"{team_class.__name__}.__init__(self, setup) has to call "
                        "super().__init__(setup)")
    gc.collect()
    gc.freeze()
    return _Runner(team, setup.robots)


def _describe(error, name):
    """Prints the traceback to the log and returns a sentence with the line of the team's file."""
    import sys
    import traceback
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame.lineno for frame in frames if frame.filename == name]
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
                f"{version})")
    try:
        text = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
    except Exception:
        text = type(error).__name__
    return f"line {own[-1]}: {text}" if own else text
