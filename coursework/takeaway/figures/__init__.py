"""The drawings of a page as files: pictures, and DXF for a drawing office."""
