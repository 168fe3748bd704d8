# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the colours of sheets on the page of the recording of record_textured.py, in Chromium: every visible face must
have the colour of its file, from the picture, the material, or its vertices.

usage: check_view_look.py PAGE RECORDING.h5 PICTURE
PICTURE: a screenshot to write."""
import pathlib
import sys

import h5py
import numpy as np
from selenium.webdriver.support.ui import Select

from check_view import Page, browser
from record_textured import LOWER, UPPER

# Colours of the pixels at places (m, in the page's coordinates), and the numbers of the fragments there.
PIXELS = """
    const stage = document.getElementById("stage"), copy = document.createElement("canvas");
    [copy.width, copy.height] = [stage.width, stage.height];
    const context = copy.getContext("2d");
    context.drawImage(stage, 0, 0);
    const data = context.getImageData(0, 0, copy.width, copy.height).data;
    return arguments[0].map(place => {
        const seen = new THREE.Vector3(...place).project(camera);
        const x = Math.round((seen.x + 1) / 2 * stage.width), y = Math.round((1 - seen.y) / 2 * stage.height);
        const fragment = fragmentAt({ clientX: (seen.x + 1) / 2 * window.innerWidth,
                                      clientY: (1 - seen.y) / 2 * window.innerHeight });
        return [...data.slice(4 * (y * stage.width + x), 4 * (y * stage.width + x) + 3), fragment];
    });"""
MATERIALS = {"glaze": None, "clay": (218, 170, 124), "lost": (89, 203, 89)}  # Kd as a screen shows it


def expected_colours(frame):
    """Returns the colours of the middles of faces, [F, 3], 0 to 255."""
    rest = frame["rest"]
    names = rest["surface_material_names"].asstr()[:]
    height = rest["texture"][:].reshape(-1, 3, 2)[:, :, 1].mean(axis=1)
    painted = rest["vertex_colour"][:][rest["faces"][:]][:, :, :3].mean(axis=1)
    def colour(face, row):
        if row < 0:
            return painted[face]
        return MATERIALS[names[row]] or (UPPER if height[face] > 0.5 else LOWER)
    return np.array([colour(face, row) for face, row in enumerate(rest["surface_material"][:])])


def tone(colours):
    """Returns colours without their brightness, which depends on the light."""
    return colours / np.linalg.norm(colours, axis=1, keepdims=True)


def check_frame(page, frame, shift):
    middles = frame["vertex/position"][:][frame["face/vertices"][:]].mean(axis=1) + shift
    pixels = np.array(page.driver.execute_script(PIXELS, middles.tolist()), dtype=float)
    seen = pixels[:, 3] == frame["face/fragment"][:]  # other faces are hidden by a fragment
    assert seen.mean() > 0.9, f"{seen.mean():.0%} of the faces are seen"
    right = np.abs(tone(pixels[:, :3]) - tone(expected_colours(frame))).max(axis=1) < 0.05
    assert right[seen].mean() > 0.98, f"{right[seen].mean():.0%} of the faces have their colours"
    return right[seen].mean()


def broken_triangles(page):
    return page.driver.execute_script("""
        return surface.geometry.groups.filter(group => group.materialIndex == paint.broken)
                                      .reduce((sum, group) => sum + group.count / 3, 0);""")


def main(file, recording, picture):
    driver = browser()
    try:
        page = Page(driver, pathlib.Path(file))
        page.wait_for(lambda: page.shown("pictures") == 1)
        assert Select(page.element("colour")).first_selected_option.text == "material"
        first = np.array(driver.execute_script("return Array.from(playback.at(0).place.slice(0, 3));"))
        with h5py.File(recording) as run:
            frames = [run["frames"][name] for name in sorted(run["frames"])]
            shift = first - frames[0]["vertex/position"][0]
            for number in [*range(len(frames)), 0]:
                driver.execute_script("showMoment(arguments[0])", number)
                thick = check_frame(page, frames[number], shift)
                broken = broken_triangles(page)
                assert (broken > 0) == (frames[number]["face/fragment"][:].max() > 1), broken
                page.element("thick").click()
                check_frame(page, frames[number], shift)
                page.element("thick").click()
            driver.execute_script("showMoment(arguments[0])", len(frames) - 1.5)
            assert page.shown("triangles") > 2 * page.shown("faces")
        driver.save_screenshot(picture)
        painted = page.picture()
        Select(page.element("colour")).select_by_visible_text("fragment")
        assert page.picture() != painted
        Select(page.element("colour")).select_by_visible_text("material")
        assert page.picture() == painted
        errors = [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"]
        assert not errors, errors
    finally:
        driver.quit()
    print(f"{thick:.0%} of the faces that are seen have their colours")


main(*sys.argv[1:])
