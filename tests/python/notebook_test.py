"""The notebook, run from its first cell to its last as a reader would; its figure is drawn and its claims hold.

usage: notebook_test.py NOTEBOOK
"""
import base64
import os
import sys
import tempfile

import nbclient
import nbformat

notebook = nbformat.read(sys.argv[1], as_version=4)
nbformat.validate(notebook)
code = [cell for cell in notebook.cells if cell.cell_type == "code"]
assert code and not any(cell.outputs or cell.execution_count for cell in code), "a notebook is stored without output"
os.environ["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"
with tempfile.TemporaryDirectory() as folder:
    os.environ.update(HOME=folder, MPLCONFIGDIR=folder, IPYTHONDIR=folder, JUPYTER_RUNTIME_DIR=folder)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3",
                            resources={"metadata": {"path": folder}}).execute()
    pictures = [output.data["image/png"] for cell in code for output in cell.outputs if "image/png" in output.get("data", {})]
    texts = "".join(output.get("text", "") for cell in code for output in cell.outputs)
print(texts)
assert len(pictures) == 1 and len(base64.b64decode(pictures[0])) > 10_000, "the figure is not drawn"
assert texts.count("restitution") == 5, texts

# That a wrong claim would end it.
notebook.cells[-1].source = notebook.cells[-1].source.replace("errors[0] > 0.02", "errors[0] < -0.02")
with tempfile.TemporaryDirectory() as folder:
    try:
        nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3",
                                resources={"metadata": {"path": folder}}).execute()
    except nbclient.exceptions.CellExecutionError:
        sys.exit(0)
sys.exit("a wrong claim has ended nothing")
