package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.player.PlayerPose;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;

/** A simulated walk into a portal of a hall, oblique and with a pitched view, tick by tick. */
final class RecordedTraversal {
    private static final double HALF_HALL_METRES = 8;
    private static final int MOST_TICKS = 240;

    /** The normals of the exit portals; the last one is in the floor. The entry's normal is +z. */
    private static final Vec3[] EXIT_NORMALS = {
        new Vec3(1, 0, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, -1), new Vec3(0, 1, 0)
    };

    private final List<SimState> states = new ArrayList<>();
    private final Portals portals;

    RecordedTraversal(long seed) {
        Level hall = hall(new SplittableRandom(seed));
        portals = Portals.of(hall);
        var simulation = new Simulation(hall, SimSettings.DEFAULT);
        SimState state = simulation.start();
        for (int tick = 0; tick < MOST_TICKS; tick++) {
            states.add(state);
            state = simulation.step(state, PlayerInput.FORWARD);
        }
    }

    private static Level hall(SplittableRandom random) {
        double h = HALF_HALL_METRES;
        Vec3 normal = EXIT_NORMALS[random.nextInt(EXIT_NORMALS.length)];
        boolean floor = normal.y() > 0;
        Vec3 exit = new Vec3(-h * normal.x(), floor ? 0 : 1.05, floor ? 4 : -h * normal.z());
        Vec3 up = floor ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
        double away = random.nextDouble(1.5, 3);
        double aside = away * random.nextDouble(-0.8, 0.8);
        double yaw = Math.toDegrees(Math.atan2(aside - random.nextDouble(-0.25, 0.25), away));
        var start = new PlayerStart(new Vec3(aside, 0, away - h), yaw, random.nextDouble(-30, 20));
        var environment = new Environment(null, null, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        return Level.of("traversal", "", environment, List.of())
                .with(start, null)
                .with(List.of(), walls())
                .withPortals(List.of(
                        portal("a", "b", new Vec3(0, 1.05, -h), new Vec3(0, 0, 1), new Vec3(0, 1, 0)),
                        portal("b", "a", exit, normal, up)));
    }

    private static PortalSpec portal(String id, String to, Vec3 centre, Vec3 normal, Vec3 up) {
        return new PortalSpec(id, to, centre, normal, up, 1.2, 2.1, PortalShape.RECTANGLE);
    }

    private static List<Solid> walls() {
        double h = HALF_HALL_METRES;
        return List.of(
                box("floor", new Vec3(0, -0.5, 0), new Vec3(2 * h, 1, 2 * h)),
                box("ahead", new Vec3(0, 3, -h - 0.5), new Vec3(2 * h, 6, 1)),
                box("behind", new Vec3(0, 3, h + 0.5), new Vec3(2 * h, 6, 1)),
                box("left", new Vec3(-h - 0.5, 3, 0), new Vec3(1, 6, 2 * h)),
                box("right", new Vec3(h + 0.5, 3, 0), new Vec3(1, 6, 2 * h)));
    }

    private static Solid box(String id, Vec3 centre, Vec3 size) {
        return new Solid.Box(id, null, true, null, centre, size, Map.of());
    }

    Portals portals() {
        return portals;
    }

    List<SimState> states() {
        return states;
    }

    /** Returns the first pose that the source's rule would move; {@code null} if none comes near. */
    ViewPose near() {
        for (int tick = 0; tick + 1 < states.size(); tick++) {
            ViewPose pose = pose(tick, 0);
            if (ViewPose.isDue(portals.portal(0), pose.eye())) {
                return pose;
            }
        }
        return null;
    }

    /**
     * Returns the last pose before and the first pose behind the portal; {@code null} if the eye does not go through.
     */
    ViewPose[] through() {
        for (int tick = 0; tick + 1 < states.size(); tick++) {
            if (apart(pose(tick, 0), pose(tick, 1)) > 1) {
                return bisected(tick);
            }
        }
        return null;
    }

    private ViewPose[] bisected(int tick) {
        double low = 0;
        double high = 1;
        for (int i = 0; i < 50; i++) {
            double middle = (low + high) / 2;
            if (apart(pose(tick, low), pose(tick, middle)) < 1) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return new ViewPose[] {pose(tick, low), pose(tick, high)};
    }

    private ViewPose pose(int tick, double fraction) {
        return ViewPose.of(PlayerPose.between(states.get(tick), states.get(tick + 1), fraction));
    }

    private static double apart(ViewPose a, ViewPose b) {
        return a.eye().toVector().distance(b.eye().toVector());
    }
}
