"""Tables of a result, each made once: the terminal and the page render the same one."""
