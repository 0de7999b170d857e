package nephele.engine.sim;

import nephele.engine.math.BitHash;
import nephele.engine.math.Vec3;
import nephele.engine.portal.placement.Refusal;

/** Something that happened in a tick and that the player sees or hears. Bodies and portals are given by their index. */
public sealed interface TickEvent {
    /** Joins the event to a state's hash. */
    long hash(long seed);

    /** A shot placed a portal, or moved it. */
    record PortalOpened(Shots.Colour shot, int portal) implements TickEvent {
        @Override
        public long hash(long seed) {
            return BitHash.join(BitHash.join(BitHash.join(seed, 1), shot.ordinal()), portal);
        }
    }

    /** A shot placed no portal, with the place and the reason. */
    record PortalRefused(Shots.Colour shot, Refusal reason, Vec3 where) implements TickEvent {
        @Override
        public long hash(long seed) {
            long hash = BitHash.join(BitHash.join(seed, 2), shot.ordinal());
            return BitHash.join(BitHash.join(hash, reason.ordinal()), where);
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
            return BitHash.join(BitHash.join(BitHash.join(seed, 3), kind.ordinal()), body);
        }
    }

    /** The player tried to pick up a body and none was in reach. */
    record NothingInReach() implements TickEvent {
        @Override
        public long hash(long seed) {
            return BitHash.join(seed, 4);
        }
    }
}
