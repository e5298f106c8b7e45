"""Print subjects of commits that are too long or do not begin with an imperative.

The first word is taken for an imperative where it begins with a capital and has not the ending of another form.
"""

import re
import subprocess
import sys

SINCE = "d3ac1906"  # those before are as they are; a shallow clone that has it not, has none to look at
LONGEST = 72
SUBJECT = re.compile(r"(?!\w+(?:ing|ed|[^s]s)\b|(?:An?|The|This|We|I|No|Fix(?:es)?:)\b)[A-Z][a-z]+\b.*[^.]")
IMPERATIVE = re.compile(
    r"(?:Bring|String|Ring|Sing|Swing|Fling|Cling|Sling|Spring|Ping|Feed|Need|Embed|Seed|Shed|Speed|Bias|Focus)\b"
)


def fault_of(subject: str) -> str:
    """Return what is wrong with a subject, or nothing."""
    if len(subject) > LONGEST:
        return f"{len(subject)} characters; at most {LONGEST} are expected"
    is_fine = IMPERATIVE.match(subject) or SUBJECT.fullmatch(subject)
    return "" if is_fine else "an imperative is expected first (Add, Mend, Say ...), and no full stop at the end"


def git(*arguments: str) -> list[str]:
    """Return the lines that git prints; none where this is no clone."""
    return subprocess.run(["git", *arguments], capture_output=True, text=True).stdout.splitlines()


def main() -> int:
    """Return 1 where a subject is at fault."""
    commits = [line.partition(" ") for line in git("log", "--no-merges", "--format=%h %s", f"{SINCE}..")]
    faults = [f"{commit} {subject!r}: {fault}" for commit, _, subject in commits if (fault := fault_of(subject))]
    print("\n".join(faults) or f"{len(commits)} subjects of commits are imperative and short")
    return int(bool(faults))


if __name__ == "__main__":
    sys.exit(main())
