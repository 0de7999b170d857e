package nephele.engine.sim;

import nephele.engine.math.BitHash;
import nephele.engine.math.Vec3;
import nephele.engine.portal.placement.Refusal;

/** Something that happened in a tick and that a player sees or hears. Bodies and portals by their index. */
public sealed interface TickEvent {
    /** Joins it to a state's hash. */
    long hash(long seed);

    /** A shot made a portal, or moved it. */
    record PortalOpened(Shots.Colour shot, int portal) implements TickEvent {
        @Override
        public long hash(long seed) {
            return BitHash.join(BitHash.join(BitHash.join(seed, 1), shot.ordinal()), portal);
        }
    }

    /** A shot made none, here and for this reason. */
    record PortalRefused(Shots.Colour shot, Refusal reason, Vec3 where) implements TickEvent {
        @Override
        public long hash(long seed) {
            long hash = BitHash.join(BitHash.join(seed, 2), shot.ordinal());
            return BitHash.join(BitHash.join(hash, reason.ordinal()), where);
        }
    }

    /** What happened to a body in the player's hands. */
    record Handled(Kind kind, int body) implements TickEvent {
        /** How it went. */
        public enum Kind {
            PICKED_UP,
            DROPPED,
            THROWN,
            /** It was let go because nothing led to it any more. */
            LOST,
            TOO_HEAVY
        }

        @Override
        public long hash(long seed) {
            return BitHash.join(BitHash.join(BitHash.join(seed, 3), kind.ordinal()), body);
        }
    }

    /** A hand reached for something and there was nothing. */
    record NothingInReach() implements TickEvent {
        @Override
        public long hash(long seed) {
            return BitHash.join(seed, 4);
        }
    }
}
