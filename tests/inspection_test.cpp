// inspection
