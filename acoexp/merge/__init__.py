"""``python -m acoexp.merge``: finished runs of other stores are brought into one."""
