"""What the checks of this folder have in common: how they tell what they found."""


def report(complaints, summary):
    """prints one complaint per line, and what was looked at; returns the exit status."""
    for complaint in complaints:
        print(complaint)
    print(f"{summary}, {len(complaints)} complaints")
    return 1 if complaints else 0
