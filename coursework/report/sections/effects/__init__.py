"""What forces do, on the page: the data of masses and loads, the plans and rows of forces, the motion that forces make."""
