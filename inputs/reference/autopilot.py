"""The signal "autopilot" of the reference scene."""


def throttle(time, height, velocity):
    """Share of the largest thrust [-], at a height [m] and a velocity [m/s]."""
    return 0.0 if height < 0.0 else min(max(-0.2 * velocity, 0.0), 1.0)
