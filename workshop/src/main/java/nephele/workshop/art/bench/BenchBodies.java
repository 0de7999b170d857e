package nephele.workshop.art.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Body;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Camera;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;

/**
 * The benchmark levels of bodies: a stack of boxes at rest, without the jitter of the other engines' scene, and a shaft
 * of bodies that never come to rest.
 */
public final class BenchBodies {
    static final int STACKED = 500;
    static final int RESTLESS = 200;

    private static final double GAP_METRES = 0.01;
    private static final Vec3 ALONG = new Vec3(0, 0, -1);

    private BenchBodies() {}

    /** Returns 20 layers of 5 × 5 unit boxes, 1 cm apart in all directions, above a plane. */
    public static Level stack(Environment environment) {
        List<Body> bodies = new ArrayList<>(STACKED);
        for (int i = 0; i < STACKED; i++) {
            int layer = i / 25;
            int place = i % 25;
            double pitch = 1 + GAP_METRES;
            Vec3 centre = new Vec3((place % 5 - 2) * pitch, 0.5 + GAP_METRES + layer * pitch, (place / 5 - 2) * pitch);
            bodies.add(new Body.Box("b" + i, centre, new Vec3(1, 1, 1), 1, null, 0.6, 0));
        }
        Solid ground = box("ground", new Vec3(0, -0.5, 0), new Vec3(200, 1, 200));
        return Level.of(
                        "Bench: stack of 500 boxes",
                        "case H: 20 layers of 5 x 5 unit boxes with gaps of 1 cm over a plane",
                        environment,
                        List.of(camera(new Vec3(0, 12, 30), new Vec3(0, 8, 0))))
                .with(List.of(), List.of(ground), bodies);
    }

    /**
     * Returns a shaft with a portal from the floor to the ceiling and with two slopes. Its bodies slide and fall
     * forever, and the slopes limit their speed.
     */
    public static Level shaft(Environment environment) {
        List<Solid> solids = List.of(
                box("floor", new Vec3(0, -0.5, 0), new Vec3(14, 1, 14)),
                box("ceiling", new Vec3(0, 10.5, 0), new Vec3(14, 1, 14)),
                box("west", new Vec3(-5.4, 5, 0), new Vec3(1, 10, 9.8)),
                box("east", new Vec3(5.4, 5, 0), new Vec3(1, 10, 9.8)),
                box("north", new Vec3(0, 5, -5.4), new Vec3(11.8, 10, 1)),
                box("south", new Vec3(0, 5, 5.4), new Vec3(11.8, 10, 1)),
                wedge("upper", new Vec3(-2.05, 6.75, 0), BoxFace.MINUS_X),
                wedge("lower", new Vec3(2.05, 2.75, 0), BoxFace.PLUS_X));
        List<PortalSpec> portals = List.of(
                new PortalSpec(
                        "down", "up", new Vec3(0, 0, 0), new Vec3(0, 1, 0), ALONG, 10, 10, PortalShape.RECTANGLE),
                new PortalSpec(
                        "up", "down", new Vec3(0, 10, 0), new Vec3(0, -1, 0), ALONG, 10, 10, PortalShape.RECTANGLE));
        return Level.of(
                        "Bench: 200 bodies that never rest",
                        "boxes, balls and capsules that slide down two slopes and fall through the floor to the"
                                + " ceiling for ever",
                        environment,
                        List.of(camera(new Vec3(0, 5, 4.5), new Vec3(0, 4, 0))))
                .with(List.of(), solids, falling())
                .withPortals(portals);
    }

    private static List<Body> falling() {
        List<Body> bodies = new ArrayList<>(RESTLESS);
        for (int i = 0; i < RESTLESS; i++) {
            double x = -4.4 + 0.8 * (i % 5);
            double y = 0.7 + 0.57 * (i / 25);
            double z = -4 + 2 * (i / 5 % 5) + 0.1 * (i / 25);
            bodies.add(body(i, new Vec3(x, y, z)));
        }
        return bodies;
    }

    /** Returns two boxes, a ball and a capsule in turn, with a low friction so that none rests on a slope. */
    private static Body body(int i, Vec3 centre) {
        String id = "b" + i;
        return switch (i % 4) {
            case 1 -> new Body.Sphere(id, centre, 0.2, 4, null, 0.2, 0);
            case 3 -> new Body.Capsule(id, centre, 0.15, 0.5, 4, null, 0.2, 0);
            default -> new Body.Box(id, centre, new Vec3(0.4, 0.3, 0.35), 4, null, 0.2, 0);
        };
    }

    private static Solid box(String id, Vec3 centre, Vec3 size) {
        return new Solid.Box(id, null, false, TextureMapping.WORLD, centre, size, Map.of());
    }

    private static Solid wedge(String id, Vec3 centre, BoxFace rising) {
        Vec3 size = new Vec3(5.7, 3.5, 9.8);
        return new Solid.Wedge(id, null, false, TextureMapping.WORLD, centre, size, rising, Map.of());
    }

    private static Camera camera(Vec3 eye, Vec3 target) {
        return new Camera("main", eye, target, new Vec3(0, 1, 0), 0, 60, 0.1, 500, List.of());
    }
}
