"""`stickslip convert IN OUT.csv`: one joint's record out of a log. What the reader guessed goes to standard error."""
from __future__ import annotations

import argparse
import sys
from pathlib import Path

from .logs import read_log
from .program import BAD_INPUT, StickslipError


def main() -> int:
    parser = argparse.ArgumentParser(prog="stickslip convert", description="A record in CSV from a log: MCAP, ROS 1 bag, Parquet, "
                                     "SAGE folder, BAM JSON, .npz, .mat, HDF5, NetCDF")
    parser.add_argument("log", metavar="IN")
    parser.add_argument("csv", metavar="OUT.csv")
    parser.add_argument("--joint", help="name of the joint, where the log has several")
    parser.add_argument("--topic", help="ROS: topic of the joint states")
    parser.add_argument("--command", help="ROS: topic of the commands")
    parser.add_argument("--time", help="arrays: which one is the time")
    parser.add_argument("--episode", type=int, help="LeRobot: which episode")
    asked = parser.parse_args()
    options = {k: v for k, v in vars(asked).items() if k not in ("log", "csv", "joint") and v is not None}
    try:
        if not asked.csv.endswith((".csv", ".csv.gz")):
            raise StickslipError(f"{asked.csv}: got this as the file to write, expected a name that ends in .csv or .csv.gz")
        try:
            frame = read_log(asked.log, joint=asked.joint, **options)
        except TypeError as error:
            raise StickslipError(f"{asked.log}: logs of this kind take no {', '.join('--' + k for k in options)} ({error})") from None
        Path(asked.csv).parent.mkdir(parents=True, exist_ok=True)
        frame.to_csv(asked.csv, index=False)
    except StickslipError as error:
        print(error, file=sys.stderr)
        return BAD_INPUT
    for guess in frame.attrs.get("guessed", []):
        print(f"guessed: {guess}", file=sys.stderr)
    print(f"{asked.csv}: {len(frame)} rows, columns {', '.join(frame.columns)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
