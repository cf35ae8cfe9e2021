"""YAML as this language sees it: nodes with their places, and the specs that a spec extends."""
