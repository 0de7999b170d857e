package nephele.engine.sim.state;

import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.engine.portal.placement.PlacementResult.Refusal;

/** Something that happened in a tick and that the player sees or hears. Bodies and portals are given by their index. */
public sealed interface TickEvent {
    /** Joins the event to a state's hash. */
    long hash(long seed);

    /** A shot placed a portal, or moved it. */
    record PortalOpened(GunPortals.Colour shot, int portal) implements TickEvent {
        @Override
        public long hash(long seed) {
            return Hash64.combine(Hash64.combine(Hash64.combine(seed, 1), shot.ordinal()), portal);
        }
    }

    /**
     * A shot placed no portal, with the place and the reason.
     *
     * @param unevenMetres how uneven the ground is, if that is the reason, otherwise 0; says why, and is not in the hash
     */
    record PortalRefused(GunPortals.Colour shot, Refusal reason, Vec3 where, double unevenMetres) implements TickEvent {
        public PortalRefused(GunPortals.Colour shot, Refusal reason, Vec3 where) {
            this(shot, reason, where, 0);
        }

        @Override
        public long hash(long seed) {
            long hash = Hash64.combine(Hash64.combine(seed, 2), shot.ordinal());
            return Hash64.combine(Hash64.combine(hash, reason.ordinal()), where);
        }
    }

    /** The player picked up, dropped or threw a body, or failed to. */
    record Handled(Kind kind, int body) implements TickEvent {
        /** The outcome. */
        public enum Kind {
            PICKED_UP,
            DROPPED,
            THROWN,
            /** Dropped because the line to it was broken or a portal of it closed. */
            LOST,
            TOO_HEAVY
        }

        @Override
        public long hash(long seed) {
            return Hash64.combine(Hash64.combine(Hash64.combine(seed, 3), kind.ordinal()), body);
        }
    }

    /** The player entered an exit: the level has ended. Happens once. */
    record ExitReached(int exit) implements TickEvent {
        @Override
        public long hash(long seed) {
            return Hash64.combine(Hash64.combine(seed, 5), exit);
        }
    }

    /** A body that had fallen out of the world is back in its place. */
    record BodyReturned(int body) implements TickEvent {
        @Override
        public long hash(long seed) {
            return Hash64.combine(Hash64.combine(seed, 6), body);
        }
    }

    /** An event without further data. */
    enum Plain implements TickEvent {
        /** The player tried to pick up a body and none was in reach. */
        NOTHING_IN_REACH(4),
        /** The player fell below everything solid, with the assist that puts it back: the picture turns black. */
        PLAYER_FELL(7),
        /** The player that had fallen is back where it last stood: the picture comes back. */
        PLAYER_RETURNED(8);

        private final int code;

        Plain(int code) {
            this.code = code;
        }

        @Override
        public long hash(long seed) {
            return Hash64.combine(seed, code);
        }
    }
}
