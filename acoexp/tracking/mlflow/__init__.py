"""MLflow as the store; all that knows of it."""
