"""The power of a drive over its stretches in cells: its extremes, and by how much straight lines are off."""

from __future__ import annotations

from engine.machine.powering import PARTS, taylor
from workbook.book.declare import Quantity, calc, result
from workbook.entries.units import KW, shown
from workbook.machines.machine.stretched import Stretched

PAST = "([x{n}]*(({u}-[p{n}])*([z4]-[z0])>0)+(1-[x{n}])*(([p{n}]-[z0])^2<([p{n}]-[z4])^2))"
"""whether a place is past a bend of the torque: of a stretch that does not pass it, all of its places or none"""
SLOPE = "([g1]+{first}*[s1]+{second}*[s2])"
LINE = "([b0]+[g1]*{y}+{first}*[s1]*({y}-[y1])+{second}*[s2]*({y}-[y2]))"
PLACES = ("pwb", "pwe", "pwa", "pwc", "pwk")
"""columns of the power where it can be largest"""
PEAKS = ",".join(f"MAX([@st.{name}])" for name in PLACES), ",".join(f"MIN([@st.{name}])" for name in PLACES)
"""highest and lowest power, of the places where it can be"""


def line(view: Stretched, u: str) -> str:
    """Return the torque in the direction of motion at a place, past its bends too."""
    first, second = (PAST.format(u=u, n=n) for n in "12")
    return LINE.format(y=f"[per]*{view.acceleration(u)}", first=first, second=second)


def power_columns(view: Stretched) -> list[Quantity]:
    """Return the columns of the stretches: the power at ends, where it is largest, where the torque bends; errors."""
    size, of = shown(view.most_power, KW), view.powering

    def end(name: str, words: str, k: int) -> Quantity:
        u, t = (("[ub]", "[tyb]"), ("[ue]", "[tye]"))[k]
        return calc(f"pw{name}", f"power at its {words}", "P", "kW", f"=@kilo*ABS([dir])*{t}*{view.velocity(u)}",
                    of(lambda one: shown(one.ends[k], KW)), scale=size)  # fmt: skip

    def bend(n: int) -> str:
        """The power at a bend: y is known there, and y' by a step of Newton's from a place that nearly is."""
        u, y = f"[p{n}]", f"[y{n}]"
        on = f"([per]*{view.acceleration(u)}-{y})*{view.acceleration(u)}/([per]*{view.jerk(u)}+1-[x{n}])"
        more = "+[s1]*([y2]-[y1])" if n == 2 else ""
        return f"[x{n}]*ABS({view.velocity(u)}-{on})*ABS([b0]+[g1]*{y}{more})"

    return [
        end("b", "begin", 0), end("e", "end", 1),
        *top(view, "a", "0", "z0", "p3"), *top(view, "c", "1", "p3", "z4"),
        calc("pwk", "where the torque bends", "", "kW",
             f"=IF([x1]+[x2]=0,0,(0-[sign])*@kilo*MAX({bend(1)},{bend(2)}))", of(lambda one: shown(one.at_bends, KW),
             0.0),
             scale=size),
        *errors(view),
    ]  # fmt: skip


def top(view: Stretched, name: str, bent: str, low: str, high: str) -> list[Quantity]:
    """Return where the power is largest before the torque passes 0, or behind that (``bent`` 1)."""
    k, part, place = int(bent), f"n{name}", f"u{name}"
    width = f"([{high}]-[{low}])"
    way = "[sign]" if bent == "0" else "(0-[sign])"

    def torque(u: str) -> str:
        return line(view, u) if k else f"([b0]+[g1]*[per]*{view.acceleration(u)})"

    def counted(share: str) -> str:
        u = f"([{low}]+{width}*{share})"
        slope = SLOPE.format(first=PAST.format(u=u, n=1), second=PAST.format(u=u, n=2)) if k else "[g1]"
        rise = f"[dir]*({slope}*[per]*{view.jerk(u)}*{view.velocity(u)}+{torque(u)}*{view.acceleration(u)})"
        return f"MIN({PARTS - 1},SUMPRODUCT(({way}*SIGN{width}*{rise}>@steep)*1))"

    coarse, fine = counted("[fine.at]"), counted(f"([{part}]+[fine.at])/{PARTS}")
    last = view.parts[-1].sides[0]
    return [
        calc(part, "power is largest in part", "", "", f"=IF([on]*ABS([dir])=0,0,{coarse})",
             view.powering(lambda one: one.tops[k].part, 0), format="0",
             source="while the motor drives, or is driven" if k else "up to T = 0"),
        calc(place, "at", "u", "rad",
             f"=IF([on]*ABS([dir])=0,[z0],[{low}]+{width}*([{part}]+({fine}+0.5)/{PARTS})/{PARTS})",
             view.powering(lambda one: one.tops[k].place, last), scale=1.0),
        calc(f"pw{name}", "power there", "P", "kW",
             f"=[on]*(ABS{width}>check_zero)*@kilo*[dir]*{view.velocity(f'[{place}]')}*{torque(f'[{place}]')}",
             view.powering(lambda one: shown(one.tops[k].power, KW), 0.0), scale=shown(view.most_power, KW)),
    ]  # fmt: skip


def errors(view: Stretched) -> list[Quantity]:
    """Return the columns of by how much straight lines between the places of the sheet Power are off at most."""
    of, motion = view.powering, view.driven.axis.motion
    septic = "AND([c6]=0,[c7]=0)" if view.septics else ""

    def most(formula: str, order: int) -> str:
        return f"IF({septic},MAX({formula}),{stays_below(view, order)})" if septic else f"MAX({formula})"

    sharp = ",".join(
        f"ABS({view.jerk(u)})" for u in ("[ub]", "[ue]", "MAX([ub],MIN([ue],IF([c5]=0,[ub],0-[c4]/(5*[c5]))))")
    )
    snap = ",".join(f"ABS(24*[c4]+120*[c5]*[{u}])" for u in ("ub", "ue"))
    slope = "MAX(ABS([g1]),ABS([g1]+[s1]),ABS([g1]+[s1]+[s2]))"
    bend = f"{slope}*ABS([per])*[nm]*@vmax+(2*{slope}*MAX(ABS([yb]),ABS([ye]))+MAX(ABS([tyb]),ABS([tye])))*[jm]"
    broken = "ABS([per])*[jm]*@vmax*([x3]*ABS([g1])*(1-power_efficiency^2)+[x1]*ABS([s1])+[x2]*ABS([s2]))"
    short = "MIN(RADIANS(bus_step),[ue]-[ub])"

    def waves(order: int) -> str:
        return "+".join(f"ABS([A{sine.mark}]*[om{sine.mark}]^{order})" for sine in view.one.pieces.sines)

    return [
        calc("jm", "greatest y'''", "", "", f"=IF([A]=0,{most(sharp, 3)},{waves(3)})",
             of(lambda one: one.sharpest), scale=motion.size(3)),
        calc("nm", "greatest y''''", "", "", f"=IF([A]=0,{most(snap, 4)},{waves(4)})", of(lambda one: one.snap),
             scale=view.most_snap),
        calc("off", "straight lines are off by at most", "", "kW",
             f"=[on]*ABS([dir])*@kilo/power_efficiency*(({bend})*{short}^2/8+{broken}*{short}/4)",
             of(lambda part: shown(view.off(part), KW), 0.0), scale=shown(max(view.most_off, 1e-3), KW)),
    ]  # fmt: skip


def stays_below(view: Stretched, order: int) -> str:
    """Return the formula of what a derivative of a polynomial stays below: Taylor's series from the middle."""
    terms = []
    for n in range(order, view.one.pieces.powers):
        text = ""
        for m in range(view.one.pieces.powers - 1, n - 1, -1):
            term = f"{taylor(m, n, order)}*[c{m}]"
            text = f"{term}+([ub]+[ue])/2*({text})" if text else term
        terms.append(f"ABS({text})*(([ue]-[ub])/2)^{n - order}")
    return "+".join(terms)


def power_rows(view: Stretched) -> list[Quantity]:
    """Return the rows that the columns refer to."""
    return [
        calc("@turning", "Speed of the motor for y' = 1", "", "rad/s", "=@i*timing_omega*@faster", view.turning),
        calc("@kilo", "… of which Nm make kW", "", "", "=@turning/1000", shown(view.turning, KW)),
        calc("@steep", "No slope has the power up to", "", "",
             "=check_zero*MAX(@tmax,0-@tmin)*@hard/(timing_omega*@faster)^2", view.flat, scale=max(view.flat, 1e-12)),
    ]  # fmt: skip


def power_peaks(view: Stretched, of: tuple[str, str]) -> list[Quantity]:
    """Return the results: highest and lowest power at the motor's shaft, by these formulas."""
    power, size = view.driven.demand.power, shown(view.most_power, KW)
    most, least = of
    return [
        result("@pmax", "Highest power at its shaft", "P_max", "kW", f"=MAX(0,{most})",
               shown(max(0.0, power.highest.value), KW), scale=size,
               source="exact: at ends, bends, and where its slope is 0"),
        result("@pmin", "Lowest: what comes back", "P_min", "kW", f"=MIN(0,{least})",
               shown(min(0.0, power.lowest.value), KW), scale=size),
    ]  # fmt: skip
