# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the obstacle on the page of a recording, in Chromium: it must be drawn at its recorded or interpolated pose.

usage: check_view_obstacles.py PAGE RUN.h5 PICTURE X0,Y0,Z0 X1,Y1,Z1
PAGE: made by sherd view RUN.h5, with a floor and one more obstacle; PICTURE: screenshot to write; X0,Y0,Z0, X1,Y1,Z1:
the obstacle's centre (m) in the first and in the last frame."""
import pathlib
import sys

import h5py
import numpy as np
from selenium.webdriver.common.keys import Keys

from check_view import Page, browser

# The picture's pixel at a point (m) of the recording, and its colour.
PIXEL = """
    const middle = arguments[0].map((x, k) => x - arguments[1][k] + recording.low[k]);
    const seen = new THREE.Vector3(...middle).project(camera), stage = document.getElementById("stage");
    const x = Math.round((seen.x + 1) / 2 * stage.width), y = Math.round((1 - seen.y) / 2 * stage.height);
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [stage.width, stage.height];
    const context = copy.getContext("2d");
    context.drawImage(stage, 0, 0);
    return [x, y, ...context.getImageData(x, y, 1, 1).data];"""


def obstacle_is_at(page, centre):
    """Returns whether the obstacle is seen at a place: whether the pixel changes when the page is drawn without it."""
    place = [float(x) for x in centre.split(",")]
    with_it = page.driver.execute_script(PIXEL, place, page.lowest)
    page.driver.execute_script("obstacles[0].visible = false; draw();")
    without = page.driver.execute_script(PIXEL, place, page.lowest)
    page.driver.execute_script("obstacles[0].visible = true; draw();")
    return with_it != without


def lowest_corner(recording):
    """Returns the lowest corner (m) of the box around the sheets in all frames, which is recording.low on the page."""
    with h5py.File(recording) as file:
        return np.min([frame["vertex/position"][:].min(axis=0) for frame in file["frames"].values()], axis=0).tolist()


def main(file, recording, picture, first, last):
    driver = browser()
    try:
        page = Page(driver, pathlib.Path(file))
        page.lowest = lowest_corner(recording)
        assert page.shown("obstacles") == 1
        assert obstacle_is_at(page, first) and not obstacle_is_at(page, last)
        # Half way from the middle frame to the last.
        between = ",".join(str(0.25 * float(a) + 0.75 * float(b)) for a, b in zip(first.split(","), last.split(",")))
        page.driver.execute_script("showMoment(0.75 * playback.last)")
        assert obstacle_is_at(page, between) and not obstacle_is_at(page, last)
        page.driver.execute_script("showMoment(0.5 * playback.last)")
        assert not obstacle_is_at(page, between)
        while page.shown("frame") < int(page.element("time").get_attribute("max")):
            page.press(Keys.ARROW_RIGHT)
        assert obstacle_is_at(page, last) and not obstacle_is_at(page, first)
        driver.save_screenshot(picture)
    finally:
        driver.quit()
    print("the obstacle goes with the frames")


main(*sys.argv[1:])
