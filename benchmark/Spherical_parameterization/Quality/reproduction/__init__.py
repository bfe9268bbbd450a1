"""What reproduce_paper.py is made of: the paper's models and values, the experiments, and what they have in common."""
