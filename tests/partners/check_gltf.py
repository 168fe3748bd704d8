# SPDX-License-Identifier: GPL-3.0-or-later
"""check_gltf.py SHERD RUN.h5 FOLDER FILE.glb...

Validates .glb files with the Khronos glTF validator: the given ones, and exports of RUN.h5, the recording of
record_textured.py, which are made in FOLDER. Errors and warnings are failures. Exit code 77: the validator (npm:
gltf-validator) is not installed."""

import json
import os
import shutil
import subprocess
import sys

VALIDATE = """
const paths = [process.cwd(), ...(process.env.NODE_PATH || '').split(':'), process.argv[1]];
let validator;
try { validator = require(require.resolve('gltf-validator', { paths })); } catch { process.exit(77); }
validator.validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[2])))
    .then((report) => console.log(JSON.stringify(report.issues)));
"""


def export_textured(sherd, recording, folder):
    os.makedirs(folder, exist_ok=True)
    for name, *options in [("rigid",), ("morph", "--animate", "morph"), ("solid", "--solid")]:
        file = os.path.join(folder, name + ".glb")
        subprocess.run([sherd, "export", recording, "--to", "glb", "--force", "-o", file, *options],
                       check=True, stdout=subprocess.DEVNULL)
        yield file


def issues(file):
    npm = subprocess.run(["npm", "root", "-g"], capture_output=True, text=True) if shutil.which("npm") else None
    modules = npm.stdout.strip() if npm else ""
    result = subprocess.run(["node", "-e", VALIDATE, os.path.dirname(modules), file], capture_output=True, text=True)
    if result.returncode == 77:
        print("SKIPPED: gltf-validator is not installed and NOTHING has been validated; "
              "npm install -g gltf-validator installs it")
        sys.exit(77)
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def main():
    sherd, recording, folder, *files = sys.argv[1:]
    for file in [*files, *export_textured(sherd, recording, folder)]:
        found = issues(file)
        serious = [message for message in found["messages"] if message["severity"] < 2]
        assert not serious, f"{file}: {serious}"
        print(f"{os.path.basename(file)}: {found['numErrors']} errors, {found['numWarnings']} warnings")


main()
