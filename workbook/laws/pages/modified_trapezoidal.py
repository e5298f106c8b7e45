"""Modified trapezoidal acceleration with seven durations."""

from engine.laws.modified_trapezoidal import ModifiedTrapezoidal
from workbook.laws.edged import FLAT, SINE_IN, SINE_OUT, Stage, edged
from workbook.laws.shared import DURATIONS, LASTING, SevenDurations

PAGE = edged(
    dict(enumerate(map(Stage, (SINE_OUT, FLAT, SINE_IN, None, SINE_IN, FLAT, SINE_OUT)), 1)),
    titled="Modified trapezoidal acceleration",
    source="S1, seven parameters; S3, figure 2",
    entries=SevenDurations,
    law=ModifiedTrapezoidal,
    parameters=DURATIONS,
    variations=(
        {"durations": [0.1, 0.2, 0.15, 0.05, 0.12, 0.25, 0.13]},
        {"durations": [0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0]},
        {"durations": [0.3, 0.0, 0.25, 0.1, 0.15, 0.0, 0.2]},
        {"durations": [0.0, 0.2, 0.2, 0.0, 0.25, 0.35, 0.0]},
        {"durations": [0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1]},
        {"durations": [0.15, 0.1, 0.0, 0.2, 0.0, 0.3, 0.25]},
    ),
    checks=LASTING,
)
