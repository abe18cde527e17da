"""What jobs leave behind, and what a person sees of it: records, the table, pictures, progress."""
