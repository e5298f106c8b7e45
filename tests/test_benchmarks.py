"""Each program of benchmarks/ runs to its end, on a case that is small."""

import asyncio
import importlib

import pytest

from tests.tiers import by_day
from tests.workbook.serve.chromium import CHROMIUM
from workbook.templates import TEMPLATES
from workbook.witnesses.engines import libreoffice_path

SMALLEST = {"flying-cutter": TEMPLATES["flying-cutter"]}
SMALL = {
    "any_workbook": {"SIZES": (100,), "CASES": 3},
    "audit": {"FAULTS": 2, "SIZES": (40,)},
    "build": {"ROUNDS": 1, "TEMPLATES": SMALLEST},
    "cam_tables": {"INTERVALS": (8,), "AXES": 1, "POINTS": 20, "ROUNDS": 1, "targets": list},
    "faster": {"NAMES": ("crank-press",), "TRIED": {}},
    "improve": {"ROUNDS": 1, "DEGREES": (7,), "STAGES": {}},
    "laws": {"SAMPLES": 100, "ROUNDS": 1},
    "pycel_speed": {"SIZES": ((4, 4),)},
    "scale": {"COUNTS": (1,), "JOBS": (1,)},
    "serve": {"EDITS": 1, "GOALS": {2: 1.0}, "BUILT": 2},
    "serve_page": {"SIZES": (4,), "ROUNDS": 1, "MOVES": 5, "FILES": 3},
    "study": {},
}


@pytest.fixture
def benchmark(request, monkeypatch):
    """The module of a benchmark, made small."""
    module = importlib.import_module(f"benchmarks.{request.param}")
    for name, value in SMALL[request.param].items():
        assert hasattr(module, name), name
        monkeypatch.setattr(module, name, value)
    return module


@pytest.mark.parametrize("benchmark", by_day(SMALL, "laws", "improve", "cam_tables"), indirect=True)
def test_a_benchmark_runs(benchmark, monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", ["benchmark", "10"])
    name = benchmark.__name__.removeprefix("benchmarks.")
    if name == "scale" and libreoffice_path() is None:
        pytest.skip("LibreOffice is not on this machine")
    if name == "serve_page" and CHROMIUM is None:
        pytest.skip("Chromium is not on this machine")
    if name == "serve":
        asyncio.run(benchmark.main())
        benchmark.pages()
    else:
        benchmark.main(*{"study": [10, 0], "faster": [[]]}.get(name, []))
    assert len(capsys.readouterr().out.splitlines()) > 1
