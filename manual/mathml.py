"""Formulas as MathML, which browsers draw without a script: what docutils makes of TeX."""

from __future__ import annotations

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxTranslator


def _inline(self: SphinxTranslator, node: nodes.math) -> None:
    self.body.append(tex2mathml(node.astext(), inline=True))
    raise nodes.SkipNode


def _display(self: SphinxTranslator, node: nodes.math_block) -> None:
    self.body.append(self.starttag(node, "div", CLASS="formula"))
    self.body.append(tex2mathml(node.astext(), inline=False))
    self.body.append("</div>")
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_html_math_renderer("mathml", (_inline, None), (_display, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
