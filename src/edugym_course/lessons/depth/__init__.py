"""The depth of credit assignment (lesson 3)."""
