"""`python3 -m stickslip …` and the command `stickslip` of the wheel: the program itself; `convert` also reads logs."""
import os
import sys

from .program import StickslipError, executable


def main() -> None:
    try:
        path = executable()
    except StickslipError as error:
        sys.exit(f"stickslip: {error}")
    os.execv(path, [path, *sys.argv[1:]])


if __name__ == "__main__":
    main()
