"""What averaging was measured to be worth. Takes an answer; returns how far to trust it."""
