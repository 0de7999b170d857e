package nephele.engine.sim.state;

import java.util.List;
import nephele.engine.portal.placement.ShotAids;

/**
 * The settings that a replay depends on besides the level.
 *
 * @param assists stored without duplicates, in the order of the enum
 * @param uprightDegreesPerSecond the rate at which the view turns upright after a portal has left it tilted. It affects
 *     the simulation and not only the picture, as shots follow the view. The body turns at its own rate, as room allows
 */
public record SimSettings(int ticksPerSecond, List<Assist> assists, int uprightDegreesPerSecond) {
    public static final int LEAST_TICKS_PER_SECOND = 10;
    public static final int MOST_TICKS_PER_SECOND = 1000;
    public static final int DEFAULT_UPRIGHT_DEGREES_PER_SECOND = 360;
    public static final int LEAST_UPRIGHT_DEGREES_PER_SECOND = 10;
    /** Half a turn within one tick, at every tick rate. */
    public static final int INSTANT_UPRIGHT_DEGREES_PER_SECOND = 180 * MOST_TICKS_PER_SECOND;

    /** Greatest height above a floor from which {@link Assist#PORTAL_TO_FLOOR} slides a portal down. */
    private static final double DROP_METRES = 0.8;

    /** Greatest angle by which {@link Assist#PORTAL_TURN} turns a portal. */
    private static final double TURN_RADIANS = Math.toRadians(15);

    public static final SimSettings DEFAULT = new SimSettings(120, List.of());

    /** @throws IllegalArgumentException if a rate is out of range */
    public SimSettings {
        if (ticksPerSecond < LEAST_TICKS_PER_SECOND || ticksPerSecond > MOST_TICKS_PER_SECOND) {
            throw new IllegalArgumentException("ticks per second must be " + LEAST_TICKS_PER_SECOND + " to "
                    + MOST_TICKS_PER_SECOND + ", not " + ticksPerSecond);
        }
        if (uprightDegreesPerSecond < LEAST_UPRIGHT_DEGREES_PER_SECOND
                || uprightDegreesPerSecond > INSTANT_UPRIGHT_DEGREES_PER_SECOND) {
            throw new IllegalArgumentException("degrees per second upright must be " + LEAST_UPRIGHT_DEGREES_PER_SECOND
                    + " to " + INSTANT_UPRIGHT_DEGREES_PER_SECOND + ", not " + uprightDegreesPerSecond);
        }
        assists = assists.stream().distinct().sorted().toList();
    }

    /** Creates settings in which the view turns upright at the same rate as the body. */
    public SimSettings(int ticksPerSecond, List<Assist> assists) {
        this(ticksPerSecond, assists, DEFAULT_UPRIGHT_DEGREES_PER_SECOND);
    }

    /** Returns the aids of shots among the assists. */
    public ShotAids shotAids() {
        return new ShotAids(
                assists.contains(Assist.PORTAL_TO_FLOOR) ? DROP_METRES : 0,
                PlayerDimensions.MIN_GROUND_NORMAL_Y,
                assists.contains(Assist.PORTAL_TURN) ? TURN_RADIANS : 0);
    }

    /** Returns these settings with another tick rate. */
    public SimSettings withTicksPerSecond(int changed) {
        return new SimSettings(changed, assists, uprightDegreesPerSecond);
    }

    /** Returns these settings with another rate at which the view turns upright. */
    public SimSettings withUprightDegreesPerSecond(int changed) {
        return new SimSettings(ticksPerSecond, assists, changed);
    }
}
