package nephele.engine.sim.state;

import java.util.List;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.level.Exit;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * The world state: everything that can change in a level besides the player. Parts that the level does not use are
 * their empty constants, which cost nothing and do not enter the hash.
 *
 * @param bodies in the level's order
 * @param portals the level's fixed portals in its order, then the shot ones in the order of their first shots: an index
 *     once given keeps its meaning
 * @param shots the indices of the gun's portals
 * @param holding what the player holds
 * @param trace what the last tick did
 * @param exit whether the level has ended
 * @param fall where the player last stood; only with the assist that uses it
 * @param arrival the portal that the player came out of; only with the assist that uses it
 */
public record WorldState(
        Bodies bodies,
        Portals portals,
        GunPortals shots,
        HeldBody holding,
        TickTrace trace,
        ExitState exit,
        FallState fall,
        Arrival arrival) {
    public static final WorldState NOTHING = new WorldState(
            Bodies.NONE,
            Portals.NONE,
            GunPortals.NONE,
            HeldBody.NOTHING,
            TickTrace.NONE,
            ExitState.NONE,
            FallState.NONE,
            Arrival.NONE);

    public WorldState with(Bodies changed) {
        return changed == bodies ? this : new WorldState(changed, portals, shots, holding, trace, exit, fall, arrival);
    }

    public WorldState with(HeldBody changed) {
        return new WorldState(bodies, portals, shots, changed, trace, exit, fall, arrival);
    }

    public WorldState with(Portals changed, GunPortals now) {
        return new WorldState(bodies, changed, now, holding, trace, exit, fall, arrival);
    }

    public WorldState with(TickTrace changed) {
        return changed == trace ? this : new WorldState(bodies, portals, shots, holding, changed, exit, fall, arrival);
    }

    /** Returns this state with another state of the exits. */
    public WorldState with(ExitState changed) {
        return changed == exit ? this : new WorldState(bodies, portals, shots, holding, trace, changed, fall, arrival);
    }

    /** Returns this state with another memory of falls. */
    public WorldState with(FallState changed) {
        return changed == fall ? this : new WorldState(bodies, portals, shots, holding, trace, exit, changed, arrival);
    }

    /** Returns this state with another arrival. */
    public WorldState with(Arrival changed) {
        return changed == arrival ? this : new WorldState(bodies, portals, shots, holding, trace, exit, fall, changed);
    }

    public long hash(long seed) {
        long hash = bodies.size() == 0 ? seed : bodies.hash(seed);
        hash = portals.size() == 0 ? hash : joined(hash, portals);
        return arrival.hash(fall.hash(exit.hash(trace.hash(holding.hash(shots.hash(hash))))));
    }

    /** Joins the portals' centres, frames and links to a hash; apertures belong to the level and never change. */
    private static long joined(long seed, Portals portals) {
        long hash = Hash64.combine(seed, portals.size());
        for (int i = 0; i < portals.size(); i++) {
            Portal portal = portals.portal(i);
            hash = Hash64.combine(Hash64.combine(hash, portals.partner(i)), portal.centre());
            hash = Hash64.combine(hash, portal.frame().up());
            hash = Hash64.combine(hash, portal.frame().back());
        }
        return hash;
    }

    /**
     * The data that a tick passes to the next one and to the interpolated picture between the two.
     *
     * @param pressed the bits of the hands' actions that were held: they act again only after a release
     * @param playerCrossed the portals that the player went through in this tick
     * @param events for the player
     */
    public record TickTrace(int pressed, CrossingWord playerCrossed, List<TickEvent> events) {
        public static final TickTrace NONE = new TickTrace(0, CrossingWord.EMPTY, List.of());

        public TickTrace {
            events = List.copyOf(events);
        }

        public static TickTrace of(int pressed, CrossingWord playerCrossed, List<TickEvent> events) {
            boolean isNone = pressed == 0 && playerCrossed.length() == 0 && events.isEmpty();
            return isNone ? NONE : new TickTrace(pressed, playerCrossed, events);
        }

        long hash(long seed) {
            if (equals(NONE)) {
                return seed;
            }
            long hash = playerCrossed.hash(Hash64.combine(seed, pressed));
            for (TickEvent event : events) {
                hash = event.hash(hash);
            }
            return hash;
        }
    }

    /**
     * The end of a level: the first exit that the player's centre has entered, and the tick of it.
     *
     * @param exit index of the exit; {@link #NOT_REACHED} before the end
     * @param tick number of ticks since the start; 0 before the end
     */
    public record ExitState(int exit, long tick) {
        /** Stands for the absence of an exit's index. */
        public static final int NOT_REACHED = -1;

        /** The state in a level without exits, which does not enter the hash. */
        public static final ExitState NONE = new ExitState(-2, 0);

        /** The state in a level with exits before the player has entered one. */
        public static final ExitState OPEN = new ExitState(NOT_REACHED, 0);

        /** Returns the state at the start of a level with these exits. */
        public static ExitState start(List<Exit> exits) {
            return exits.isEmpty() ? NONE : OPEN;
        }

        /** Returns true once the level has ended. */
        public boolean isReached() {
            return exit >= 0;
        }

        /**
         * Returns the state after a tick.
         *
         * @param centre of the player
         */
        public ExitState after(long now, Vec3 centre, List<Exit> exits) {
            if (exit != NOT_REACHED) {
                return this;
            }
            for (int i = 0; i < exits.size(); i++) {
                if (exits.get(i).contains(centre)) {
                    return new ExitState(i, now);
                }
            }
            return this;
        }

        long hash(long seed) {
            return this == NONE ? seed : Hash64.combine(Hash64.combine(seed, exit), tick);
        }
    }

    /**
     * The memory of {@link Assist#SAFE_RETURN}: where the player last stood, and when it last fell out of the level and came
     * back. The picture fades by {@link #darkness}.
     *
     * @param safe the player at rest where it had static ground for {@link #STOOD_SECONDS} from then on, last of all
     * @param candidate the player at rest in the next such place, if it keeps ground for so long; {@code null} for none
     * @param candidateTick the tick of the candidate; 0 for none
     * @param fellTick the tick in which the player last fell below everything solid; {@link #NEVER} for none
     * @param returnedTick the tick in which it last came back; {@link #NEVER} for none
     */
    public record FallState(
            PlayerState safe, PlayerState candidate, long candidateTick, long fellTick, long returnedTick) {
        /** The time for which the player has to have ground under it. */
        public static final double STOOD_SECONDS = 0.5;

        /** The time in which the picture turns black during a fall, and in which it comes back. */
        public static final double FADE_SECONDS = 0.25;

        /** Stands for the absence of a tick. */
        public static final long NEVER = -1;

        /** The state without the assist, which does not enter the hash. */
        public static final FallState NONE = new FallState(null, null, 0, NEVER, NEVER);

        /** Returns the state at the start of a level. */
        public static FallState start(PlayerState player) {
            return new FallState(player, null, 0, NEVER, NEVER);
        }

        /** Returns true while the player falls below everything solid, before it comes back. */
        public boolean isFalling() {
            return fellTick > returnedTick;
        }

        /** Returns the state after the player has fallen below everything solid. */
        public FallState fell(long tick) {
            return new FallState(safe, null, 0, tick, returnedTick);
        }

        /** Returns the state after the player has come back. */
        public FallState returned(long tick) {
            return new FallState(safe, null, 0, fellTick, tick);
        }

        /** Returns this state with another candidate, {@code null} for none. */
        public FallState withCandidate(PlayerState player, long tick) {
            return new FallState(safe, player, player == null ? 0 : tick, fellTick, returnedTick);
        }

        /** Returns this state with the candidate as the place to return to. */
        public FallState confirmed() {
            return new FallState(candidate, null, 0, fellTick, returnedTick);
        }

        /**
         * Returns how dark the picture is for a fall, 0 (as always) to 1 (black).
         *
         * @param ticks since the start, with the fraction of a tick that the picture shows
         */
        public double darkness(double ticks, int ticksPerSecond) {
            double fade = FADE_SECONDS * ticksPerSecond;
            if (isFalling()) {
                return Math.max(0, Math.min(1, (ticks - fellTick) / fade));
            }
            return returnedTick == NEVER ? 0 : Math.max(0, Math.min(1, 1 - (ticks - returnedTick) / fade));
        }

        long hash(long seed) {
            if (this == NONE) {
                return seed;
            }
            long hash = safe.hash(seed);
            hash = candidate == null ? Hash64.combine(hash, 0) : candidate.hash(hash);
            return Hash64.combine(Hash64.combine(Hash64.combine(hash, candidateTick), fellTick), returnedTick);
        }
    }

    /**
     * The memory of {@link Assist#EXIT_ROOM}: the portal that the player came out of shortly before.
     *
     * @param portal its index; {@link #NOWHERE} has −1
     * @param ticksLeft for how many ticks it still counts
     */
    public record Arrival(int portal, int ticksLeft) {
        /** The time for which an arrival counts. */
        public static final double SECONDS = 1;

        /** The state without the assist, which does not enter the hash. */
        public static final Arrival NONE = new Arrival(-2, 0);

        /** The state with the assist while no arrival counts. */
        public static final Arrival NOWHERE = new Arrival(-1, 0);

        /** Returns the arrival in the tick in which the player comes out of a portal. */
        public static Arrival at(int portal, int ticksPerSecond) {
            return new Arrival(portal, (int) Math.ceil(SECONDS * ticksPerSecond));
        }

        /** Returns true while the arrival counts. */
        public boolean isRecent() {
            return ticksLeft > 0;
        }

        /** Returns the state in which no arrival counts. */
        private Arrival over() {
            return this == NONE ? NONE : NOWHERE;
        }

        /** Returns the arrival a tick later. */
        public Arrival later() {
            return ticksLeft > 1 ? new Arrival(portal, ticksLeft - 1) : over();
        }

        long hash(long seed) {
            return this == NONE ? seed : Hash64.combine(Hash64.combine(seed, portal), ticksLeft);
        }
    }

    /**
     * The body that the player holds, and the line to it.
     *
     * @param body the body's index, {@link #NONE} for none
     * @param word the crossing word from the player's centre to the body's centre
     * @param ticksUnseen the number of ticks for which the line of sight along the crossing word has been broken
     * @param leaving a body that was dropped while it overlapped the player, {@link #NONE} for none: the two do not collide
     *     until it is outside
     */
    public record HeldBody(int body, CrossingWord word, int ticksUnseen, int leaving) {
        public static final int NONE = -1;
        public static final HeldBody NOTHING = new HeldBody(NONE, CrossingWord.EMPTY, 0, NONE);

        public HeldBody(int body, CrossingWord word, int ticksUnseen) {
            this(body, word, ticksUnseen, NONE);
        }

        /** Returns the holding after the body is dropped. */
        public HeldBody released() {
            return word.length() == 0 ? new HeldBody(NONE, CrossingWord.EMPTY, 0, body) : NOTHING;
        }

        /** Returns the body that does not collide with the player, or {@link #NONE}. */
        public int passing() {
            return isHolding() ? body : leaving;
        }

        public boolean isHolding() {
            return body != NONE;
        }

        public HeldBody unseenFor(int ticks) {
            return ticks == ticksUnseen ? this : new HeldBody(body, word, ticks);
        }

        /** Returns true if every portal of the crossing word is open. */
        public boolean isOpen(Portals portals) {
            for (int i = 0; i < word.length(); i++) {
                if (!portals.isOpen(word.entry(i))) {
                    return false;
                }
            }
            return true;
        }

        /** Maps a point of the player's space to the body's; the crossing word has to be open. */
        public Vector3d pointThere(Vector3d point, Portals portals) {
            for (int i = 0; i < word.length(); i++) {
                portals.transform(word.entry(i)).point(point);
            }
            return point;
        }

        /** Maps a direction of the player's space to the body's. */
        public Vector3d directionThere(Vector3d direction, Portals portals) {
            for (int i = 0; i < word.length(); i++) {
                portals.transform(word.entry(i)).direction(direction);
            }
            return direction;
        }

        /** Maps a point of the body's space to the player's, where it would be without the portals in between. */
        public Vector3d pointHere(Vector3d point, Portals portals) {
            for (int i = word.length() - 1; i >= 0; i--) {
                portals.transform(portals.partner(word.entry(i))).point(point);
            }
            return point;
        }

        long hash(long seed) {
            if (equals(NOTHING)) {
                return seed;
            }
            long hash = Hash64.combine(Hash64.combine(Hash64.combine(seed, body), ticksUnseen), leaving);
            return word.hash(hash);
        }
    }
}
