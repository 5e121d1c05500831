"""Equations as MathML: the reader's browser draws them, without a script, a font or a network."""
from docutils import nodes
from docutils.utils.math import latex2mathml
from sphinx.errors import SphinxError


def mathml(latex, inline):
    """One equation; in a displayed one, lines end in \\\\ and `&` stands where they are aligned."""
    if not inline and "\\\\" in latex:
        latex = "\\begin{align*}" + latex + "\\end{align*}"
    try:
        return latex2mathml.tex2mathml(latex, inline=inline)
    except SyntaxError as error:
        raise SphinxError(f"equation {latex!r}: {error}") from error


def visit_inline(self, node):
    self.body.append(mathml(node.astext(), inline=True))
    raise nodes.SkipNode


def visit_displayed(self, node):
    self.body.append(f'<div class="equation">{mathml(node.astext(), inline=False)}</div>\n')
    raise nodes.SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_displayed, None))
    return {"parallel_read_safe": True}
