"""What averaging was measured to be worth: in goes an answer, out comes how far to trust it."""
