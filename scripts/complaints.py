"""The output that the checks of this folder have in common."""


def report(complaints, summary):
    """Prints one complaint per line and a summary. Returns the exit status."""
    for complaint in complaints:
        print(complaint)
    print(f"{summary}, {len(complaints)} complaints")
    return 1 if complaints else 0
