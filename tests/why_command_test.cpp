// why_command
