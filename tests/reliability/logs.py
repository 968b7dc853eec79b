#!/usr/bin/env python3
"""Damaged logs of every format through the Python readers: cut, overwritten, shuffled. A reader gives a record, columns of one length,
finite times that ascend, or refuses in words of its own; any other exception, a hang or a hunger for memory is a finding.

Run: logs.py [LOGS] [SEED] with the package `stickslip` on PYTHONPATH. A log that is found wanting is kept as crash-log-SEED-K.SUFFIX."""
import pathlib
import resource
import shutil
import signal
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests/python")]

import log_samples as sample  # noqa: E402
import numpy  # noqa: E402
import stickslip  # noqa: E402
from test_logs import one_joint_files  # noqa: E402

LONGEST = 20  # s, of one log
MEMORY = 6 * 2**30  # bytes of addresses


def hang(*_):
    raise RuntimeError(f"took more than {LONGEST} s")


def samples(folder):
    """A whole log of every format that can be written here; a folder where the format is one."""
    made = [sample.mcap(folder / "chunks.mcap"), sample.mcap(folder / "plain.mcap", chunked=False), sample.rosbag(folder / "packed.bag"),
            sample.rosbag(folder / "plain.bag", packed=False), sample.bam(folder / "bam.json"), sample.sage(folder / "sage")]
    return [log for log in made if log] + list(one_joint_files(folder))


def damaged(data, random):
    data = bytearray(data)
    for _ in range(int(random.integers(1, 5))):
        at = int(random.integers(0, len(data) + 1))
        length = int(random.integers(1, 64))
        match int(random.integers(0, 6)):
            case 0:
                del data[at:]
            case 1:
                del data[at:at + length]
            case 2:
                data[at:at] = random.bytes(length)
            case 3:
                data[at:at + length] = random.bytes(len(data[at:at + length]))
            case 4:  # most formats keep what matters in front
                at = int(random.integers(0, min(len(data), 2000) + 1))
                data[at:at + 1] = bytes([int(random.integers(0, 256))])[:len(data[at:at + 1])]
            case _:
                data[at:at] = data[:length] if random.integers(0, 2) else b"\xff" * 8
    return bytes(data)


def fault_of(log):
    """What a reader promises and did not keep; nothing where it did."""
    signal.alarm(LONGEST)
    try:
        frame = stickslip.read_log(log, joint="elbow")
    except stickslip.StickslipError as refusal:
        return "" if str(refusal).strip() else "a refusal without words"
    except BaseException as error:  # whatever it is, it is no answer
        return f"{type(error).__name__}: {error}"
    finally:
        signal.alarm(0)
    time = frame["time"].to_numpy()
    if not numpy.isfinite(frame.to_numpy(dtype=float)).all():
        return "a number that is not finite"
    return "" if len(time) and (numpy.diff(time) > 0).all() else "time does not ascend"


def main():
    count, seed = (int(word) for word in (sys.argv[1:] + ["2000", "20261123"][len(sys.argv) - 1:]))
    random = numpy.random.default_rng(seed)
    signal.signal(signal.SIGALRM, hang)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    findings = 0
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        (folder / "whole").mkdir()
        whole = samples(folder / "whole")
        for k in range(count):
            log = whole[k % len(whole)]
            target = folder / log.name
            if log.is_dir():
                shutil.rmtree(target, ignore_errors=True)
                shutil.copytree(log, target)
                part = sorted(target.iterdir())[int(random.integers(0, len(list(target.iterdir()))))]
                part.write_bytes(damaged(part.read_bytes(), random))
            else:
                target.write_bytes(damaged(log.read_bytes(), random))
            fault = fault_of(target)
            if fault:
                findings += 1
                kept = pathlib.Path(f"crash-log-{seed}-{k}{log.suffix}")
                print(f"FINDING {log.name}, damage {k}: {fault}; kept as {kept}", flush=True)
                if target.is_dir():
                    shutil.copytree(target, kept, dirs_exist_ok=True)
                else:
                    shutil.copy(target, kept)
    print(f"{count} damaged logs of {len(whole)} kinds (seed {seed}), findings: {findings}")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
