package nephele.engine.portal;

import java.util.Arrays;
import java.util.function.BiConsumer;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Follows a straight segment through portals: an eye's ray, a camera boom, the path to a held body, an aim, a sound, a
 * ray of light. One tracer for one set of portals, reused for every path; the accessors describe the last one.
 */
public final class PathTrace {
    /** Greatest number of crossings of a path, which ends there: between facing portals it would go on for ever. */
    public static final int MOST_CROSSINGS = 64;

    /** Distance by which a portal takes precedence over the wall around it at the same place. */
    private static final double FLUSH_METRES = 1e-6;

    private static final Vector3dc NO_ACCELERATION = new Vector3d();

    /** The reason for the end of a path. */
    public enum End {
        ARRIVED,
        BLOCKED,
        TOO_MANY_CROSSINGS
    }

    private final Portals portals;
    private final Obstacles obstacles;
    private final PortalCrossing crossing = new PortalCrossing();
    private final Vector3d place = new Vector3d();
    private final Vector3d rest = new Vector3d();
    private final Vector3d piece = new Vector3d();
    private final int[] entered = new int[MOST_CROSSINGS];
    private int crossings;
    private double freeFraction;
    private End end;

    /** Makes a tracer for these portals and obstacles. */
    public PathTrace(Portals portals, Obstacles obstacles) {
        this.portals = portals;
        this.obstacles = obstacles;
    }

    /** Follows the segment from a point along a displacement, through every portal on it, up to the first obstacle. */
    public End trace(Vector3dc from, Vector3dc displacement) {
        return trace(from, displacement, (start, leg) -> {});
    }

    /**
     * Does the same and reports each straight piece before the next one.
     *
     * @param legs receives start and displacement of a piece, in the space that contains it; valid only during the call
     */
    public End trace(Vector3dc from, Vector3dc displacement, BiConsumer<Vector3dc, Vector3dc> legs) {
        place.set(from);
        rest.set(displacement);
        crossings = 0;
        double length = displacement.length();
        double walked = 0;
        end = null;
        while (end == null) {
            double free = obstacles.free(place, rest);
            boolean crosses = crossing.find(portals, place, rest, NO_ACCELERATION, 1);
            double left = 1 - walked;
            if (crosses && crossing.seconds() <= free + FLUSH_METRES / Math.max(length * left, FLUSH_METRES)) {
                walked += left * crossing.seconds();
                legs.accept(place, crossing.place().sub(place, piece));
                enter();
            } else {
                legs.accept(place, rest.mul(free, piece));
                place.fma(free, rest);
                walked += left * free;
                end = free < 1 ? End.BLOCKED : End.ARRIVED;
            }
        }
        freeFraction = walked;
        return end;
    }

    private void enter() {
        if (crossings == MOST_CROSSINGS) {
            place.set(crossing.place());
            end = End.TOO_MANY_CROSSINGS;
            return;
        }
        PortalTransform transform = portals.transform(crossing.portal());
        transform.point(place.set(crossing.place()));
        rest.mul(1 - crossing.seconds());
        transform.direction(rest);
        entered[crossings++] = crossing.portal();
    }

    /** Returns the end of the path, in the space behind its last crossing. */
    public Vector3dc place() {
        return place;
    }

    /** Returns the reason for the end of the path. */
    public End end() {
        return end;
    }

    /** Returns the fraction of the segment up to its end, 0 to 1. */
    public double freeFraction() {
        return freeFraction;
    }

    /** Returns the number of portals that were entered. */
    public int crossings() {
        return crossings;
    }

    /** Returns the index of the portal that was entered at a crossing. */
    public int entered(int place) {
        return entered[place];
    }

    /** Returns the crossings as a word, without any pair that goes through and back. */
    public CrossingWord word() {
        return wordAfter(CrossingWord.EMPTY);
    }

    /** Returns the word of a path that leads to the start of this one, continued by the crossings of this one. */
    public CrossingWord wordAfter(CrossingWord before) {
        CrossingWord word = before;
        for (int i = 0; i < crossings; i++) {
            word = word.then(entered[i], portals);
        }
        return word;
    }

    /** Maps a direction from the path's start to its end, in place, and returns it. */
    public Vector3d carryDirection(Vector3d direction) {
        for (int i = 0; i < crossings; i++) {
            portals.transform(entered[i]).direction(direction);
        }
        return direction;
    }

    /** Maps a point through the portals of the path, in place, and returns it. */
    public Vector3d carryPoint(Vector3d point) {
        for (int i = 0; i < crossings; i++) {
            portals.transform(entered[i]).point(point);
        }
        return point;
    }

    @Override
    public String toString() {
        return end + " at " + place + " through " + Arrays.toString(Arrays.copyOf(entered, crossings));
    }
}
