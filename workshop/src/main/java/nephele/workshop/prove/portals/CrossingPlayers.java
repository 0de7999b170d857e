package nephele.workshop.prove.portals;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.ViewAngles;
import org.joml.Vector3d;

/** Moves players that walk, run, jump, fall and turn through a pair of portals. */
final class CrossingPlayers {
    private static final double SECONDS_AFTER = 0.25;

    private final PortalRoom room;
    private final PortalWorld portalWorld;
    private final SeamedClearance clearance;
    private final Simulation simulation;
    private final int mostTicks;
    private final int ticksAfter;
    private final Depenetration depenetration = new Depenetration();

    CrossingPlayers(PortalRoom room, int ticksPerSecond) {
        this(room, new SimSettings(ticksPerSecond, List.of()));
    }

    CrossingPlayers(PortalRoom room, SimSettings settings) {
        this.room = room;
        portalWorld = PortalWorld.of(room.world(), room.portals());
        clearance = new SeamedClearance(room);
        SimLevel level = SimLevel.of(room.world(), new PlayerStart(room.origin(), 0, 0), room.portals());
        mostTicks = settings.ticksPerSecond() / 3;
        ticksAfter = (int) Math.ceil(SECONDS_AFTER * settings.ticksPerSecond());
        simulation = new Simulation(level, settings);
    }

    /** Draws starts until a player goes through, and returns true if one did. */
    boolean cross(SplittableRandom random, String where, CrossingTally tally) {
        for (int i = 0; i < CrossingsProof.MOST_TRIES; i++) {
            PlayerState start = start(random);
            if (start != null && crosses(where, start, random, tally)) {
                return true;
            }
        }
        return false;
    }

    /** Draws starts until a player goes through, and returns the state after that tick; {@code null} for none. */
    SimState crossed(SplittableRandom random) {
        for (int i = 0; i < CrossingsProof.MOST_TRIES; i++) {
            PlayerState start = start(random);
            SimState state = start == null ? null : simulation.start().withPlayer(start);
            PlayerInput input = input(random);
            for (int tick = 0; tick < mostTicks && state != null; tick++) {
                state = simulation.step(state, input);
                if (state.world().trace().playerCrossed().length() > 0) {
                    return state;
                }
            }
        }
        return null;
    }

    /** Returns the state one tick later. */
    SimState step(SimState state, PlayerInput input) {
        return simulation.step(state, input);
    }

    /** Returns how deep a player is in a solid, metres; 0 for one that is free. */
    double depth(PlayerState player) {
        return clearance.depth(player);
    }

    private boolean crosses(String where, PlayerState start, SplittableRandom random, CrossingTally tally) {
        SimState state = simulation.start().withPlayer(start);
        PlayerInput input = input(random);
        int last = mostTicks;
        boolean crossed = false;
        for (int tick = 0; tick < last; tick++) {
            state = simulation.step(state, input);
            if (!crossed && state.world().trace().playerCrossed().length() > 0) {
                crossed = true;
                last = tick + 1 + ticksAfter;
                input = input(random);
            }
            if (!check(where + " at tick " + tick, state.player(), tally)) {
                return true;
            }
        }
        return crossed;
    }

    private boolean check(String where, PlayerState player, CrossingTally tally) {
        if (!room.holds(player.centre())) {
            tally.escaped(where + ": out of the room: " + player);
            return false;
        }
        double depth = clearance.depth(player);
        tally.playerDepth(depth);
        if (depth > 0) {
            tally.stuck(where + ": " + depth + " m in a solid: " + player);
        }
        return depth == 0;
    }

    /** Returns a start in front of one of the portals, moving towards it; {@code null} if no draw is free. */
    private PlayerState start(SplittableRandom random) {
        for (int i = 0; i < 20; i++) {
            Portal entry = room.portals().portal(random.nextInt(2));
            double x = random.nextDouble(-0.7, 0.7);
            double y = random.nextDouble(-1.1, 1.1);
            double inFront = random.nextDouble(0.01, 0.8);
            Vec3 centre = entry.world(x, y, inFront);
            double sill = entry.centre().y()
                    - entry.aperture().heightMetres() / 2
                    - room.origin().y();
            if (entry.normal().y() == 0 && sill < 0.3 && random.nextInt(4) > 0) {
                centre = new Vec3(centre.x(), room.origin().y() + Stance.STANDING.centreAboveFeet(), centre.z());
            }
            Stance stance = random.nextInt(5) == 0 ? Stance.CROUCHED : Stance.STANDING;
            Vec3 feet = new Vec3(centre.x(), centre.y() - stance.centreAboveFeet(), centre.z());
            Vector3d at = centre.toVector();
            long active = portalWorld.active(stance.shape(), at, new Vector3d());
            PlayerState player = heading(random, entry, feet, stance);
            if (depenetration.isFree(portalWorld.openedFor(active), stance.shape(), at)
                    && room.holds(centre)
                    && clearance.depth(player) == 0) {
                return player;
            }
        }
        return null;
    }

    private static PlayerState heading(SplittableRandom random, Portal entry, Vec3 feet, Stance stance) {
        Vec3 n = entry.normal();
        double towards = Math.toDegrees(StrictMath.atan2(n.x(), n.z())) + random.nextDouble(-50, 50);
        double speed = StrictMath.pow(10, random.nextDouble(-3, 1.5)) + (n.y() < -0.1 ? 4 : 0);
        Vec3 velocity = new Vec3(
                -n.x() * speed + random.nextDouble(-2, 2),
                -n.y() * speed + random.nextDouble(-2, 2),
                -n.z() * speed + random.nextDouble(-2, 2));
        ViewAngles heading = ViewAngles.ofDegrees(towards, random.nextDouble(-89, 89));
        return new PlayerState(
                feet, random.nextInt(3) == 0 ? Vec3.ZERO : velocity, heading, stance.eyeMetres(), stance, null, false);
    }

    private static PlayerInput input(SplittableRandom random) {
        PlayerInput input = PlayerInput.NONE.walking(random.nextInt(-20, 250), random.nextInt(-60, 61));
        if (random.nextInt(4) == 0) {
            input = input.turning(random.nextInt(-4000, 4000), random.nextInt(-2000, 2000));
        }
        input = random.nextInt(3) == 0 ? input.holding(Action.RUN) : input;
        input = random.nextInt(6) == 0 ? input.holding(Action.JUMP) : input;
        return random.nextInt(6) == 0 ? input.holding(Action.CROUCH) : input;
    }
}
