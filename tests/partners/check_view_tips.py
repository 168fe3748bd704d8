# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays the page of a recording with crack tips in Chromium: tips must be where they were recorded, be described when
the pointer is on them, and can be switched off.

usage: check_view_tips.py PAGE RECORDING.h5"""
import pathlib
import sys

import h5py
import numpy as np
from selenium.webdriver.common.action_chains import ActionChains

from check_view import Page, browser

# Place of a tip in the picture, pixels from its centre.
SEEN = """
    const tip = shownTips()[arguments[0]], seen = new THREE.Vector3(tip.x, tip.y, tip.z).project(camera);
    return [seen.x * window.innerWidth / 2, -seen.y * window.innerHeight / 2];"""


def check_places(page, run):
    """Checks the tips of all frames; the page's positions differ from the recorded ones by a constant shift. Returns
    the last frame with tips."""
    tips, shifts, last = run["tips"], [], None
    for number, name in enumerate(sorted(run["frames"])):
        rows = np.flatnonzero(tips["step"][:] == run["frames"][name].attrs["step"])
        page.driver.execute_script("showMoment(arguments[0])", number)
        shown = page.driver.execute_script("return shownTips()")
        assert page.shown("tips") == len(shown) == len(rows), (number, len(shown), len(rows))
        for tip, row in zip(shown, rows):
            assert tip["number"] == tips["tip"][row]
            assert np.isclose(tip["speed"], tips["speed"][row], rtol=1e-6)
            assert np.isclose(tip["share"], tips["G"][row] / tips["G_c"][row], rtol=1e-6)
            shifts.append(np.array([tip["x"], tip["y"], tip["z"]]) - tips["position"][row])
            last = number
    assert last is not None, "no frame has a tip"
    assert np.ptp(shifts, axis=0).max() < 1e-6, np.ptp(shifts, axis=0)
    return last


def check_pointer(page):
    stage, box = page.element("stage"), page.element("tip")
    x, y = page.driver.execute_script(SEEN, 0)
    def point(dx):
        ActionChains(page.driver).move_to_element_with_offset(stage, x + dx, y).perform()
    assert not box.is_displayed()
    point(3)
    number = page.driver.execute_script("return shownTips()[0].number")
    page.wait_for(box.is_displayed)
    assert box.text.startswith(f"tip {number}: G / G_c = ") and "K_I = " in box.text, box.text
    point(25)
    page.wait_for(lambda: not box.is_displayed())


def check_switch(page):
    with_tips, legend = page.picture(), page.element("legend").text
    assert "crack tips" in legend, legend
    page.element("tipped").click()
    page.wait_for(lambda: page.shown("tips") == 0)
    assert page.picture() != with_tips and "crack tips" not in page.element("legend").text
    page.element("tipped").click()
    page.wait_for(lambda: page.shown("tips") > 0)
    assert page.picture() == with_tips
    page.driver.execute_script("""
        element("explode").value = 40;
        element("explode").dispatchEvent(new Event("input"));""")
    assert page.shown("tips") == 0, "the fragments are somewhere else"


def main(file, recording):
    driver = browser()
    try:
        page = Page(driver, pathlib.Path(file))
        with h5py.File(recording) as run:
            last = check_places(page, run)
        page.driver.execute_script("showMoment(arguments[0])", last)
        check_pointer(page)
        check_switch(page)
        errors = [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"]
        assert not errors, errors
    finally:
        driver.quit()
    print("the page shows the tips where they were")


main(*sys.argv[1:])
