"""The lessons' own code, one module a lesson: experiments, claims and figures. `edugym.experiments` finds them here."""
