package nephele.engine.portal;

import java.util.Arrays;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Walks a straight segment through portals: an eye's ray, a camera's boom, the way to a held thing, an aim, a sound, a
 * beam of light. One walker for one set of portals, reused for every path; the accessors speak of the last one.
 */
public final class PathTrace {
    /** A path that crosses more often than this ends there: between facing portals it would go on for ever. */
    public static final int MOST_CROSSINGS = 64;

    /** A wall and the portal in it are met at one place: the portal wins by this. */
    private static final double FLUSH_METRES = 1e-6;

    private static final Vector3dc NO_ACCELERATION = new Vector3d();

    /** How a path ended. */
    public enum End {
        ARRIVED,
        BLOCKED,
        TOO_MANY_CROSSINGS
    }

    /** Hears of each straight piece of a path, in the space where it lies. */
    @FunctionalInterface
    public interface Legs {
        Legs NOBODY = (from, way) -> {};

        /** Both vectors are the walker's own: read them at once. */
        void leg(Vector3dc from, Vector3dc way);
    }

    private final Portals portals;
    private final Obstacles obstacles;
    private final Crossing crossing = new Crossing();
    private final Vector3d place = new Vector3d();
    private final Vector3d rest = new Vector3d();
    private final Vector3d piece = new Vector3d();
    private final int[] entered = new int[MOST_CROSSINGS];
    private int crossings;
    private double freeFraction;
    private End end;

    public PathTrace(Portals portals, Obstacles obstacles) {
        this.portals = portals;
        this.obstacles = obstacles;
    }

    /** Walks from a point as far as {@code way} goes, through every portal on it, up to the first obstacle. */
    public End walk(Vector3dc from, Vector3dc way) {
        return walk(from, way, Legs.NOBODY);
    }

    /** The same, telling of each piece before the next one. */
    public End walk(Vector3dc from, Vector3dc way, Legs legs) {
        place.set(from);
        rest.set(way);
        crossings = 0;
        double length = way.length();
        double walked = 0;
        end = null;
        while (end == null) {
            double free = obstacles.free(place, rest);
            boolean crosses = crossing.find(portals, place, rest, NO_ACCELERATION, 1);
            double left = 1 - walked;
            if (crosses && crossing.seconds() <= free + FLUSH_METRES / Math.max(length * left, FLUSH_METRES)) {
                walked += left * crossing.seconds();
                legs.leg(place, crossing.place().sub(place, piece));
                enter();
            } else {
                legs.leg(place, rest.mul(free, piece));
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
        Passage passage = portals.passage(crossing.portal());
        passage.point(place.set(crossing.place()));
        rest.mul(1 - crossing.seconds());
        passage.direction(rest);
        entered[crossings++] = crossing.portal();
    }

    /** Where the path ended, in the space behind its last crossing. */
    public Vector3dc place() {
        return place;
    }

    /** How much of the way was walked, 0 to 1. */
    public double freeFraction() {
        return freeFraction;
    }

    public int crossings() {
        return crossings;
    }

    /** The portal that was entered at a crossing. */
    public int entered(int place) {
        return entered[place];
    }

    /** The crossings with every there-and-back taken out. */
    public CrossingWord word() {
        CrossingWord word = CrossingWord.EMPTY;
        for (int i = 0; i < crossings; i++) {
            word = word.then(entered[i], portals);
        }
        return word;
    }

    /** Turns a direction at the path's start into the one at its end. */
    public Vector3d carryDirection(Vector3d direction) {
        for (int i = 0; i < crossings; i++) {
            portals.passage(entered[i]).direction(direction);
        }
        return direction;
    }

    /** Moves a point as if it had gone the path's way. */
    public Vector3d carryPoint(Vector3d point) {
        for (int i = 0; i < crossings; i++) {
            portals.passage(entered[i]).point(point);
        }
        return point;
    }

    @Override
    public String toString() {
        return end + " at " + place + " through " + Arrays.toString(Arrays.copyOf(entered, crossings));
    }
}
