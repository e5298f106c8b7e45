"""A load that follows the angle of its axis, in cells: a slide on a crank, the weight of a swinging arm."""

from workbook.book.declare import Quantity, check
from workbook.book.sentence import amount, quoted
from workbook.entries.phase import TURN
from workbook.entries.units import shown
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.linkages import SHORT
from workbook.machines.machine.drive.mechanisms.crank_slider import FITS, HOLDS
from workbook.machines.machine.drive.view import DriveView

NEAR = 1e-9
"""of a turn, and of the sheet's check_zero: how near to whole turns a cycle must end"""


def resisting(view: DriveView) -> tuple[str, str]:
    """Return the formula of what resists without inertia, at the axis, and its equation."""
    steady, friction = "INDEX([@iv.steady],[iv])", "INDEX([@iv.friction],[iv])"
    if view.slides:
        return f"=[dx]*{steady}+[dir]*ABS([dx])*{friction}", "dx/dψ F_r, without inertia"
    arm = "+@arm*COS([y]+RADIANS(@arm_angle))" if view.driven.by_angle else ""
    return f"={steady}+[dir]*{friction}{arm}", "without inertia"


def driving(view: DriveView) -> tuple[str, str]:
    """Return the formula of what drives the load, at its axis, and its equation."""
    resists = f"+@viscous*{'[vs]' if view.slides else '[v]'}" if view.driven.entered.load.viscous is not None else ""
    if view.slides:
        return f"=[R]+[dx]*(@m*[as]{resists})", "F_r + dx/dψ m ẍ"
    return f"=[R]+@m*[a]{resists}", "F_r + m ÿ"


def ends_in_place(driven: Driven) -> bool:
    """Return whether a cycle ends at the angle where it begins: after whole turns, or none."""
    turns = shown(driven.axis.motion.lifts_sum, driven.axis.unit) / TURN
    return abs(turns - round(turns)) <= NEAR


def checks(view: DriveView) -> list[Quantity]:
    """Return the checks that a cycle ends in the angle in which it begins, and that a crank can turn round."""
    driven, i = view.driven, view.driven.number
    if driven.by_angle is None:
        return []
    cell, travel = f"[axes.travel.{i}]", shown(driven.axis.motion.lifts_sum, driven.axis.unit)
    whole = check("@ok_turns", f"{driven.called}: a cycle ends at the angle where it begins",
                  f"ABS({cell}/360-ROUND({cell}/360,0))<=check_zero", ends_in_place(driven),
                  "whole turns, or none", says=amount(cell, travel, "it ends ", " ° from where it begins"))  # fmt: skip
    fits = check("@ok_linked", f"{driven.called}: the sizes of the mechanism go together", FITS, True, HOLDS,
                 f":linked{i}", quoted(SHORT))  # fmt: skip
    return [fits, whole] if view.slides else [whole]
