"""`python -m fembearing.cli`, where the script is not on the path."""

from fembearing.cli import main

main()
