"""A machine at a rate, told without its master shaft."""

from workbook.fields.units import PER_MINUTE, shown
from workbook.machines.machine.places import to_units


def convert_to_seconds(machine):
    """Return the same machine over a cycle in seconds."""
    cycle = shown(shown(1.0, machine.per_minute), PER_MINUTE)
    data = machine.model_dump() | {"master": {"cycle": cycle}}
    to_units(data, "s", cycle)
    return type(machine).model_validate(data)
