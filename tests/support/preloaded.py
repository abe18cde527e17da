"""All that a command may import, nothing that it says or keeps: where commands are forked from."""

from importlib import import_module
from importlib.metadata import distribution
from pkgutil import walk_packages

import PIL.Image
import sqlalchemy.orm
from numba.core.registry import cpu_target

ONE_BY_ONE = (
    "alembic.command",
    "forked",
    "hydra.experimental.callback",
    "matplotlib.backends.backend_agg",
    "matplotlib.backends.backend_svg",
    "mlflow.store.tracking.sqlalchemy_workspace_store",
    "scipy.ndimage",
    "scipy.stats",
    "sqlalchemy.dialects.sqlite",
)
WHOLE = ("acoexp.command", "acoexp.compare", "hydra._internal.core_plugins", "hydra_plugins.acoexp")

for name in ONE_BY_ONE:
    import_module(name)
for name in WHOLE:
    for module in walk_packages(import_module(name).__path__, f"{name}."):
        import_module(module.name)
for entry in distribution("acoexp").entry_points:
    if entry.group.startswith("acoexp."):
        import_module(entry.module)
PIL.Image.preinit()
sqlalchemy.orm.configure_mappers()
cpu_target.target_context.refresh()
