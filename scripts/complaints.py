"""The command line and the output that the checks of this folder have in common."""

import sys


def report(complaints, summary):
    """Prints one complaint per line and a summary. Returns the exit status."""
    for complaint in complaints:
        print(complaint)
    print(f"{summary}, {len(complaints)} complaints")
    return 1 if complaints else 0


def run_script(documentation, self_test, main, numbers_of_arguments):
    """Exits with the status of self_test() or main(*arguments). Prints the documentation if the arguments are wrong."""
    arguments = sys.argv[1:]
    if arguments == ["--self-test"]:
        sys.exit(self_test())
    if len(arguments) not in numbers_of_arguments:
        print(documentation)
        sys.exit(2)
    sys.exit(main(*arguments))
