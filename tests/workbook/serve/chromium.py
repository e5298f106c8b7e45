"""The system's Chromium, driven by Playwright, with axe-core; None where this machine has not all of them."""

import shutil

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)

try:
    from axe_playwright_python.sync_playwright import Axe
    from playwright.sync_api import expect, sync_playwright
except ImportError:
    CHROMIUM = Axe = expect = sync_playwright = None

__all__ = ["CHROMIUM", "Axe", "expect", "sync_playwright"]
