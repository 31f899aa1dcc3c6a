"""First contacts of discs and walls with more digits than any scalar of carom has: contact_roots.csv, wall_crossings.csv.

Run it from anywhere:  python3 validation/references/contact_roots.py
Needs Python 3.9 or newer and mpmath (BSD licence, PyPI), written with 1.3.0. No code of carom is used. The rows are drawn
from a fixed seed; all numbers of a problem are f64 and written so that they are read back to the bit.

A pair: relative position p + v t + a t^2/2, contact distance D. In rows with `rest`, a is exactly -v / rest (a sliding
ball and a resting one; `inf`: constant velocity). The contact is the first t >= 0 with f <= 0 and f' < 0, where
f = |p + v t + a t^2/2|^2 - D^2. The polynomial is solved at 200 digits: between neighbouring roots of its derivative it is
monotone, so every root is bracketed and none can be missed. mpmath.polyroots, which knows nothing of brackets, must find the
same root, or the program stops.

kind    hit: f falls through 0 at `time`; now: contact at time 0; turn: contact at `time`, where an overlapping pair turns inward;
        late: a hit, after `limit`; miss: none
time    s, 75 digits; empty for a miss
margin  length, positive: by how much the answer is what it is, the smallest of: how deep the discs would go after the
        contact, and how far they stayed apart at every closest approach before it and up to `limit`; empty without either
"""

import csv
import math
import os
import random

import mpmath as mp

mp.mp.dps = 200
DIGITS = 75
draw = random.Random(20240611)
HERE = os.path.dirname(os.path.abspath(__file__))


# ---- truth


def value(c, t):
    s = mp.mpf(0)
    for k in reversed(c):
        s = s * t + k
    return s


def derivative(c):
    return [k * i for i, k in enumerate(c)][1:]


def trimmed(c):
    c = list(c)
    while c and c[-1] == 0:
        c.pop()
    return c


def bracketed(c, lo, hi):
    """The root of c between lo and hi, where it changes sign once: false position with bisection, to all digits."""
    flo, fhi = value(c, lo), value(c, hi)
    if flo == 0:
        return lo
    if fhi == 0:
        return hi
    d = derivative(c)
    t = (lo + hi) / 2
    for _ in range(3000):
        ft = value(c, t)
        if ft == 0:
            return t
        if (ft > 0) == (flo > 0):
            lo = t
        else:
            hi = t
        slope = value(d, t)
        new = t - ft / slope if slope != 0 else lo - 1
        if not lo < new < hi:
            # far apart in size: by the geometric mean, as bisection in the exponent
            new = mp.sqrt(lo * hi) if lo > 0 and hi / lo > 4 else (lo + hi) / 2
        if abs(new - t) <= abs(new) * mp.mpf(10) ** (-180) or hi - lo <= abs(hi) * mp.mpf(10) ** (-180):
            return new
        t = new
    raise ArithmeticError("no convergence")


def positive_roots(c):
    """All roots t > 0 at which c changes sign, ascending."""
    c = trimmed(c)
    if len(c) <= 1:
        return []
    if len(c) == 2:
        r = -c[0] / c[1]
        return [r] if r > 0 else []
    # Cauchy's bound
    top = 1 + max(abs(k / c[-1]) for k in c[:-1])
    marks = [mp.mpf(0)] + [r for r in positive_roots(derivative(c)) if r < top] + [top]
    found = []
    for lo, hi in zip(marks, marks[1:]):
        flo, fhi = value(c, lo), value(c, hi)
        if flo == 0:
            # sign to the right of lo
            continue
        if fhi == 0 or (flo > 0) != (fhi > 0):
            r = bracketed(c, lo, hi)
            if r > 0 and (not found or r > found[-1]):
                found.append(r)
    return found


def confirm(c, t, what):
    """mpmath.polyroots must have a root there."""
    c = trimmed(c)
    # in units of t, so that coefficients of any size do
    scaled = [k * t**i for i, k in enumerate(c)]
    big = max(abs(k) for k in scaled)
    scaled = trimmed([k / big for k in scaled])
    # coefficients below all digits are none
    while abs(scaled[-1]) < mp.mpf(10) ** (-120):
        scaled.pop()
    with mp.workdps(150):
        roots = mp.polyroots(scaled[::-1], maxsteps=2000, extraprec=1200)
    off = min(abs(r - 1) for r in roots)
    assert off < mp.mpf(10) ** (-60), (what, mp.nstr(off, 5))


def contact(c, distance, limit, what):
    """(kind, time, margin) by the event rule, for f with coefficients c."""
    f = trimmed(c)
    slope = derivative(f)
    D = mp.mpf(distance)

    def gap(t):
        return mp.sqrt(D * D + value(f, t)) - D

    turns = positive_roots(slope)  # f' changes sign
    marks = [mp.mpf(0)] + turns
    margins = []
    for i, lo in enumerate(marks):
        hi = marks[i + 1] if i + 1 < len(marks) else None
        probe = (lo + hi) / 2 if hi is not None else 2 * lo + 1
        if slope == [] or value(slope, probe) >= 0:
            continue  # receding
        if lo > limit:
            break
        if value(f, lo) <= 0:
            kind = "now" if lo == 0 else "turn"
            return kind, lo, min(margins + ([abs(gap(lo))] if lo > 0 else []), default=None)
        if hi is not None and value(f, hi) > 0:
            margins.append(gap(min(hi, limit)))
            continue
        end = hi if hi is not None else 1 + max(abs(k / f[-1]) for k in f[:-1])
        t = bracketed(f, lo, end)
        confirm(f, t, what)
        depth = -gap(hi) if hi is not None else D
        margins.append(depth)
        return ("hit" if t <= limit else "late"), t, min(margins)
    return "miss", None, min(margins, default=None)


def pair_polynomial(p, v, a, distance):
    p, v, a = ([mp.mpf(x) for x in y] for y in (p, v, a))
    dot = lambda x, y: x[0] * y[0] + x[1] * y[1]
    D = mp.mpf(distance)
    return [dot(p, p) - D * D, 2 * dot(p, v), dot(v, v) + dot(p, a), dot(v, a), dot(a, a) / 4]


# ---- rows


pairs, walls = [], []


def number(x):
    return repr(float(x))


def digits(x, n=DIGITS):
    return "" if x is None else mp.nstr(x, n, strip_zeros=True, min_fixed=0, max_fixed=0)


def pair(name, p, v, distance, limit, a=None, rest=None, extent=None):
    p, v = [float(x) for x in p], [float(x) for x in v]
    exact_a = [mp.mpf(x) for x in a] if a is not None else [-mp.mpf(x) / mp.mpf(rest) for x in v]
    c = pair_polynomial(p, v, exact_a, distance)
    stop = min(mp.mpf(limit), mp.mpf(rest)) if rest is not None else mp.mpf(limit)
    kind, time, margin = contact(c, distance, stop, name)
    motion = [number(a[0]), number(a[1]), ""] if a is not None else ["", "", number(rest)]
    pairs.append(
        [name, number(p[0]), number(p[1]), number(v[0]), number(v[1]), *motion, number(distance), number(stop)]
        + ["" if extent is None else number(extent), kind, digits(time), digits(margin, 8)]
    )
    return kind, time


def wall(name, gap, speed, acceleration, limit):
    """Contact of a centre with a line: f = free distance, as a polynomial."""
    gap, speed, acceleration = float(gap), float(speed), float(acceleration)
    f = [mp.mpf(gap), -mp.mpf(speed), -mp.mpf(acceleration) / 2]
    slope = derivative(f)
    marks = [mp.mpf(0)] + positive_roots(slope)
    kind, time, margins = "miss", None, []
    for i, lo in enumerate(marks):
        hi = marks[i + 1] if i + 1 < len(marks) else None
        probe = (lo + hi) / 2 if hi is not None else 2 * lo + 1
        if value(slope, probe) >= 0:
            continue
        if lo > limit:
            break
        if value(f, lo) <= 0:
            kind, time = ("now" if lo == 0 else "turn"), lo
            margins += [-value(f, lo)] if lo > 0 else []
            break
        if hi is not None and value(f, hi) > 0:
            margins.append(value(f, min(hi, mp.mpf(limit))))
            continue
        end = hi if hi is not None else 1 + max(abs(k / trimmed(f)[-1]) for k in f)
        time = bracketed(trimmed(f), lo, end)
        confirm(f, time, name)
        kind = "hit" if time <= limit else "late"
        if hi is not None:
            margins.append(-value(f, hi))
        break
    walls.append([name, number(gap), number(speed), number(acceleration), number(limit), kind, digits(time)]
                 + [digits(min(margins, default=None), 8)])


between = draw.uniform


def decades(lo, hi):
    return 10.0 ** between(lo, hi)


def direction():
    angle = between(0, 2 * math.pi)
    return [math.cos(angle), math.sin(angle)]


def times(x, v):
    return [x * v[0], x * v[1]]


def plus(*vs):
    return [sum(v[0] for v in vs), sum(v[1] for v in vs)]


def left(n):
    return [-n[1], n[0]]


def vector(size):
    return times(size * draw.random(), direction())


def apart(least, most):
    """A relative position between least and most long."""
    return times(between(least, most), direction())


def aimed(p, speed, miss):
    """A velocity that would pass the other ball at distance `miss` in a straight line."""
    far = math.hypot(*p)
    s = miss / far
    n = times(-1 / far, p)
    return times(speed, plus(times(math.sqrt(1 - s * s), n), times(s, left(n))))


def generic(name, n, length, time):
    speed = length / time
    for _ in range(n):
        D = length * between(0.2, 1)
        p = apart(1.2 * length, 12 * length)
        v = aimed(p, speed * between(0.2, 8), D * between(-1.2, 1.2))
        pair(name, p, v, D, time * decades(-0.5, 1.5), a=vector(speed / time))


def passing(depth, t, speed, a):
    """p and v of a pair whose smallest distance is (1 - depth) D at time t, passing with a speed."""
    n, distance = direction(), between(0.2, 2)
    d, u = times(distance * (1 - depth), n), times(speed, left(n))
    return plus(d, times(-t, u), times(0.5 * t * t, a)), plus(u, times(-t, a)), distance


def depths(each):
    for k in range(2, 16):
        for sign in (1, -1):
            for _ in range(each):
                yield sign * 10.0**-k


def draw_pairs():
    generic("generic", 150, 1.0, 1.0)
    generic("scale 1e-6", 40, 1e-6, 1.0)
    generic("scale 1e6", 40, 1e6, 1.0)
    for _ in range(60):
        generic("scales 1e-30 to 1e30", 1, decades(-30, 30), decades(-20, 20))
    g = 0.2 * 9.81
    for _ in range(150):  # two balls that slide on one cloth
        p, D = apart(0.6, 6), 0.46875
        w = vector(6)
        u = plus(w, times(-1, aimed(p, between(0.5, 12), D * between(-1.2, 1.2))))
        speeds = [math.hypot(*u), math.hypot(*w)]
        a = plus(times(-g / speeds[1], w), times(g / speeds[0], u))
        pair("both sliding", p, plus(w, times(-1, u)), D, min(speeds) / g, a=a)
    for _ in range(150):
        p, speed = apart(0.5, 8), between(0.2, 12)
        aim = plus(times(-1 / math.hypot(*p), p), times(between(-0.3, 0.3), direction()))
        pair("partner at rest", p, times(speed, aim), 0.46875, 1e3, rest=speed * math.hypot(*aim) / g)
    for _ in range(120):
        p = apart(0.5, 8)
        aim = plus(times(-1 / math.hypot(*p), p), times(between(-0.3, 0.3), direction()))
        pair("free", p, times(between(0.2, 12), aim), 0.46875, between(0.5, 20), rest=math.inf)
    for depth in depths(4):
        t = between(0.5, 3)
        p, v, D = passing(depth, t, between(1, 4), [0, 0])
        pair("graze, free", p, v, D, 2 * t, rest=math.inf)
    for depth in depths(4):
        t = between(0.5, 3)
        p, v, D = passing(depth, t, between(1, 4), vector(0.5))
        a = vector(0.5)
        p, v, D = passing(depth, t, between(1, 4), a)
        if math.hypot(*p) > 1.05 * D:
            pair("graze, curved", p, v, D, t + 0.5, a=a)
    for depth in depths(4):  # the closest point shortly before or after the stop
        n, D, g = direction(), between(0.2, 2), between(0.5, 3)
        path, beyond = between(1, 6), between(-0.05, 0.3)
        p = plus(times(D * (1 - depth), n), times(-path, left(n)))
        speed = math.sqrt(2 * g * (path + beyond))
        pair("graze, with a stop near it", p, times(speed, left(n)), D, 1e3, rest=speed / g)
    for depth in depths(3):  # head-on, and stops (1 - b/D is the depth) at contact
        n, D, g = direction(), between(0.2, 2), between(0.5, 3)
        path = between(1, 6)
        speed = math.sqrt(2 * g * path)
        pair("stop at contact, straight", times(-(path + D * (1 - depth)), n), times(speed, n), D, 1e3, rest=speed / g)
        pair("stop at contact, curved", times(-(path + D * (1 - depth)), n), times(speed, n), D, speed / g * 1.5,
             a=times(-g, n))
    for _ in range(120):  # relative speed far below that of the balls
        slow, n, D = decades(-9, -1), direction(), 0.5
        gap = decades(-6, 1)
        v = times(-slow, plus(n, times(between(-0.5, 0.5), left(n))))
        pair("catch-up", times(D + gap, n), v, D, between(0.5, 4) * gap / slow, a=vector(slow * slow))
    for k in [8, 10, 12, 16, 24, 32, 48, 64, 96, 120, 140, 150, 160, 180, 220, 260, 290, 300]:
        for _ in range(3):
            slow, n, D, gap = 10.0**-k * between(1, 5), direction(), 0.5, between(0.01, 3)
            v = times(-slow, plus(n, times(between(-0.02, 0.02), left(n))))
            limit = min(between(0.7, 4) * gap / slow, 1e300)
            pair("residual speed, free", times(D + gap, n), v, D, limit, rest=math.inf)
            a = vector(slow / limit)
            pair("residual speed, curved", times(D + gap, n), v, D, limit, a=a)
    for k in [1, 2, 3, 4, 5, 6, 7, 7.4, 7.8, 8, 9, 12, 16, 32, 64, 100]:  # what is left of the speed at contact
        for _ in range(4):
            n, D, g = direction(), between(0.2, 2), between(0.5, 3)
            path, rest_speed = between(0.5, 4), 10.0**-k
            speed = math.sqrt(2 * g * path + rest_speed**2)
            p, v = times(-(path + D), n), times(speed, n)
            pair("residual speed at contact", p, v, D, 1e3, rest=speed / g)
    for _ in range(100):
        p = apart(0.6, 8)
        aim = plus(times(-1 / math.hypot(*p), p), times(between(-0.2, 0.2), direction()))
        pair("no acceleration", p, times(between(0.2, 12), aim), between(0.2, 0.6), between(0.5, 20), a=[0.0, 0.0])
    for _ in range(100):
        p = apart(0.6, 8)
        aim = plus(times(-1 / math.hypot(*p), p), times(between(-0.2, 0.2), direction()))
        tiny = decades(-16, -6) if draw.random() < 0.7 else decades(-300, -16)
        pair("nearly no acceleration", p, times(between(0.2, 12), aim), between(0.2, 0.6), between(0.5, 20), a=vector(tiny))
    for _ in range(60):
        n, D = direction(), between(0.2, 2)
        v = times(-decades(-5, 1), plus(n, times(between(-0.5, 0.5), left(n))))
        pair("touching, approaching", times(D, n), v, D, 5.0, a=vector(2))
    for _ in range(80):
        n, D, out, inward = direction(), between(0.2, 2), decades(-2, 1), decades(-1, 1)
        v = times(out, plus(n, times(between(-0.3, 0.3), left(n))))
        pair("touching, receding, back", times(D, n), v, D, 4 * out / inward, a=times(-inward, n))
    for _ in range(60):
        n, D, out, inward = direction(), between(0.2, 2), decades(-2, 1), decades(-1, 1)
        pair("receding, turning inward", times(D + decades(-6, 0), n), times(out, n), D, 6 * out / inward,
             a=plus(times(-inward, n), vector(0.02 * inward)))
    for _ in range(60):
        n, D, inward = direction(), between(0.5, 2), decades(-1, 1)
        deep = D * decades(-6, -0.5)
        out = math.sqrt(2 * inward * deep) * between(0.2, 1.5)
        pair("overlapping, turning inward", times(D - deep, n), times(out, n), D, 6 * out / inward,
             a=plus(times(-inward, n), vector(0.02 * inward)))
    for depth in depths(3):  # there and back past the other ball: two minima of almost the same distance
        n, D, acceleration = direction(), between(0.2, 2), between(0.5, 3)
        far = between(3, 6) * D
        side, t = left(n), math.sqrt(2 * far / acceleration)
        sink = decades(-9, -2) * draw.choice([1, -1])
        p = plus(times(D * (1 - depth), n), times(far, side))
        v = plus(times(-2 * acceleration * t * 0.7071067811865476, side), times(-sink * D / t, n))
        p = plus(p, times(sink * D * 0.5857864376269049, n))
        pair("two minima", p, v, D, 4 * t, a=times(acceleration, side))
    for _ in range(110):  # f, f' and f'' nearly vanish together
        n, D, u = direction(), between(0.2, 2), between(0.5, 4)
        t, small = between(0.3, 1.2) * D / u, decades(-8, -1)
        a = plus(times(-u * u / D * (1 + between(-1, 1) * small), n), times(between(-1, 1) * u * u / D, left(n)))
        d, w = times(D, n), plus(times(u, left(n)), times(-u * small * draw.choice([1, 0.1, 0.01]), n))
        p, v = plus(d, times(-t, w), times(0.5 * t * t, a)), plus(w, times(-t, a))
        if math.hypot(*p) > 1.01 * D:
            pair("nearly a triple root", p, v, D, 2 * t, a=a)
    for k in range(2, 16):
        for sign in (1, -1):
            for straight in (True, False):
                while True:  # a hit first, then the limit beside it
                    p = apart(0.6, 6)
                    v = times(between(2, 9) / math.hypot(*p), plus(times(-1, p), vector(0.2)))
                    motion = {"rest": math.hypot(*v) / g} if straight else {"a": vector(2)}
                    kind, time = pair("limit beside the contact", p, v, 0.46875, 1e3, **motion)
                    pairs.pop()
                    if kind == "hit":
                        break
                pair("limit beside the contact", p, v, 0.46875, float(time * (1 + sign * mp.mpf(10) ** -k)), **motion)
    for _ in range(80):
        D, far = between(0.2, 1), decades(3, 8)
        p = times(far, direction())
        v = times(decades(0, 6) / far, plus(times(-1, p), vector(1.2 * D)))
        pair("very distant", p, v, D, 3 * far / math.hypot(*v), a=vector(0.1 * D * math.hypot(*v) ** 2 / far**2))
    for _ in range(80):
        p = apart(0.6, 8)
        v = times(1e6 * between(0.5, 2) / math.hypot(*p), plus(times(-1, p), vector(1)))
        pair("very fast", p, v, 0.46875, 1e-3, a=vector(4))
        pair("very fast, straight", p, v, 0.46875, 1e6, rest=math.hypot(*v) / g)
    for _ in range(80):  # a table 1e8 away: positions are good to 1e-8 and no better
        p = [round(x * 2**26) / 2**26 for x in apart(0.6, 8)]
        v = times(between(0.5, 9) / math.hypot(*p), plus(times(-1, p), vector(1)))
        pair("table 1e8 away", p, v, 0.46875, 20.0, a=vector(2), extent=1e8)


def draw_walls():
    for _ in range(100):
        wall("generic", between(0.01, 9), between(-6, 9), between(-3, 3), between(0.5, 20))
    for _ in range(60):
        length, time = decades(-30, 30), decades(-20, 20)
        wall("scales 1e-30 to 1e30", length * between(0.01, 9), length / time * between(-6, 9),
             length / time**2 * between(-3, 3), time * between(0.5, 20))
    for depth in depths(4):  # it stops at the line, but for `depth` of its way
        way, g = between(0.3, 6), between(0.5, 3)
        speed = math.sqrt(2 * g * way)
        wall("stop at the line", way * (1 - depth), speed, -g, 3 * speed / g)
    for _ in range(60):
        gap = between(0.01, 5)
        wall("constant velocity", gap, decades(-8, 6), 0.0, 1e9)
        wall("nearly constant velocity", gap, between(1, 5), decades(-300, -10) * draw.choice([1, -1]), 20.0)
    for k in [8, 16, 32, 64, 100, 150, 160, 200, 250, 300]:
        for _ in range(3):
            slow, gap = 10.0**-k * between(1, 5), between(0.01, 3)
            wall("residual speed", gap, slow, 0.0, min(between(0.7, 4) * gap / slow, 1e300))
    for _ in range(40):
        wall("at the line, outward", 0.0, decades(-6, 3), between(-2, 2), 5.0)
        wall("at the line, inward, back", 0.0, -decades(-2, 1), decades(-1, 1), 200.0)
        wall("beyond the line, inward, back", -decades(-6, 0), -decades(-2, 1), decades(-1, 1), 200.0)
        wall("beyond the line, outward", -decades(-6, 0), decades(-2, 1), between(-2, 2), 5.0)
    for k in range(2, 16):
        for sign in (1, -1):
            gap, speed, g = between(0.1, 3), between(4, 9), between(-2, 2)
            square = mp.mpf(speed) ** 2 + 2 * mp.mpf(g) * mp.mpf(gap)
            time = 2 * mp.mpf(gap) / (mp.mpf(speed) + mp.sqrt(square))
            wall("limit beside the contact", gap, speed, g, float(time * (1 + sign * mp.mpf(10) ** -k)))


def write(name, columns, rows):
    path = os.path.join(HERE, name)
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(rows)
    print(f"{name}: {len(rows)} rows, {os.path.getsize(path)} bytes")


if __name__ == "__main__":
    draw_pairs()
    draw_walls()
    write("contact_roots.csv", ["class", "px", "py", "vx", "vy", "ax", "ay", "rest", "distance", "limit", "extent"]
          + ["kind", "time", "margin"], pairs)
    write("wall_crossings.csv", ["class", "gap", "speed", "acceleration", "limit", "kind", "time", "margin"], walls)
