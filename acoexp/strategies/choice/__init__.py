"""Choices: which move an ant makes."""
