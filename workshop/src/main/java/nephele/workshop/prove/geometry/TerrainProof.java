package nephele.workshop.prove.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.Terrain;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.SeededNoise;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.portal.Portals;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.ViewAngles;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/** Throws players and bodies at the ground of valleys, at up to 1 000 m/s, and checks that none falls through. */
public final class TerrainProof implements Proof {
    private static final long STARTS_PER_VALLEY = 200;
    private static final int PLAYER_TICKS = 6;
    private static final int BODY_TICKS = 12;
    private static final double MAX_METRES_PER_SECOND = 1000;
    private static final double TICK_SECONDS = 1.0 / 120;

    /** Radius of a ball around any body, in the body's sizes. */
    private static final double BOUND = 0.87;

    /** Places that are tried for a body. */
    private static final int TRIES = 20;

    private static final Vec3 GRAVITY = new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0);

    private static final double RIM_METRES = 60;
    private static final double FAR_METRES = 1e4;

    /** A player that falls out of the world restarts here, where the check detects it. */
    private static final PlayerStart FAR_AWAY = new PlayerStart(new Vec3(1e6, 1e6, 1e6), 0, 0);

    @Override
    public Claim claim() {
        return new Claim(
                "terrain",
                "Players, boxes, balls and capsules that are thrown at a terrain at up to 1 000 m/s do not fall through"
                        + " it.",
                "starts",
                1_000_000,
                100_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        Run run = new Run();
        for (long unit = from; unit < from + count; unit++) {
            run.test(unit);
            progress.unitsDone(unit + 1 - from);
        }
        return run.result(count);
    }

    /** Returns a valley with steep hills around it: oblong cells, bumps of any size, sometimes far from the world's origin. */
    private static HeightField valley(long number) {
        SplittableRandom random = new SplittableRandom(number);
        int columns = random.nextInt(9, 65);
        int rows = random.nextInt(9, 65);
        double far = random.nextInt(4) == 0 ? FAR_METRES : 0;
        double bumps = StrictMath.pow(10, random.nextDouble(-3, 1.2));
        double roughness = random.nextDouble(0.05, 0.9);
        SeededNoise noise = new SeededNoise(random.nextInt());
        Vec3 origin = new Vec3(far, random.nextDouble(-50, 50), -far);
        return HeightField.of(
                origin,
                random.nextDouble(0.3, 4),
                random.nextDouble(0.3, 4),
                columns,
                rows,
                (column, row) -> bumps * noise.at(roughness * column, roughness * row, 0.5)
                        + rim(column, columns)
                        + rim(row, rows));
    }

    private static double rim(int at, int count) {
        double aside = Math.abs(2.0 * at / (count - 1) - 1);
        return RIM_METRES * aside * aside * aside * aside;
    }

    /** The throws in one valley after another, and their results. */
    private static final class Run {
        private final Depenetration depenetration = new Depenetration();
        private long number = -1;
        private HeightField field;
        private CollisionWorld world;
        private Simulation simulation;
        private final List<String> falls = new ArrayList<>();
        private long ticks;
        private long players;
        private long bodies;
        private double lowest = Double.POSITIVE_INFINITY;

        void test(long unit) {
            if (number != unit / STARTS_PER_VALLEY) {
                number = unit / STARTS_PER_VALLEY;
                enter(valley(number));
            }
            SplittableRandom random = new SplittableRandom(~unit);
            if (unit % 2 == 0) {
                throwPlayer(unit, random);
            } else {
                throwBody(unit, random);
            }
        }

        private void enter(HeightField valley) {
            field = valley;
            var authored = new Terrain(
                    "valley",
                    "none",
                    Vec3.ZERO,
                    new Terrain.Sides(1, 1),
                    new Terrain.HeightRange(0, 1),
                    List.of(),
                    false);
            var grid = new StaticShape.HeightGrid(0, authored, valley);
            world = CollisionWorld.of(new StaticShapes(List.of(), PlacedModels.NONE, List.of(grid)));
            simulation = new Simulation(world, FAR_AWAY, SimSettings.DEFAULT);
        }

        private boolean look(long unit, String what, double above) {
            ticks++;
            lowest = Math.min(lowest, above);
            if (above > 0) {
                return true;
            }
            falls.add(String.format(Locale.ROOT, "start %d: a %s is %.6f m below the ground", unit, what, -above));
            return false;
        }

        ProofResult result(long units) {
            return ProofResult.of(
                    units,
                    falls,
                    Figure.sum("falls", falls.size(), ""),
                    Figure.sum("ticks", ticks, ""),
                    Figure.sum("players", players, ""),
                    Figure.sum("bodies", bodies, ""),
                    Figure.least("least height of a centre above the ground", lowest, "m"));
        }

        /** Returns the height of a point above the ground; infinity beside the terrain. */
        private double above(double x, double y, double z) {
            double ground = HeightFieldSurface.y(field, x, z);
            return Double.isNaN(ground) ? Double.POSITIVE_INFINITY : y - ground;
        }

        /** Returns a random place at a height above the ground, metres. */
        private Vec3 place(SplittableRandom random, double metres) {
            double x = field.x(0) + field.cellX() * field.cellColumns() * random.nextDouble(0.1, 0.9);
            double z = field.z(0) + field.cellZ() * field.cellRows() * random.nextDouble(0.1, 0.9);
            return new Vec3(x, HeightFieldSurface.y(field, x, z) + metres, z);
        }

        private void throwPlayer(long unit, SplittableRandom random) {
            Vec3 feet = place(random, StrictMath.pow(10, random.nextDouble(-3, 1)));
            Vector3d centre = new Vector3d(feet.x(), feet.y() + Stance.STANDING.centreAboveFeet(), feet.z());
            if (!depenetration.isFree(world, Stance.STANDING.shape(), centre)) {
                feet = feet.plus(new Vec3(0, 5, 0));
                centre.y += 5;
                if (!depenetration.isFree(world, Stance.STANDING.shape(), centre)) {
                    return;
                }
            }
            players++;
            PlayerState player = PlayerState.standing(feet, ViewAngles.ofDegrees(360 * random.nextDouble(), 0))
                    .withVelocity(velocity(random));
            SimState state = new SimState(0, 0, 0, player);
            boolean isAbove = true;
            for (int tick = 0; tick < PLAYER_TICKS && isAbove; tick++) {
                state = simulation.step(state, input(random));
                Vec3 at = state.player().feet();
                double above = above(at.x(), at.y() + Stance.STANDING.centreAboveFeet(), at.z());
                isAbove = look(unit, "player", above);
            }
        }

        private void throwBody(long unit, SplittableRandom random) {
            double size = random.nextDouble(0.2, 1);
            Vec3 at = freePlace(random, RoundedHull.sphere(BOUND * size));
            if (at == null) {
                return;
            }
            Body body = body(random, at, size);
            bodies++;
            RigidStep step = new RigidStep(new BodyTable(List.of(body)), GRAVITY);
            Vec3 spin = new Vec3(random.nextDouble(-20, 20), random.nextDouble(-20, 20), random.nextDouble(-20, 20));
            Bodies thrown = Bodies.of(List.of(BodyState.resting(body.centre()).moving(velocity(random), spin)));
            PortalWorld space = PortalWorld.of(world, Portals.NONE);
            Vector3d centre = new Vector3d();
            boolean isAbove = true;
            for (int tick = 0; tick < BODY_TICKS && isAbove; tick++) {
                thrown = step.step(thrown, space, BodyInfluences.none(), TICK_SECONDS);
                thrown.centre(0, centre);
                isAbove = look(unit, body.id(), above(centre.x, centre.y, centre.z));
            }
        }

        /**
         * Returns a place where a ball touches no ground; {@code null} if none is found. Some metres above a cliff are some
         * centimetres beside it.
         */
        private Vec3 freePlace(SplittableRandom random, RoundedHull ball) {
            for (int i = 0; i < TRIES; i++) {
                Vec3 at = place(random, random.nextDouble(1.2, 6));
                if (depenetration.isFree(world, ball, at.toVector())) {
                    return at;
                }
            }
            return null;
        }

        private static Body body(SplittableRandom random, Vec3 at, double size) {
            return switch (random.nextInt(3)) {
                case 0 -> new Body.Box("box", at, new Vec3(size, size, size), 1, null, 0.6, 0);
                case 1 -> new Body.Sphere("ball", at, size / 2, 1, null, 0.6, 0);
                default -> new Body.Capsule("capsule", at, size / 3, size, 1, null, 0.6, 0);
            };
        }

        /** Returns a velocity that is as often steep as flat, a quarter of them at the greatest speed. */
        private static Vec3 velocity(SplittableRandom random) {
            double speed = random.nextInt(4) == 0
                    ? MAX_METRES_PER_SECOND
                    : MAX_METRES_PER_SECOND * StrictMath.pow(10, -4 * random.nextDouble());
            Vec3 direction = new Vec3(component(random), random.nextDouble(-1, 0.2), component(random));
            return direction.scaled(speed / direction.length());
        }

        private static double component(SplittableRandom random) {
            return random.nextInt(6) == 0 ? 0 : 2 * random.nextDouble() - 1;
        }

        private static PlayerInput input(SplittableRandom random) {
            return new PlayerInput(random.nextInt(-100, 101), random.nextInt(-100, 101), 0, 0, random.nextInt(8));
        }
    }
}
