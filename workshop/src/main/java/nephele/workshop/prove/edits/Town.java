package nephele.workshop.prove.edits;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.level.Body;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Camera;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.Sun;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;

/**
 * A town of houses on square plots, each of {@value #HOUSE} solids that touch: walls, floors, stairs, columns and a
 * roof. It has sun, sky, lights, a pair of portals, models and bodies. The seed determines it.
 */
final class Town {
    /** Solids of a plot. */
    private static final int HOUSE = 25;

    private static final double PLOT_METRES = 12;
    private static final double STOREY_METRES = 3;
    private static final double THICKNESS_METRES = 0.2;
    static final int LIGHTS = 20;
    private static final Vec3 ONE = new Vec3(1, 1, 1);

    private static final List<String> TEXTURES =
            List.of("brick", "concrete", "plaster", "wood-planks", "paver", "terracotta", "gravel", "metal-plates");

    /** The models, in turn: convex shapes and concave ones. */
    private static final List<String> MODELS =
            List.of("sphere_0.5_16_12.3d", "torus_0.6_0.2_16_8.3d", "box_1_2.3d", "models/vase.obj");

    private final SplittableRandom random;
    private final List<Solid> solids = new ArrayList<>();
    private Vec3 corner;

    private Town(long seed) {
        random = new SplittableRandom(seed);
    }

    /**
     * @param plots number in a row
     * @param rows number of rows
     */
    static Level of(long seed, int plots, int rows) {
        return new Town(seed).level(plots, rows);
    }

    private Level level(int plots, int rows) {
        for (int plot = 0; plot < plots * rows; plot++) {
            corner = new Vec3(PLOT_METRES * (plot % plots), 0, PLOT_METRES * (plot / plots));
            house();
        }
        double width = PLOT_METRES * plots;
        double depth = PLOT_METRES * rows;
        Sun sun = new Sun(new Vec3(0.4, 0.8, 0.3), new Vec3(3, 3, 2.8), true);
        Sky sky = new Sky.Gradient(new Vec3(0.2, 0.4, 0.8), new Vec3(0.6, 0.7, 0.8), new Vec3(0.2, 0.2, 0.2));
        Environment environment = new Environment(sun, sky, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        // Drawn from the random numbers in this order.
        List<Light> lights = lights(width, depth);
        List<ModelPlacement> models = models(width, depth);
        List<Body> bodies = bodies(width, depth);
        return Level.of("Town", "", environment, List.of(camera(width, depth)))
                .with(materials(), List.copyOf(solids), bodies, models)
                .with(environment, lights)
                .withPortals(portals());
    }

    private static Camera camera(double width, double depth) {
        Vec3 middle = new Vec3(width / 2, 0, depth / 2);
        return new Camera("main", new Vec3(-5, 12, -5), middle, new Vec3(0, 1, 0), 80, 0, 0.1, 1000, List.of());
    }

    private static List<Material> materials() {
        List<Material> all = new ArrayList<>();
        for (String name : TEXTURES) {
            boolean isRelief = all.size() % 2 == 1;
            String normals = isRelief ? "textures/" + name + "-normal.png" : null;
            Double roughness = isRelief ? 0.7 : null;
            all.add(new Material(name, ONE, "textures/" + name + ".png", roughness, null, normals, Vec3.ZERO, 2));
        }
        return all;
    }

    private void house() {
        double storey = STOREY_METRES * (1 + 0.2 * random.nextInt(3));
        double top = 2 * storey;
        box(0, -0.5, 0, PLOT_METRES, 0.5, PLOT_METRES);
        box(2, 0, 2, 8, THICKNESS_METRES, 8);
        double door = 4 + random.nextInt(4) * 0.5;
        box(2, THICKNESS_METRES, 2, door - 2, storey - THICKNESS_METRES, THICKNESS_METRES);
        box(door + 1, THICKNESS_METRES, 2, 9 - door, storey - THICKNESS_METRES, THICKNESS_METRES);
        box(door, 2.2, 2, 1, storey - 2.2, THICKNESS_METRES);
        box(2, THICKNESS_METRES, 9.8, 8, storey - THICKNESS_METRES, THICKNESS_METRES);
        box(2, THICKNESS_METRES, 2.2, THICKNESS_METRES, storey - THICKNESS_METRES, 7.6);
        box(9.8, THICKNESS_METRES, 2.2, THICKNESS_METRES, storey - THICKNESS_METRES, 7.6);
        box(5, THICKNESS_METRES, 2.2, THICKNESS_METRES, storey - THICKNESS_METRES, 5);
        box(2, storey, 2, 8, THICKNESS_METRES, 8);
        box(2, storey + THICKNESS_METRES, 2, 8, storey - THICKNESS_METRES, THICKNESS_METRES);
        box(2, storey + THICKNESS_METRES, 9.8, 8, storey - THICKNESS_METRES, THICKNESS_METRES);
        box(2, storey + THICKNESS_METRES, 2.2, THICKNESS_METRES, storey - THICKNESS_METRES, 7.6);
        box(9.8, storey + THICKNESS_METRES, 2.2, THICKNESS_METRES, storey - THICKNESS_METRES, 7.6);
        box(2, top, 2, 8, THICKNESS_METRES, 8);
        wedge(2, top + THICKNESS_METRES, 2, 4, 1.5, 8, BoxFace.PLUS_X);
        wedge(6, top + THICKNESS_METRES, 2, 4, 1.5, 8, BoxFace.MINUS_X);
        box(8, top + 0.5, 8, 0.6, 2, 0.6);
        prism(door - 0.3, 1.1, 1.5, 0.2, 2.2);
        prism(door + 1.3, 1.1, 1.5, 0.2, 2.2);
        box(door - 0.6, 2.2, 1.2, 2.2, THICKNESS_METRES, 0.8);
        for (int step = 0; step < 4; step++) {
            box(5.2 + 0.3 * step, THICKNESS_METRES, 8.8, 0.3, 0.3 * (step + 1), 1);
        }
    }

    private String material() {
        return TEXTURES.get(random.nextInt(TEXTURES.size()));
    }

    private String id() {
        return "s" + solids.size();
    }

    private void box(double x, double y, double z, double width, double height, double depth) {
        Map<BoxFace, Solid.Face> faces =
                random.nextInt(4) == 0 ? Map.of(BoxFace.PLUS_Y, new Solid.Face(material(), null, null)) : Map.of();
        solids.add(new Solid.Box(
                id(),
                material(),
                true,
                TextureMapping.WORLD,
                middle(x, y, z, width, height, depth),
                new Vec3(width, height, depth),
                faces));
    }

    private Vec3 middle(double x, double y, double z, double width, double height, double depth) {
        return new Vec3(corner.x() + x + width / 2, y + height / 2, corner.z() + z + depth / 2);
    }

    private void wedge(double x, double y, double z, double width, double height, double depth, BoxFace rising) {
        solids.add(new Solid.Wedge(
                id(),
                material(),
                false,
                TextureMapping.WORLD,
                middle(x, y, z, width, height, depth),
                new Vec3(width, height, depth),
                rising,
                Map.of()));
    }

    private void prism(double x, double y, double z, double radius, double height) {
        Vec3 centre = new Vec3(corner.x() + x, y, corner.z() + z);
        solids.add(new Solid.Prism(id(), material(), false, TextureMapping.WORLD, centre, radius, height, 8, Map.of()));
    }

    private Vec3 place(double width, double depth, double height) {
        return new Vec3(width * random.nextDouble(), height, depth * random.nextDouble());
    }

    private List<Light> lights(double width, double depth) {
        List<Light> lights = new ArrayList<>();
        Vec3 intensity = new Vec3(6, 5, 4);
        for (int i = 0; i < LIGHTS; i++) {
            String id = "lamp" + i;
            Vec3 at = place(width, depth, 2.5);
            lights.add(
                    i % 2 == 0
                            ? new Light.Point(id, at, intensity, 8, i % 4 == 0)
                            : new Light.Spot(id, at, new Vec3(0.2, -1, 0.1), intensity, 8, 20, 35, true));
        }
        return lights;
    }

    private static List<PortalSpec> portals() {
        return List.of(portal("a", "b", 3.5), portal("b", "a", 6.5));
    }

    static PortalSpec portal(String id, String linkedTo, double along) {
        Vec3 normal = new Vec3(-1, 0, 0);
        Vec3 centre = new Vec3(2, 1.5, along);
        return new PortalSpec(id, linkedTo, centre, normal, new Vec3(0, 1, 0), 1.2, 2.1, PortalShape.ARCH);
    }

    private List<ModelPlacement> models(double width, double depth) {
        List<ModelPlacement> models = new ArrayList<>();
        for (int i = 0; i < MODELS.size(); i++) {
            TransformStep step = new TransformStep.Translate(place(width, depth, 1));
            models.add(new ModelPlacement("m" + i, MODELS.get(i), null, List.of(step), material(), false));
        }
        return models;
    }

    private List<Body> bodies(double width, double depth) {
        List<Body> bodies = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            Vec3 size = new Vec3(0.5, 0.5, 0.5);
            bodies.add(new Body.Box("body" + i, place(width, depth, 8), size, 20, null, 0.6, 0));
        }
        return bodies;
    }
}
