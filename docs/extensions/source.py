"""What the source says beside the fields of a class."""

import ast
import inspect
import io
import textwrap
import tokenize


def field_comments(of: type) -> dict[str, str]:
    """The comment on the line of each field of a class, by the name of the field."""
    source = textwrap.dedent(inspect.getsource(of))
    comments = {
        token.start[0]: token.string.lstrip("# ")
        for token in tokenize.generate_tokens(io.StringIO(source).readline)
        if token.type == tokenize.COMMENT
    }
    body = ast.parse(source).body[0]
    assert isinstance(body, ast.ClassDef)
    fields = [node for node in body.body if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)]
    said = {}
    for node in fields:
        assert isinstance(node.target, ast.Name)
        last = node.end_lineno or node.lineno
        above = node.lineno - 1 if source.splitlines()[node.lineno - 2].strip().startswith("#") else 0
        lines = (comments.get(line, "") for line in (above, *range(node.lineno, last + 1)))
        said[node.target.id] = " ".join(filter(None, lines))
    return said
