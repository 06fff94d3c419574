"""`python -m fembearing`, where the script is not on the path."""

from fembearing.cli import main

if __name__ == "__main__":
    main()
