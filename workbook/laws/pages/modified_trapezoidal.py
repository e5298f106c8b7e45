"""Modified trapezoidal acceleration with seven durations."""

from engine.laws.modified_trapezoidal import ModifiedTrapezoidal
from workbook.laws.brief import BRIEF
from workbook.laws.edged import FLAT, SINE_IN, SINE_OUT, Stage, Stages, edged
from workbook.laws.seven import DURATIONS, LASTS, SUM_IS_1, SevenDurations

FORMS = {1: SINE_OUT, 2: FLAT, 3: SINE_IN, 4: None, 5: SINE_IN, 6: FLAT, 7: SINE_OUT}
STAGES = Stages({k: Stage(form, "") for k, form in FORMS.items()}, entered=True)

PAGE = edged(
    STAGES,
    title="Modified trapezoidal acceleration",
    source="S1, seven parameters; S3, figure 2",
    entries=SevenDurations,
    made=lambda entered: ModifiedTrapezoidal(entered.durations),
    parameters=DURATIONS,
    variations=(
        {"durations": [0.1, 0.2, 0.15, 0.05, 0.12, 0.25, 0.13]},
        {"durations": [0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0]},
        {"durations": [0.3, 0.0, 0.25, 0.1, 0.15, 0.0, 0.2]},
        {"durations": [0.0, 0.2, 0.2, 0.0, 0.25, 0.35, 0.0]},
        {"durations": [0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1]},
        {"durations": [0.15, 0.1, 0.0, 0.2, 0.0, 0.3, 0.25]},
    ),
    checks=(SUM_IS_1, LASTS, BRIEF),
)
