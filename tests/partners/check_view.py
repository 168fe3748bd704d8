# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays the page of a recording in Chromium, without a display or a network, by simulated clicks and keys.

usage: check_view.py PAGE SUMMARY PICTURE
PAGE: made by sherd view; SUMMARY: JSON of the recording's frames (check_recording.py); PICTURE: screenshot to write.
"""
import json
import pathlib
import shutil
import sys

from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

OWN_BYTES_MOST = 1.5e6  # largest size of the page without its data


def browser():
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
                     "--enable-unsafe-swiftshader", "--window-size=1000,700", "--disable-dev-shm-usage",
                     "--host-resolver-rules=MAP * ~NOTFOUND"):  # no network
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=webdriver.chrome.service.Service(shutil.which("chromedriver")), options=options)


class Page:
    def __init__(self, driver, file):
        self.driver = driver
        driver.get(file.resolve().as_uri())
        self.wait_for(lambda: self.shown("frame") == 0)

    def wait_for(self, condition):
        WebDriverWait(self.driver, 60).until(lambda _: condition())

    def shown(self, what):
        value = self.driver.execute_script("return document.body.dataset[arguments[0]]", what)
        return None if value is None else int(value)

    def element(self, name):
        return self.driver.find_element(By.ID, name)

    def picture(self):
        return self.driver.execute_script('return document.getElementById("stage").toDataURL()')

    def press(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def colours(self):
        """Returns the number of different colours in the picture."""
        return self.driver.execute_script("""
            const stage = document.getElementById("stage"), copy = document.createElement("canvas");
            [copy.width, copy.height] = [stage.width, stage.height];
            const context = copy.getContext("2d");
            context.drawImage(stage, 0, 0);
            const data = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
            return new Set(data).size;""")


def check_playing(page, frames):
    page.element("play").click()
    page.wait_for(lambda: page.shown("frame") > 2)
    page.press(Keys.SPACE)
    stopped = page.shown("frame")
    assert stopped <= page.shown("frame") <= stopped + 1
    slider = page.element("time")
    ActionChains(page.driver).click_and_hold(slider).move_by_offset(slider.size["width"] // 2 - 4, 0).release().perform()
    page.wait_for(lambda: page.shown("frame") > len(frames) * 3 // 4)
    while page.shown("frame") < len(frames) - 1:
        page.press(Keys.ARROW_RIGHT)
    assert page.shown("fragments") == frames[-1]["fragments"], page.shown("fragments")
    assert page.shown("faces") == frames[-1]["faces"]
    page.press(Keys.ARROW_LEFT)  # backwards the topology is rebuilt
    assert page.shown("fragments") == frames[-2]["fragments"]
    page.press(Keys.ARROW_RIGHT)


# A quarter of the way between all frames: the largest distance of faces' corners from the straight line between the
# frames (m) and from the earlier frame (m), and whether the fragments are those of the earlier frame.
BETWEEN = """
    const corners = ({ faces, place }) => Array.from(faces, v => [0, 1, 2].map(x => place[3 * v + x])).flat();
    let off = 0, moved = 0, kept = true;
    for (let k = 0; k < playback.last; ++k) {
        const fragments = Array.from(playback.at(k).fragments);
        const [start, end, seen] = [k, k + 1, k + 0.25].map(position => corners(playback.at(position)));
        seen.forEach((x, i) => { off = Math.max(off, Math.abs(x - 0.75 * start[i] - 0.25 * end[i])); });
        seen.forEach((x, i) => { moved = Math.max(moved, Math.abs(x - start[i])); });
        const shown = playback.at(k + 0.25).fragments;
        kept = kept && fragments.every((fragment, f) => shown[f] == fragment);
    }
    return [off, moved, kept];"""


def check_slow_motion(page, frames):
    """Checks that the run of 30 ms plays for 6 s or with the chosen slowdown, in straight lines between frames."""
    off, moved, kept = page.driver.execute_script(BETWEEN)
    assert off < 1e-7 < 1e-5 < moved and kept, (off, moved, kept)

    def time_after(seconds):
        return page.driver.execute_script("return playback.timeAt(positionAfter(0, arguments[0]))", seconds)

    assert page.element("slow").get_attribute("value") == "200"
    for seconds, time in ((0, 0), (1.5, 0.0075), (5.99, 0.02995), (6.3, 0.03), (7.7, 0.005)):
        assert abs(time_after(seconds) - time) < 1e-9, (seconds, time_after(seconds))
    Select(page.element("slow")).select_by_visible_text("1000 times")
    assert abs(time_after(1.5) - 0.0015) < 1e-9
    page.driver.execute_script("showMoment(12.5)")
    assert page.shown("frame") == 12 and page.element("now").text.endswith("frame 12 to 13")
    half = page.picture()
    for key, frame in ((Keys.ARROW_RIGHT, 13), (Keys.ARROW_LEFT, 12)):
        page.press(key)
        assert page.shown("frame") == frame and page.element("now").text.endswith(f"frame {frame}")
        assert page.picture() != half
    while page.shown("frame") < len(frames) - 1:
        page.press(Keys.ARROW_RIGHT)


def check_hiding(page, frames):
    x, y = page.driver.execute_script("""
        // A place on the picture where a fragment is.
        for (let y = 100; y < 600; y += 20)
            for (let x = 100; x < 900; x += 20)
                if (fragmentAt({ clientX: x, clientY: y }) !== null) return [x, y];""")
    stage = page.element("stage").rect
    def click(keys=()):
        chain = ActionChains(page.driver)
        for key in keys:
            chain.key_down(key)
        chain.move_to_element_with_offset(page.element("stage"), x - stage["width"] / 2, y - stage["height"] / 2).click()
        for key in keys:
            chain.key_up(key)
        chain.perform()
    before = page.picture()
    click([Keys.SHIFT])
    page.wait_for(lambda: page.shown("faces") < frames[-1]["faces"])
    alone = page.shown("faces")
    assert page.picture() != before
    page.element("all").click()
    page.wait_for(lambda: page.shown("faces") == frames[-1]["faces"])
    click()
    page.wait_for(lambda: page.shown("faces") == frames[-1]["faces"] - alone)
    page.element("all").click()
    page.wait_for(lambda: page.shown("faces") == frames[-1]["faces"])


def check_thickness(page, frames):
    """Checks that a sheet with its thickness has two sides, and walls along every open edge."""
    thick = page.picture()
    assert page.shown("triangles") > 2 * frames[-1]["faces"], page.shown("triangles")
    page.element("thick").click()
    page.wait_for(lambda: page.shown("triangles") == frames[-1]["faces"])
    assert page.picture() != thick
    page.element("thick").click()
    page.wait_for(lambda: page.shown("triangles") > 2 * frames[-1]["faces"])
    assert page.picture() == thick


# Largest distances in x and y of vertices of visible fragments from the picture's centre, 1 at its edges.
FARTHEST = """
    const place = surface.geometry.getAttribute("position"), shown = new Set(surface.geometry.index.array);
    let farthest = [0, 0];
    for (const v of shown) {
        const seen = new THREE.Vector3().fromBufferAttribute(place, v).project(camera);
        farthest = [Math.max(farthest[0], Math.abs(seen.x)), Math.max(farthest[1], Math.abs(seen.y))];
    }
    return farthest;"""


def check_explosion(page):
    """Checks that all fragments stay in the picture for all positions of the slider, in narrow windows and after
    zooming in, and that the camera returns when the explosion ends."""
    def explode(value):
        page.driver.execute_script("""
            element("explode").value = arguments[0];
            element("explode").dispatchEvent(new Event("input"));""", value)
        return page.driver.execute_script(FARTHEST)
    def camera():
        return page.driver.execute_script("return camera.position.toArray();")
    def drawn_size():
        return page.driver.execute_script("const size = renderer.domElement; return [size.width, size.height];")
    def resize(width, height):
        if (size := page.driver.get_window_size()) == {"width": width, "height": height}:
            return
        old = drawn_size()
        page.driver.set_window_size(width, height)
        page.wait_for(lambda: (drawn_size()[0] - old[0]) * (width - size["width"]) > 0)
    for width, height in ((1000, 700), (500, 900), (1000, 700)):
        resize(width, height)
        before = camera()
        for zoom in (1, 0.4):
            page.driver.execute_script("""
                camera.position.sub(controls.target).multiplyScalar(arguments[0]).add(controls.target);
                controls.update();""", zoom)
            for value in (0, 5, 30, 100) if zoom == 1 else (5, 30, 100):
                right, top = explode(value)
                assert right < 1 and top < 1, (width, zoom, value, right, top)
            assert max(right, top) > 0.5, "the camera is farther away than it need be"
            for key in [Keys.ARROW_LEFT] * 3 + [Keys.ARROW_RIGHT] * 3:
                page.press(key)
                assert max(page.driver.execute_script(FARTHEST)) < 1, "a frame that is not in the picture"
            explode(0)
        page.driver.execute_script("""
            camera.position.sub(controls.target).divideScalar(0.4).add(controls.target);
            controls.update();""")
        assert max(abs(a - b) for a, b in zip(before, camera())) < 1e-6, "the camera does not come back"


def check_bar(page):
    """Checks the colour scale, with unit and ordered ticks, and the caption with the time, which are there only while
    colours stand for numbers."""
    def shown():
        return page.driver.execute_script("""
            const bar = document.getElementById("scale");
            return [bar ? bar.innerText : null, document.getElementById("caption").innerText,
                    bar ? [...bar.querySelectorAll("#map span")].map(tick => tick.getBoundingClientRect().y) : []];""")
    Select(page.element("colour")).select_by_visible_text("strain")
    words, caption, heights = shown()
    assert "strain (1/m)" in words, words
    assert len(heights) >= 3 and all(above - below < -10 for below, above in zip(heights, heights[1:])), heights
    assert caption.startswith("t = ") and "s, step " in caption, caption
    page.press(Keys.ESCAPE)  # closes the list of colours, which would take the arrow keys
    page.driver.execute_script("document.activeElement.blur();")
    page.press(Keys.ARROW_LEFT)
    assert shown()[1] not in ("", caption), "the caption does not go with the frames"
    page.press(Keys.ARROW_RIGHT)
    assert shown()[1] == caption
    for name in ("state", "fragment"):
        Select(page.element("colour")).select_by_visible_text(name)
        assert shown() == [None, "", []], name
    page.driver.execute_script("document.activeElement.blur();")


def check_looks(page):
    seen = {page.picture()}
    for name in ("strain", "state", "fragment"):
        Select(page.element("colour")).select_by_visible_text(name)
        assert page.colours() > 50, f"{name}: an empty picture"
        seen.add(page.picture())
    slider = page.element("explode")
    ActionChains(page.driver).move_to_element(slider).click().perform()
    seen.add(page.picture())
    ActionChains(page.driver).drag_and_drop_by_offset(page.element("stage"), 120, 40).perform()
    seen.add(page.picture())
    assert len(seen) == 5, "a colouring, the explosion or turning the view changes nothing"


def main(file, summary, picture):
    text = file.read_text()
    begin = text.index('<script id="recording"')
    own = len(text) - (text.index("</script>", begin) - begin)
    assert own < OWN_BYTES_MOST, own
    frames = [{"faces": surface["cells"], "fragments": int(surface["cell"]["fragment"][1]) + 1}
              for surface in (frame["surface"] for frame in json.loads(summary.read_text()))]
    driver = browser()
    try:
        page = Page(driver, file)
        check_playing(page, frames)
        check_slow_motion(page, frames)
        check_thickness(page, frames)
        check_hiding(page, frames)
        check_bar(page)
        check_explosion(page)
        check_looks(page)
        driver.save_screenshot(str(picture))
        errors = [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"]
        assert not errors, errors
    finally:
        driver.quit()
    print(f"played {len(frames)} frames; {own} bytes without data")


if __name__ == "__main__":
    main(*map(pathlib.Path, sys.argv[1:]))
