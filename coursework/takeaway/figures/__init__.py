"""The drawings of a page as a person takes them along: pictures, and DXF for a drawing office."""
