"""Losses that no formula here gives: the scene declares them, and the total counts them."""

import numpy as np

from analytic.effects.ledger import Ledger, share_in
from analytic.effects.table import DECLARED, ENTRIES
from analytic.errors import require_non_negative
from analytic.scene import Array


def declared_losses(ledger: Ledger, computed: Array) -> Array | None:
    """(n,) N m, of seals and drag together; settles both. None: nothing is declared.

    computed : (n,) N m, the torque of all that is computed
    Raises InputError for a loss below 0.
    """
    given = {name: getattr(ledger.scene.losses, name) for name in DECLARED}
    known = {f"losses.{name}": value for name, value in given.items() if value is not None}
    require_non_negative(**known)
    declared = ledger.scene.losses.total
    total = computed + (declared or 0.0)
    for name, value in given.items():
        share = None if value is None else share_in(np.full_like(total, value), total)
        lacks = ENTRIES[name].lacks(ledger.scene)
        given_by = "estimated" if name == "seals" and ledger.scene.losses.seals_are_estimated else ENTRIES[name].given
        ledger.settle(name, on=lacks is None, share=share, reason=lacks or given_by)
    return None if declared is None else np.full_like(computed, declared)
