"""The target languages, one folder each: a printer, templates, and `files`, which fills them; `render` asks all.

In:  `Module`s.
Out: a dict from file name (below `generated/`) to text.
"""
