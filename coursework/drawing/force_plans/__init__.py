"""Forces on paper: the plan of forces of each group, Zhukovsky's lever, and what a ruler reads off them."""
