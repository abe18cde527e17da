"""What is read: the sections of the report, and the document that they make, as HTML and as Markdown."""
