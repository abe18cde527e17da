"""What may be said on the command line: arguments, options, help."""
