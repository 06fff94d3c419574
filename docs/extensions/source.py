"""What the source says beside the fields of a class."""

import ast
import inspect
import io
import textwrap
import tokenize


def field_comments(of: type) -> dict[str, str]:
    """What stands beside each field of a class; where nothing does, the comment above it."""
    source = textwrap.dedent(inspect.getsource(of))
    comments, alone = {}, {}
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.COMMENT:
            place = alone if token.line.strip().startswith("#") else comments
            place[token.start[0]] = token.string.lstrip("# ")
    body = ast.parse(source).body[0]
    assert isinstance(body, ast.ClassDef)
    said = {}
    for node in body.body:
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            beside = [comments[line] for line in range(node.lineno, (node.end_lineno or 0) + 1) if line in comments]
            first = node.lineno
            while first - 1 in alone:
                first -= 1
            said[node.target.id] = " ".join(beside or [alone[line] for line in range(first, node.lineno)])
    return said
