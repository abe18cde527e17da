"""What all commands share: how they end, what they write whole, how they show parameters."""
