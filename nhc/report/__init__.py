"""Results as files: tables, pictures, pages."""
