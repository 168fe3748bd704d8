#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""slurm_sweep.py SHERD: runs a study on a temporary Slurm cluster on this machine, as this user.

Cancels a task and restarts the controller while the study runs, then submits the rest. The table must be that of a
sweep without Slurm. Exit code 77: Slurm is not installed or may not be started.
"""
import csv
import getpass
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time

SQUARE = "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0.02\nv 0 0.1 0\nf 1 2 3\nf 1 3 4\n"
SCENE = """duration = 1
[sheet.plate]
mesh = "square.obj"
place = { translate = [0, 0, 0.001] }
material = { preset = "stoneware" }
[obstacle.floor]
plane = {}
[solver]
step = 1e-3
[output]
every = 0.1
checkpoint = 0.1
"""
STUDY = """scene = "tiny.toml"
[parameters]
speed = { set = "sheet.plate.velocity=[0, 0, -{}]", from = 1, to = 5, steps = 12 }
"""
CONFIGURATION = """ClusterName=sherd
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
KillWait=5
SchedulerParameters=sched_interval=1,batch_sched_delay=0
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=4000 State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""
PATIENCE = 300  # s


def skip(why):
    print("skipped:", why)
    sys.exit(77)


def program(name):
    return shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_until(true, what):
    end = time.monotonic() + PATIENCE
    while not true():
        assert time.monotonic() < end, "waited too long until " + what
        time.sleep(0.1)


class Cluster:
    """The daemons munged, slurmctld and slurmd, with all their files in a folder."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = {}
        for name in ("state", "spool"):
            (folder / name).mkdir()
        (folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], user=getpass.getuser(), folder=folder, port=free_port(),
            node_port=free_port()))
        os.environ["SLURM_CONF"] = str(folder / "slurm.conf")
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self.start("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket",
                   f"--pid-file={folder}/munge.pid", f"--log-file={folder}/munge.log", f"--seed-file={folder}/seed")
        self.start_controller()
        self.start("slurmd", "-D")

    def start(self, name, *arguments):
        with open(self.folder / (name + ".out"), "ab") as out:
            self.daemons[name] = subprocess.Popen([program(name), *arguments], stdout=out, stderr=out)

    def start_controller(self):
        self.start("slurmctld", "-D")

    def saved_at(self):
        """Returns the time (s since 1970) at which the controller last saved the state of jobs."""
        return (self.folder / "state" / "job_state").stat().st_mtime

    def kill_controller(self):
        self.daemons["slurmctld"].kill()
        self.daemons["slurmctld"].wait()

    def is_idle(self):
        """Returns whether the node accepts jobs and has none."""
        state = subprocess.run(["sinfo", "--noheader", "--format", "%T"], capture_output=True, text=True).stdout
        return state.strip() == "idle"

    def comes_up(self):
        end = time.monotonic() + 30
        while time.monotonic() < end and all(daemon.poll() is None for daemon in self.daemons.values()):
            if self.is_idle():
                return True
            time.sleep(0.2)
        return False

    def end(self):
        subprocess.run(["scancel", "--user", getpass.getuser()], capture_output=True)
        for name in ("slurmd", "slurmctld", "munged"):
            self.daemons[name].terminate()
            try:
                self.daemons[name].wait(timeout=20)
            except subprocess.TimeoutExpired:
                self.daemons[name].kill()
                self.daemons[name].wait()


def queue():
    """Returns the states of the tasks of all jobs that have not ended; None while the controller does not answer."""
    asked = subprocess.run(["squeue", "--noheader", "--array", "--format", "%F_%K %T"], capture_output=True, text=True)
    if asked.returncode != 0:
        return None
    tasks = dict(line.split() for line in asked.stdout.splitlines())
    return {task: state for task, state in tasks.items() if state != "COMPLETING"}


def table(folder):
    """Returns the rows of a study without their times."""
    with open(folder / "study.csv", newline="") as file:
        return [{key: value for key, value in row.items() if not key.endswith("_seconds")}
                for row in csv.DictReader(file)]


def results(folder):
    return sum(file.read_text().count("\n") for file in (folder / "rows").glob("*.jsonl"))


def try_sweep(sherd, folder, cluster):
    def sweep(*arguments, into="study", expected=0):
        done = subprocess.run([sherd, "sweep", "study.toml", "-o", into, *arguments], cwd=folder, capture_output=True,
                              text=True)
        assert done.returncode == expected, (done.returncode, done.stdout, done.stderr)
        return done.stdout + done.stderr

    for name, text in (("square.obj", SQUARE), ("tiny.toml", SCENE), ("study.toml", STUDY)):
        (folder / name).write_text(text)
    sweep(into="local")
    study = folder / "study"

    words = sweep("--slurm", "--chunk", "3", "--partition", "test")
    assert "4 tasks of 3 rows each, 12 rows to run" in words, words
    script = (study / "slurm" / "job.sh").read_text()
    assert "#SBATCH --array=0-3\n" in script and "#SBATCH --time=" in script and "#SBATCH --mem=" in script, script
    for again in ((), ("--slurm",)):
        assert "still in the queue" in sweep(*again, expected=2)
    wait_until(lambda: results(study) >= 1, "a row is done")

    running = []

    def something_runs():
        running[:] = [task for task, state in (queue() or {}).items() if state == "RUNNING"]
        return running

    wait_until(something_runs, "a task runs")
    subprocess.run(["scancel", running[0]], check=True)
    cancelled = time.time()
    wait_until(lambda: running[0] not in (queue() or running), "the task is cancelled")
    # A controller that started without this state would restart the task.
    wait_until(lambda: cluster.saved_at() > cancelled, "the controller has saved its state")
    cluster.kill_controller()
    assert "rows         12:" in sweep("--status"), "the rows are told without a controller, too"
    cluster.start_controller()
    wait_until(lambda: queue() is not None, "the controller is back")
    wait_until(lambda: queue() == {}, "the job is over")
    assert results(study) < 12, "the cancelled task was over before anything could happen to it"

    again = sweep("--slurm", "--chunk", "3")
    assert "1 tasks of 3 rows each" in again, again
    wait_until(lambda: queue() == {}, "the rest is over")
    words = sweep("--status")
    logs = "".join(file.read_text() for file in sorted((study / "slurm").glob("*.log")))
    assert "12 done, 0 failed, 0 to run" in words, words + logs
    assert "no row is left to run" in sweep("--slurm")
    sweep("--collect")
    assert table(study) == table(folder / "local")
    assert results(study) == 12, "a row that was done has been run again"


def main():
    missing = [name for name in ("munged", "slurmctld", "slurmd", "sbatch", "squeue") if not program(name)]
    if missing:
        skip(f"{', '.join(missing)} are not installed (packages slurm-wlm and munge)")
    with tempfile.TemporaryDirectory(prefix="sherd-test-") as name:
        folder = pathlib.Path(name)
        folder.chmod(0o755)  # munge requires that all users can reach its socket
        cluster = Cluster(folder)
        try:
            if not cluster.comes_up():
                for log in folder.glob("*.out"):
                    print(f"{log.name}: {log.read_text(errors='replace')[-1000:]}")
                skip("Slurm cannot be started here")
            try_sweep(os.path.abspath(sys.argv[1]), folder, cluster)
        except BaseException:
            for log in ("slurmctld.log", "slurmd.log"):
                print(f"{log}: {(folder / log).read_text(errors='replace')[-3000:]}")
            raise
        finally:
            cluster.end()


if __name__ == "__main__":
    main()
